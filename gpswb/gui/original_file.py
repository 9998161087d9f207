# SPDX-License-Identifier: LGPL-2.1-or-later
"""The STEP file that a part was imported from, which PMI is appended to.

The part remembers the file's path and checksum, its own shape, and where it stood: it may be moved
afterwards, but not changed.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import FreeCAD
import numpy as np

from gpswb.cad.sniff import sniff
from gpswb.cad.solid import Solid
from gpswb.core.mesh import Mesh
from gpswb.errors import InputError
from gpswb.gui.fingerprint import shape_fingerprint
from gpswb.io.ap242.part21 import Part21
from gpswb.io.ap242.write import read_text
from gpswb.sentence import Sentence

_PROPERTIES = (
    ("App::PropertyString", "StepFile", "File that the part was imported from"),
    ("App::PropertyString", "StepSha256", "Checksum of that file"),
    ("App::PropertyString", "StepShape", "Fingerprint of the shape that was in it"),
    ("App::PropertyPlacement", "StepPlacement", "Where the part stood when it was imported"),
)


def remember_file(part: Any, path: Path, sha256: str) -> None:
    """Let a part know the STEP file that it was just imported from."""
    for kind, name, text in _PROPERTIES:
        part.addProperty(kind, name, "GPS", text)
        part.setEditorMode(name, 1)
    part.StepFile, part.StepSha256 = str(path.resolve()), sha256
    part.StepShape, part.StepPlacement = _unmoved(part), part.getGlobalPlacement()


def original_of(part: Any, solid: Solid) -> tuple[Part21, Solid]:
    """The text of a part's STEP file, and the part's mesh where the file has it.

    Raises:
        InputError: the part knows no file, or one of the two has changed.
    """
    if not getattr(part, "StepFile", ""):
        raise InputError(Sentence("the part wasn't imported from a STEP file by GPS"))
    path = Path(part.StepFile)
    if sniff(path)[1] != part.StepSha256:
        raise InputError(Sentence("{path} has changed since the part was imported", path=path))
    if _unmoved(part) != part.StepShape:
        raise InputError(
            Sentence("the part has changed since it was imported from {path}", path=path)
        )
    move = part.StepPlacement.multiply(part.Placement.inverse()).toMatrix()
    matrix = np.array(move.A).reshape(4, 4)
    vertices = solid.mesh.vertices @ matrix[:3, :3].T + matrix[:3, 3]
    return read_text(path), replace(solid, mesh=Mesh(vertices, solid.mesh.triangles))


def _unmoved(part: Any) -> str:
    """Fingerprint of a part's shape, wherever it stands."""
    shape = part.Shape.copy()
    shape.Placement = FreeCAD.Placement()
    return shape_fingerprint(shape)
