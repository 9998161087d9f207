# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curvature across edges: closed forms where arcs meet, and none inside a smooth surface."""

from __future__ import annotations

import numpy as np
import pytest
from analytic_meshes import sheet
from known_surfaces import Frame
from scipy.interpolate import CubicSpline

from gpswb.core.mesh import BoolArray, FloatArray, IntArray, Mesh
from gpswb.core.robust import trials
from gpswb.core.robust.curvature_jumps import BORDER, curvature_jumps
from gpswb.core.robust.growth import Grown, fit_facets
from gpswb.core.robust.hypotheses import Explained, explain
from gpswb.core.robust.jump_memory import JumpMemory
from gpswb.core.robust.patches import Patches
from gpswb.core.robust.reclaim import reclaim
from gpswb.core.robust.rejoin import rejoin
from gpswb.core.robust.smooth_parts import smooth_parts
from gpswb.core.robust.topology import FacetGraph
from gpswb.core.robust.unbroken import unbroken_parts

FACETS = 48
"""Facets along the profile, half of them on either side of its middle."""


def arcs(first: float, second: float, seed: int = 0) -> Mesh:
    """Two tangent cylinders of these curvatures (1/mm), 12 mm of arc each, 10 mm wide, posed."""
    frame = Frame(seed)

    def along(s: FloatArray, curvature: float) -> FloatArray:
        if curvature == 0.0:
            return np.column_stack([s, 0.0 * s])
        return np.column_stack([np.sin(curvature * s), 1.0 - np.cos(curvature * s)]) / curvature

    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        s = 24.0 * u - 12.0
        profile = np.where((s < 0.0)[:, None], along(s, first), along(s, second))
        return frame.point(np.column_stack([profile, 10.0 * v]))

    return sheet(surface, FACETS, 16)


def wave(u: FloatArray, v: FloatArray) -> FloatArray:
    """A freeform sheet of 24 mm, its curvatures everywhere different and smooth."""
    x, y = 24.0 * u, 24.0 * v
    return np.column_stack([x, y, 2.0 * np.sin(0.2 * x + 0.1 * y) + 0.02 * x * y])


