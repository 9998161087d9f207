# SPDX-License-Identifier: LGPL-2.1-or-later
from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from gps_parts import Part, X, Y, Z, box, flange, negative, plate, shaft
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from gpswb.errors import InputError
from gpswb.gps.compound import compound_features
from gpswb.gps.feature_table import feature_table
from gpswb.gps.features import maximal_features
from gpswb.gps.suggest_datums import suggest_datums


def table(part):
    features = maximal_features(part.partition())
    return features, compound_features(features, part.frame)


def of_kind(compounds, kind):
    return [c for c in compounds if c.kind == kind]


def by_region(features, region):
    (found,) = [f for f in features if region in f.regions]
    return found


def test_every_region_and_face_is_in_exactly_one_feature():
    part = Part()
    flange(part)
    faces = {r.id: [f"Face{r.id + 1}"] for r in part.regions}
    features = maximal_features(part.partition(), faces)
    assert sorted(r for f in features for r in f.regions) == list(range(len(part.regions)))
    assert sorted(n for f in features for n in f.faces) == sorted(
        n for ns in faces.values() for n in ns
    )
    assert [f.area for f in features] == sorted((f.area for f in features), reverse=True)


def test_a_region_without_a_face_is_a_bit_of_one():
    part = Part()
    top = part.plane((0.0, 0.0, 0.0), Z, X, 10.0, 10.0)
    part.cylinder((20.0, 0.0, 0.0), Z, 5.0, 10.0)
    assert len(maximal_features(part.partition())) == 2
    (feature,) = maximal_features(part.partition(), {top: ["Face1"]})
    assert feature.regions == (top,)


def test_split_interrupted_and_coplanar_faces_are_united():
    part = Part()
    left, middle, right, *_ = shaft(part)
    pads = [part.plane((x, 0.0, -50.0), negative(Z), X, 20.0, 10.0) for x in (20.0, 100.0)]
    features = maximal_features(part.partition())
    bearings = by_region(features, left)
    assert bearings.regions == (left, right)
    assert bearings.interrupted
    assert bearings.area == pytest.approx(2 * 30 * np.pi * 30, rel=0.01)
    assert by_region(features, middle).regions == (middle,)
    assert by_region(features, pads[0]).regions == tuple(pads)


def test_touching_halves_are_one_feature_that_is_not_interrupted():
    part = Part()
    a = part.cylinder((0.0, 0.0, 0.0), Z, 10.0, 20.0, hole=True)
    b = part.cylinder((0.0, 0.0, 20.0), Z, 10.0, 20.0, hole=True)
    partition = part.partition()
    vertices, inverse = np.unique(partition.mesh.vertices.round(9), axis=0, return_inverse=True)
    welded = replace(
        partition.mesh, vertices=vertices, triangles=inverse.reshape(-1)[partition.mesh.triangles]
    )
    (hole,) = maximal_features(replace(partition, mesh=welded))
    assert set(hole.regions) == {a, b}
    assert not hole.interrupted


def test_material_side_keeps_apart_what_one_surface_shares():
    """A pocket's floor level with a ceiling, a hole in line with an equal shaft."""
    part = Part()
    part.plane((0.0, 0.0, 0.0), Z, X, 10.0, 10.0)
    part.plane((50.0, 0.0, 0.0), negative(Z), X, 10.0, 9.0)
    part.cylinder((0.0, 0.0, 0.0), Z, 5.0, 10.0)
    part.cylinder((0.0, 0.0, 30.0), Z, 5.0, 9.0, hole=True)
    assert len(maximal_features(part.partition())) == 4


def test_steps_are_not_united():
    part = Part()
    part.plane((0.0, 0.0, 0.0), Z, X, 50.0, 50.0)
    part.plane((60.0, 0.0, 0.1), Z, X, 50.0, 40.0)
    part.cylinder((0.0, 0.0, 0.0), Z, 10.0, 10.0)
    part.cylinder((0.0, 0.0, 20.0), Z, 10.1, 10.0)
    part.cone((0.0, 0.0, 0.0), Z, 10.0, 5.0, 10.0)
    part.cone((0.0, 0.0, 1.0), Z, 10.0, 5.0, 10.0)
    assert len(maximal_features(part.partition())) == 6


