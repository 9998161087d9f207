# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces of one surface on a mesh that is too coarse to show how it curves: borders tell."""

from __future__ import annotations

import numpy as np
import pytest
from analytic_meshes import TURN, sheet

from gpswb.core.initial import initial_partition
from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.core.reference import Reference
from gpswb.core.robust.one_face import join_faces
from gpswb.core.robust.orbits import leaves_orbits
from gpswb.core.robust.topology import FacetGraph
from gpswb.core.stages import StageClock
from gpswb.core.tolerances import Tolerances

AROUND, ROWS = 60, 2


def turned(around: int = AROUND) -> Mesh:
    """Three rings of so many vertices of a turned face that turns by 0.15 rad at the middle one."""

    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        angle, z = TURN * u, 4.0 * (v - 0.5)
        rho = 20.0 + np.where(z > 0.0, np.tan(0.15), 0.0) * z
        return np.column_stack([rho * np.cos(angle), rho * np.sin(angle), z])

    return sheet(surface, around, ROWS, closed=True)


def extruded() -> Mesh:
    """A profile whose second half is straight, drawn along the first axis in two rows."""

    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        s = 6.0 * (u - 0.5)
        return np.column_stack([8.0 * v, s, np.where(s < 0.0, 0.02 * s**4, 0.0)])

    return sheet(surface, AROUND, ROWS)


def joined(mesh: Mesh, label: IntArray, sure: IntArray | None = None) -> int:
    """Number of regions after ``label`` is joined; the facets ``sure`` are certain planes."""
    tolerances = Tolerances(form=Tolerances().distance)
    first = initial_partition(mesh, 0.0, tolerances, StageClock(None))
    planes = np.isin(np.arange(len(label)), [] if sure is None else sure)
    graph = FacetGraph.of(mesh)
    out = join_faces(mesh, graph, first, label, {}, planes, 0.0, tolerances)
    return len(np.unique(out))


def column_of(mesh: Mesh) -> IntArray:
    """(m,) place of each facet along the first direction of its sheet."""
    half = np.arange(len(mesh.triangles)) % (AROUND * ROWS)
    column: IntArray = half // ROWS
    return column


def row_of(mesh: Mesh) -> IntArray:
    """(m,) place of each facet along the second direction."""
    return np.arange(len(mesh.triangles)) % ROWS


def test_a_border_along_a_meridian_is_none() -> None:
    # Half of the face whole, the other half cut at its middle ring.
    mesh = turned()
    label = np.where(column_of(mesh) < AROUND // 2, 0, 1 + row_of(mesh))
    assert joined(mesh, label) == 1


@pytest.mark.parametrize(("around", "told"), [(20, True), (300, False)])
def test_one_edge_tells_of_small_regions_only(around: int, told: bool) -> None:
    # Two halves of one face: all their border tells, one edge of it is a touch of large regions.
    mesh = turned(around)
    half = (mesh.centroids[:, 1] > 0.0).astype(np.int64)
    border = np.flatnonzero(FacetGraph.of(mesh).borders(half))
    axis = Reference(np.zeros(3), np.array([0.0, 0.0, 1.0]))
    across = np.abs(np.diff(mesh.vertices[mesh.pair_edges[border]], axis=1)[:, 0, 2])
    one = border[[across.argmax()]]
    assert leaves_orbits(mesh, border, half, (0, 1), "revolute", axis)
    assert leaves_orbits(mesh, one, half, (0, 1), "revolute", axis) == told


def test_coaxial_faces_meet_along_a_parallel() -> None:
    mesh = turned()
    assert joined(mesh, row_of(mesh)) == ROWS


def test_a_plane_that_an_extrusion_leaves_across_its_direction_is_part_of_it() -> None:
    # Flat facets of one of the two rows: beside them the profile is as straight.
    mesh = extruded()
    flat = (column_of(mesh) > AROUND // 2 + 3) & (row_of(mesh) == 0)
    assert joined(mesh, flat.astype(np.int64), np.flatnonzero(flat)) == 1


def test_a_plane_beside_an_extrusion_stays() -> None:
    mesh = extruded()
    flat = column_of(mesh) >= AROUND // 2
    assert joined(mesh, flat.astype(np.int64), np.flatnonzero(flat)) == 2
