# SPDX-License-Identifier: LGPL-2.1-or-later
from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from gps_parts import Part, X, Y, Z, box, flange, plate, shaft

from gpswb.errors import InputError
from gpswb.gps.compound import compound_features
from gpswb.gps.datum_system import (
    Datum,
    datum_system,
    freedom_left,
    parse_datums,
    part_situation,
)
from gpswb.gps.explain import explain_datum_system, explain_freedom
from gpswb.gps.features import maximal_features
from gpswb.gps.suggest_datums import suggest_datums
from gpswb.gps.twists import Frame

OBLIQUE = (0.6, 0.0, 0.8)


@pytest.fixture(scope="module")
def letters():
    """One feature a letter, none of one surface with another."""
    part = Part()
    made = {
        "A": part.plane((50.0, 30.0, 0.0), (0.0, 0.0, -1.0), X, 100.0, 60.0),
        "B": part.plane((50.0, 0.0, 5.0), (0.0, -1.0, 0.0), X, 100.0, 10.0),
        "C": part.plane((0.0, 30.0, 5.0), (-1.0, 0.0, 0.0), Y, 60.0, 10.0),
        "D": part.cylinder((20.0, 20.0, 0.0), Z, 4.0, 10.0, hole=True),
        "E": part.cylinder((80.0, 40.0, 0.0), Z, 5.0, 10.0, hole=True),
        "F": part.plane((50.0, 30.0, 10.0), Z, X, 90.0, 50.0),
        "G": part.sphere((50.0, 30.0, 40.0), 6.0),
        "H": part.sphere((10.0, 30.0, 40.0), 5.0),
        "J": part.sphere((40.0, 10.0, 60.0), 4.0),
        "K": part.thread((60.0, 15.0, 0.0), Z, 3.0, 10.0, 1.0),
        "L": part.plane((100.0, 30.0, 5.0), OBLIQUE, Y, 30.0, 8.0),
        "M": part.cone((20.0, 20.0, 10.0), Z, 4.0, 8.0, 4.0, hole=True),
        "N": part.cylinder((0.0, 50.0, 20.0), X, 3.0, 30.0),
    }
    features = maximal_features(part.partition())
    found = {
        letter: next(f for f in features if region in f.regions) for letter, region in made.items()
    }
    assert len({f.id for f in found.values()}) == len(found)
    return found, part.frame


@pytest.mark.parametrize(
    ("text", "locks"),
    [
        # Plane, plane, plane: the 3-2-1 of every textbook.
        ("A|B|C", [(1, 2), (1, 1), (1, 0)]),
        # Plane, hole, hole.
        ("A|D|E", [(1, 2), (2, 0), (0, 1)]),
        # Plane, hole, side.
        ("A|D|B", [(1, 2), (2, 0), (0, 1)]),
        # The hole leads: the plane only stops it.
        ("D|A|E", [(2, 2), (1, 0), (0, 1)]),
        # A plane parallel to the first is redundant.
        ("A|F", [(1, 2), (0, 0)]),
        ("A|B|F|C", [(1, 2), (1, 1), (0, 0), (1, 0)]),
        # Two holes as one datum: a plane and a line, 2T + 3R.
        ("D-E", [(2, 3)]),
        ("A|D-E", [(1, 2), (2, 1)]),
        ("D-E|A", [(2, 3), (1, 0)]),
        # Three spheres on their own and in common.
        ("G|H|J", [(3, 0), (0, 2), (0, 1)]),
        ("G-H-J", [(3, 3)]),
        ("G-H", [(3, 2)]),
        # Plane and sphere; sphere on a cylinder's flank.
        ("A|G", [(1, 2), (2, 0)]),
        # A thread is its pitch cylinder as a datum: 4, not 5.
        ("K", [(2, 2)]),
        ("K|A", [(2, 2), (1, 0)]),
        # Cone: axis and point; coaxial with D it adds only the point.
        ("M", [(3, 2)]),
        ("D|M", [(2, 2), (1, 0)]),
        ("M|D", [(3, 2), (0, 0)]),
        # Orientation only.
        ("A><", [(0, 2)]),
        ("D><|A", [(0, 2), (1, 0)]),
        ("A|B><", [(1, 2), (0, 1)]),
        ("D-E><", [(0, 3)]),
        ("G><", [(0, 0)]),
        # Crossing cylinders, wedge.
        ("D|N", [(2, 2), (1, 1)]),
        ("A|L", [(1, 2), (1, 1)]),
        ("A-B-C", [(3, 3)]),
    ],
)
def test_degrees_that_each_letter_locks(letters, text, locks):
    features, frame = letters
    system = datum_system(parse_datums(text, features), frame)
    assert [(lock.translations, lock.rotations) for lock in system.locks] == locks
    assert system.degrees == sum(map(sum, locks))
    assert system.notation == text
    assert list(system.redundant) == [
        n for n, k in zip(text.split("|"), locks, strict=True) if k == (0, 0)
    ]


