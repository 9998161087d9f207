# SPDX-License-Identifier: LGPL-2.1-or-later
"""A STEP file's own text with its faces named and coloured by class (ISO 10303-46)."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

from gpswb.cad.solid import Solid
from gpswb.core.invariance import InvarianceClass
from gpswb.errors import InputError
from gpswb.io.ap242.match import match_faces
from gpswb.io.ap242.part21 import Part21
from gpswb.io.ap242.strings import encode
from gpswb.io.ap242.structure import shapes_of
from gpswb.io.ap242.write import appended
from gpswb.io.colours import NONE, WHEEL, Rgb
from gpswb.sentence import Sentence

_NAME = re.compile(r"\s*(?:ADVANCED_FACE|FACE_SURFACE)\s*\(\s*('(?:[^']|'')*')", re.IGNORECASE)
_STYLED = "STYLED_ITEM", "OVER_RIDING_STYLED_ITEM"
_STYLES = re.compile(r"\(\s*'(?:[^']|'')*'\s*,\s*(\([^()]*\))", re.IGNORECASE)
"""Name and, captured, the styles of a styled item."""


def write_coloured_step(
    path: Path,
    file: Part21,
    solid: Solid,
    classes: Mapping[str, InvarianceClass],
    names: Mapping[str, str],
) -> tuple[str, ...]:
    """Write a file with the names and colours of its faces changed, and nothing else.

    Args:
        file: the text that ``solid`` was read from.
        classes: class of each face, by the face's name (``Face1`` ...); the others become grey.
        names: text after the face's name: ``Face1 planar Plane 2``.

    Returns:
        Names of the faces that aren't found in the text, and stay as they are.

    Raises:
        InputError: none of them is found.
        OSError: the file can't be written.
    """
    shapes = shapes_of(file)
    facemap = solid.facemap
    found = match_faces(file, shapes, solid.mesh, facemap) if facemap is not None else {}
    if facemap is None or not found:
        raise InputError(
            Sentence("{path}: its text holds no B-rep face to colour", path=solid.source)
        )
    styled = _styled_items(file)
    style = _Styles(file.highest + 1)
    changes: list[tuple[int, int, str]] = []
    items: dict[int, list[str]] = {}
    done: set[int] = set()
    for face in facemap.faces:
        entity = found.get(face.name)
        # The occurrences of a part share its faces: the first one names them.
        if entity is None or entity.number in done:
            continue
        done.add(entity.number)
        given = classes.get(face.name)
        words = [face.name, given or "no class", names.get(face.name, "")]
        changes += _change(file, entity.number, _NAME, encode(" ".join(filter(None, words))))
        assigned = style.of(given or "no class", WHEEL[given] if given else NONE)
        own = styled.get(entity.number, [])
        for number in own:
            changes += _change(file, number, _STYLES, f"({assigned})")
        if not own:
            item = style.add(f"STYLED_ITEM('',({assigned}),#{int(entity.number)})")
            items.setdefault(entity.shape, []).append(item)
    for shape, new in items.items():
        context = f"#{int(shapes[shape].context)}"  # type: ignore[arg-type]
        style.add(
            "MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION("
            f"'',({','.join(new)}),{context})"
        )
    text = file.text
    for start, end, new_text in sorted(changes, reverse=True):
        text = text[:start] + new_text + text[end:]
    path.write_bytes(appended(Part21(text), style.lines).encode("latin-1"))
    return tuple(face.name for face in facemap.faces if face.name not in found)


class _Styles:
    """Entities to be appended, numbered from ``first``; one style a colour."""

    def __init__(self, first: int) -> None:
        self.lines: list[str] = []
        self._next = first
        self._known: dict[str, str] = {}

    def add(self, body: str) -> str:
        """Append an entity; its reference."""
        number = f"#{self._next}"
        self._next += 1
        self.lines.append(f"{number}={body};")
        return number

    def of(self, name: str, rgb: Rgb) -> str:
        """The style that fills a surface with a colour, on both sides."""
        if name not in self._known:
            shares = ",".join(f"{value / 255:.6f}" for value in rgb)
            colour = self.add(f"COLOUR_RGB({encode(name)},{shares})")
            filled = self.add(f"FILL_AREA_STYLE_COLOUR('',{colour})")
            area = self.add(f"FILL_AREA_STYLE('',({filled}))")
            surface = self.add(f"SURFACE_STYLE_FILL_AREA({area})")
            side = self.add(f"SURFACE_SIDE_STYLE('',({surface}))")
            usage = self.add(f"SURFACE_STYLE_USAGE(.BOTH.,{side})")
            self._known[name] = self.add(f"PRESENTATION_STYLE_ASSIGNMENT(({usage}))")
        return self._known[name]


def _styled_items(file: Part21) -> dict[int, list[int]]:
    """The styled items of each entity that has some."""
    found: dict[int, list[int]] = {}
    for number in file.of(*_STYLED):
        for keyword in _STYLED:
            parameters = file[number].get(keyword, ())
            if len(parameters) > 2 and isinstance(parameters[2], int):
                found.setdefault(int(parameters[2]), []).append(number)
    return found


def _change(
    file: Part21, number: int, what: re.Pattern[str], text: str
) -> list[tuple[int, int, str]]:
    """Start, end and new text of what a pattern captures in an entity; nothing if it isn't there:
    a comment may stand in between."""
    start, end = file.span(number)
    match = what.search(file.text, start, end)
    return [] if match is None else [(match.start(1), match.end(1), text)]
