# SPDX-License-Identifier: LGPL-2.1-or-later
"""PMI appended to files with several bodies and shells, in any unit, and read again."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest
from box_files import UNITS, Box, boxes_solid, boxes_text, every_pmi

from gpswb.errors import InputError
from gpswb.io.ap242.compare import differences
from gpswb.io.ap242.match import match_faces
from gpswb.io.ap242.read_pmi import read_pmi
from gpswb.io.ap242.strings import encode
from gpswb.io.ap242.structure import shapes_of
from gpswb.io.ap242.write import read_text, write_ap242

PAIR = (Box((0, 0, 0), (40, 30, 20)), Box((60, 5, 3), (10, 10, 10)))
HOLLOW = (Box((0, 0, 0), (40, 30, 20)), Box((5, 5, 5), (20, 10, 10), void=True))
EVIL = "<script>alert('x')</script> \\X2\\ \"ä⌀\""
NAMES = [f"Face{i}" for i in (1, 3, 5, 7, 9, 11)]
"""Of both bodies or shells."""
ORDER = [3, 1, 5, 0, 2, 4]


@pytest.mark.parametrize("unit", UNITS)
@pytest.mark.parametrize("boxes", [PAIR, HOLLOW], ids=["two bodies", "two shells"])
def test_what_was_written_is_read_and_nothing_else_was_touched(
    boxes: Sequence[Box], unit: str, tmp_path: Path
) -> None:
    source, out = tmp_path / "in.step", tmp_path / "out.step"
    source.write_text(boxes_text(boxes, unit, ORDER, encode(EVIL)), "latin-1")
    solid = boxes_solid(boxes)
    letters, specified = every_pmi(NAMES)
    wanted = write_ap242(out, read_text(source), solid, letters, specified)
    assert (len(wanted.datums), len(wanted.tolerances), len(wanted.sizes)) == (3, 15, 6)
    file = read_text(out)
    read = read_pmi(file, match_faces(file, shapes_of(file), solid.mesh, solid.facemap))
    assert differences(wanted, read) == []
    deviations = [value for size in read.sizes[:4] for value in (size.lower, size.upper)]
    assert deviations == pytest.approx([-0.1, 0.02, 0.01, 0.03, -0.03, -0.01, 0.0, 0.0])
    before, after = source.read_text("latin-1"), out.read_text("latin-1")
    head, data = before.split("DATA;\n")
    entities = data.split("ENDSEC;")[0]
    assert after.split("DATA;\n")[1].startswith(entities)
    assert after.endswith("ENDSEC;\nEND-ISO-10303-21;\n")
    changed = [a for a, b in zip(head.splitlines(), after.splitlines(), strict=False) if a != b]
    assert [line.partition("(")[0] for line in changed] == ["FILE_SCHEMA"]
    (product,) = file.of("PRODUCT")
    assert file[product]["PRODUCT"][0] == EVIL


def test_differences_are_found(tmp_path: Path) -> None:
    """The comparison that guards every export must see each kind of loss."""
    source, out = tmp_path / "in.step", tmp_path / "out.step"
    source.write_text(boxes_text(PAIR), "latin-1")
    solid = boxes_solid(PAIR)
    letters, specified = every_pmi(NAMES)
    wanted = write_ap242(out, read_text(source), solid, letters, specified)
    text = out.read_text("latin-1")
    for old, new in (
        ("FLATNESS_TOLERANCE", "ROUNDNESS_TOLERANCE"),
        ("LENGTH_MEASURE(0.011)", "LENGTH_MEASURE(0.012)"),
        ("LENGTH_MEASURE(-0.1)", "LENGTH_MEASURE(0.1)"),
        (".MAXIMUM_MATERIAL_REQUIREMENT.", ".LEAST_MATERIAL_REQUIREMENT."),
        ("SIMPLE_DATUM_REFERENCE_MODIFIER(.ORIENTATION.)", ""),
        ("'H','hole','7'", "'G','hole','7'"),
        (",.F.,'C')", ",.F.,'D')"),
    ):
        assert old in text
        out.write_text(text.replace(old, new, 1), "latin-1")
        file = read_text(out)
        read = read_pmi(file, match_faces(file, shapes_of(file), solid.mesh, solid.facemap))
        assert differences(wanted, read), old


def test_what_can_not_be_attached_is_refused(tmp_path: Path) -> None:
    source, out = tmp_path / "in.step", tmp_path / "out.step"
    source.write_text(boxes_text(PAIR), "latin-1")
    far = boxes_solid([Box((900, 0, 0), (1, 2, 3)), Box((990, 0, 0), (1, 2, 3))])
    letters, specified = every_pmi(NAMES)
    with pytest.raises(InputError, match="no B-rep face that PMI could be attached to"):
        write_ap242(out, read_text(source), far, letters, specified)
    assert not out.exists()