@pytest.mark.parametrize(
    ("text", "letter", "words"),
    [
        ("A|B|C", "D", "the datums locate it fully"),
        ("A", "F", "the datums locate it fully"),
        ("A", "B", "translation along Y and rotation about Z stays free"),
        ("A|B", "C", "translation along X stays free"),
        ("D", "E", "rotation about Z stays free"),
        ("D", "F", "translation along Z stays free"),
        ("A|D", "E", "rotation about Z stays free"),
        ("A|D", "M", "the datums locate it fully"),
        ("D", "M", "translation along Z stays free"),
        ("D-E", "K", "translation along Z stays free"),
        ("A", "G", "translation along any direction perpendicular to Z stays free"),
        ("G", "H", "rotation about any direction perpendicular to X stays free"),
        ("", "G", "translation along any direction stays free"),
        ("B", "L", "translation along (0.6, 0, 0.8) and rotation about Y stays free"),
        ("A><", "F", "translation along Z stays free"),
        # Sliding along its axis is the only translation that D leaves.
        ("D", "L", "translation along Z and rotation about Z stays free"),
    ],
)
def test_what_stays_free(letters, text, letter, words):
    features, frame = letters
    datums = parse_datums(text, features) if text else ()
    freedom = freedom_left(datum_system(datums, frame), features[letter])
    assert explain_freedom(freedom) == words


def test_oriented_but_not_located(letters):
    features, frame = letters
    a = datum_system(parse_datums("A", features), frame)
    assert freedom_left(a, features["D"]).oriented
    assert not freedom_left(a, features["D"]).located
    assert not freedom_left(a, features["B"]).oriented
    assert freedom_left(datum_system(parse_datums("A|B", features), frame), features["C"]).oriented


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("A|Q", "datum Q in 'A|Q' isn't assigned"),
        ("A||B", "'' in 'A||B' is no datum"),
        ("A|b", "'b' in 'A|b' is no datum"),
        ("A-", "'A-' in 'A-' is no datum"),
    ],
)
def test_bad_notation_is_refused(letters, text, message):
    with pytest.raises(InputError) as error:
        parse_datums(text, letters[0])
    assert message in str(error.value)


def suggested(make):
    part = Part()
    ids = make(part)
    features = maximal_features(part.partition())
    features += compound_features(features, part.frame)
    return ids, suggest_datums(features, part.frame), features, part.frame


def primary(suggestion):
    return [datum.features[0] for datum in suggestion.system.datums]


def test_a_plate_gets_three_planes():
    _, (best, runner_up), _, _ = suggested(plate)
    assert [f.surface for f in primary(best)] == ["plane"] * 3
    assert [lock.degrees for lock in best.system.locks] == [3, 2, 1]
    assert best.complete
    assert best.needed == 6
    assert runner_up.complete
    assert primary(runner_up)[0] is not primary(best)[0]


def test_a_flange_gets_its_face_a_bore_and_a_bolt_hole():
    _, (best, *_), _, _ = suggested(flange)
    assert [f.surface for f in primary(best)] == ["plane", "cylinder", "cylinder"]
    assert [lock.degrees for lock in best.system.locks] == [3, 2, 1]
    assert primary(best)[2].size.value == 10.0


