# SPDX-License-Identifier: LGPL-2.1-or-later
"""Append semantic PMI to a STEP file: its own lines stay as they are, but FILE_SCHEMA."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from gpswb.cad.pmi import Pmi
from gpswb.cad.solid import Solid
from gpswb.errors import InputError
from gpswb.gps.specified import GeometricalTolerance, Letters, Specified
from gpswb.io.ap242.compare import pmi_of
from gpswb.io.ap242.entities import Entities
from gpswb.io.ap242.match import match_faces
from gpswb.io.ap242.part21 import Part21
from gpswb.io.ap242.structure import shapes_of

_SCHEMA = (
    "FILE_SCHEMA(('AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF { 1 0 10303 442 1 1 4 }'));"
)
_MOST_BYTES = 500_000_000


def read_text(path: Path) -> Part21:
    """The text of a STEP file.

    Raises:
        InputError: it can't be read, or isn't one.
    """
    try:
        if path.stat().st_size > _MOST_BYTES:
            raise InputError(f"{path}: larger than {_MOST_BYTES} bytes")
        data = path.read_bytes()
    except OSError as error:
        raise InputError(f"{path}: can't be read ({error.strerror})") from None
    try:
        return Part21(data.decode("latin-1"))
    except InputError as error:
        raise InputError(f"{path}: {error}") from None


def check_letters(file: Part21, letters: Iterable[str], source: str) -> None:
    """Refuse datum letters that a STEP file has.

    Raises:
        InputError: ``source`` has one of the letters.
    """
    present = {str(file[number]["DATUM"][-1]) for number in file.of("DATUM")}
    for letter in letters:
        if letter in present:
            raise InputError(f"{source}: the file has a datum {letter} already")


def write_ap242(
    path: Path, file: Part21, solid: Solid, letters: Letters, specified: Sequence[Specified]
) -> Pmi:
    """Write the file with datums and tolerances appended; values still open are left out.

    Args:
        file: the text that ``solid`` was read from.
        letters: datum features.
        specified: geometrical and size tolerances.

    Returns:
        What was written, as a reader should find it.

    Raises:
        InputError: there is no B-rep; a face isn't found in the text; the file has PMI with one of
            these letters; the features belong to several parts of an assembly.
        OSError: the file can't be written.
    """
    if solid.facemap is None or file.schema is None:
        raise InputError(f"{solid.source}: PMI can be appended to STEP files with a B-rep only")
    check_letters(file, letters, solid.source)
    shapes = shapes_of(file)
    faces = match_faces(file, shapes, solid.mesh, solid.facemap)
    if not faces:
        raise InputError(
            f"{solid.source}: its text holds no B-rep face that PMI could be attached to (geometry "
            "that is only tessellated has none)"
        )
    entities = Entities(file.highest + 1, shapes, faces)
    for letter, features in letters.items():
        entities.datum(letter, features)
    for each in specified:
        if each.open:
            continue
        if isinstance(each, GeometricalTolerance):
            entities.tolerance(each)
        else:
            entities.size(each)
    path.write_bytes(appended(file, entities.lines).encode("latin-1"))
    return pmi_of(letters, specified, faces)


def appended(file: Part21, lines: Sequence[str]) -> str:
    """The text with entities at the end of its data and, where it isn't AP242, a new schema."""
    text, newline = file.text, "\r\n" if "\r\n" in file.text else "\n"
    head, tail = text[: file.data_end], text[file.data_end :]
    if file.schema is not None:
        start, stop = file.schema
        if "AP242" not in text[start:stop].upper():
            head = head[:start] + _SCHEMA + head[stop:]
    if not head.endswith(("\n", "\r")):
        head += newline
    return head + newline.join(lines) + newline + tail
