# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a document keeps of a datum, a datum system or a specification: versioned JSON."""

from __future__ import annotations

import dataclasses
import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from gpswb.errors import InputError
from gpswb.gui.face_keys import FaceKey, face_key
from gpswb.io.specification_file import COLUMNS
from gpswb.sentence import Sentence

SCHEMA = "gpswb-annotation/1"
WORDS = tuple(name for name in COLUMNS if name != "feature")
"""What a specification says beside its faces, named as in the table that ``--specs`` reads."""


@dataclass(frozen=True)
class DatumRecord:
    """A datum feature."""

    letter: str
    faces: tuple[FaceKey, ...]


@dataclass(frozen=True)
class SystemRecord:
    """A datum system, as ``A|B-C``."""

    notation: str


@dataclass(frozen=True)
class SpecificationRecord:
    """A specification: ``words`` by the names of `WORDS`, as the user gave them."""

    faces: tuple[FaceKey, ...]
    words: Mapping[str, str]


Record = DatumRecord | SystemRecord | SpecificationRecord
_KINDS: dict[str, type[Record]] = {
    "datum": DatumRecord,
    "datum system": SystemRecord,
    "specification": SpecificationRecord,
}


def record_text(record: Record) -> str:
    """The text that a document keeps."""
    kind = next(name for name, type_ in _KINDS.items() if isinstance(record, type_))
    return json.dumps({"schema": SCHEMA, "kind": kind, **dataclasses.asdict(record)})


def read_record(text: str) -> Record:
    """Read what `record_text` wrote.

    Raises:
        InputError: it is damaged, or of another version.
    """
    try:
        entry = json.loads(text)
        if entry["schema"] != SCHEMA:
            raise InputError(
                Sentence(
                    "the annotation is of schema {found!r}, not {known!r}",
                    found=entry["schema"],
                    known=SCHEMA,
                )
            )
        if entry["kind"] == "datum":
            return DatumRecord(letter_of(entry["letter"]), _faces(entry))
        if entry["kind"] == "datum system":
            return SystemRecord(str(entry["notation"]))
        if entry["kind"] == "specification":
            words = {name: str(entry["words"].get(name, "")) for name in WORDS}
            return SpecificationRecord(_faces(entry), words)
        raise ValueError(f"kind {entry['kind']!r}")
    except (AttributeError, KeyError, TypeError, ValueError, RecursionError) as error:
        raise InputError(Sentence("the annotation is damaged ({error})", error=error)) from None


def letter_of(text: Any) -> str:
    """A datum letter.

    Raises:
        InputError: it is none: one to three capitals, without a hyphen.
    """
    if not isinstance(text, str) or not re.fullmatch("[A-Z]{1,3}", text):
        raise InputError(Sentence("{text!r} is no datum letter; A to ZZZ are", text=text))
    return text


def _faces(entry: Any) -> tuple[FaceKey, ...]:
    return tuple(face_key(face) for face in entry["faces"])
