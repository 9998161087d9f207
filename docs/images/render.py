# SPDX-License-Identifier: LGPL-2.1-or-later
"""Render the picture of the README from a report: ``python docs/images/render.py REPORT.html``.

Chromium draws the page with all but the four views and their legend hidden.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image, ImageChops

STYLE = """<style>
header, #figures, .controls, #ranking, #validation, #validation ~ section, #classes ~ p,
main > .card { display: none !important; }
</style></head>"""
WIDTH, HEIGHT, SCALE = 1040, 1300, 1.4
OUT = Path(__file__).with_name("bracket.png")


def main() -> None:
    """Draw, cut the empty margin away, reduce to 256 colours."""
    with tempfile.TemporaryDirectory() as scratch:
        page, shot = Path(scratch) / "page.html", Path(scratch) / "page.png"
        report = Path(sys.argv[1]).read_text(encoding="utf-8")
        page.write_text(report.replace("</head>", STYLE, 1), encoding="utf-8")
        command = [
            "chromium", "--headless", "--no-sandbox", "--use-angle=swiftshader",
            "--enable-unsafe-swiftshader", "--hide-scrollbars", "--virtual-time-budget=8000",
            f"--user-data-dir={scratch}/profile", f"--window-size={WIDTH},{HEIGHT}",
            f"--force-device-scale-factor={SCALE}", f"--screenshot={shot}", page.as_uri(),
        ]  # fmt: skip
        subprocess.run(command, check=True, capture_output=True, timeout=120)  # noqa: S603
        picture = Image.open(shot).convert("RGB")
    ground = Image.new("RGB", picture.size, picture.getpixel((0, 0)))
    box = ImageChops.difference(picture, ground).getbbox()
    picture.crop(box).quantize(256, dither=Image.Dither.NONE).save(OUT, optimize=True)


if __name__ == "__main__":
    main()
