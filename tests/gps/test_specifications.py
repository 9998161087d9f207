# SPDX-License-Identifier: LGPL-2.1-or-later
from __future__ import annotations

import numpy as np
import pytest
from gps_parts import Part, X, Y, Z, flange

from gpswb.gps.characteristics import RULES
from gpswb.gps.compound import compound_features
from gpswb.gps.datum_system import datum_system, parse_datums
from gpswb.gps.feature_table import feature_table
from gpswb.gps.features import maximal_features
from gpswb.gps.specifications import permitted_specifications
from gpswb.gps.specified import SpecificationRow, specify

FORM = {"straightness", "flatness", "roundness", "cylindricity"}
PROFILES = {"line profile", "surface profile"}
ORIENTATION = {"parallelism", "perpendicularity", "angularity"}
LOCATION = {"position", "concentricity", "coaxiality", "symmetry"}
RUN_OUT = {"circular run-out", "total run-out"}
COAXIAL = {"coaxiality", "concentricity"}
FLAT = {"straightness", "flatness"}
ROUND = {"straightness", "roundness", "cylindricity"}


@pytest.fixture(scope="module")
def part():
    """A feature of every kind: A, B planes; C bore along Z at the origin; the rest by name."""
    p = Part()
    made = {
        "A": p.plane((0.0, 0.0, 0.0), (0.0, 0.0, -1.0), X, 200.0, 200.0),
        "B": p.plane((100.0, 0.0, 10.0), X, Y, 200.0, 20.0),
        "C": p.cylinder((0.0, 0.0, 0.0), Z, 20.0, 20.0, hole=True),
        "face": p.plane((0.0, 5.0, 20.0), Z, X, 190.0, 190.0),
        "side": p.plane((0.0, -100.0, 10.0), (0.0, -1.0, 0.0), X, 150.0, 20.0),
        "slope": p.plane((-80.0, 0.0, 25.0), (-0.6, 0.0, 0.8), Y, 50.0, 10.0),
        "boss": p.cylinder((0.0, 0.0, 20.0), Z, 30.0, 15.0),
        "hole": p.cylinder((60.0, 40.0, 0.0), Z, 4.0, 20.0, hole=True),
        "fillet": p.cylinder((90.0, 90.0, 0.0), Z, 5.0, 20.0, arc=1.5),
        "ball": p.sphere((0.0, 0.0, 70.0), 9.0),
        "ball beside": p.sphere((50.0, 0.0, 70.0), 8.0),
        "cone": p.cone((0.0, 0.0, 35.0), Z, 30.0, 25.0, 10.0),
        "thread": p.thread((-60.0, 40.0, 0.0), Z, 5.0, 20.0, 1.5),
        "slot -": p.plane((50.0, -4.0, 30.0), Y, X, 30.0, 10.0),
        "slot +": p.plane((50.0, 4.0, 30.0), (0.0, -1.0, 0.0), X, 30.0, 10.0),
        "hole 2": p.cylinder((60.0, -40.0, 0.0), Z, 4.0, 20.0, hole=True),
    }
    t = np.linspace(0, 1, 4)
    grid = np.stack([*np.meshgrid(t, t, indexing="ij"), np.zeros((4, 4))], axis=-1) * 10 + [
        0,
        60,
        22,
    ]
    up = np.broadcast_to(Z, grid.shape)
    made["extrusion"] = p.add("extrusion", grid, up, {"direction": X, "point": (0.0, 60.0, 22.0)})
    made["freeform"] = p.add("freeform", grid + np.array([30, 0, 0]), up, {})
    features = maximal_features(p.partition())
    named = {n: next(f for f in features if r in f.regions) for n, r in made.items()}
    for compound in compound_features(features, p.frame):
        if compound.kind == "slot":
            named["slot"] = compound
        elif compound.kind == "hole pattern":
            named["pattern"] = compound
    return named, p.frame


def rows(part, name, text=""):
    features, frame = part
    letters = {k: features[k] for k in "ABC"}
    system = datum_system(parse_datums(text, letters), frame) if text else None
    return {s.characteristic: s for s in permitted_specifications(features[name], system)}


def not_refused(part, name, text=""):
    return {k for k, s in rows(part, name, text).items() if s.status != "not allowed"}


