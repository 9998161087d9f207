# SPDX-License-Identifier: LGPL-2.1-or-later
"""OCCT's own reader finds the PMI that was appended, in any unit, on several bodies and shells."""

from pathlib import Path

import cadquery as cq
import pytest
from box_files import every_pmi
from parts.step_units import Unit, write_step

from gpswb.cad.density import Density
from gpswb.cad.pmi_read import read_pmi_ocp
from gpswb.cad.read import read_solid
from gpswb.io.ap242.compare import differences
from gpswb.io.ap242.write import read_text, write_ap242

BOX = cq.Workplane().box(40, 30, 20)
NAMES = {
    "an assembly": [f"Face{i}" for i in range(7, 13)],
    "two shells": [f"Face{i}" for i in (1, 3, 5, 7, 9, 11)],
}
SHAPES = {
    "an assembly": cq.Compound.makeCompound(
        [BOX.val(), cq.Workplane().box(10, 10, 10).translate((60, 5, 3)).val()]
    ),
    "two shells": BOX.cut(cq.Workplane().box(20, 10, 8)).val(),
}


@pytest.mark.parametrize("unit", ["MM", "M", "INCH"])
@pytest.mark.parametrize("name", SHAPES)
def test_types_values_letters_and_faces_are_equal(name: str, unit: Unit, tmp_path: Path) -> None:
    source, out = tmp_path / "in.step", tmp_path / "out.step"
    write_step(SHAPES[name], source, unit)
    solid = read_solid(source, Density("stl"))
    assert len(solid.facemap.faces) == 12
    letters, specified = every_pmi(NAMES[name])
    wanted = write_ap242(out, read_text(source), solid, letters, specified)
    assert differences(wanted, read_pmi_ocp(out), occt=True) == []