def jumps(mesh: Mesh) -> tuple[FloatArray, BoolArray, FloatArray]:
    """Jump and whether none is seen for every interior edge, and where its middle lies, u."""
    graph = FacetGraph.of(mesh)
    edges = np.arange(len(graph.pairs))
    jump, none = curvature_jumps(mesh, graph, edges, graph.smooth)
    u = (graph.pair_edges // 17).mean(axis=1) / FACETS
    return jump, none, u


@pytest.mark.parametrize(("first", "second"), [(0.1, 0.0), (0.1, 0.05), (0.1, -0.1), (0.04, 0.1)])
def test_a_jump_is_that_of_the_curvatures_over_the_larger(first: float, second: float) -> None:
    mesh = arcs(first, second)
    jump, none, u = jumps(mesh)
    lengthwise = u == 0.5
    expected = abs(first - second) / max(abs(first), abs(second))
    inner = np.sort(jump[lengthwise])[2:]  # the ends of the border know less
    assert np.median(inner) == pytest.approx(expected, abs=0.03)
    assert none[lengthwise].mean() < 0.2


@pytest.mark.parametrize("seed", range(3))
def test_inside_a_smooth_surface_there_is_none(seed: int) -> None:
    jump, none, _ = jumps(arcs(0.1, 0.1, seed))
    assert jump.max() < 0.05
    assert none.mean() > 0.9
    freeform = sheet(wave, FACETS, 48)
    graph = FacetGraph.of(freeform)
    edges = np.arange(len(graph.pairs))
    jump, none = curvature_jumps(freeform, graph, edges, graph.smooth)
    assert np.quantile(jump, 0.99) < BORDER
    assert none.mean() > 0.7


def halves(mesh: Mesh) -> BoolArray:
    """Facets of the second half of the profile."""
    second: BoolArray = (mesh.triangles // 17).mean(axis=1) > FACETS / 2
    return second


def parts(mesh: Mesh) -> IntArray:
    """Parts of a mesh all of which hangs together."""
    graph = FacetGraph.of(mesh)
    all_ = np.ones(len(graph.pairs), dtype=bool)
    return smooth_parts(mesh, graph, all_, JumpMemory(mesh, graph))[0]


@pytest.mark.parametrize("second", [0.05, 0.0, -0.1])
def test_parts_end_where_curvature_jumps(second: float) -> None:
    mesh = arcs(0.1, second)
    part = parts(mesh)
    assert len(np.unique(part)) == 2
    assert np.array_equal(part == part[-1], halves(mesh))


@pytest.mark.parametrize(
    ("first", "second", "whole"),
    [(0.1, 0.1, True), (0.1, 0.08, False), (0.1, 0.0, False), (0.1, -0.1, False)],
)
def test_a_part_is_of_one_face_where_no_border_is_in_it(
    first: float, second: float, whole: bool
) -> None:
    mesh = arcs(first, second)
    graph = FacetGraph.of(mesh)
    part = np.zeros(len(mesh.triangles), dtype=np.int64)
    part[:100] = 1  # not asked about
    asked = np.array([True, False])
    found = unbroken_parts(mesh, graph, part, graph.smooth, asked)
    assert found.tolist() == [whole, False]


def test_jumps_are_sought_again_where_something_has_changed_around() -> None:
    mesh = arcs(0.1, 0.05)
    graph = FacetGraph.of(mesh)
    jumps = JumpMemory(mesh, graph)
    joined = np.ones(len(graph.pairs), dtype=bool)
    jumps.across(joined)
    # A hole in the middle of the border, and two pairs less that are anywhere.
    joined[
        (np.abs(mesh.centroids[graph.pairs] - mesh.centroids.mean(axis=0)) < 2.0).all((1, 2))
    ] = 0
    joined[[5, 900]] = False
    for now in (joined, ~joined, np.ones_like(joined)):
        jump, none = jumps.across(now)
        again, none_again = curvature_jumps(mesh, graph, np.flatnonzero(now), now)
        assert jump == pytest.approx(again, abs=1e-9)
        assert np.array_equal(none, none_again)


def test_of_a_coarse_part_nothing_is_said() -> None:
    mesh = sheet(wave, 8, 8)
    graph = FacetGraph.of(mesh)
    part = np.zeros(len(mesh.triangles), dtype=np.int64)
    assert not unbroken_parts(mesh, graph, part, graph.smooth, np.array([True])).any()


def test_a_part_is_fitted_once_however_wide_the_tolerance(monkeypatch: pytest.MonkeyPatch) -> None:
    mesh = sheet(wave, FACETS, 48)
    asked = []

    def counted(mesh: Mesh, patches: Patches, size: IntArray, tolerance: float) -> Explained:
        asked.append(len(size))
        return explain(mesh, patches, size, tolerance)

    monkeypatch.setattr(trials, "explain", counted)
    fits = trials.Trials(mesh)
    facets = np.arange(0, len(mesh.triangles), 100)[None]
    size = np.array([len(mesh.triangles)])
    first = fits.of(facets, size, 1e-6)
    left = float(first.residual[0])
    assert first.fresh[0]
    assert left > 1e-3  # the wave is on no surface
    again = fits.of(facets, size, 0.9 * left)
    assert not again.fresh[0]
    assert again.residual[0] == left
    assert asked == [1]
    assert fits.of(facets, size, 1.1 * left).fresh[0]


def test_a_smooth_face_is_one_part() -> None:
    for mesh in (arcs(0.1, 0.1), arcs(0.1, 0.08), sheet(wave, FACETS, 48)):
        assert len(np.unique(parts(mesh))) == 1


def test_an_exact_cylinder_takes_back_what_a_rough_neighbour_has_taken() -> None:
    mesh = arcs(0.1, 0.05)
    graph = FacetGraph.of(mesh)
    row = (mesh.triangles // 17).mean(axis=1)
    exact = Grown("cylinder", fit_facets(mesh, "cylinder", np.flatnonzero(row < 20)), np.zeros(0))
    exact = Grown("cylinder", exact.surface, np.flatnonzero(row < 20))
    # A cylinder that fits the other half roughly, and four rows of the first half with it.
    rough = np.flatnonzero(row > 20)
    surface = fit_facets(mesh, "cylinder", rough)
    flat = np.zeros(len(mesh.triangles), dtype=bool)
    found = reclaim(mesh, graph, [exact, Grown("cylinder", surface, rough)], flat, 1e-6)
    first = next(g for g in found if np.array_equal(g.surface, exact.surface))
    assert np.array_equal(np.sort(first.facets), np.flatnonzero(~halves(mesh)))


def test_pieces_of_a_spline_that_stands_for_a_circle_are_joined() -> None:
    # Eight knots on a quarter of a circle R10: its pieces fit circles of their own better.
    angle = np.linspace(0.0, np.pi / 2.0, 8)
    spline = CubicSpline(angle, 10.0 * np.column_stack([np.cos(angle), np.sin(angle)]))

    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        return np.column_stack([spline(u * np.pi / 2.0), 10.0 * v])

    mesh = sheet(surface, FACETS, 16)
    graph = FacetGraph.of(mesh)
    row = (mesh.triangles // 17).mean(axis=1)

    def pieces(mesh: Mesh) -> list[Grown]:
        found = []
        for start in range(0, FACETS, 12):
            facets = np.flatnonzero((row > start) & (row < start + 12))
            found.append(Grown("cylinder", fit_facets(mesh, "cylinder", facets), facets))
        return found

    (whole,) = rejoin(mesh, graph, pieces(mesh), 1e-9)
    assert len(whole.facets) == len(mesh.triangles)
    assert whole.surface[6] == pytest.approx(10.0, abs=5e-3)
    # Two tangent cylinders stay two, though each was cut in two.
    assert len(rejoin(arcs(0.1, 0.05), graph, pieces(arcs(0.1, 0.05)), 1e-9)) == 2