def recommended(part, name, text=""):
    return [k for k, s in rows(part, name, text).items() if s.status == "recommended"]


@pytest.mark.parametrize(
    ("name", "without", "datums", "with_"),
    [
        # The table of the design, section 7; with datums each row keeps what it had without.
        ("face", FLAT, "A", {"parallelism", "angularity", "position"}),
        ("face", FLAT, "A|B|C", {*ORIENTATION, "position", *RUN_OUT}),
        ("side", FLAT, "A", {"perpendicularity", "angularity", "position"}),
        ("slope", FLAT, "A", {"angularity", "position"}),
        ("boss", ROUND, "C", {"parallelism", "angularity", "position", *COAXIAL, *RUN_OUT}),
        ("boss", ROUND, "A|B|C", {*ORIENTATION, "position", *COAXIAL, *RUN_OUT}),
        ("hole", ROUND, "A", {"perpendicularity", "angularity", "position"}),
        ("ball beside", {"roundness"}, "A|B|C", {"position"}),
        ("cone", ROUND - {"cylindricity"}, "C",
         {"parallelism", "angularity", "position", *COAXIAL, "circular run-out"}),
        ("extrusion", {"straightness"}, "A|B", {*ORIENTATION, "position"}),
        ("thread", set(), "A|B|C", {*ORIENTATION, "position"}),
        ("freeform", set(), "A|B|C", set()),
        ("slot", FLAT, "A", {"perpendicularity", "angularity", "position"}),
        ("slot", FLAT, "A|C", {*ORIENTATION, "position", "symmetry"}),
    ],
)  # fmt: skip
def test_the_table_of_permitted_characteristics(part, name, without, datums, with_):
    assert not_refused(part, name) == without | PROFILES
    assert not_refused(part, name, datums) == without | PROFILES | with_


@pytest.mark.parametrize(
    ("name", "datums", "best"),
    [
        ("A", "", "flatness"),
        ("A", "A|B|C", "flatness"),
        ("B", "A|B|C", "perpendicularity"),
        ("C", "A", "perpendicularity"),
        # B gives it a dimension.
        ("C", "A|B|C", "position"),
        ("C", "", "cylindricity"),
        ("face", "A", "surface profile"),
        ("side", "A", "perpendicularity"),
        ("slope", "A", "angularity"),
        ("side", "A|B|C", "surface profile"),
        ("hole", "A", "perpendicularity"),
        ("hole", "A|B|C", "position"),
        ("boss", "C", "coaxiality"),
        ("boss", "A|C", "coaxiality"),
        ("cone", "C", "circular run-out"),
        ("ball beside", "A|B|C", "position"),
        ("fillet", "A|B|C", "surface profile"),
        ("freeform", "A|B|C", "surface profile"),
        ("freeform", "", "surface profile"),
        ("extrusion", "", "surface profile"),
        ("slot", "A|C", "symmetry"),
        ("slot", "A|B", "perpendicularity"),
        ("thread", "A|B|C", "position"),
        ("pattern", "", "position"),
        ("pattern", "A|B|C", "position"),
    ],
)
def test_one_recommendation(part, name, datums, best):
    assert recommended(part, name, datums) == [best]


@pytest.mark.parametrize("datums", ["", "A", "C", "A|B|C"])
def test_rules_that_hold_for_every_feature(part, datums):
    for name in part[0]:
        table = rows(part, name, datums)
        assert list(table) == list(RULES)
        for key, row in table.items():
            assert row.value == "?"
            assert row.reason
            assert row.zone
            if key in FORM:
                assert (row.datum, row.datums) == ("none", "")
            if key in PROFILES:
                assert row.datum == "optional"
                assert row.status != "not allowed"
                assert row.modifiers == ()
            if key in RUN_OUT:
                assert row.modifiers == ()
            if key in ORIENTATION | LOCATION | RUN_OUT and name != "pattern":
                assert row.datum == "required"
                if not datums:
                    assert row.status == "not allowed"


def test_material_modifiers_only_on_the_derived_feature_of_a_linear_size(part):
    takes = {n: {k for k, s in rows(part, n, "A").items() if s.modifiers} for n in part[0]}
    derived = ORIENTATION | {"position", "coaxiality", "symmetry"}
    assert takes["hole"] == derived | {"straightness"}
    assert takes["slot"] == derived | {"flatness"}
    assert takes["pattern"] == takes["ball"] == derived
    for name in ("face", "fillet", "cone", "thread", "extrusion", "freeform"):
        assert takes[name] == set(), name
    assert rows(part, "hole", "A")["position"].modifiers == ("Ⓜ", "Ⓛ", "Ⓡ")


