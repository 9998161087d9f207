# SPDX-License-Identifier: LGPL-2.1-or-later
"""B-rep faces are found in the text by surface and border, however either side orders them."""

from collections.abc import Sequence

import numpy as np
import pytest
from box_files import SIDES, UNITS, Box, Text, boxes_solid, boxes_text
from hypothesis import given, settings
from hypothesis import strategies as st

from gpswb.cad.solid import Solid
from gpswb.io.ap242.match import match_faces
from gpswb.io.ap242.part21 import Part21, Ref
from gpswb.io.ap242.structure import shapes_of
from gpswb.io.ap242.surfaces import text_face
from gpswb.io.ap242.units import Units

PAIR = (Box((0, 0, 0), (40, 30, 20)), Box((40, 5, 3), (10, 10, 10)))
HOLLOW = (Box((0, 0, 0), (40, 30, 20)), Box((5, 5, 5), (20, 10, 10), void=True))


def planes_found(text: str, solid: Solid) -> int:
    """Matched faces whose entity lies in the face's own plane, with the same corners."""
    file = Part21(text)
    shapes = shapes_of(file)
    found = match_faces(file, shapes, solid.mesh, solid.facemap)
    assert len({int(entity.number) for entity in found.values()}) == len(found)
    good = 0
    for i, face in enumerate(solid.facemap.faces):
        entity = found[face.name]
        read = text_face(file, entity.number, shapes[entity.shape].units)
        own = solid.mesh.vertices[solid.mesh.triangles[solid.facemap.face_of_triangle == i]]
        corners = np.unique(np.round(own.reshape(-1, 3), 6), axis=0)
        border = np.unique(np.round(read.border.reshape(-1, 3), 6), axis=0)
        good += all(np.abs(border - c).max(axis=1).min() < 1e-6 for c in corners)
    return good


@pytest.mark.parametrize("unit", UNITS)
@pytest.mark.parametrize("boxes", [PAIR, HOLLOW], ids=["two bodies", "two shells"])
@settings(max_examples=10)
@given(order=st.permutations(range(6)), other=st.permutations(range(12)))
def test_every_face_is_found(
    boxes: Sequence[Box], unit: str, order: list[int], other: list[int]
) -> None:
    assert planes_found(boxes_text(boxes, unit, order), boxes_solid(boxes, other)) == 12


def test_touching_faces_are_told_apart_by_their_normals() -> None:
    boxes = (Box((0, 0, 0), (10, 10, 10)), Box((10, 0, 0), (10, 10, 10)))
    file = Part21(boxes_text(boxes))
    solid = boxes_solid(boxes)
    found = match_faces(file, shapes_of(file), solid.mesh, solid.facemap)
    order = [int(number) for number in file.of("ADVANCED_FACE")]
    # Side 5 of the first and side 4 of the second lie on each other; the text has them in order.
    assert [int(found[f"Face{i + 1}"].number) for i in range(12)] == order


def test_faces_of_another_part_are_not_found() -> None:
    file = Part21(boxes_text([Box((0, 0, 0), (10, 10, 10))]))
    solid = boxes_solid([Box((0, 0, 1), (10, 10, 10.5))])
    found = match_faces(file, shapes_of(file), solid.mesh, solid.facemap)
    assert found == {}


@pytest.mark.parametrize("listed", ["child first", "parent first"])
@pytest.mark.parametrize("frames", ["as the shapes", "crosswise"])
def test_occurrences_in_an_assembly_are_placed(listed: str, frames: str) -> None:
    box = Box((0, 0, 0), (10, 20, 30))
    text = Text()
    child_context, whole_context = text.context("inch"), text.context("mm")
    origin = text.frame()
    shell = text.shell(box, 25.4, range(6))
    solid = text.add(f"MANIFOLD_SOLID_BREP('',{shell})")
    shape = text.add(f"ADVANCED_BREP_SHAPE_REPRESENTATION('',({solid},{origin}),{child_context})")
    part, part_shape = text.product("'part'")
    text.add(f"SHAPE_DEFINITION_REPRESENTATION({part_shape},{shape})")
    # Turned by 90 degrees about Z and moved, in mm: x goes to y.
    spots = [text.frame((100, 0, 0), x=(0, 1, 0)), text.frame((0, 0, -50), x=(0, 1, 0))]
    whole = text.add(f"SHAPE_REPRESENTATION('',({','.join(spots)}),{whole_context})")
    assembly, assembly_shape = text.product("'assembly'")
    text.add(f"SHAPE_DEFINITION_REPRESENTATION({assembly_shape},{whole})")
    for i, spot in enumerate(spots):
        use = text.add(f"NEXT_ASSEMBLY_USAGE_OCCURRENCE('{i}','','',{assembly},{part},$)")
        placed = text.add(f"PRODUCT_DEFINITION_SHAPE('','',{use})")
        pair = (origin, spot) if frames == "as the shapes" else (spot, origin)
        if listed == "parent first":
            pair = pair[::-1]
        move = text.add(f"ITEM_DEFINED_TRANSFORMATION('','',{pair[0]},{pair[1]})")
        shapes = (shape, whole) if listed == "child first" else (whole, shape)
        relation = text.add(
            f"(REPRESENTATION_RELATIONSHIP('','',{shapes[0]},{shapes[1]})"
            f"REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({move})"
            "SHAPE_REPRESENTATION_RELATIONSHIP())"
        )
        text.add(f"CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({relation},{placed})")
    file = Part21(text.whole())
    # (x, y, z) goes to (-y, x, z) and the spot's origin: the same boxes with x and y swapped.
    moved = (Box((100 - 20, 0, 0), (20, 10, 30)), Box((-20, 0, -50), (20, 10, 30)))
    solid_made = boxes_solid(moved)
    found = match_faces(file, shapes_of(file), solid_made.mesh, solid_made.facemap)
    assert len(found) == 12
    for i in range(6):
        assert found[f"Face{i + 1}"] == found[f"Face{i + 7}"]


