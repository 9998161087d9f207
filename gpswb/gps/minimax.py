# SPDX-License-Identifier: LGPL-2.1-or-later
"""Chebyshev fits: the parameters that make the largest deviation smallest."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from scipy.optimize import linprog

from gpswb.core.mesh import FloatArray

Evaluate = Callable[[FloatArray], tuple[FloatArray, FloatArray]]
"""From (p,) parameters to (n,) deviations and their (n, p) derivatives."""

STEPS = 40
"""Linear programmes at most; they converge quadratically where as many deviations as parameters are
largest together, which is the usual case."""

WORKING = 400
"""Points of each linear programme: those with the largest deviations. Others can't come first
before the step has been checked on all of them."""


def minimax(evaluate: Evaluate, x: FloatArray, trust: float) -> FloatArray:
    """Minimise max |d(x)| by linear programmes within a trust region (Madsen 1975).

    Args:
        evaluate: the deviations and their derivatives.
        x: (p,) start, of a least-squares fit say.
        trust: largest first step of a parameter.

    Returns:
        (p,) parameters; never worse than the start.
    """
    d, jacobian = evaluate(x)
    worst = float(np.abs(d).max())
    for _ in range(STEPS):
        step, promised = _linear_step(d, jacobian, trust)
        gain = worst - promised
        if not gain > 1e-10 * worst:
            break
        tried = x + step
        new_d, new_jacobian = evaluate(tried)
        new_worst = float(np.abs(new_d).max())
        achieved = (worst - new_worst) / gain
        if achieved > 0.01:
            x, d, jacobian, worst = tried, new_d, new_jacobian, new_worst
        if achieved < 0.25:
            trust *= 0.3
        elif achieved > 0.75:
            trust *= 2.0
        if trust < 1e-14:
            break
    return x


def _linear_step(d: FloatArray, jacobian: FloatArray, trust: float) -> tuple[FloatArray, float]:
    """The step that makes the largest linearised deviation smallest, and that deviation."""
    p = jacobian.shape[1]
    scale = max(float(np.abs(d).max()), 1e-300)
    chosen = np.argsort(-np.abs(d))[:WORKING]
    while True:
        a, r = jacobian[chosen] / scale, d[chosen] / scale
        one = np.ones((len(chosen), 1))
        solved = linprog(
            np.r_[np.zeros(p), 1.0],
            A_ub=np.block([[a, -one], [-a, -one]]),
            b_ub=np.r_[-r, r],
            bounds=[(-trust, trust)] * p + [(0.0, None)],
            method="highs",
        )
        if solved.x is None:
            return np.zeros(p), float(np.abs(d).max())
        step, level = solved.x[:p], float(solved.x[p]) * scale
        linear = np.abs(d + jacobian @ step)
        beyond = np.flatnonzero(linear > level * (1 + 1e-9))
        if not len(beyond) or len(chosen) == len(d):
            return step, float(linear.max())
        worst = beyond[np.argsort(-linear[beyond])[:WORKING]]
        chosen = np.union1d(chosen, worst)