def test_cones_on_one_surface_are_united_wherever_they_start():
    part = Part()
    part.cone((0.0, 0.0, 0.0), Z, 10.0, 8.0, 10.0)
    part.cone((0.0, 0.0, 20.0), Z, 6.0, 5.0, 5.0)
    (cone,) = maximal_features(part.partition())
    assert cone.size.value == pytest.approx(2 * np.degrees(np.arctan(0.2)))


def test_holes_shafts_and_fillets_are_told_apart():
    part = Part()
    hole = part.cylinder((0.0, 0.0, 0.0), Z, 5.0, 10.0, hole=True)
    pin = part.cylinder((50.0, 0.0, 0.0), Z, 5.0, 10.0)
    fillet = part.cylinder((0.0, 50.0, 0.0), Z, 5.0, 10.0, hole=True, arc=np.pi / 2)
    half = part.cylinder((50.0, 50.0, 0.0), Z, 5.0, 10.0, hole=True, arc=np.pi)
    ball = part.sphere((80.0, 0.0, 0.0), 8.0)
    cap = part.sphere((80.0, 90.0, 0.0), 8.0, polar=0.5)
    features = maximal_features(part.partition())
    assert by_region(features, hole).material == "internal"
    assert by_region(features, pin).material == "external"
    assert by_region(features, hole).size.value == 10.0
    for partial in (fillet, half, cap):
        assert by_region(features, partial).size is None
    assert by_region(features, fillet).name.startswith("Concave radius")
    assert by_region(features, ball).size.kind == "spherical diameter"
    assert by_region(features, ball).derived == "centre point"


def test_a_lobe_has_a_size_but_is_no_first_choice_as_a_datum():
    """A hole that goes all round stands before a larger boss that covers two thirds of a turn."""
    part = Part()
    box(part, (-60, -60, 0), (60, 60, 8))
    lobe = part.cylinder((0.0, 0.0, 8.0), Z, 30.0, 40.0, arc=4.2)
    bore = part.cylinder((30.0, 0.0, 0.0), Z, 10.0, 40.0, hole=True)
    features = maximal_features(part.partition())
    assert by_region(features, lobe).size.value == 60.0
    assert not by_region(features, lobe).whole
    assert by_region(features, bore).whole
    round_ = [f for f in features if f.surface == "cylinder"]
    (best, *_) = suggest_datums(round_, part.frame)
    assert best.system.datums[0].features == (by_region(features, bore),)


def test_normals_of_planes_point_out_of_the_material():
    part = Part()
    part.plane((0.0, 0.0, 0.0), Z, X, 10.0, 10.0, flip=True)
    (plane,) = maximal_features(part.partition())
    assert plane.situation["normal"] == [0.0, 0.0, 1.0]


def tilted_groove(part, seen, tilt):
    """A narrow band of a cone about X whose axis recognition saw ``seen`` off by ``tilt`` rad."""
    part.cylinder((0.0, 0.0, 0.0), X, 20.0, 100.0)
    band = part.cone((40.0, 0.0, 0.0), X, 20.0, 19.0, 1.0)
    axis = np.array([np.cos(tilt), np.sin(tilt), 0.0])
    wrong = {"point": [40.0, seen, 0.0], "direction": axis.tolist()}
    part.regions[band] = replace(part.regions[band], situation=wrong)
    return by_region(maximal_features(part.partition()), band)


def test_a_narrow_band_takes_the_axis_that_its_points_lie_about():
    cone = tilted_groove(Part(), 0.03, 0.005)
    assert cone.place.direction == X
    assert cone.place.point[1:] == (0.0, 0.0)
    assert cone.situation["direction"] == [1.0, 0.0, 0.0]


