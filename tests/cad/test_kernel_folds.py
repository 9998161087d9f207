# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes on which a mesh folds over itself easily: poles, apexes, thin rings, thin blades."""

from __future__ import annotations

from pathlib import Path

import folding_parts
import numpy as np
import pytest

from gpswb.cad.defects import Defects, find_defects
from gpswb.cad.density import Density
from gpswb.cad.faced import FacedMesh
from gpswb.cad.read import read_solid

SOUND = Defects(flat=0, folded=0, single=0, crowded=0)


@pytest.mark.parametrize("density", ["auto", "turn=8", "turn=48"])
@pytest.mark.parametrize("name", folding_parts.NAMES)
def test_refined_mesh_has_no_defect(name: str, density: str, kernel: str, tmp_path: Path) -> None:
    solid = read_solid(folding_parts.write(name, tmp_path), Density.parse(density), kernel)
    assert solid.facemap is not None
    face = solid.facemap.face_of_triangle
    assert find_defects(FacedMesh(solid.mesh.vertices, solid.mesh.triangles, face)) == SOUND
    assert set(face.tolist()) == set(range(len(solid.facemap.faces)))


@pytest.mark.parametrize("name", folding_parts.NAMES)
def test_facets_cover_each_face_once(name: str, kernel: str, tmp_path: Path) -> None:
    solid = read_solid(folding_parts.write(name, tmp_path), Density.parse("turn=48"), kernel)
    assert solid.facemap is not None
    area = np.bincount(solid.facemap.face_of_triangle, solid.mesh.areas)
    # Chords of 7.5 degrees fall short of their arcs by 0.07 %; a fold counts its area three times.
    for found, face in zip(area, solid.facemap.faces, strict=True):
        assert found == pytest.approx(face.area, rel=0.02)


def test_same_mesh_twice(kernel: str, tmp_path: Path) -> None:
    path = folding_parts.write("spindle", tmp_path)
    first, second = (read_solid(path, Density.parse("auto"), kernel).mesh for _ in range(2))
    np.testing.assert_array_equal(first.vertices, second.vertices)
    np.testing.assert_array_equal(first.triangles, second.triangles)
