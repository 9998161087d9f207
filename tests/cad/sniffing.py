# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job that raises one of our errors, for the isolation test."""

from __future__ import annotations

from pathlib import Path

from gpswb.cad.sniff import sniff


def sniff_text(path: str) -> str:
    return sniff(Path(path))[0]
