# SPDX-License-Identifier: LGPL-2.1-or-later
"""Point clouds of known surfaces."""

import numpy as np


def on_sphere(n: int, radius: float = 20.0, seed: int = 1) -> np.ndarray:
    x = np.random.default_rng(seed).normal(size=(n, 3))
    return radius * x / np.linalg.norm(x, axis=1, keepdims=True)


def on_box(n: int, size: tuple[float, float, float] = (30, 20, 10), seed: int = 1) -> np.ndarray:
    """Uniform on the six sides."""
    random = np.random.default_rng(seed)
    area = np.array([size[1] * size[2], size[0] * size[2], size[0] * size[1]])
    axis = random.choice(3, n, p=area / area.sum())
    x = random.uniform(0, 1, (n, 3))
    x[np.arange(n), axis] = random.integers(0, 2, n)
    return x * size
