# SPDX-License-Identifier: LGPL-2.1-or-later
"""An expansion move by a minimum cut against all subsets tried one by one."""

from __future__ import annotations

import numpy as np
import pytest

from gpswb.core.noisy.best_move import UNIT, best_move

PAIRS = np.array([[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0], [1, 4], [5, 6], [2, 7]])
NEW = 2


@pytest.mark.parametrize("seed", range(20))
def test_a_move_is_the_best_of_all_subsets(seed: int) -> None:
    random = np.random.default_rng(seed)
    # Facet 6 has the new label, facet 7 another; both stay as they are.
    label = np.append(random.integers(0, 2, 6), [NEW, 1])
    price = random.uniform(0.0, 2.0, len(PAIRS))
    stay, move = random.uniform(0.0, 3.0, (2, 6))

    def energy(taken: np.ndarray) -> float:
        trial = label.copy()
        trial[:6][taken] = NEW
        borders = trial[PAIRS[:, 0]] != trial[PAIRS[:, 1]]
        return float(np.where(taken, move, stay).sum() + price[borders].sum())

    taken = best_move(PAIRS, price, label, NEW, np.arange(6), stay, move, np.ones(6))
    least = min(energy(np.array([bool(n >> i & 1) for i in range(6)])) for n in range(64))
    assert energy(taken) <= least + 40 / UNIT  # every capacity is rounded to a unit
