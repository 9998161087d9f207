# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scan a part that is not there: ``python examples/scan.py PART.step --out CLOUD.xyz``."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from parts.simulated_scan import Scanner, simulate

from gpswb.cad.density import Density
from gpswb.cad.read import read_solid


def main() -> None:
    """Read the command line, scan, write."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("part", type=Path)
    parser.add_argument("--out", type=Path, required=True, help="text file for the points, mm")
    parser.add_argument("--points", type=int, default=40_000)
    parser.add_argument("--noise", type=float, default=0.02, help="sigma along the normal, mm")
    parser.add_argument("--gaps", type=int, default=6)
    parser.add_argument("--outliers", type=float, default=0.005, help="share of the points")
    args = parser.parse_args()
    # Chords of an eighth of the noise stay out of sight.
    fine = Density.parse(f"deflection={max(args.noise / 8, 1e-3):g}")
    solid = read_solid(args.part, fine)
    scanner = Scanner(args.points, args.noise, gaps=args.gaps, outliers=args.outliers)
    scan = simulate(solid, scanner)
    np.savetxt(args.out, scan.points, fmt="%.6f")
    print(f"{args.out}: {len(scan.points)} points, {int((scan.label < 0).sum())} of them outliers")


if __name__ == "__main__":
    main()