def test_a_turned_part_stops_at_five():
    _, suggestions, features, frame = suggested(shaft)
    assert part_situation(features, frame).invariance_class == "revolute"
    assert len(suggestions) == 2
    for suggestion in suggestions:
        assert suggestion.needed == suggestion.system.degrees == 5
        assert suggestion.system.redundant == ()
        assert primary(suggestion)[0].surface == "cylinder"


@pytest.mark.parametrize("seed", range(12))
def test_suggestions_are_complete_and_without_zero_gain(seed):
    """Three letters always suffice: each takes one step down a chain of subgroups."""
    rng = np.random.default_rng(seed)
    part = Part()
    for _ in range(rng.integers(1, 9)):
        point = tuple(rng.uniform(-50, 50, 3))
        axis = tuple(np.eye(3)[rng.integers(3)])
        kind = rng.integers(4)
        if kind == 0:
            part.plane(point, axis, tuple(np.roll(axis, 1)), *rng.uniform(5, 50, 2))
        elif kind == 1:
            part.cylinder(point, axis, rng.uniform(2, 20), rng.uniform(5, 50))
        elif kind == 2:
            part.sphere(point, rng.uniform(2, 20))
        else:
            part.cone(point, axis, 10.0, rng.uniform(2, 9), rng.uniform(5, 20))
    features = maximal_features(part.partition())
    suggestions = suggest_datums(features, part.frame)
    assert suggestions
    for suggestion in suggestions:
        assert suggestion.complete
        assert len(suggestion.system.datums) <= 3
        assert all(lock.degrees > 0 for lock in suggestion.system.locks)


def test_nothing_is_suggested_without_features():
    assert suggest_datums((), Frame()) == ()


def test_an_undecided_feature_takes_no_symmetry_from_the_part():
    part = Part()
    shaft(part)
    part.cylinder((60.0, 0.0, 0.0), Z, 3.0, 20.0, hole=True)
    features = maximal_features(part.partition())
    assert part_situation(features, part.frame).invariance_class == "complex"
    part.regions[-1] = replace(part.regions[-1], undecided=("spherical", "cylindrical"))
    features = maximal_features(part.partition())
    assert part_situation(features, part.frame).invariance_class == "revolute"


def test_the_explanation_names_letters_degrees_and_redundancy(letters):
    features, frame = letters
    text = explain_datum_system(datum_system(parse_datums("A|F|D><", features), frame), 6)
    first, second, third, last, free = text.splitlines()
    assert first.startswith("A (Plane")
    assert first.endswith("locks one translation and two rotations.")
    assert second.startswith("F (")
    assert "redundant" in second
    assert "for orientation only" in third
    assert "three of the six" in last
    assert free == (
        "Of the part translation along any direction perpendicular to Z and rotation about Z "
        "stays free."
    )
    complete = explain_datum_system(datum_system(parse_datums("A|B|C", features), frame), 6)
    assert complete.endswith("Together they lock six of six: complete.")
    assert explain_datum_system(datum_system((), frame), 6) == "Without a datum nothing is locked."


def test_the_same_system_by_hand(letters):
    """``Datum`` objects and notation are two ways to one system."""
    features, frame = letters
    hand = datum_system(
        [Datum("A", (features["A"],)), Datum("D-E", (features["D"], features["E"]))], frame
    )
    assert hand.locks == datum_system(parse_datums("A|D-E", features), frame).locks


def test_a_box_needs_six():
    part = Part()
    box(part, (0, 0, 0), (30, 20, 10))
    (best, second) = suggest_datums(maximal_features(part.partition()), part.frame)
    assert best.needed == second.needed == 6


def test_a_slope_gives_way_to_a_smaller_face_that_stands_square():
    def make(part):
        base = part.plane((0.0, 0.0, 0.0), (0.0, 0.0, -1.0), X, 200.0, 200.0)
        part.plane((60.0, 0.0, 30.0), OBLIQUE, Y, 150.0, 60.0)
        side = part.plane((0.0, 100.0, 10.0), Y, X, 150.0, 20.0)
        part.plane((-100.0, 0.0, 10.0), (-1.0, 0.0, 0.0), Y, 100.0, 20.0)
        return base, side

    (base, side), (best, *_), _, _ = suggested(make)
    assert [f.regions for f in primary(best)[:2]] == [(base,), (side,)]
    assert best.complete
