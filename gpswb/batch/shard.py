# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which parts are whose where several runs share the work."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass

from gpswb.batch.source import Part


@dataclass(frozen=True)
class Shard:
    """The parts of one of ``count`` runs that share the work, ``number`` from 1 to ``count``."""

    number: int = 1
    count: int = 1

    def __contains__(self, part: Part) -> bool:
        # By name, so that a part keeps its shard whatever else is added.
        digest = hashlib.sha256(part.name.encode("utf-8", "surrogateescape")).digest()
        return int.from_bytes(digest[:8]) % self.count == self.number - 1

    @property
    def record(self) -> str:
        """File name of its record."""
        if self.count == 1:
            return "record.jsonl"
        return f"record-{self.number}-of-{self.count}.jsonl"
