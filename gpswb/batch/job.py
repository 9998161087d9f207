# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part to examine among many, what it may cost, and how it ended."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from gpswb.validation.corpus import Status

RESULTS = ("result.json", "labels.npz")
"""What a part that is done leaves in its directory."""


@dataclass(frozen=True)
class Limits:
    """Seconds of wall time and bytes of memory for one part."""

    seconds: float
    memory: int


@dataclass(frozen=True)
class Job:
    """A part, by path or URL, its name, and the directory that its results go in."""

    url: str
    name: str
    directory: Path


@dataclass(frozen=True)
class End:
    """How a part ended; anything but ``done`` comes with a one-line message.

    ``seconds`` is wall time, ``cpu_s`` user and system time, ``memory_mb`` the peak of the resident
    memory (MB of 10⁶ bytes); the last two are None where the child could not tell. ``cached``: the
    results are those of an earlier run, and so are the three figures.
    """

    status: Status
    message: str
    seconds: float
    cpu_s: float | None = None
    memory_mb: float | None = None
    cached: bool = False
