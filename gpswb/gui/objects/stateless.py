# SPDX-License-Identifier: LGPL-2.1-or-later
"""Behaviour of document objects and views, of which a document keeps only the class."""

from __future__ import annotations

from typing import Any


class Stateless:
    """What all of ours derive from: state is in properties, which every FreeCAD can read.

    FreeCAD asks for it by ``dumps`` and ``loads``, before 0.21 by the names that pickle uses.
    """

    def dumps(self) -> None:
        return None

    def loads(self, state: Any) -> None:
        return None

    __getstate__ = dumps
    __setstate__ = loads
