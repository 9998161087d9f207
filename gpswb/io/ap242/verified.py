# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write semantic PMI and read it back: a file that doesn't say what was meant is no result."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from gpswb.cad.pmi import Pmi
from gpswb.cad.solid import Solid
from gpswb.errors import OutputError
from gpswb.gps.specified import Letters, Specified
from gpswb.io.ap242.compare import differences
from gpswb.io.ap242.match import match_faces
from gpswb.io.ap242.part21 import Part21
from gpswb.io.ap242.read_pmi import read_pmi
from gpswb.io.ap242.structure import shapes_of
from gpswb.io.ap242.write import read_text, write_ap242


def write_verified_ap242(
    path: Path, file: Part21, solid: Solid, letters: Letters, specified: Sequence[Specified]
) -> Pmi:
    """`write_ap242`, and its result read back.

    Raises:
        InputError: as `write_ap242`.
        OutputError: it doesn't read back as it was meant.
        OSError: the file can't be written.
    """
    wanted = write_ap242(path, file, solid, letters, specified)
    written = read_text(path)
    assert solid.facemap is not None
    faces = match_faces(written, shapes_of(written), solid.mesh, solid.facemap)
    check_read_back(path, differences(wanted, read_pmi(written, faces)))
    return wanted


def check_read_back(path: Path, lost: Sequence[str]) -> None:
    """Raise OutputError where something of a file was not read back."""
    if lost:
        raise OutputError(f"{path.name} does not read back as it was meant: {lost[0]}")
