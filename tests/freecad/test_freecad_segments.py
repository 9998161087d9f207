# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's own segmentation, from the part to the figures that the comparison shows."""

import math

import FreeCAD  # noqa: F401 - before Part
import Part
import pytest
from benchmark_modules import benchmark_module

from gpswb.cad.density import Density
from gpswb.cad.read import read_solid
from gpswb.validation.validate import validate

RADIUS, HEIGHT = 5.0, 12.0
CAPS = 2 * math.pi * RADIUS**2
WHOLE = CAPS + 2 * math.pi * RADIUS * HEIGHT


@pytest.fixture(scope="module")
def segments():
    return benchmark_module("segments")


@pytest.fixture(scope="module")
def cylinder(tmp_path_factory):
    path = tmp_path_factory.mktemp("segments") / "cylinder.step"
    Part.makeCylinder(RADIUS, HEIGHT).exportStep(str(path))
    return read_solid(path, Density.parse("edge=0.4"), "freecad")


def judged(segments, solid, call):
    partition, seconds = segments.freecad_partition(solid, call, 0.01, 100, 60.0)
    assert seconds >= 0.0
    return validate(partition, solid.facemap)


def test_planes_are_the_caps(segments, cylinder):
    result = judged(segments, cylinder, "planar")
    assert result.face_accuracy == pytest.approx(2 / 3)
    assert result.area_accuracy == pytest.approx(CAPS / WHOLE, abs=0.01)
    assert result.found == 2


def test_cylinder_is_found_by_its_radius(segments, cylinder):
    assert segments.true_radii(cylinder) == [RADIUS]
    by_name = {f.name: f for f in judged(segments, cylinder, "curvature").faces}
    (side,) = [f for f in by_name.values() if f.surface == "Cylinder"]
    assert side.invariance_class == "cylindrical"
    # At a sharp edge FreeCAD's curvature is not that of the face: a row of facets is lost.
    assert 0.5 < side.share < 1.0


def test_failure_is_no_result(segments, cylinder):
    with pytest.raises(ChildProcessError, match="FreeCAD ended with"):
        segments.freecad_partition(cylinder, "unknown", 0.01, 100, 60.0)
