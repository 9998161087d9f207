# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part that a script made, and what is known of it by construction."""

from __future__ import annotations

from dataclasses import dataclass

import cadquery as cq
from OCP.BRepBuilderAPI import BRepBuilderAPI_NurbsConvert

from gpswb.core.invariance import InvarianceClass


@dataclass(frozen=True, eq=False)
class MadePart:
    """A shape in mm with the classes of its faces, known from how it was made.

    Args:
        name: also the stem of its file.
        shape: the solid, or a compound of several.
        class_counts: number of B-rep faces of each class.
        features: number of maximal features (adjacent faces on one surface count once).
    """

    name: str
    shape: cq.Shape
    class_counts: dict[InvarianceClass, int]
    features: int

    @property
    def classes(self) -> tuple[InvarianceClass, ...]:
        """The class of every face, in no particular order."""
        return tuple(c for c, n in self.class_counts.items() for _ in range(n))

    def nurbs_twin(self) -> MadePart:
        """The same part with every surface and curve as a B-spline: the classes don't change."""
        twin = BRepBuilderAPI_NurbsConvert(self.shape.wrapped, True).Shape()
        return MadePart(f"{self.name}_nurbs", cq.Shape.cast(twin), self.class_counts, self.features)
