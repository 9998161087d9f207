# SPDX-License-Identifier: LGPL-2.1-or-later
"""The example parts as whichever kernel this Python has reads them."""

from __future__ import annotations

import importlib.util
from collections import Counter
from pathlib import Path

from gpswb.cad.density import Density
from gpswb.cad.read import read_solid
from gpswb.cad.solid import FaceMap, Solid
from gpswb.core.mesh import Mesh
from gpswb.core.pipeline import partition
from gpswb.validation.validate import validate

IN_FREECAD = importlib.util.find_spec("FreeCAD") is not None
BUILT = Path(__file__).parents[2] / "build" / "examples"

KNOWN: dict[str, dict[str, int]] = {
    "sphere_cube": {"planar": 6, "spherical": 1},
    "simple_part": {"planar": 10, "cylindrical": 9},
    "revolution_part": {"planar": 3, "cylindrical": 3, "revolute": 4},
    "bracket": {"planar": 24, "cylindrical": 17, "revolute": 2},
    "multi_solid": {"planar": 8, "cylindrical": 2, "spherical": 1},
    "thread": {"helical": 2, "cylindrical": 2, "planar": 2},
}
"""Number of faces of each class, by construction; each face is a feature of its own."""


def step_file(name: str, folder: Path, nurbs: bool = False) -> Path:
    """A STEP file of the part; ``nurbs`` makes a B-spline of every surface and curve.

    FreeCAD's Python can't run the scripts that build the parts: `./gps test` has run them before.
    """
    path = folder / f"{name}.step"
    if IN_FREECAD:
        if not nurbs:
            return BUILT / f"{name}.step"
        import Part

        shape = Part.Shape()
        shape.read(str(BUILT / f"{name}.step"))
        shape.toNurbs().exportStep(str(path))
        return path
    from parts import PARTS
    from parts.step_units import write_step

    part = PARTS[name]()
    write_step((part.nurbs_twin() if nurbs else part).shape, path)
    return path


def read(path: Path, density: str) -> tuple[Solid, FaceMap]:
    solid = read_solid(path, Density.parse(density), "freecad" if IN_FREECAD else "ocp")
    assert solid.facemap is not None
    return solid, solid.facemap


def classes(mesh: Mesh, facemap: FaceMap) -> list[str | None]:
    """The class that the default mode finds for each face."""
    return [face.invariance_class for face in validate(partition(mesh), facemap).faces]


def expect_all_right(name: str, mesh: Mesh, facemap: FaceMap) -> None:
    """Every face has its class, and the regions are the features."""
    found = partition(mesh)
    judged = validate(found, facemap)
    wrong = [(f.name, f.true_class, f.invariance_class) for f in judged.faces if not f.agrees]
    assert wrong == []
    assert judged.face_accuracy == 1.0
    assert Counter(f.invariance_class for f in judged.faces) == KNOWN[name]
    assert len(found.regions) == sum(KNOWN[name].values())
    assert judged.region_f1 == 1.0
