# SPDX-License-Identifier: LGPL-2.1-or-later
"""Near-uniform meshes: gmsh's, and what happens where gmsh fails."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import kernel_parts
import numpy as np
import pytest
from mesh_checks import open_sides, sides, volume

from gpswb.cad import gmsh_mesher
from gpswb.cad.density import Density
from gpswb.cad.read import read_solid
from gpswb.errors import InputError, KernelError


def test_sides_have_the_length_asked_for(tmp_path: Path) -> None:
    solid = read_solid(kernel_parts.write("drilled", tmp_path), Density.parse("edge=0.8"))
    assert solid.mesher == "gmsh"
    assert solid.notes == ()
    length = sides(solid.mesh)
    assert np.median(length) == pytest.approx(0.8, rel=0.1)
    assert length.std() / length.mean() < 0.2


@pytest.mark.parametrize(("preset", "fraction"), [("coarse", 30), ("medium", 60), ("fine", 120)])
def test_presets_go_by_the_diagonal_and_the_curvature(
    preset: str, fraction: int, tmp_path: Path
) -> None:
    solid = read_solid(kernel_parts.write("drilled", tmp_path), Density.parse(preset))
    longest = sides(solid.mesh).max()
    assert longest < 1.9 * solid.mesh.diagonal / fraction
    assert solid.facemap is not None
    hole = next(
        i for i, f in enumerate(solid.facemap.faces) if f.truth and f.truth.surface == "Cylinder"
    )
    rim = solid.mesh.vertices[
        np.unique(solid.mesh.triangles[solid.facemap.face_of_triangle == hole])
    ]
    assert (rim[:, 2] > 10 - 1e-9).sum() >= 12


def test_count_of_vertices_over_several_bodies(tmp_path: Path) -> None:
    solid = read_solid(kernel_parts.write("two", tmp_path), Density.parse("vertices=3000"))
    assert len(solid.mesh.vertices) == pytest.approx(3000, rel=0.15)
    assert open_sides(solid.mesh) == 0
    assert volume(solid.mesh) == pytest.approx(2000)


def test_a_body_that_gmsh_fails_on_is_refined_instead(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real, calls = gmsh_mesher.run_isolated, []

    def once(function: str, args: list[Any], timeout_s: float) -> Any:
        calls.append(function)
        if len(calls) == 1:
            raise KernelError("no result within 1 s")
        return real(function, args, timeout_s)

    monkeypatch.setattr(gmsh_mesher, "run_isolated", once)
    solid = read_solid(kernel_parts.write("two", tmp_path), Density.parse("edge=1"))
    assert solid.mesher == "brepmesh+refine and gmsh"
    assert len(solid.notes) == 1
    assert solid.notes[0].startswith("solid 1: no result within 1 s")
    assert open_sides(solid.mesh) == 0
    assert volume(solid.mesh) == pytest.approx(2000)
    assert solid.facemap is not None
    first = np.array([f.solid for f in solid.facemap.faces])[solid.facemap.face_of_triangle] == 0
    # Both bodies are the same box: both meshers give about the same number of triangles.
    assert first.sum() == pytest.approx((~first).sum(), rel=0.25)


def test_a_hopeless_edge_length_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="would make about"):
        read_solid(kernel_parts.write("drilled", tmp_path), Density.parse("edge=0.0001"))
