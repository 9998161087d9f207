# SPDX-License-Identifier: LGPL-2.1-or-later
import numpy as np
import pytest
from analytic_meshes import box, capped_cylinder, cylinder, plane, samples, sphere

from gpswb.core.mesh import Mesh
from gpswb.core.patches import equal_patches
from gpswb.core.pipeline import Method, Mode, partition
from gpswb.core.rival_curvature import class_by_table
from gpswb.core.rival_slippage import class_by_signature, partition_by_slippage
from gpswb.core.slippage import slippage_moments
from gpswb.core.stages import StageClock
from gpswb.core.tolerances import PaperSettings
from gpswb.errors import InputError

FLOWS: list[tuple[Mode, Method]] = [
    ("corrected", "hybrid"), ("paper", "hybrid"), ("robust", "curvature"), ("robust", "slippage"),
]  # fmt: skip


@pytest.mark.parametrize(("mode", "method"), FLOWS)
def test_every_flow_times_its_stages_and_reports_progress(mode: Mode, method: Method) -> None:
    heard: list[tuple[str, float]] = []
    mesh = capped_cylinder(nu=20, nv=3, rings=2)
    found = partition(
        mesh, mode=mode, method=method, noise=0.0, progress=lambda s, f: heard.append((s, f))
    )
    assert list(found.timings) == ["curvature", "initial", "refine", "recognise"]
    assert list(dict.fromkeys(s for s, _ in heard)) == list(found.timings)
    assert all(0.0 <= f <= 1.0 for _, f in heard)
    assert found.mesh is mesh
    assert found.method == method
    assert len(found.shape_type) == len(found.region) == len(mesh.triangles)
    assert len(found.shape_index) == len(found.vertex_shape_type) == len(mesh.vertices)
    assert len(np.unique(found.region)) == len(found.regions)


@pytest.mark.parametrize(("mode", "method"), FLOWS)
def test_degenerate_and_doubled_facets_and_stray_vertices_are_survived(
    mode: Mode, method: Method
) -> None:
    mesh = box(n=4)
    triangles = np.concatenate([mesh.triangles, [[0, 1, 1], [2, 2, 2]], mesh.triangles[:3]])
    vertices = np.concatenate([mesh.vertices, [[99.0, 99.0, 99.0]]])
    found = partition(Mesh(vertices, triangles), mode=mode, method=method, noise=0.0)
    n = len(mesh.triangles)
    assert (found.region[n : n + 2] == -1).all()
    assert (np.delete(found.region, [n, n + 1]) >= 0).all()


@pytest.mark.parametrize(("mode", "method"), FLOWS)
def test_a_single_triangle_is_a_partition(mode: Mode, method: Method) -> None:
    one = Mesh(np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]]), np.array([[0, 1, 2]]))
    found = partition(one, mode=mode, method=method)
    assert len(found.regions) == 1
    assert found.region.tolist() == [0]


@pytest.mark.parametrize("facets", [[], [[0, 0, 0]], [[0, 1, 2]]])
def test_a_mesh_without_area_is_refused(facets: list[list[int]]) -> None:
    line = np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0]])
    mesh = Mesh(line, np.array(facets, dtype=np.int64).reshape(-1, 3))
    with pytest.raises(InputError, match="nothing to partition"):
        partition(mesh)


@pytest.mark.parametrize("noise", [-1.0, np.nan, np.inf])
def test_an_impossible_noise_is_refused(noise: float) -> None:
    with pytest.raises(InputError, match="noise"):
        partition(box(n=1), noise=noise)


def test_unknown_modes_and_methods_are_refused() -> None:
    with pytest.raises(ValueError, match="unknown mode"):
        partition(box(n=1), mode="best")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="unknown method"):
        partition(box(n=1), method="magic")  # type: ignore[arg-type]


def test_a_clock_adds_up_stages_of_one_name() -> None:
    clock = StageClock()
    for _ in range(3):
        with clock.stage("a"):
            pass
    assert list(clock.timings) == ["a"]
    assert clock.timings["a"] > 0.0


@pytest.mark.parametrize("size", [5, 20, 60])
def test_patches_are_connected_and_about_equal(size: int) -> None:
    mesh = sphere(level=10)
    patch = equal_patches(mesh, size)
    count = int(patch.max()) + 1
    assert 0.8 < count * size / len(mesh.triangles) < 1.2
    assert np.bincount(patch).max() < 4 * size
    same = mesh.facet_pairs[patch[mesh.facet_pairs[:, 0]] == patch[mesh.facet_pairs[:, 1]]]
    from gpswb.core.growing import grow_regions

    assert grow_regions(np.zeros(len(patch), dtype=np.int64), same)[1] == count


@pytest.mark.parametrize(
    "name", ["planar", "cylindrical", "spherical", "revolute", "prismatic", "helical", "complex"]
)
def test_the_signature_of_gelfand_and_guibas_tells_the_class(name: str) -> None:
    p, n = samples(name, 2000)
    label = np.zeros(2000, dtype=np.int64)
    for unit in (1.0, 0.001):
        moments = slippage_moments(unit * p, n, np.ones(2000), label, 1)
        assert class_by_signature(moments, PaperSettings(condition_number=1e4)) == name


def test_the_usual_condition_number_adds_false_motions() -> None:
    p, n = samples("complex", 2000)
    moments = slippage_moments(p, n, np.ones(2000), np.zeros(2000, dtype=np.int64), 1)
    assert class_by_signature(moments, PaperSettings(condition_number=5.0)) != "complex"


def test_patches_that_straddle_edges_cost_the_slippage_rival_its_borders() -> None:
    mesh = box(n=8)
    side = np.argmax(np.abs(mesh.facet_normals), axis=1) + 3 * (
        mesh.facet_normals.max(axis=1) > 0.5
    )
    found = partition_by_slippage(mesh, 0.0, patch_facets=16)
    straddling = [
        len(np.unique(side[found.initial_region == p])) > 1
        for p in range(found.initial_region_count)
    ]
    assert any(straddling)
    # One facet a patch straddles nothing.
    fine = partition_by_slippage(mesh, 0.0, patch_facets=1)
    assert fine.initial_region_count == len(mesh.triangles)


def test_the_table_of_curvatures() -> None:
    even, uneven = np.full(9, 0.2), np.linspace(0.1, 0.3, 9)
    wild = np.array([0.01, 0.02, 3.0])

    def table(shape: int, curved: np.ndarray) -> str:
        return class_by_table(np.full(len(curved), shape), curved)

    assert table(5, wild) == "planar"
    assert table(4, even) == table(-4, even) == "spherical"
    assert table(2, even) == table(-2, even) == "cylindrical"
    # A ridge of varying curvedness is prismatic to Table 4: a cone too, wrongly.
    assert table(2, uneven) == "prismatic"
    assert table(1, uneven) == "revolute"
    assert table(0, wild) == table(4, wild) == "complex"


def test_the_curvature_rival_neither_votes_nor_merges() -> None:
    for mesh, expected in ((cylinder(), ["cylindrical"]), (plane(), ["planar"])):
        found = partition(mesh, method="curvature", noise=0.0)
        assert [r.invariance_class for r in found.regions] == expected
        assert found.initial_region_count == len(found.regions)
