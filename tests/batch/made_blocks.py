# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small meshes as parts: no kernel has to read them."""

from pathlib import Path

from gpswb.batch.settings import Settings
from gpswb.cad.density import Density

SETTINGS = Settings(Density("auto"), "robust", "curvature", "ocp")

POINTS = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
QUADS = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]


def off_block(height: float) -> str:
    """A block 1 x 1 x height as an OFF file."""
    lines = ["OFF", "8 12 0", *(f"{x} {y} {height * z}" for x, y, z in POINTS)]
    lines += [f"3 {a} {b} {c}\n3 {a} {c} {d}" for a, b, c, d in QUADS]
    return "\n".join(lines) + "\n"


def make_blocks(directory: Path, count: int) -> Path:
    """A directory with so many blocks, each of another height, in two subdirectories."""
    root = directory / "parts"
    for i in range(count):
        path = root / f"{i % 2}" / f"block{i:02d}.off"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(off_block(1 + i))
    return root
