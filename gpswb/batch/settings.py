# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a part is to be examined, as a value that can travel to another process."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from gpswb.cad.density import Density

if TYPE_CHECKING:
    from gpswb.core.pipeline import Method, Mode

Kernel = Literal["ocp", "freecad"]


@dataclass(frozen=True)
class Settings:
    """How one part is to be examined.

    ``noise`` is the σ (mm) told to the pipeline, None to let it estimate; ``noise_added`` the
    displacement given to the vertices before, as a fraction of the diagonal, which it isn't told.
    ``unit`` is that of a measured file, None for the one it states, or mm.
    """

    density: Density
    mode: Mode
    method: Method
    kernel: Kernel
    noise: float | None = None
    noise_added: float = 0.0
    unit: str | None = None

    def plain(self) -> dict[str, Any]:
        """As values that JSON can hold; the density in the command line's words."""
        return {**dataclasses.asdict(self), "density": str(self.density)}

    @classmethod
    def from_plain(cls, plain: Mapping[str, Any]) -> Settings:
        """What `plain` gave, back.

        Raises:
            ValueError: the density is none.
        """
        return cls(**{**plain, "density": Density.parse(plain["density"])})
