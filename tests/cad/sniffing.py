# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jobs for the isolation test: one raises an error of ours, one never ends."""

from __future__ import annotations

import time
from pathlib import Path

from gpswb.cad.isolate import job_progress, run_isolated
from gpswb.cad.sniff import sniff


def sniff_text(path: str) -> str:
    return sniff(Path(path))[0]


def tell_and_sleep(sign_of_life: str) -> None:
    job_progress()("sleep", 0.5)
    run_isolated("sniffing:touch_for_ever", [sign_of_life], 600)


def touch_for_ever(path: str) -> None:
    while True:
        Path(path).touch()
        time.sleep(0.05)
