# SPDX-License-Identifier: LGPL-2.1-or-later
"""The symbols of ISO 1101 as strokes, as no font is sure to have them (proportions: ISO 7083)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

Point = tuple[float, float]


@dataclass(frozen=True)
class Symbol:
    """Strokes in a square of side 1, y upwards: open or closed lines, and filled ones."""

    lines: tuple[tuple[Point, ...], ...]
    filled: tuple[tuple[Point, ...], ...] = ()


def _arc(x: float, y: float, r: float, start: float = 0, stop: float = 360) -> tuple[Point, ...]:
    angles = np.radians(np.linspace(start, stop, 33))
    return tuple((x + r * float(np.cos(a)), y + r * float(np.sin(a))) for a in angles)


def _arrow(x: float) -> tuple[tuple[Point, ...], tuple[Point, ...]]:
    """A shaft from (x, 0.08) up to the right at 60°, and its head."""
    ux, uy = 0.5, 0.8660254
    tip = (x + 0.95 * ux, 0.08 + 0.95 * uy)
    back = (tip[0] - 0.34 * ux, tip[1] - 0.34 * uy)
    head = (
        tip,
        (back[0] - 0.13 * uy, back[1] + 0.13 * ux),
        (back[0] + 0.13 * uy, back[1] - 0.13 * ux),
    )
    return ((x, 0.08), back), head


_ONE, _ONE_HEAD = _arrow(0.25)
_LEFT, _LEFT_HEAD = _arrow(0.02)
_RIGHT, _RIGHT_HEAD = _arrow(0.48)
_CONCENTRIC = Symbol((_arc(0.5, 0.5, 0.44), _arc(0.5, 0.5, 0.22)))

SYMBOLS: dict[str, Symbol] = {
    "⏤": Symbol((((0.04, 0.5), (0.96, 0.5)),)),
    "⏥": Symbol((((0.02, 0.25), (0.68, 0.25), (0.98, 0.75), (0.32, 0.75), (0.02, 0.25)),)),
    "○": Symbol((_arc(0.5, 0.5, 0.42),)),
    "⌭": Symbol((_arc(0.5, 0.5, 0.26), ((0.06, 0.14), (0.44, 0.92)), ((0.56, 0.08), (0.94, 0.86)))),
    "⌒": Symbol((_arc(0.5, 0.28, 0.45, 0, 180),)),
    "⌓": Symbol(((*_arc(0.5, 0.28, 0.45, 0, 180), (0.95, 0.28)),)),
    "∥": Symbol((((0.12, 0.08), (0.56, 0.92)), ((0.44, 0.08), (0.88, 0.92)))),
    "⟂": Symbol((((0.06, 0.1), (0.94, 0.1)), ((0.5, 0.1), (0.5, 0.92)))),
    "∠": Symbol((((0.95, 0.15), (0.05, 0.15), (0.85, 0.85)),)),
    "⌖": Symbol((_arc(0.5, 0.5, 0.29), ((0.02, 0.5), (0.98, 0.5)), ((0.5, 0.02), (0.5, 0.98)))),
    "◎": _CONCENTRIC,
    "⌯": Symbol(
        (((0.2, 0.22), (0.8, 0.22)), ((0.02, 0.5), (0.98, 0.5)), ((0.2, 0.78), (0.8, 0.78)))
    ),
    "↗": Symbol((_ONE,), (_ONE_HEAD,)),
    "⌰": Symbol((_LEFT, _RIGHT, (_LEFT[0], _RIGHT[0])), (_LEFT_HEAD, _RIGHT_HEAD)),
}
"""By the character that `gpswb.gps.characteristics` names the symbol with."""
