# SPDX-License-Identifier: LGPL-2.1-or-later
"""The GPS tables of report.html in a real browser."""

import json
import re
from pathlib import Path

import pytest
from gps_parts import Part, plate
from made_parts import solid_of
from test_part_page import EVIL, Page, chromium

from gpswb.gps.annotation import annotate
from gpswb.gps.feature_table import feature_table
from gpswb.gps.review import Remark
from gpswb.gps.specified import SpecificationRow
from gpswb.io.features_json import features_document
from gpswb.io.result_json import result_document
from gpswb.report.part_report import report_page

CLICK = """
<script>
const waiting = setInterval(() => {
  const rows = [...document.querySelectorAll("#features tbody tr")];
  const pattern = rows.findIndex((row) => row.cells[0].textContent === "Hole pattern 1");
  if (pattern < 0 || typeof views === "undefined" || !views.mesh) return;  // still unpacking
  clearInterval(waiting);
  rows[pattern].click();
  const lit = [...views.mesh.region].filter((id) => report.features.features[pattern].regions.includes(id));
  const found = [by("permitted-title").textContent, rows[pattern].classList.contains("chosen"), lit.length > 0];
  document.querySelectorAll("#features thead button")[0].click();
  found.push(document.querySelector("#features tr.chosen").cells[0].textContent);
  document.title = JSON.stringify(found);
}, 200);
</script></body>"""  # noqa: E501


@pytest.fixture(scope="module")
def annotated(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, int]:
    """A plate with four holes: its page, and how many features it has."""
    part = Part()
    sides, _ = plate(part)
    partition = part.partition()
    table = feature_table(partition, {r.id: [f"Face{r.id + 1}"] for r in part.regions})
    bottom = f"Face{sides[4] + 1}"
    rows = [
        SpecificationRow("Hole pattern 1", "position", 0.2, "A", ("Ⓜ",)),
        SpecificationRow(bottom, "flatness"),
    ]
    annotation = annotate(table, [("A", bottom)], rows)
    remarks = [Remark(EVIL, ("Plane 1",), "planar", EVIL)]
    solid = solid_of(partition.mesh, None, EVIL)
    features = features_document(annotation, {"path": EVIL}, remarks)
    path = tmp_path_factory.mktemp("gps") / "report.html"
    document = result_document(solid, partition, None)
    path.write_text(report_page(document, partition, None, features), encoding="utf-8")
    return path, len(table.features)


def test_features_systems_and_specifications_are_shown(annotated: tuple[Path, int]) -> None:
    path, count = annotated
    done = chromium(path.parent, "--dump-dom", path.as_uri())
    page = Page(done.stdout)
    assert not re.search(r"CONSOLE|Uncaught|Refused to", done.stderr), done.stderr
    assert page.rows["features"] == count
    assert page.rows["permitted"] == 15
    assert page.rows["specified"] == 2
    assert page.rows["review"] == 1
    assert "Datum system A" in page.text["systems"]
    assert "Suggested datum system A | B | C" in page.text["systems"]
    assert EVIL in page.text["review"]
    assert "img" not in page.tags


def test_a_feature_selects_its_regions_and_shows_what_it_permits(
    annotated: tuple[Path, int],
) -> None:
    path, _ = annotated
    clicked = path.with_name("clicked.html")
    clicked.write_text(path.read_text("utf-8").replace("</body>", CLICK), encoding="utf-8")
    done = chromium(path.parent, "--dump-dom", clicked.as_uri())
    title = re.search("<title>(.*?)</title>", done.stdout)
    assert title is not None
    assert json.loads(title[1]) == [
        "Permitted specifications: Hole pattern 1", True, True, "Hole pattern 1"
    ]  # fmt: skip


def test_without_features_their_sections_stay_away(annotated: tuple[Path, int]) -> None:
    part = Part()
    plate(part)
    partition = part.partition()
    document = result_document(solid_of(partition.mesh, None), partition, None)
    path = annotated[0].with_name("plain.html")
    path.write_text(report_page(document, partition, None), encoding="utf-8")
    page = Page(chromium(path.parent, "--dump-dom", path.as_uri()).stdout)
    assert "features" not in page.rows
    assert "hidden" in page.attributes["permitted-card"]
