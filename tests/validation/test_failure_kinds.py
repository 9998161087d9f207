# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each kind of failure is what a part made for it shows."""

import numpy as np
from made_parts import arc, put_together, row_of_squares, sheet, truth

from gpswb.cad.solid import Face, FaceMap
from gpswb.validation.failures import KINDS
from gpswb.validation.validate import validate

FINE = (6, 6)


def kinds(partition: object, facemap: object) -> dict[str, str]:
    found = {f.face: f.kind for f in validate(partition, facemap).failures}
    assert set(found.values()) <= set(KINDS)
    return found


def square(corners: list, cells: tuple = FINE) -> tuple:
    return sheet(corners, cells)


def wall_and_round() -> list[tuple]:
    """A wall along y, a quarter round of R1 tangent to it, and a wall along x tangent to that."""
    return [
        square([[1, -2, 0], [1, 0, 0], [1, 0, 1], [1, -2, 1]]),
        arc(1.0, 0, 90, 12, 6),
        square([[0, 1, 0], [-2, 1, 0], [-2, 1, 1], [0, 1, 1]]),
    ]


def plane(point: tuple, direction: tuple, **more: bool) -> object:
    return truth("planar", "Plane", point=point, direction=direction, **more)


ROUND = truth("cylindrical", "Cylinder", point=(0, 0, 0), direction=(0, 0, 1), radius=(1,))
WALLS = [plane((1, 0, 0), (1, 0, 0)), ROUND, plane((0, 1, 0), (0, 1, 0))]


def test_right_part_has_no_failures() -> None:
    classes = ["planar", "cylindrical", "planar"]
    assert kinds(*put_together(wall_and_round(), WALLS, [0, 1, 2], classes)) == {}


def test_fillet_lost() -> None:
    part = put_together(wall_and_round(), WALLS, [0, 0, 1], ["planar", "planar"])
    assert kinds(*part)["Face2"] == "fillet lost"


def test_tangent_chain_swallowed() -> None:
    found = kinds(*put_together(wall_and_round(), WALLS, [0, 0, 0], ["prismatic"]))
    assert found["Face1"] == found["Face3"] == "tangent chain swallowed"


def test_parallel_steps_merged() -> None:
    step = 0.1
    patches = [
        square([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]),
        square([[1, 0, 0], [1, 0, step], [1, 1, step], [1, 1, 0]], (1, 6)),
        square([[1, 0, step], [2, 0, step], [2, 1, step], [1, 1, step]]),
    ]
    truths = [
        plane((0, 0, 0), (0, 0, 1)),
        plane((1, 0, 0), (1, 0, 0)),
        plane((0, 0, step), (0, 0, 1)),
    ]
    found = kinds(*put_together(patches, truths, [0, 1, 0], ["planar", "planar"]))
    assert found == {"Face1": "parallel steps merged", "Face3": "parallel steps merged"}


def test_coaxial_steps_merged() -> None:
    def cylinder(radius: float) -> object:
        return truth(
            "cylindrical", "Cylinder", point=(0, 0, 0), direction=(0, 0, 1), radius=(radius,)
        )

    patches = [arc(1.0, 0, 180, 24, 6), arc(1.2, 0, 180, 24, 6, z=1.0)]
    part = put_together(patches, [cylinder(1.0), cylinder(1.2)], [0, 0], ["cylindrical"])
    assert kinds(*part) == {"Face1": "coaxial steps merged", "Face2": "coaxial steps merged"}


def test_merged_across_a_crease() -> None:
    patches = [
        square([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]),
        square([[1, 0, 0], [1, 0, 1], [1, 1, 1], [1, 1, 0]]),
    ]
    truths = [plane((0, 0, 0), (0, 0, 1)), plane((1, 0, 0), (1, 0, 0))]
    found = kinds(*put_together(patches, truths, [0, 0], ["prismatic"]))
    assert found == {"Face1": "merged across a crease", "Face2": "merged across a crease"}


def test_tiny_face_and_few_triangles() -> None:
    patches = [
        square([[0, 0, 0], [100, 0, 0], [100, 100, 0], [0, 100, 0]]),
        square([[0, 0, 50], [0.5, 0, 50], [0.5, 0.5, 50], [0, 0.5, 50]], (2, 2)),
        square([[0, 0, 90], [50, 0, 90], [50, 50, 90], [0, 50, 90]], (2, 2)),
    ]
    truths = [truth("planar", "Other"), truth("spherical", "Sphere"), truth("spherical", "Sphere")]
    classes = ["planar", "planar", "planar"]
    # Both small faces have 8 triangles; only the area tells them apart.
    found = kinds(*put_together(patches, truths, [0, 1, 2], classes))
    assert found == {"Face2": "tiny face", "Face3": "few triangles"}


def test_strip() -> None:
    narrow, turning, wide = arc(1, 0, 10, 1, 20), arc(1, 0, 90, 10, 1), arc(1, 0, 90, 20, 20)
    for patch, kind in ((narrow, "strip"), (turning, "class confused"), (wide, "class confused")):
        part = put_together([patch], [ROUND], [0], ["planar"])
        assert kinds(*part) == {"Face1": kind}


def test_split_and_border_displaced() -> None:
    half = np.r_[np.zeros(36), np.ones(36)]
    part = put_together(row_of_squares(1, FINE), [truth("planar")], half, ["planar", "planar"])
    assert kinds(*part) == {"Face1": "split"}
    # 80 of 100 facets in one region, the others in none: right, but the IoU is 0.8.
    part = put_together(
        row_of_squares(1, (10, 5)),
        [truth("planar")],
        np.r_[np.zeros(80), -np.ones(20)],
        ["planar"],
    )
    assert kinds(*part) == {"Face1": "border displaced"}


def test_class_missed_on_a_clean_region() -> None:
    for true, surface, kind in (
        ("helical", "BSpline", "helical missed"),
        ("prismatic", "Extrusion", "prismatic missed"),
        ("revolute", "BSpline", "B-spline face"),
        ("revolute", "Cone", "class confused"),
    ):
        part = put_together(row_of_squares(1, FINE), [truth(true, surface)], [0], ["complex"])
        assert kinds(*part) == {"Face1": kind}


def test_disputed_and_undecided_come_first() -> None:
    patches = row_of_squares(1, FINE)
    disputed = put_together(patches, [truth("helical", ambiguous=True)], [0], ["complex"])
    assert kinds(*disputed) == {"Face1": "truth disputed"}
    open_ = put_together(
        patches, [truth("helical")], [0], ["complex"], undecided=("complex", "helical")
    )
    assert kinds(*open_) == {"Face1": "undecided"}


def test_no_truth_and_no_triangles() -> None:
    partition, facemap = put_together(row_of_squares(1, FINE), [None], [-1], [])
    bare = Face("Face2", 1.0, 0, truth("planar"))
    both = FaceMap(facemap.face_of_triangle, (*facemap.faces, bare), np.array([0, 1]))
    assert kinds(partition, both) == {"Face1": "no truth", "Face2": "no triangles"}
    # Without a truth there is no wrong class, only a feature that was not found.
    assert [f.wrong_class for f in validate(partition, both).failures] == [False, True]
