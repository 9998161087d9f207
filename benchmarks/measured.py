# SPDX-License-Identifier: LGPL-2.1-or-later
"""Renew docs/measured.md: ``python benchmarks/measured.py [CORPUS] [SECTION...]``.

Sections: blade, methods, noise, and corpus, which needs a directory of labelled meshes and clouds.
"""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

# Before numpy starts its threads: CPU seconds are to be those of one.
os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", MKL_NUM_THREADS="1")

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "measured.md"
IMAGES = ROOT / "docs" / "images"
sys.path.insert(0, str(ROOT / "examples"))


def main() -> None:
    """Run the sections asked for, each of which replaces its own part of the page."""
    from measured_corpus import corpus_section
    from measured_parts import blade_section, methods_section, noise_section

    from gpswb.io.whole import write_whole
    from gpswb.report.corpus_markdown import renew_section

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--corpus", type=Path, help="directory with mesh/ and cloud/")
    parser.add_argument("sections", nargs="*", metavar="SECTION", help="all that can be made")
    args = parser.parse_args()
    makers = {
        "corpus": lambda: corpus_section(args.corpus, IMAGES),
        "blade": lambda: blade_section(IMAGES),
        "methods": lambda: methods_section(IMAGES),
        "noise": lambda: noise_section(IMAGES),
    }
    if args.corpus is None:
        del makers["corpus"]
    unknown = [name for name in args.sections if name not in makers]
    if unknown:
        parser.error(f"no section {', '.join(unknown)}; there are {', '.join(makers)}")
    for name in args.sections or makers:
        # A section grows: what a run that is cut short has found stands on the page.
        for section in makers[name]():
            text = PAGE.read_text(encoding="utf-8")
            write_whole(PAGE, renew_section(text, name, section))
        print(f"{PAGE.relative_to(ROOT)}: section {name} renewed", flush=True)


if __name__ == "__main__":
    main()
