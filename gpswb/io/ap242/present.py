# SPDX-License-Identifier: LGPL-2.1-or-later
"""The semantic PMI that a STEP file holds already, on the faces of the shape read from it."""

from __future__ import annotations

from gpswb.cad.pmi import Pmi
from gpswb.cad.solid import Solid
from gpswb.io.ap242.match import match_faces
from gpswb.io.ap242.part21 import Part21
from gpswb.io.ap242.read_pmi import graphic_annotations, read_pmi
from gpswb.io.ap242.structure import shapes_of


def present_pmi(file: Part21, solid: Solid) -> tuple[Pmi | None, str]:
    """PMI of a file, None for none; and what there is to say of it.

    Args:
        solid: with a facemap, made from the same file.

    Raises:
        InputError: the file is too odd to be understood.
    """
    assert solid.facemap is not None
    pmi = None
    if any(True for _ in file.of("DATUM", "SHAPE_ASPECT")):
        pmi = read_pmi(file, match_faces(file, shapes_of(file), solid.mesh, solid.facemap)) or None
    drawn = graphic_annotations(file)
    if pmi is None and drawn:
        return None, f"the file's PMI is graphic only ({drawn} annotations): nothing to review"
    return pmi, ""
