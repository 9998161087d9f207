# SPDX-License-Identifier: LGPL-2.1-or-later
"""Build the example parts as STEP files: ``python examples/build.py --out DIR [NAME...]``."""

from __future__ import annotations

import argparse
from pathlib import Path

from parts import PARTS
from parts.made import MadePart
from parts.step_units import write_step


def build(out: Path, names: list[str]) -> list[Path]:
    """Write the named parts to ``out``; return the files."""
    out.mkdir(parents=True, exist_ok=True)
    files = []
    for name in names:
        part: MadePart = PARTS[name]()
        file = out / f"{part.name}.step"
        write_step(part.shape, file)
        files.append(file)
    return files


def main() -> None:
    """Read the command line and build."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, required=True, help="directory for the STEP files")
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"of {', '.join(PARTS)}; all")
    args = parser.parse_args()
    unknown = [name for name in args.names if name not in PARTS]
    if unknown:
        parser.error(f"no part named {', '.join(unknown)}; there are {', '.join(PARTS)}")
    for file in build(args.out, args.names or list(PARTS)):
        print(file)


if __name__ == "__main__":
    main()
