# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's own specifications: what is refused, what is remarked upon, how it is written."""

from __future__ import annotations

import pytest
from gps_parts import Part, flange, plate

from gpswb.errors import InputError
from gpswb.gps.annotation import annotate
from gpswb.gps.feature_table import feature_table
from gpswb.gps.specified import SpecificationRow


@pytest.fixture(scope="module")
def table():
    part = Part()
    plate(part)
    faces = {r.id: [f"Face{r.id + 1}"] for r in part.regions}
    return feature_table(part.partition(), faces)


DATUMS = [("A", "Face5"), ("B", "Face1"), ("C", "Face3")]


def one(table, **row):
    (found,) = annotate(table, DATUMS, [SpecificationRow(**row)]).specified
    return found


@pytest.mark.parametrize(
    ("row", "frame", "remark"),
    [
        ({"feature": "Face5", "characteristic": "flatness", "value": 0.05}, "⏥ 0.05", ""),
        ({"feature": "Face5", "characteristic": "flatness"}, "⏥ ?", ""),
        (
            {"feature": "Hole pattern 1", "characteristic": "position", "value": 0.2,
             "datums": "A|B|C", "modifiers": ("Ⓜ",)},
            "4× ⌖ Ø0.2 CZ Ⓜ | A | B | C", "",
        ),
        ({"feature": "Hole pattern 1", "characteristic": "size", "fit": "H13"}, "4× Ø8 H13", ""),
        # Zero at maximum material (ISO 2692).
        (
            {"feature": "Hole 1", "characteristic": "perpendicularity", "value": 0.0,
             "datums": "A", "modifiers": ("Ⓜ",)},
            "⟂ Ø0 Ⓜ | A", "",
        ),
        # With a modifier it is the median line that has to be straight.
        (
            {"feature": "Hole 1", "characteristic": "straightness", "value": 0.1,
             "modifiers": ("Ⓜ",)},
            "⏤ Ø0.1 Ⓜ", "",
        ),
        (
            {"feature": "Hole 1", "characteristic": "straightness", "value": 0.1}, "⏤ 0.1", "",
        ),
        ({"feature": "Face6", "characteristic": "cylindricity", "value": 0.1}, "⌭ 0.1",
         "Plane 2: it isn't a cylinder"),
        ({"feature": "Face6", "characteristic": "position", "value": 0.1, "datums": "A",
          "modifiers": ("Ⓜ",)}, "⌖ 0.1 Ⓜ | A", "Ⓜ doesn't go with it (ISO 2692)"),
        ({"feature": "Hole 1", "characteristic": "position", "value": 0.1, "datums": "A|B|C",
          "modifiers": ("Ⓡ",)}, "⌖ Ø0.1 Ⓡ | A | B | C", "Ⓡ stands after Ⓜ or Ⓛ only (ISO 2692)"),
        ({"feature": "Hole 1", "characteristic": "position", "value": 0.1, "datums": "A|B|C",
          "modifiers": ("Ⓜ", "Ⓛ")}, "⌖ Ø0.1 Ⓜ Ⓛ | A | B | C",
         "Ⓜ and Ⓛ exclude each other (ISO 2692)"),
        ({"feature": "Hole 1", "characteristic": "size", "upper": 0.022, "lower": 0.0},
         "Ø8 +0.022/+0", ""),
        ({"feature": "Hole 1", "characteristic": "size", "fit": "H7"}, "Ø8 H7", ""),
        ({"feature": "Hole 1", "characteristic": "size"}, "Ø8 ?", ""),
    ],
)  # fmt: skip
def test_indications_and_remarks(table, row, frame, remark):
    found = one(table, **row)
    assert (found.frame, getattr(found, "remark", "")) == (frame, remark)


@pytest.mark.parametrize(
    ("row", "words"),
    [
        ({"feature": "Face77", "characteristic": "flatness"},
         "'Face77' is neither a feature nor a face of one"),
        ({"feature": "Hole 1 + Face77", "characteristic": "flatness"},
         "'Face77' in 'Hole 1 + Face77' is neither"),
        ({"feature": "<b>", "characteristic": "flatness"}, "'<b>' is neither"),
        ({"feature": "Face5+Face1", "characteristic": "flatness"}, "name one feature"),
        ({"feature": "Face5", "characteristic": "flatnes"}, "did you mean 'flatness'?"),
        ({"feature": "Face5", "characteristic": "flatness", "value": -1.0},
         "needs a value above 0"),
        ({"feature": "Face5", "characteristic": "flatness", "value": 0.0},
         "needs a value above 0"),
        ({"feature": "Hole 1", "characteristic": "position", "value": -0.1, "datums": "A",
          "modifiers": ("Ⓛ",)}, "needs a value of at least 0"),
        ({"feature": "Face5", "characteristic": "flatness", "datums": "B"}, "takes no datum"),
        ({"feature": "Face6", "characteristic": "parallelism", "datums": "Z"},
         "parallelism of 'Face6': datum Z in 'Z' isn't assigned"),
        ({"feature": "Face5", "characteristic": "size", "upper": 1.0, "lower": 0.0},
         "no feature of size"),
        ({"feature": "Hole 1", "characteristic": "size", "upper": 1.0}, "both deviations"),
        ({"feature": "Hole 1", "characteristic": "size", "upper": -1.0, "lower": 0.0},
         "the lower deviation is above the upper one"),
        ({"feature": "Hole 1", "characteristic": "size", "fit": "g6"},
         "g6 is a class of shafts and ribs, Hole 1 is internal"),
    ],
)  # fmt: skip
def test_what_can_not_be_meant_is_refused_in_one_line(table, row, words):
    with pytest.raises(InputError) as error:
        one(table, **row)
    assert words in str(error.value)
    assert "\n" not in str(error.value)


def test_datums_that_are_wrong_name_their_letter(table):
    with pytest.raises(InputError, match="datum A is given twice"):
        annotate(table, [("A", "Face1"), ("A", "Face2")])
    with pytest.raises(InputError, match="datum B: 'Hole 9' is neither"):
        annotate(table, [("A", "Face1"), ("B", "Hole 9")])


def test_each_specification_refers_to_the_datum_that_it_needs():
    """Run-out and coaxiality to the bore alone, orientation to the face alone, position to all."""
    part = Part()
    top, bottom, rim, bore, bolts = flange(part)
    table = feature_table(part.partition(), {r.id: [f"Face{r.id + 1}"] for r in part.regions})
    datums = [("A", f"Face{bottom + 1}"), ("B", f"Face{bore + 1}"), ("C", f"Face{bolts[0] + 1}")]
    annotation = annotate(table, datums)

    def sections(region):
        feature = next(f for f in table.integral if region in f.regions)
        return {s.characteristic: s.datums for s in annotation.permitted[feature.id]}

    assert sections(rim)["coaxiality"] == sections(rim)["circular run-out"] == "B"
    assert sections(rim)["perpendicularity"] == "A"
    assert sections(rim)["position"] == "A|B|C"
    assert sections(top)["parallelism"] == "A"
    assert sections(top)["perpendicularity"] == "B"
    assert sections(bore)["perpendicularity"] == "A"
    assert sections(bore)["coaxiality"] == "A"  # under the letters before its own; not allowed


def test_a_compound_of_a_datum_is_judged_under_the_letters_before_it(table):
    annotation = annotate(table, DATUMS)
    thickness = next(f for f in table.compounds if f.kind == "rib" and "Face5" in f.faces)
    rows = {s.characteristic: s for s in annotation.permitted[thickness.id]}
    assert rows["position"].status == "not allowed"
    assert "needs a datum" in rows["position"].reason
