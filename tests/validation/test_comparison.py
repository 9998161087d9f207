# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scan against its nominal part: a plate with a boss, disturbed by known functions."""

import importlib.util

import numpy as np
import pytest
from made_parts import arc, partition_of, put_together, sheet, solid_of, truth

from gpswb.core.mesh import Mesh
from gpswb.core.partition import Partition
from gpswb.errors import InputError
from gpswb.validation.alignment import align, placement
from gpswb.validation.comparison import Comparison, compare
from gpswb.validation.nominal import Nominal, nominal_samples

FLOOR = sheet([[-20, -20, 0], [20, -20, 0], [20, 20, 0], [-20, 20, 0]], (40, 40))
WALL = sheet([[-20, 20, 0], [20, 20, 0], [20, 20, 12], [-20, 20, 12]], (40, 12))


def cylinder(steps: int = 96, rows: int = 24) -> tuple:
    """A boss of radius 5, 6 high, that stands 1 over the floor."""
    points, triangles = arc(5, 0, 360, steps, rows)
    return points * [1, 1, 6] + [0, 0, 1], triangles


def part() -> tuple[Partition, Nominal]:
    """The undisturbed mesh, a region a face, and the nominal part."""
    truths = [
        truth("planar", "Plane", point=(0, 0, 0), direction=(0, 0, 1)),
        truth("planar", "Plane", point=(0, 20, 0), direction=(0, 1, 0)),
        truth("cylindrical", "Cylinder", point=(0, 0, 3), direction=(0, 0, 1), radius=(5.0,)),
    ]
    made, facemap = put_together(
        [FLOOR, WALL, cylinder()], truths, [0, 1, 2], ["planar", "planar", "cylindrical"]
    )
    return made, nominal_samples(solid_of(made.mesh, facemap))


def disturbed(h: float) -> tuple[np.ndarray, np.ndarray]:
    """Vertices moved: waves of ±h on the floor, three lobes of ±h on the boss; the regions."""
    made, _ = part()
    v = made.mesh.vertices.copy()
    x, y, z = v.T
    floor = (z == 0) & (y < 20)
    boss = np.isclose(np.hypot(x, y), 5) & (z >= 1)
    v[floor, 2] += h * np.cos(np.pi * x[floor] / 5) * np.cos(np.pi * y[floor] / 5)
    phi = np.arctan2(y[boss], x[boss])
    v[boss, :2] += h * np.cos(3 * phi)[:, None] * np.column_stack([np.cos(phi), np.sin(phi)])
    return v, made.region


def compared(h: float, region: np.ndarray | None = None) -> Comparison:
    vertices, own = disturbed(h)
    made, nominal = part()
    mesh = Mesh(vertices, made.mesh.triangles)
    labels = own if region is None else region
    return compare(partition_of(mesh, labels, ["planar", "planar", "cylindrical"]), nominal)


def test_form_deviations_are_those_that_were_made() -> None:
    h = 0.05
    floor, wall, boss = compared(h).features
    assert (floor.form, wall.form, boss.form) == ("flatness", "flatness", "cylindricity")
    # Waves on whole periods with both extremes among the vertices: a zone of 2h.
    assert floor.minimax == pytest.approx(2 * h, abs=1e-9)
    assert floor.least_squares == pytest.approx(2 * h, rel=0.02)
    assert floor.profile == pytest.approx(2 * h, abs=1e-9)
    assert wall.minimax == pytest.approx(0.0, abs=1e-9)
    # Lobes keep axis and radius; 96 vertices a turn hit their extremes.
    assert boss.minimax == pytest.approx(2 * h, abs=1e-6)
    assert boss.roundness_minimax == pytest.approx(2 * h, abs=1e-4)
    assert boss.intrinsic["radius"] == pytest.approx(5.0, abs=1e-4)
    assert boss.intrinsic["nominal_radius"] == 5.0
    assert [f.extraction for f in (floor, wall, boss)] == ["region"] * 3


def test_points_on_an_edge_are_in_no_form() -> None:
    found = compared(0.05)
    vertices, _ = disturbed(0.05)
    on_edge = np.isclose(vertices[:, 1], 20) & np.isclose(vertices[:, 2], 0)
    assert on_edge.sum() == 41
    assert not found.extracted[on_edge].any()


def test_a_region_over_two_faces_goes_to_the_larger_one() -> None:
    made, _ = part()
    merged = np.where(made.region == 1, 0, made.region)  # the floor's region runs up the wall
    floor, wall, _ = compared(0.05, merged).features
    assert floor.regions == (0,)
    assert floor.minimax == pytest.approx(0.1, abs=1e-9)
    assert (wall.regions, wall.extraction) == ((), "nearness")
    assert wall.scan_class is None


def test_what_is_far_off_belongs_to_no_face() -> None:
    made, nominal = part()
    lifted = made.mesh.vertices.copy()
    lifted[made.mesh.triangles[made.region == 1]] += [0, 10, 0]
    found = compare(partition_of(Mesh(lifted, made.mesh.triangles), made.region,
                                 ["planar", "planar", "cylindrical"]), nominal)  # fmt: skip
    wall = found.features[1]
    assert (wall.points, wall.extraction, wall.minimax) == (0, "none", None)


def test_alignment_undoes_a_rough_placement() -> None:
    if importlib.util.find_spec("small_gicp") is None:  # FreeCAD's Python
        with pytest.raises(InputError, match="small-gicp"):
            align(np.zeros((9, 3)), np.zeros((9, 3)), 1.0, np.eye(4))
        return
    vertices, _ = disturbed(0.02)
    _, nominal = part()
    away = np.linalg.inv(placement([3, -2, 1.5, 4, -3, 6]))
    scan = vertices @ away[:3, :3].T + away[:3, 3]
    found = align(scan, nominal.points, nominal.diagonal, placement([2.6, -1.8, 1.2, 3, -2, 4]))
    back = scan @ found.transform[:3, :3].T + found.transform[:3, 3]
    # Waves and lobes of ±0.02 pull evenly: what is left is a tenth of their height at most.
    assert np.linalg.norm(back - vertices, axis=1).max() < 0.002
    assert found.paired == 1.0


def test_placement_turns_about_x_then_y_then_z() -> None:
    moved = placement([1, 2, 3, 90, 0, 90]) @ [0, 1, 0, 1]
    assert moved == pytest.approx([1, 2, 4, 1])  # y to z about x; z stays about z
    moved = placement([0, 0, 0, 0, 90, 90]) @ [0, 0, 1, 1]
    assert moved == pytest.approx([0, 1, 0, 1])  # z to x about y; x to y about z