def test_an_axis_that_is_meant_to_be_off_stays():
    """Points drawn 0.05 mm off the main axis of a part about 108 mm long: an eccentric."""
    part = Part()
    part.cylinder((0.0, 0.0, 0.0), X, 20.0, 100.0)
    pin = part.cylinder((100.0, 0.05, 0.0), X, 8.0, 10.0)
    assert by_region(maximal_features(part.partition()), pin).place.point[1] == pytest.approx(0.05)


def test_a_narrow_shoulder_takes_a_normal_and_a_drafted_wall_keeps_its_own():
    part = Part()
    part.plane((0.0, 0.0, 0.0), Z, X, 100.0, 100.0)
    a = np.radians(0.5)
    narrow = part.plane((0.0, 0.0, 5.0), Z, X, 0.3, 0.3)
    part.regions[narrow] = replace(
        part.regions[narrow],
        situation={"point": [0.0, 0.0, 5.0], "normal": [np.sin(a), 0.0, np.cos(a)]},
    )
    drafted = part.plane((0.0, 0.0, 9.0), (np.sin(a), 0.0, np.cos(a)), Y, 30.0, 30.0)
    features = maximal_features(part.partition())
    assert by_region(features, narrow).place.direction == Z
    assert by_region(features, drafted).place.direction[0] == pytest.approx(np.sin(a))


def test_a_region_without_its_situation_is_refused_in_one_line():
    part = Part()
    part.cylinder((0.0, 0.0, 0.0), Z, 5.0, 10.0)
    part.regions[0] = replace(part.regions[0], situation={"point": [0.0, 0.0, 0.0]})
    with pytest.raises(InputError, match="region 0 is cylindrical but has no direction"):
        maximal_features(part.partition())


def test_slot_and_rib_are_told_apart_by_the_material():
    """A comb: walls at x = 0, 10 | 16, 22 | 30, 40: two slots of 6 and 8 between three ribs."""
    part = Part()
    for x, outward in ((0, -1), (10, 1), (16, -1), (22, 1), (30, -1), (40, 1)):
        part.plane((float(x), 0.0, 0.0), (float(outward), 0.0, 0.0), Y, 30.0, 20.0)
    _, compounds = table(part)
    assert sorted(c.size.value for c in of_kind(compounds, "slot")) == pytest.approx([6.0, 8.0])
    assert sorted(c.size.value for c in of_kind(compounds, "rib")) == pytest.approx(
        [6.0, 10.0, 10.0]
    )
    for slot in of_kind(compounds, "slot"):
        assert slot.place.point[0] in (13.0, 26.0)
        assert (slot.material, slot.derived) == ("internal", "median plane")


def test_planes_that_do_not_face_each_other_are_no_slot():
    part = Part()
    part.plane((0.0, 0.0, 0.0), X, Y, 10.0, 10.0)
    part.plane((20.0, 30.0, 0.0), negative(X), Y, 10.0, 10.0)
    assert table(part)[1] == ()


def test_a_plane_facing_the_gap_of_an_interrupted_one_is_no_slot():
    part = Part()
    for y in (-20.0, 20.0):
        part.plane((0.0, y, 0.0), X, Y, 10.0, 10.0)
    part.plane((8.0, 0.0, 0.0), negative(X), Y, 12.0, 10.0)
    features, compounds = table(part)
    assert len(features) == 2
    assert compounds == ()


def test_a_detail_on_a_large_face_gives_no_size():
    part = Part()
    large = part.plane((0.0, 0.0, 0.0), negative(Z), X, 100.0, 100.0)
    top = part.plane((0.0, 0.0, 10.0), Z, X, 100.0, 100.0)
    part.plane((0.0, 0.0, 15.0), Z, X, 20.0, 20.0)
    (rib,) = table(part)[1]
    assert set(rib.regions) == {large, top}


