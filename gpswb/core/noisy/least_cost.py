# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cheapest of ever finer descriptions."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol, TypeVar


class Priced(Protocol):
    """A description: chi-square and the price of its numbers."""

    @property
    def cost(self) -> float:
        """Smaller is likelier."""


P = TypeVar("P", bound=Priced)


def cheapest(descriptions: Iterable[P], patience: int) -> P | None:
    """The first of the cheapest descriptions; None of none.

    Args:
        descriptions: coarse ones first, made as they are asked for.
        patience: dearer ones in a row after which no more are asked for.
    """
    best: P | None = None
    idle = 0
    for description in descriptions:
        if best is None or description.cost < best.cost:
            best, idle = description, 0
        else:
            idle += 1
            if idle == patience:
                break
    return best
