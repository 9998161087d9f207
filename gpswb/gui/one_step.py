# SPDX-License-Identifier: LGPL-2.1-or-later
"""Changes of a document that are undone in one step."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any


@contextmanager
def one_step(document: Any, text: str) -> Iterator[None]:
    """What the block does is one step to undo; if it raises, the document is as it was."""
    document.openTransaction(text)
    try:
        yield
    except BaseException:
        document.abortTransaction()
        raise
    document.commitTransaction()
