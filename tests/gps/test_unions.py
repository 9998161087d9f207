# SPDX-License-Identifier: LGPL-2.1-or-later
"""The invariance class of a union, by hand from the group of motions that all members share."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from gpswb.core.invariance import DIMENSION
from gpswb.gps.invariance_of_union import invariance_of_union
from gpswb.gps.twists import (
    Frame,
    SituationFeature,
    constraint_rows,
    locked_degrees,
    null_space,
    vector,
)

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
OBLIQUE = (0.6, 0.0, 0.8)
FRAME = Frame((5.0, 5.0, 5.0), 100.0)


def plane(p, n):
    return SituationFeature("planar", p, n)


def cylinder(p, d):
    return SituationFeature("cylindrical", p, d)


def sphere(*p):
    return SituationFeature("spherical", p)


def cone(p, d):
    return SituationFeature("revolute", p, d)


def prism(d):
    return SituationFeature("prismatic", (3.0, 4.0, 5.0), d)


def helix(p, d, lead):
    return SituationFeature("helical", p, d, lead)


ORIGIN, P, Q = (0.0, 0.0, 0.0), (20.0, 0.0, 0.0), (0.0, 30.0, 10.0)
HEX = [
    plane((np.cos(a), np.sin(a), 0.0), (np.cos(a), np.sin(a), 0.0))
    for a in np.arange(6) * np.pi / 3
]

UNIONS = [
    ("one plane", [plane(ORIGIN, Z)], "planar"),
    ("one cylinder", [cylinder(P, Z)], "cylindrical"),
    ("one sphere", [sphere(1.0, 2.0, 3.0)], "spherical"),
    ("one cone", [cone(P, OBLIQUE)], "revolute"),
    ("one extrusion", [prism(OBLIQUE)], "prismatic"),
    ("one thread", [helix(P, Z, 1.5)], "helical"),
    ("one left-hand thread", [helix(P, Z, -1.5)], "helical"),
    ("one freeform surface", [SituationFeature("complex")], "complex"),
    ("parallel planes", [plane(ORIGIN, Z), plane(Q, (0.0, 0.0, -1.0))], "planar"),
    ("two secant planes", [plane(ORIGIN, Z), plane(ORIGIN, X)], "prismatic"),
    ("wedge", [plane(ORIGIN, Z), plane(ORIGIN, OBLIQUE)], "prismatic"),
    ("hexagon sides", HEX, "prismatic"),
    ("three planes at a corner", [plane(ORIGIN, X), plane(ORIGIN, Y), plane(ORIGIN, Z)], "complex"),
    ("hexagon sides and end", [*HEX, plane(ORIGIN, Z)], "complex"),
    ("plane ⟂ cylinder", [plane(ORIGIN, Z), cylinder(P, Z)], "revolute"),
    ("plane ∥ cylinder", [plane(ORIGIN, X), cylinder(P, Z)], "prismatic"),
    ("plane oblique to cylinder", [plane(ORIGIN, OBLIQUE), cylinder(P, Z)], "complex"),
    ("coaxial cylinders", [cylinder(P, Z), cylinder((20.0, 0.0, 40.0), Z)], "cylindrical"),
    ("parallel cylinders", [cylinder(ORIGIN, Z), cylinder(P, Z)], "prismatic"),
    ("crossing cylinders", [cylinder(ORIGIN, Z), cylinder(ORIGIN, X)], "complex"),
    ("skew cylinders", [cylinder(ORIGIN, Z), cylinder(Q, X)], "complex"),
    (
        "four holes and their face",
        [*(cylinder((x, y, 0.0), Z) for x in (0.0, 9.0) for y in (0.0, 7.0)), plane(ORIGIN, Z)],
        "complex",
    ),
    ("concentric spheres", [sphere(*Q), sphere(*Q)], "spherical"),
    ("two spheres", [sphere(*ORIGIN), sphere(*Q)], "revolute"),
    ("three spheres", [sphere(*ORIGIN), sphere(*P), sphere(*Q)], "complex"),
    ("three spheres in line", [sphere(*ORIGIN), sphere(*P), sphere(-7.0, 0.0, 0.0)], "revolute"),
    ("sphere and plane", [sphere(*Q), plane(ORIGIN, Z)], "revolute"),
    ("sphere on a cylinder's axis", [sphere(20.0, 0.0, 9.0), cylinder(P, Z)], "revolute"),
    ("sphere beside a cylinder", [sphere(*ORIGIN), cylinder(P, Z)], "complex"),
    ("cone and coaxial cylinder", [cone(P, Z), cylinder((20.0, 0.0, 9.0), Z)], "revolute"),
    ("cone and parallel cylinder", [cone(ORIGIN, Z), cylinder(P, Z)], "complex"),
    ("cone and plane ⟂ axis", [cone(P, Z), plane(ORIGIN, Z)], "revolute"),
    ("cone and plane ∥ axis", [cone(P, Z), plane(ORIGIN, X)], "complex"),
    ("coaxial cones", [cone(ORIGIN, Z), cone((0.0, 0.0, 9.0), (0.0, 0.0, -1.0))], "revolute"),
    ("extrusion and plane along it", [prism(Z), plane(ORIGIN, X)], "prismatic"),
    ("extrusion and plane across", [prism(Z), plane(ORIGIN, Z)], "complex"),
    ("parallel extrusions", [prism(Z), prism(Z)], "prismatic"),
    ("extrusions in two directions", [prism(Z), prism(X)], "complex"),
    ("extrusion and parallel cylinder", [prism(Z), cylinder(Q, Z)], "prismatic"),
    ("helix and coaxial cylinder", [helix(P, Z, 1.5), cylinder(P, Z)], "helical"),
    ("helix and parallel cylinder", [helix(P, Z, 1.5), cylinder(ORIGIN, Z)], "complex"),
    ("helices of one lead", [helix(P, Z, 3.0), helix((20.0, 0.0, 1.0), Z, 3.0)], "helical"),
    ("helices of two leads", [helix(P, Z, 3.0), helix(P, Z, 5.0)], "complex"),
    ("helix and plane across", [helix(P, Z, 1.5), plane(ORIGIN, Z)], "complex"),
    (
        "shaft: cylinder, cone, ends, sphere",
        [cylinder(P, X), cone(P, X), plane(P, X), sphere(50.0, 0.0, 0.0)],
        "revolute",
    ),
]
TABLE = pytest.mark.parametrize(
    ("members", "expected"), [u[1:] for u in UNIONS], ids=[u[0] for u in UNIONS]
)


def moved(feature, rotation, shift, unit):
    return replace(
        feature,
        point=vector(unit * (rotation.apply(feature.point) + shift)),
        direction=vector(rotation.apply(feature.direction)),
        lead=unit * feature.lead,
    )


COORDINATE = st.floats(-1.0, 1.0)
POSES = st.builds(
    lambda q, shift, unit: (Rotation.from_quat(q), np.array(shift), unit),
    st.tuples(COORDINATE, COORDINATE, COORDINATE, st.floats(0.1, 1.0)),
    st.tuples(*[st.floats(-1000.0, 1000.0)] * 3),
    st.sampled_from([1.0, 1e-3, 1 / 25.4, 1e3]),
)


@TABLE
@settings(max_examples=25, deadline=None)
@given(pose=POSES)
def test_union_is_unchanged_by_rotation_translation_and_unit(members, expected, pose):
    rotation, shift, unit = pose
    frame = Frame(vector(unit * (rotation.apply(FRAME.origin) + shift)), unit * FRAME.length)
    union = invariance_of_union([moved(m, *pose) for m in members], frame)
    assert union.invariance_class == expected


@TABLE
def test_union_survives_half_a_tenth_of_a_degree(members, expected):
    """Recognised directions are a little off: 0.05° must not turn planar into prismatic.

    The first member stays: its error would move what lies far along its axis.
    """
    axes = np.array([X, Y, Z, OBLIQUE])
    tilted = [
        replace(
            m,
            direction=vector(
                Rotation.from_rotvec(np.radians(0.05) * axes[i % 4]).apply(m.direction)
            ),
        )
        for i, m in enumerate(members[1:])
    ]
    tilted = [members[0], *tilted]
    assert invariance_of_union(tilted, FRAME).invariance_class == expected


@TABLE
def test_union_is_invariant_under_its_own_motions(members, expected):
    """The union leaves every member in place, and no other class of as many motions would."""
    union = invariance_of_union(members, FRAME)
    free = null_space(constraint_rows(union, FRAME), 1e-9)
    assert free.shape[1] == DIMENSION[expected]
    for member in members:
        assert np.abs(constraint_rows(member, FRAME) @ free).max(initial=0.0) < 1e-12


def test_order_does_not_matter():
    for name, members, expected in UNIONS:
        assert invariance_of_union(members[::-1], FRAME).invariance_class == expected, name


def test_union_gives_axis_centre_and_lead():
    axis = invariance_of_union([sphere(20.0, 3.0, 0.0), sphere(20.0, 3.0, 50.0)], FRAME)
    assert np.allclose(axis.direction, Z)
    assert np.allclose(axis.point[:2], (20.0, 3.0))
    centre = invariance_of_union([sphere(7.0, 8.0, 9.0)] * 2, FRAME)
    assert np.allclose(centre.point, (7.0, 8.0, 9.0))
    for lead in (1.5, -0.35):
        assert invariance_of_union(
            [helix(P, Z, lead), cylinder(P, Z)], FRAME
        ).lead == pytest.approx(lead)


def test_a_draft_of_a_quarter_degree_is_kept():
    a = np.radians(0.25)
    walls = [plane(ORIGIN, X), plane(P, (np.cos(a), 0.0, np.sin(a)))]
    assert invariance_of_union(walls, FRAME).invariance_class == "prismatic"


@pytest.mark.parametrize(
    ("feature", "locks"),
    [
        (plane(ORIGIN, Z), (1, 2)),
        (cylinder(P, Z), (2, 2)),
        (sphere(1.0, 2.0, 3.0), (3, 0)),
        (cone(P, Z), (3, 2)),
        (prism(Z), (2, 3)),
        (helix(P, Z, 1.5), (3, 2)),
        (SituationFeature("complex"), (3, 3)),
    ],
    ids=lambda value: getattr(value, "invariance_class", None),
)
def test_locked_translations_and_rotations(feature, locks):
    """The last column of the table of the design, section 7."""
    assert locked_degrees(null_space(constraint_rows(feature, FRAME), 1e-9)) == locks


def test_no_features_have_no_class():
    with pytest.raises(ValueError, match="no features"):
        invariance_of_union([], FRAME)
