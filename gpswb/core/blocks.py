# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks of elements small enough that what is computed of them stays in the cache."""

from __future__ import annotations

from collections.abc import Iterator

BLOCK = 8192
"""Elements of a block: some thirty arrays of that many doubles fit the second-level cache. A whole
mesh at once takes twice as long, most of it for pages of memory that are touched once."""


def blocks(count: int) -> Iterator[slice]:
    """Consecutive slices of 0..count-1."""
    for start in range(0, count, BLOCK):
        yield slice(start, min(start + BLOCK, count))
