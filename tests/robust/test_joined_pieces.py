# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces of one smooth face are joined; what only touches it is not."""

from __future__ import annotations

import numpy as np
import pytest
from analytic_meshes import TURN, sheet

from gpswb.core.initial import initial_partition
from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.core.robust.evidence import holds_inside
from gpswb.core.robust.growth import Grown, fit_facets
from gpswb.core.robust.one_face import join_faces
from gpswb.core.robust.rejoin import rejoin
from gpswb.core.robust.topology import FacetGraph
from gpswb.core.stages import StageClock
from gpswb.core.tolerances import Tolerances

ROWS, COLUMNS = 120, 4


def row_of(mesh: Mesh) -> FloatArray:
    """(m,) row of each facet of a sheet of ``COLUMNS`` columns, from 0 to ``ROWS``."""
    row: FloatArray = (mesh.triangles // (COLUMNS + 1)).mean(axis=1)
    return row


def joined(mesh: Mesh, label: IntArray, *names: InvarianceClass) -> list[int]:
    """Sizes of the regions after labels of known classes, or of one, were joined."""
    tolerances = Tolerances(form=Tolerances().distance)
    first = initial_partition(mesh, 0.0, tolerances, StageClock(None))
    used = np.unique(label).tolist()
    known = dict(zip(used, names * (len(used) // len(names)), strict=True)) if names else {}
    sure = np.zeros(len(label), dtype=bool)
    out = join_faces(mesh, FacetGraph.of(mesh), first, label, known, sure, 0.0, tolerances)
    return sorted(np.unique(out, return_counts=True)[1].tolist())


def test_pieces_of_a_helical_band_that_pass_for_tori_are_one_face() -> None:
    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        angle, s = TURN * 0.25 * u, v - 0.5
        rho = 20.0 + 0.3 * s + 0.1 * s * s
        return np.column_stack([rho * np.cos(angle), rho * np.sin(angle), 15.0 * u + 0.95 * s])

    mesh = sheet(surface, ROWS, COLUMNS)
    label = (row_of(mesh) // 10).astype(np.int64)
    assert joined(mesh, label, "revolute") == [len(label)]


def test_a_cylinder_beside_a_torus_that_hardly_leaves_it_stays() -> None:
    # Curvature jumps by a tenth only, and both have one axis: R5, and a tube of R50 behind it.
    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        angle, z = TURN * u, 12.0 * v - 3.0
        beyond = np.maximum(z, 0.0)
        rho = 5.0 - (50.0 - np.sqrt(50.0**2 - beyond**2))
        return np.column_stack([rho * np.cos(angle), rho * np.sin(angle), z])

    mesh = sheet(surface, 60, 24, closed=True)
    label = (mesh.centroids[:, 2] > 0.0).astype(np.int64)
    quarter = len(label) // 4
    assert joined(mesh, label, "cylindrical", "revolute") == [quarter, 3 * quarter]
    # Where nothing is known of them, they have one symmetry together.
    assert joined(mesh, label) == [4 * quarter]


def test_a_cylinder_beside_a_tangent_one_stays() -> None:
    # A quarter of R10 and then of R5: coaxial in nothing, parallel, and prismatic together.
    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        turn = np.pi * u
        first = np.minimum(turn, np.pi / 2.0)
        rest = np.maximum(turn - np.pi / 2.0, 0.0)
        x = 10.0 * np.cos(first) - 5.0 * np.sin(rest)
        y = 10.0 * np.sin(first) - 5.0 * (1.0 - np.cos(rest))
        return np.column_stack([x, y, 8.0 * v])

    mesh = sheet(surface, ROWS, COLUMNS)
    label = (row_of(mesh) > ROWS / 2).astype(np.int64)
    assert joined(mesh, label, "cylindrical") == [ROWS * COLUMNS] * 2


@pytest.mark.parametrize(("ramp", "count"), [(0.0, 1), (4e-3, 2)])
def test_an_exact_cylinder_takes_only_what_lies_on_it(ramp: float, count: int) -> None:
    # Three quarters of the band are a cylinder; the rest is known to 1e-4 only, and leaves it.
    rng = np.random.default_rng(4)

    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        beyond = np.maximum(u - 0.751, 0.0) / 0.249
        rho = 10.0 + ramp * beyond + 1e-4 * rng.uniform(-1.0, 1.0, len(u)) * (beyond > 0.0)
        return np.column_stack([rho * np.cos(2.0 * u), rho * np.sin(2.0 * u), 3.0 * v])

    mesh = sheet(surface, ROWS, COLUMNS)
    sides = [np.flatnonzero(row_of(mesh) < 90), np.flatnonzero(row_of(mesh) > 90)]
    found = [Grown("cylinder", fit_facets(mesh, "cylinder", facets), facets) for facets in sides]
    assert len(rejoin(mesh, FacetGraph.of(mesh), found, 1e-9)) == count


def test_mitred_cylinders_stay_two_though_half_their_vertices_are_common() -> None:
    # R10 about x and about y, that meet in the plane x = y: strips without inner vertices.
    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        angle = np.pi / 2.0 * (1.0 - 0.15 * u)
        c, s = 10.0 * np.cos(angle), 10.0 * np.sin(angle)
        return np.column_stack([np.where(v < 0.25, -20.0, c), np.where(v > 0.75, -20.0, c), s])

    mesh = sheet(surface, 30, 2)
    first = mesh.centroids[:, 0] < mesh.centroids[:, 1]
    sides = [np.flatnonzero(first), np.flatnonzero(~first)]
    found = [Grown("cylinder", fit_facets(mesh, "cylinder", facets), facets) for facets in sides]
    assert FacetGraph.of(mesh).smooth.all()
    assert len(rejoin(mesh, FacetGraph.of(mesh), found, 1e-9)) == 2


@pytest.mark.parametrize(("rim", "inside", "held"), [(5e-3, 0.0, True), (0.0, 5e-3, False)])
def test_only_vertices_of_edges_may_be_off_by_more(rim: float, inside: float, held: bool) -> None:
    rng = np.random.default_rng(2)

    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        edge = (np.abs(v - 0.5) > 0.49) | (np.abs(u - 0.5) > 0.4999)
        rho = 10.0 + np.where(edge, rim, inside) * rng.uniform(-1.0, 1.0, len(u))
        return np.column_stack([rho * np.cos(2.0 * u), rho * np.sin(2.0 * u), 30.0 * v])

    mesh = sheet(surface, 40, 12)
    facets = np.arange(len(mesh.triangles))
    cylinder = Grown("cylinder", np.array([0.0, 0, 0, 0, 0, 1, 10, 0]), facets)
    graph, tolerance = FacetGraph.of(mesh), 2e-4 * mesh.diagonal
    assert holds_inside(mesh, graph, cylinder, tolerance) is held
