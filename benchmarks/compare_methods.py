# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every method on the same meshes: ``python benchmarks/compare_methods.py [PART...]``.

A part is an example's name or a file; all examples if none is named. Renews the section ``methods``
of docs/validation.md after each mesh, so that a run that is cut short leaves what it has found;
what the same code made of a mesh before is taken from build/measured.
"""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

# Before numpy starts its threads: CPU seconds are to be those of one.
os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", MKL_NUM_THREADS="1")

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "validation.md"
sys.path.insert(0, str(ROOT / "examples"))


def main() -> None:
    """Run, and renew the section."""
    from method_comparison import sections
    from parts import PARTS

    from gpswb.io.whole import write_whole
    from gpswb.report.corpus_markdown import renew_section

    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("parts", nargs="*", metavar="PART", help="example or file; all examples")
    parser.add_argument("--limit", type=float, default=60.0, help="CPU seconds of a run; 60")
    args = parser.parse_args()
    for section in sections(args.parts or list(PARTS), args.limit):
        text = PAGE.read_text(encoding="utf-8")
        write_whole(PAGE, renew_section(text, "methods", section))


if __name__ == "__main__":
    main()
