# SPDX-License-Identifier: LGPL-2.1-or-later
"""Time of each stage as a ratio to a peer's on the same mesh, and which have become slower.

``ratios.json`` is committed. A machine, loaded or slow, changes both times and so hardly the ratio.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

FILE = Path(__file__).with_name("ratios.json")

SLOWER = 1.5
"""A ratio this many times the known one is reported. Repeated runs differ by less."""

LEAST = 0.02
"""CPU seconds below which a stage is not compared: the clock ticks in hundredths."""


def known() -> dict[str, float]:
    """The committed ratios by name."""
    ratios: dict[str, float] = json.loads(FILE.read_text("utf-8")) if FILE.exists() else {}
    return ratios


def slower(old: Mapping[str, float], new: Mapping[str, float]) -> list[str]:
    """A line for each ratio that has become worse."""
    return [
        f"{name}: {ratio:.3g}, was {old[name]:.3g}"
        for name, ratio in new.items()
        if name in old and ratio >= SLOWER * old[name]
    ]


def renewed(old: Mapping[str, float], new: Mapping[str, float]) -> dict[str, float]:
    """What is to be committed: the better of both, so that small losses can't add up unseen.

    A loss that is meant is accepted by deleting its line.
    """
    return {name: float(f"{min(ratio, old.get(name, ratio)):.3g}") for name, ratio in new.items()}


def write(ratios: Mapping[str, float]) -> None:
    """Write the file that is committed."""
    FILE.write_text(json.dumps(ratios, indent=1, sort_keys=True) + "\n", encoding="utf-8")
