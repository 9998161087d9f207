# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a `GPS Partition` keeps as text and a file, read: its result, as the user has changed it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from gpswb.errors import InputError
from gpswb.gui.overrides import Effective, apply_overrides, from_json, regions_from_json
from gpswb.gui.pieces import with_pieces
from gpswb.io.stored_result import StoredResult, read_stored_result
from gpswb.sentence import Sentence


def stored_result(obj: Any) -> StoredResult:
    """What the run found, from the mesh alone; see `with_pieces` for a measured part.

    Raises:
        InputError: there is none yet, or it is damaged.
    """
    if not obj.Result or not obj.Labels:
        raise InputError(Sentence("{part} has no result yet", part=obj.Label))
    known = _read.get(obj.Labels)
    if known is not None and known[0] == hash(obj.Result):
        return known[1]
    try:
        document = json.loads(obj.Result)
    except ValueError as error:
        raise InputError(
            Sentence("the result of {part} is damaged ({error})", part=obj.Label, error=error)
        ) from None
    return keep(obj, read_run(document, Path(obj.Labels)))


def read_run(document: dict[str, Any], labels: Path) -> StoredResult:
    """The result of a run, with what the window asks for first."""
    stored = with_pieces(read_stored_result(document, labels))
    # Computed once, at the first use: colours and borders ask for them while the window waits.
    _ = stored.solid.mesh.areas, stored.solid.mesh.pair_edges
    return stored


def keep(obj: Any, stored: StoredResult) -> StoredResult:
    """Remember what was read for the next who asks."""
    _read.clear()
    _read[obj.Labels] = hash(obj.Result), stored
    return stored


_read: dict[str, tuple[int, StoredResult]] = {}
"""The result that was read last, by file and run: it takes a second for a million triangles."""


def effective_result(obj: Any) -> tuple[StoredResult, tuple[Sentence, ...]]:
    """The result with the user's overrides, and notes on those that found no place.

    Raises:
        InputError: there is none yet, or it is damaged.
    """
    found = effective(stored_result(obj), obj.Overrides, obj.Described)
    return found.stored, found.notes


def effective(stored: StoredResult, overrides: str, described: str) -> Effective:
    """The same from texts that the object keeps, without it: a thread may ask.

    Raises:
        InputError: they are damaged.
    """
    if _last_effective and _last_effective[0][:2] == (stored, overrides):
        return _last_effective[0][2]
    found = apply_overrides(stored, from_json(overrides), regions_from_json(described))
    _last_effective[:] = [(stored, overrides, found)]
    return found


_last_effective: list[tuple[StoredResult, str, Effective]] = []
"""What was found last: each part of the window asks for it."""


def stored_datums(obj: Any) -> tuple[tuple[str, str], ...]:
    """Letter and choice of each datum that the object names; none means that they are suggested.

    Raises:
        InputError: the text isn't of the form ``A=Face1,B=Face5+Face6``.
    """
    found = []
    for part in filter(None, (part.strip() for part in obj.Datums.split(","))):
        letter, equals, choice = (piece.strip() for piece in part.partition("="))
        if not (equals and choice and letter.isascii() and letter.isupper()):
            raise InputError(
                Sentence("{text!r} is no datum; write A=Face1,B=Face5+Face6", text=part)
            )
        found.append((letter, choice))
    return tuple(found)