def test_features_of_two_bodies_are_never_taken_as_one():
    """Two boxes side by side, level, with coaxial bores: as one body and as two."""
    part = Part()
    for x in (0.0, 30.0):
        box(part, (x, 0, 0), (x + 20, 20, 10))
        part.cylinder((x, 10.0, 5.0), X, 2.0, 20.0, hole=True)
    bodies = {r.id: r.id // 7 for r in part.regions}
    one = feature_table(part.partition())
    two = feature_table(part.partition(), bodies=bodies)
    assert len(one.integral) == 9
    assert [f.kind for f in one.compounds].count("slot") == 1
    assert len(two.integral) == 14
    assert {f.kind for f in two.compounds} == {"rib"}
    for feature in two.features:
        assert {bodies[r] for r in feature.regions} == {feature.body}
    (best, *_) = suggest_datums(two.features, two.frame)
    assert len({f.body for d in best.system.datums for f in d.features}) == 1
    assert best.complete


def test_a_box_has_three_ribs_of_its_dimensions():
    part = Part()
    box(part, (0, 0, 0), (30, 20, 10))
    _, compounds = table(part)
    assert {c.kind for c in compounds} == {"rib"}
    assert sorted(c.size.value for c in compounds) == pytest.approx([10.0, 20.0, 30.0])


def test_holes_on_a_bolt_circle_and_the_coaxial_group():
    part = Part()
    _, _, rim, bore, bolts = flange(part)
    features, compounds = table(part)
    (pattern,) = of_kind(compounds, "hole pattern")
    assert sorted(pattern.regions) == bolts
    assert pattern.arrangement == "circle"
    assert pattern.intrinsic == pytest.approx(
        {"count": 6, "diameter": 10.0, "pitch_circle_diameter": 90.0}
    )
    assert pattern.invariance_class == "prismatic"
    (group,) = of_kind(compounds, "coaxial group")
    assert {features[i].regions[0] for i in group.members} == {rim, bore}
    assert group.invariance_class == "cylindrical"


def test_four_holes_in_a_square_are_a_circle_only_around_something():
    part = Part()
    flange(part, holes=4)
    (pattern,) = of_kind(table(part)[1], "hole pattern")
    assert pattern.arrangement == "circle"
    part = Part()
    for x in (0.0, 30.0):
        for y in (0.0, 30.0):
            part.cylinder((x, y, 0.0), Z, 3.0, 10.0, hole=True)
    (pattern,) = of_kind(table(part)[1], "hole pattern")
    assert pattern.arrangement == "grid"


@pytest.mark.parametrize(("bore", "arrangement"), [(True, "circle"), (False, "free")])
def test_unevenly_spaced_holes_are_on_a_circle_about_a_bore(bore, arrangement):
    part = Part()
    for angle in (0.0, 0.7, 2.0, 3.5, 4.1):
        part.cylinder((30 * np.cos(angle), 30 * np.sin(angle), 0.0), Z, 3.0, 10.0, hole=True)
    if bore:
        part.cylinder((0.0, 0.0, 0.0), Z, 15.0, 10.0, hole=True)
    (pattern,) = of_kind(table(part)[1], "hole pattern")
    assert pattern.arrangement == arrangement
    if bore:
        assert pattern.intrinsic["pitch_circle_diameter"] == pytest.approx(60.0)


def test_a_rectangle_of_holes_about_a_bore_is_a_grid():
    part = Part()
    for x in (-20.0, 20.0):
        for y in (-30.0, 30.0):
            part.cylinder((x, y, 0.0), Z, 3.0, 10.0, hole=True)
    part.cylinder((0.0, 0.0, 0.0), Z, 15.0, 10.0, hole=True)
    (pattern,) = of_kind(table(part)[1], "hole pattern")
    assert pattern.arrangement == "grid"


@pytest.mark.parametrize(
    ("spots", "arrangement", "numbers"),
    [
        ([(0, 0), (20, 0)], "linear", {"pitch": 20}),
        ([(0, 0), (10, 10), (20, 20), (30, 30)], "linear", {"pitch": 200**0.5}),
        ([(0, 0), (10, 0), (35, 0)], "free", {}),
        (
            [(x, y) for x in (0, 25, 50) for y in (0, 15)],
            "grid",
            {"columns": 2, "column_pitch": 15, "rows": 3, "row_pitch": 25},
        ),
        ([(0, 0), (31, 7), (12, 40), (50, 55), (3, 21)], "free", {}),
    ],
)
def test_arrangements(spots, arrangement, numbers):
    part = Part()
    for x, y in spots:
        part.cylinder((float(x), float(y), 0.0), Z, 2.0, 10.0, hole=True)
    (pattern,) = of_kind(table(part)[1], "hole pattern")
    assert pattern.arrangement == arrangement
    assert pattern.intrinsic == pytest.approx({"count": len(spots), "diameter": 4.0, **numbers})


def test_unequal_or_crosswise_holes_make_no_pattern():
    part = Part()
    part.cylinder((0.0, 0.0, 0.0), Z, 2.0, 10.0, hole=True)
    part.cylinder((20.0, 0.0, 0.0), Z, 2.1, 10.0, hole=True)
    part.cylinder((40.0, 0.0, 0.0), Y, 2.0, 10.0, hole=True)
    part.cylinder((60.0, 0.0, 0.0), Z, 2.0, 10.0)
    assert of_kind(table(part)[1], "hole pattern") == []


def test_rounded_ends_that_cover_more_than_half_a_turn_are_no_pins():
    part = Part()
    for x in (0.0, 30.0):
        part.cylinder((x, 0.0, 0.0), Z, 10.0, 5.0, arc=np.radians(220.0))
    features, compounds = table(part)
    assert [f.size.value for f in features if f.kind == "integral"] == pytest.approx([20.0, 20.0])
    assert of_kind(compounds, "pin pattern") == []


def test_counterbore_countersink_and_drill_point():
    part = Part()
    part.plane((50.0, 0.0, 40.0), Z, X, 200.0, 60.0)
    hole = part.cylinder((0.0, 0.0, 0.0), Z, 4.0, 30.0, hole=True)
    bore = part.cylinder((0.0, 0.0, 30.0), Z, 8.0, 10.0, hole=True)
    part.annulus((0.0, 0.0, 30.0), Z, 4.0, 8.0)
    second = part.cylinder((40.0, 0.0, 0.0), Z, 5.0, 30.0, hole=True)
    sink = part.cone((40.0, 0.0, 30.0), Z, 5.0, 15.0, 10.0, hole=True)
    part.cylinder((80.0, 0.0, 20.0), Z, 6.0, 20.0, hole=True)
    part.cone((80.0, 0.0, 20.0), negative(Z), 6.0, 0.01, 4.0, hole=True)
    _, compounds = table(part)
    (counterbore,) = of_kind(compounds, "counterbore")
    assert set(counterbore.regions) == {hole, bore}
    assert counterbore.intrinsic == pytest.approx({"diameter_1": 8.0, "diameter_2": 16.0})
    (countersink,) = of_kind(compounds, "countersink")
    assert set(countersink.regions) == {second, sink}
    assert of_kind(compounds, "coaxial group") == []


@settings(max_examples=20, deadline=None)
@given(
    quaternion=st.tuples(*[st.floats(-1.0, 1.0)] * 3, st.floats(0.1, 1.0)),
    shift=st.tuples(*[st.floats(-500.0, 500.0)] * 3),
    unit=st.sampled_from([1.0, 1e-3, 1 / 25.4]),
    make=st.sampled_from([plate, flange, shaft]),
)
def test_the_table_does_not_depend_on_pose_or_unit(quaternion, shift, unit, make):
    rotation = Rotation.from_quat(quaternion).as_matrix()
    rows = []
    for part in (Part(), Part(rotation, shift, unit)):
        make(part)
        features, compounds = table(part)
        scale = part.pose[2]
        rows.append(
            sorted(
                (f.kind, f.invariance_class, f.material, f.arrangement, sorted(f.regions),
                 round(f.size.value / (scale if f.size.linear else 1.0), 6) if f.size else None)
                for f in features + compounds
            )
        )  # fmt: skip
    assert rows[0] == rows[1]