def edge_loop(text: Text, curves: list[tuple[str, tuple, tuple]]) -> str:
    edges = []
    for curve, start, end in curves:
        ends = [text.add(f"VERTEX_POINT('',{text.point(p)})") for p in (start, end)]
        edge = text.add(f"EDGE_CURVE('',{ends[0]},{ends[1]},{curve},.T.)")
        edges.append(text.add(f"ORIENTED_EDGE('',*,*,{edge},.T.)"))
    loop = text.add(f"EDGE_LOOP('',({','.join(edges)}))")
    return text.add(f"FACE_BOUND('',{loop},.T.)")


@pytest.mark.parametrize("half", [0, 1])
def test_points_along_arcs_go_the_way_of_the_edge(half: int) -> None:
    text = Text()
    circle = text.add(f"CIRCLE('',{text.frame()},5.)")
    ends = [(5, 0, 0), (-5, 0, 0)]
    bound = edge_loop(text, [(circle, ends[half], ends[1 - half])])
    plane = text.add(f"PLANE('',{text.frame()})")
    face = text.add(f"ADVANCED_FACE('',({bound}),{plane},.T.)")
    read = text_face(Part21(text.whole()), Ref(face[1:]), Units())
    assert np.allclose(np.linalg.norm(read.border.reshape(-1, 3), axis=1), 5.0)
    # The first half runs through +y, the second through -y; inside is towards the centre.
    middle = read.border.mean(axis=1)
    assert np.all(middle[:, 1] * (1 - 2 * half) > 0)
    assert np.all(np.einsum("ij,ij->i", read.inward, middle) < 0)


@pytest.mark.parametrize("rational", [False, True])
def test_points_along_splines_lie_on_the_curve(rational: bool) -> None:
    text = Text()
    # A quarter circle as a quadratic with weights 1, 1/√2, 1; without weights a parabola.
    poles = ",".join(text.point(p) for p in ((1, 0, 0), (1, 1, 0), (0, 1, 0)))
    if rational:
        curve = text.add(
            f"(BOUNDED_CURVE()B_SPLINE_CURVE(2,({poles}),.UNSPECIFIED.,.F.,.F.)"
            "B_SPLINE_CURVE_WITH_KNOTS((3,3),(0.,1.),.UNSPECIFIED.)CURVE()"
            "GEOMETRIC_REPRESENTATION_ITEM()"
            f"RATIONAL_B_SPLINE_CURVE((1.,{2**-0.5!r},1.))REPRESENTATION_ITEM(''))"
        )
    else:
        curve = text.add(
            f"B_SPLINE_CURVE_WITH_KNOTS('',2,({poles}),.UNSPECIFIED.,.F.,.F.,(3,3),(0.,1.),.U.)"
        )
    bound = edge_loop(text, [(curve, (1, 0, 0), (0, 1, 0))])
    plane = text.add(f"PLANE('',{text.frame()})")
    face = text.add(f"ADVANCED_FACE('',({bound}),{plane},.T.)")
    points = text_face(Part21(text.whole()), Ref(face[1:]), Units()).border.reshape(-1, 3)
    x, y = points[:, 0], points[:, 1]
    if rational:
        assert np.allclose(np.hypot(x, y), 1.0)
    else:
        # x = 1 - t², y = 1 - (1 - t)²: √(1 - x) + √(1 - y) = 1.
        assert np.allclose(np.sqrt(1 - x) + np.sqrt(1 - y), 1.0)


@pytest.mark.parametrize(
    ("surface", "points"),
    [
        ("CYLINDRICAL_SURFACE('',{},5.)", [(5, 0, 9), (0, -5, -2)]),
        ("SPHERICAL_SURFACE('',{},5.)", [(5, 0, 0), (3, 0, -4)]),
        # Half angle 45 degrees, radius 5 at z = 0; both sides of the apex.
        (f"CONICAL_SURFACE('',{{}},5.,{np.pi / 4!r})", [(5, 0, 0), (0, 8, 3), (2, 0, -7)]),
        ("TOROIDAL_SURFACE('',{},10.,2.)", [(12, 0, 0), (0, 10, 2), (-8, 0, 0)]),
        ("DEGENERATE_TOROIDAL_SURFACE('',{},1.,2.,.T.)", [(3, 0, 0), (1, 0, 2), (-1, 0, 0)]),
    ],
)
def test_distances_to_elementary_surfaces(surface: str, points: list) -> None:
    text = Text()
    face = text.add(f"ADVANCED_FACE('',(),{text.add(surface.format(text.frame()))},.T.)")
    read = text_face(Part21(text.whole()), Ref(face[1:]), Units())
    turned = np.eye(4)
    turned[:3, :3] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    turned[:3, 3] = (7, 8, 9)
    placed = np.array(points, dtype=float) @ turned[:3, :3].T + turned[:3, 3]
    assert np.allclose(read.distance(placed, turned), 0.0, atol=1e-12)
    assert np.all(read.distance(placed + np.array([0, 0, 0.5]), turned) < 0.5 + 1e-12)


def test_sides_are_seen_from_outside() -> None:
    """The boxes of these tests are right themselves."""
    for side in SIDES:
        a, b, _, d = np.array(side, dtype=float)
        outward = np.mean(side, axis=0) - 0.5
        assert np.cross(b - a, d - a) @ outward > 0
