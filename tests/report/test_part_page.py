# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html in a real browser: it draws, counts right, and obeys no string of the data."""

import base64
import json
import re
import subprocess
import zlib
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from made_parts import put_together, row_of_squares, solid_of, truth
from matplotlib.image import imread

from gpswb.io.colours import WHEEL
from gpswb.io.result_json import result_document
from gpswb.report.pack import pack
from gpswb.report.part_report import report_page, script_json
from gpswb.validation.validate import validate

EVIL = "</script><img src=x onerror=alert(1)>\u2028`${alert(2)}`\"'&amp;.step"


def chromium(directory: Path, *options: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [
            "chromium",
            "--headless",
            "--no-sandbox",
            "--use-gl=angle",
            "--use-angle=swiftshader",
            "--enable-unsafe-swiftshader",
            "--enable-logging=stderr",
            f"--user-data-dir={directory / 'profile'}",
            "--virtual-time-budget=30000",
            "--window-size=1200,1400",
            *options,
        ],
        capture_output=True,
        text=True,
        timeout=120,
        check=True,
    )


class Page(HTMLParser):
    """Rows of each table body, texts by id, and the elements that there are."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.rows: dict[str, int] = {}
        self.text: dict[str, str] = {}
        self.tags: set[str] = set()
        self.attributes: dict[str, dict] = {}
        self.table, self.body, self.open = "", False, ""
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list) -> None:
        found = dict(attrs)
        self.tags.add(tag)
        self.body = tag == "tbody" or (self.body and tag != "thead")
        if tag == "table":
            self.table, self.body = found.get("id", ""), False
        if tag == "tr" and self.body:
            self.rows[self.table] = self.rows.get(self.table, 0) + 1
        if "id" in found:
            self.open = found["id"]
            self.attributes[self.open] = found
        if tag == "html":
            self.attributes["html"] = found

    def handle_data(self, data: str) -> None:
        self.text[self.open] = self.text.get(self.open, "") + data


@pytest.fixture(scope="module")
def page_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    partition, facemap = put_together(
        row_of_squares(4, (4, 4)),
        [truth("planar"), truth("cylindrical"), truth("helical"), truth("planar")],
        [0, 1, 2, 3],
        ["planar", "cylindrical", "planar", "spherical"],
    )
    solid = replace(solid_of(partition.mesh, facemap, EVIL), notes=(EVIL,))
    document = result_document(solid, partition, validate(partition, facemap))
    path = tmp_path_factory.mktemp("page") / "report.html"
    path.write_text(report_page(document, partition, facemap), encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def dumped(page_file: Path) -> tuple[Page, str]:
    done = chromium(page_file.parent, "--dump-dom", f"{page_file.as_uri()}#region=2")
    return Page(done.stdout), done.stderr


def test_views_start_and_nothing_goes_wrong(dumped: tuple[Page, str]) -> None:
    page, log = dumped
    assert page.attributes["html"]["data-ready"] == "3d"
    assert "hidden" in page.attributes["fault"]
    assert not re.search(r"CONSOLE|Uncaught|Refused to", log), log


def test_tables_count_what_the_result_holds(dumped: tuple[Page, str]) -> None:
    page, _ = dumped
    assert page.rows["regions"] == 4
    assert page.rows["disagree"] == 2
    assert page.rows["confusion"] == page.rows["classes"] == page.rows["ranking-table"] == 7
    assert "(2 of 4)" in page.text["wrong-title"]
    assert "region 2" in page.text["ranking-title"]


def test_strings_of_the_data_stay_text(dumped: tuple[Page, str]) -> None:
    page, _ = dumped
    assert "img" not in page.tags
    assert EVIL.rsplit("/", 1)[-1] in page.text["title"]
    assert EVIL in page.text["notes"]


def test_classes_are_drawn_in_their_colours(page_file: Path) -> None:
    png = page_file.parent / "page.png"
    chromium(page_file.parent, f"--screenshot={png}", page_file.as_uri())
    image = 255 * imread(png)[:, :, :3]
    length = np.linalg.norm(image, axis=2)
    for name in ("planar", "cylindrical", "spherical"):
        unit = np.array(WHEEL[name]) / np.linalg.norm(WHEEL[name])
        like = (image @ unit / np.maximum(length, 1) > 0.9995) & (length > 60)
        # A quarter of the part each (planar: half), far more than a legend's swatches, and in the
        # right half of the window: panel d stands there.
        assert like[:, 600:].sum() > 3000, name


CLICKS = """
<script>
setTimeout(() => {
  views.look("top");
  const panel = document.querySelector('[data-view="class"]'), box = panel.getBoundingClientRect();
  panel.setPointerCapture = () => {};
  const found = [0, 1, 2, 3, 9].map((square) => {
    // The row of four squares spans 1.75 / 2 of the panel's width.
    const clientX = box.left + box.width * Math.min(0.5 + (square - 1.5) * 1.75 / 8, 0.98);
    const clientY = box.top + box.height / 2;
    for (const kind of ["pointerdown", "pointerup"])
      panel.dispatchEvent(new PointerEvent(kind, { clientX, clientY, button: 0, pointerId: 1 }));
    return chosen;
  });
  document.querySelectorAll("#regions thead button")[0].click();
  found.push(document.querySelector("#regions tbody th").textContent);
  document.querySelectorAll("#regions tbody tr")[1].click();
  found.push(document.querySelector("#regions tr.chosen").dataset.region);
  document.title = JSON.stringify(found);
}, 2000);
</script></body>"""


def test_click_selects_the_region_under_it(page_file: Path) -> None:
    clicked = page_file.with_name("clicked.html")
    text = page_file.read_text("utf-8").replace("</body>", CLICKS)
    clicked.write_text(text, encoding="utf-8")
    done = chromium(page_file.parent, "--dump-dom", clicked.as_uri())
    title = re.search("<title>(.*?)</title>", done.stdout)
    assert title is not None
    # Each square its region, the background none; sorted downwards region 3 stands first.
    assert json.loads(title[1]) == [0, 1, 2, 3, None, "3", "2"]


@given(hnp.arrays(np.int32, st.integers(0, 50), elements=st.integers(-(2**31), 2**31 - 1)))
def test_packing_loses_nothing(values: np.ndarray) -> None:
    packed = pack(values)
    planes = np.frombuffer(zlib.decompress(base64.b64decode(packed["data"])), np.uint8)
    n = packed["length"]
    steps = planes.reshape(4, n).T.copy().view("<i4").reshape(n)
    assert np.array_equal(np.cumsum(steps, dtype=np.int32), values)


@given(st.text())
def test_json_in_a_script_is_the_same_json_and_closes_nothing(text: str) -> None:
    safe = script_json({"text": text})
    assert json.loads(safe) == {"text": text}
    assert not set("<>&\u2028\u2029") & set(safe)
