# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ground truth of a face: the invariance class of its unbounded support surface (design, 6)."""

from __future__ import annotations

from gpswb.cad.kernel import BrepFace
from gpswb.cad.solid import FaceTruth
from gpswb.core.invariance import InvarianceClass

_DIRECT: dict[str, InvarianceClass] = {
    "Plane": "planar",
    "Cylinder": "cylindrical",
    "Cone": "revolute",
    "Sphere": "spherical",
    "Torus": "revolute",
}


def face_truth(face: BrepFace) -> FaceTruth | None:
    """Truth of a face; None where it has no surface."""
    kind = face.kind
    if kind is None:
        return None
    if kind in _DIRECT:
        return FaceTruth(kind, _DIRECT[kind], _DIRECT[kind], {})
    return FaceTruth(kind, "complex", "complex", {}, ambiguous=True)
