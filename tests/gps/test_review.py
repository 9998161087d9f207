# SPDX-License-Identifier: LGPL-2.1-or-later
"""Existing PMI against the features: what a tolerancing engineer would remark upon."""

from __future__ import annotations

import pytest
from gps_parts import Part, plate

from gpswb.cad.pmi import Pmi, PmiDatum, PmiSize, PmiTolerance
from gpswb.gps.feature_table import feature_table
from gpswb.gps.review import review

# Sides of the plate are Face1 to Face6 (-X, +X, -Y, +Y, -Z, +Z), its holes Face7 to Face10.
BOTTOM, SIDE, END, HOLE = "Face5", "Face3", "Face1", "Face7"
DATUMS = (PmiDatum("A", (BOTTOM,)), PmiDatum("B", (SIDE,)), PmiDatum("C", (END,)))


@pytest.fixture(scope="module")
def table():
    part = Part()
    plate(part)
    faces = {r.id: [f"Face{r.id + 1}"] for r in part.regions}
    faces[6] = ["Face7", "Face7b"]
    return feature_table(part.partition(), faces)


def tolerance(name, faces, value=0.1, datums="", modifiers=(), prefix=""):
    return PmiTolerance(name, name, value, prefix, modifiers, datums, tuple(faces))


def the_last(table, *, datums=DATUMS, tolerances=(), sizes=()):
    return review(Pmi(tuple(datums), tuple(tolerances), tuple(sizes)), table)[-1]


@pytest.mark.parametrize(
    ("given", "text"),
    [
        (tolerance("flatness", [BOTTOM]), ""),
        (tolerance("flatness", [HOLE, "Face7b"]), "not allowed: Hole 1: it isn't flat"),
        (tolerance("flatness", []), "it isn't on faces"),
        (tolerance("flatness", [BOTTOM], None), "it has no value"),
        (tolerance("flatness", [BOTTOM], 0.0), "it has no value"),
        (tolerance("perpendicularity", [HOLE], 0.0, "A", ("Ⓜ",), "Ø"), ""),
        (tolerance("parallelism", [SIDE], datums="A"), "use perpendicularity"),
        (tolerance("position", [HOLE], datums="A|B|C"), ""),
        (tolerance("position", [HOLE], datums="A|B"), "Hole 1: translation along X stays free"),
        (tolerance("position", [HOLE], datums="A|D"), "datum D has no feature that resolves"),
        (tolerance("position", [HOLE], datums="A|B|A"), "datum A stands twice"),
        (tolerance("coaxiality", [HOLE], datums="A"), "its axis isn't a datum axis: use position"),
        (tolerance("surface profile", [BOTTOM, SIDE]), ""),
    ],
)
def test_tolerances(table, given, text):
    remark = the_last(table, tolerances=[given])
    assert text in remark.text
    assert bool(text) == bool(remark.text)


def test_indications_are_spelt_as_in_a_frame(table):
    given = tolerance("position", [HOLE], 0.25, "A|B|C", ("Ⓜ",), "Ø")
    assert the_last(table, tolerances=[given]).subject == "⌖ position Ø0.25 Ⓜ | A | B | C"


@pytest.mark.parametrize(
    ("datum", "features", "union", "text"),
    [
        (PmiDatum("D", (BOTTOM,)), ("Plane 1",), "planar", ""),
        (PmiDatum("D", (HOLE,)), ("Hole 1",), "cylindrical", "the feature goes on over Face7b"),
        (PmiDatum("D", (BOTTOM, SIDE)), ("Plane 1", "Plane 3"), "prismatic", ""),
        (PmiDatum("D", ()), (), "", "no feature of the part resolves"),
        (PmiDatum("D", (), target=True), (), "", "datum targets"),
        (PmiDatum("D", (BOTTOM,), target=True), ("Plane 1",), "planar", "datum targets"),
    ],
)
def test_datums(table, datum, features, union, text):
    remark = the_last(table, datums=[datum])
    assert (remark.features, remark.invariance_class) == (features, union)
    assert text in remark.text
    assert bool(text) == bool(remark.text)


@pytest.mark.parametrize(
    ("nominal", "text"), [(8.0, ""), (8.5, "the model has Hole 1, Ø8"), (None, "")]
)
def test_sizes(table, nominal, text):
    remark = the_last(table, sizes=[PmiSize("diameter", nominal, -0.1, 0.2, "", (HOLE,))])
    assert remark.text.startswith(text)
    assert bool(text) == bool(remark.text)
    assert remark.subject.endswith("+0.2/-0.1")


def test_a_group_of_holes_is_the_pattern(table):
    holes = ("Face7", "Face7b", "Face8", "Face9", "Face10")
    given = tolerance("position", holes, datums="A|B|C")
    assert the_last(table, tolerances=[given]).features == ("Hole pattern 1",)
