# SPDX-License-Identifier: LGPL-2.1-or-later
"""How fine a mesh the user asks for (design, section 4)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

from gpswb.sentence import Sentence

Rule = Literal[
    "auto", "coarse", "medium", "fine", "stl", "deflection", "edge", "vertices", "triangles", "turn"
]

PRESETS: dict[str, tuple[float, int]] = {"coarse": (30, 12), "medium": (60, 18), "fine": (120, 24)}
"""Near-uniform presets: edge length as a fraction 1/x of the bounding box's diagonal, and the least
number of elements a full turn of a curved face, where the edge length alone would give fewer."""

FORMS = (
    "auto, coarse, medium, fine, stl, deflection=MM[,DEGREES], edge=MM, vertices=N, triangles=N, "
    "turn=N"
)

STL_DEFLECTION = (0.1, 0.1)
"""Linear (mm) and angular (rad) deflection of FreeCAD 0.20's default STL export [measured]."""

DEFAULT_ANGLE_DEG = math.degrees(0.5)
"""Angular deflection where the user gives a linear one only: OCCT's own default."""


@dataclass(frozen=True)
class Density:
    """A density, from ``Density.parse``; ``str`` gives the text back.

    Args:
        rule: which form.
        value: deflection or edge length in mm, or a count; 0 where the rule has none.
        angle_deg: angular deflection of ``deflection``, degrees.
    """

    rule: Rule
    value: float = 0.0
    angle_deg: float = DEFAULT_ANGLE_DEG

    @classmethod
    def parse(cls, text: str) -> Density:
        """Read a density.

        Raises:
            ValueError: the text is none of the valid forms; the message names them.
        """
        name, equals, rest = text.strip().lower().partition("=")
        if name in ("auto", "coarse", "medium", "fine", "stl") and not equals:
            return cls(name)  # type: ignore[arg-type]
        try:
            numbers = [float(part) for part in rest.split(",")]
        except ValueError:
            raise _invalid(text) from None
        if not all(math.isfinite(x) and x > 0 for x in numbers):
            raise _invalid(text, Sentence("its numbers must be positive"))
        if name == "deflection" and len(numbers) == 2:
            if numbers[1] >= 180:
                raise _invalid(text, Sentence("the angle must be below 180 degrees"))
            return cls("deflection", numbers[0], numbers[1])
        if len(numbers) != 1:
            raise _invalid(text)
        if name in ("deflection", "edge"):
            return cls(name, numbers[0])  # type: ignore[arg-type]
        if name in ("vertices", "triangles", "turn"):
            least, most = (3, 720) if name == "turn" else (4, 20_000_000)
            if numbers[0] != int(numbers[0]) or not least <= numbers[0] <= most:
                raise _invalid(
                    text,
                    Sentence(
                        "N must be a whole number from {least} to {most}", least=least, most=most
                    ),
                )
            return cls(name, numbers[0])  # type: ignore[arg-type]
        raise _invalid(text)

    def __str__(self) -> str:
        if self.rule in ("auto", "coarse", "medium", "fine", "stl"):
            return self.rule
        text = f"{self.rule}={_number(self.value)}"
        if self.rule == "deflection" and self.angle_deg != Density.angle_deg:
            text += f",{_number(self.angle_deg)}"
        return text


def _number(value: float) -> str:
    return str(int(value)) if value == int(value) else repr(value)


def _invalid(text: str, why: Sentence | None = None) -> ValueError:
    if why is None:
        return ValueError(
            Sentence("density {text!r} isn't valid: use one of {forms}", text=text, forms=FORMS)
        )
    return ValueError(
        Sentence(
            "density {text!r} isn't valid ({why}): use one of {forms}",
            text=text,
            why=why,
            forms=FORMS,
        )
    )