def test_zones(part):
    hole, slot, ball = (rows(part, n, "A") for n in ("hole", "slot", "ball"))
    assert (hole["position"].zone, hole["position"].prefix) == ("cylinder", "Ø")
    assert slot["position"].zone == "between two parallel planes"
    assert slot["position"].prefix == ""
    assert (ball["position"].zone, ball["position"].prefix) == ("sphere", "SØ")
    assert rows(part, "cone", "C")["circular run-out"].prefix == ""


def test_a_pattern_holds_itself_together(part):
    row = rows(part, "pattern")["position"]
    assert (row.status, row.datum, row.combination) == ("recommended", "optional", "CZ")


def test_what_stays_free_is_information_never_a_refusal(part):
    row = rows(part, "hole", "A")["position"]
    assert row.status == "allowed"
    assert row.reason == "translation along any direction perpendicular to Z stays free"


def test_a_datum_is_judged_under_the_letters_before_it(part):
    row = rows(part, "B", "A|B|C")["perpendicularity"]
    assert row.datums == "A"
    assert rows(part, "A", "A|B|C")["parallelism"].status == "not allowed"


@pytest.mark.parametrize(
    ("name", "datums", "characteristic", "words"),
    [
        ("hole", "C", "coaxiality", "isn't a datum axis"),
        ("slope", "A", "parallelism", "36.87°: use angularity"),
        ("hole", "C", "circular run-out", "doesn't turn about"),
        ("side", "C", "total run-out", "doesn't turn about"),
        ("ball", "A", "flatness", "isn't flat"),
        ("boss", "B", "symmetry", "use position"),
        ("ball beside", "C", "concentricity", "use position"),
        ("boss", "", "position", "needs a datum"),
        ("fillet", "A|B|C", "symmetry", "no median line"),
    ],
)
def test_refusals_say_why(part, name, datums, characteristic, words):
    row = rows(part, name, datums)[characteristic]
    assert row.status == "not allowed"
    assert words in row.reason


def test_run_out_of_concentric_ball_and_faces_across_the_axis(part):
    assert rows(part, "ball", "C")["circular run-out"].status == "allowed"
    assert rows(part, "ball", "C")["concentricity"].status == "allowed"
    assert rows(part, "face", "C")["total run-out"].zone.startswith("between two parallel planes")


def test_interrupted_features_are_united():
    p = Part()
    flange(p)
    p.cylinder((0.0, 0.0, 30.0), Z, 20.0, 5.0, hole=True)
    bore = next(f for f in maximal_features(p.partition()) if f.interrupted)
    assert {s.combination for s in permitted_specifications(bore)} == {"UF"}
    table = feature_table(p.partition())
    row = SpecificationRow(bore.name, "cylindricity", 0.02)
    assert [each.frame for each in specify([row], table, {})] == ["UF ⌭ 0.02"]


def test_form_of_a_group_is_that_of_each_of_its_features():
    """A countersink holds a cone, which has roundness but no cylindricity."""
    p = Part()
    p.plane((0.0, 0.0, 40.0), Z, X, 60.0, 60.0)
    p.cylinder((0.0, 0.0, 0.0), Z, 5.0, 30.0, hole=True)
    p.cone((0.0, 0.0, 30.0), Z, 5.0, 15.0, 10.0, hole=True)
    p.cylinder((25.0, 0.0, 0.0), Z, 4.0, 30.0, hole=True)
    p.cylinder((25.0, 0.0, 30.0), Z, 8.0, 10.0, hole=True)
    compounds = compound_features(maximal_features(p.partition()), p.frame)
    said = {c.kind: {s.characteristic: s for s in permitted_specifications(c)} for c in compounds}
    assert said["counterbore"]["cylindricity"].status == "allowed"
    assert said["countersink"]["roundness"].status == "allowed"
    assert said["countersink"]["cylindricity"].status == "not allowed"
    assert said["countersink"]["cylindricity"].reason.endswith("a cone: it isn't a cylinder")
