# SPDX-License-Identifier: LGPL-2.1-or-later
"""Leave-one-out log density of 100,000 points: gpswb against scikit-learn, as JSON."""

from __future__ import annotations

import json

from measure import timed  # first: it limits the threads

# isort: split
import numpy as np
from sklearn.neighbors import KernelDensity

from gpswb.core.kernel_density import leave_one_out_at

POINTS = 100_000
RTOL = 1e-3
"""Relative accuracy that scikit-learn is asked for: 0.001 nats. Exact densities take it twice the
time."""

ASKED = 500
"""Points at which scikit-learn is asked: its time is that of one point times their number."""


def compare(dimensions: int) -> dict[str, float]:
    """Seconds of both for all points, and the difference of the mean log density, nats."""
    random = np.random.default_rng(dimensions)
    # Two clusters of unequal width: neither a uniform nor a normal density.
    wide = random.normal(0.0, 1.0, (POINTS // 2, dimensions))
    narrow = random.normal(2.0, 0.3, (POINTS - POINTS // 2, dimensions))
    points = random.permutation(np.concatenate([wide, narrow]))
    bandwidth = points.std(axis=0) * POINTS ** (-1.0 / (dimensions + 4))
    leave_one_out_at(points[:100], bandwidth)
    own, density = timed(lambda: leave_one_out_at(points, bandwidth))
    scaled = points / bandwidth

    def estimate() -> KernelDensity:
        return KernelDensity(bandwidth=1.0, rtol=RTOL).fit(scaled)

    def ask() -> np.ndarray:
        return estimate().score_samples(scaled[:ASKED])

    seconds, logs = timed(ask)
    fit, _ = timed(estimate)
    itself = (2.0 * np.pi) ** (-dimensions / 2)
    others = np.exp(logs) * POINTS - itself
    with np.errstate(divide="ignore"):
        peer = np.log(others / (POINTS - 1)) - np.log(bandwidth).sum()
    near = np.isfinite(peer) & np.isfinite(density[:ASKED])
    return {
        "own": own,
        "sklearn": fit + (seconds - fit) * POINTS / ASKED,
        "difference": float(abs(density[:ASKED][near].mean() - peer[near].mean())),
    }


if __name__ == "__main__":
    print(json.dumps({str(d): compare(d) for d in (1, 2, 3)}))
