# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables that a spreadsheet opens without evaluating anything."""

import csv
from pathlib import Path

import pytest

from gpswb.io.csv_table import write_csv


@pytest.mark.parametrize("text", ["=1+1", "+cmd|' /C calc'!A0", "-2+3", "@SUM(A1)", "\t=1", "-"])
def test_text_is_no_formula(tmp_path: Path, text: str) -> None:
    write_csv(tmp_path / "t.csv", ("a", "b"), [(text, "x")])
    with (tmp_path / "t.csv").open(newline="", encoding="utf-8") as file:
        assert list(csv.reader(file)) == [["a", "b"], [f"'{text}", "x"]]


def test_numbers_and_other_text_stay_what_they_are(tmp_path: Path) -> None:
    row = (-1.5, "-1.5", "-1 0 2.5e-3", None, 'say "a, b"', "a=b", "ä⌀\nnext")
    write_csv(tmp_path / "t.csv", "abcdefg", [row])
    with (tmp_path / "t.csv").open(newline="", encoding="utf-8") as file:
        _, read = csv.reader(file)
    assert read == ["-1.5", "-1.5", "-1 0 2.5e-3", "", 'say "a, b"', "a=b", "ä⌀\nnext"]
