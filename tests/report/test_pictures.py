# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures: PNG that other readers understand, and colours where they belong."""

import io

import numpy as np
import pytest
from made_parts import put_together, row_of_squares, truth
from matplotlib.image import imread

from gpswb.io.colours import WHEEL
from gpswb.report.picture import OUTLINE, truth_and_recognised
from gpswb.report.png import png_bytes


@pytest.mark.parametrize("shape", [(1, 1), (3, 7), (40, 2)])
def test_png_is_read_back_by_another_reader(shape: tuple[int, int]) -> None:
    image = np.random.default_rng(3).integers(0, 256, (*shape, 3), dtype=np.uint8)
    read = imread(io.BytesIO(png_bytes(image)), format="png")
    assert np.array_equal(np.rint(255 * read).astype(np.uint8), image)


def test_png_refuses_another_kind_of_array() -> None:
    with pytest.raises(ValueError, match=r"\(h, w, 3\) uint8 image"):
        png_bytes(np.zeros((2, 2), dtype=np.uint8))


def hues(half: np.ndarray) -> set[str]:
    """Classes whose colour, at some brightness, covers more than 1 % of the pixels."""
    found = set()
    for name, colour in WHEEL.items():
        unit = np.array(colour) / np.linalg.norm(colour)
        length = np.linalg.norm(half.astype(float), axis=2)
        cosine = half @ unit / np.maximum(length, 1)
        painted = (length > 20) & (half != 255).any(axis=2)
        if (painted & (cosine > 0.9995)).mean() > 0.01:
            found.add(name)
    return found


def test_left_is_truth_right_is_recognised() -> None:
    partition, facemap = put_together(
        row_of_squares(2, (3, 3)),
        [truth("planar"), truth("helical")],
        [0, 1],
        ["planar", "spherical"],
    )
    label = np.array([0, 2])[partition.region]
    image = truth_and_recognised(
        partition.mesh, facemap.face_of_triangle, ["planar", "helical"], label, np.array([1])
    )
    left, right = image[:, :420], image[:, 420:]
    assert hues(left) == {"planar", "helical"}
    assert hues(right) == {"planar", "spherical"}
    outlined = (image == OUTLINE).all(axis=2)
    # The wrong face is the one at larger x; its outline keeps to its side.
    assert outlined.any()
    assert outlined[:, :420].sum() == outlined[:, 420:].sum()


def test_nothing_wrong_nothing_outlined() -> None:
    partition, facemap = put_together(row_of_squares(1), [truth("planar")], [0], ["planar"])
    image = truth_and_recognised(
        partition.mesh,
        facemap.face_of_triangle,
        ["planar"],
        np.zeros(2, dtype=int),
        np.zeros(0, dtype=int),
    )
    assert not (image == OUTLINE).all(axis=2).any()
