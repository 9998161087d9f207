# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures: PNG that other readers understand, and colours where they belong."""

import io

import numpy as np
import pytest
from made_parts import put_together, row_of_squares, truth
from matplotlib.image import imread

from gpswb.io.colours import WHEEL
from gpswb.report.picture import OUTLINE, SIZE, Labelled, close_up, whole_part
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


def labelled(planes: int = 1) -> Labelled:
    """Squares: planar ones, right; a helical one, taken for spherical; all one region."""
    n = planes + 1
    partition, facemap = put_together(
        row_of_squares(n, (3, 3)), [truth("planar")] * n, range(n), ["planar"] * n
    )
    return Labelled(
        mesh=partition.mesh,
        face=facemap.face_of_triangle,
        truth=["planar"] * planes + ["helical"],
        label=np.where(partition.region == planes, 2, 0),
        region=np.zeros(18 * n, dtype=np.int64),
    )


def thirds(image: np.ndarray) -> list[np.ndarray]:
    return np.split(image, 3, axis=1)


def outlined(image: np.ndarray) -> np.ndarray:
    return (image == OUTLINE).all(axis=2)


def test_truth_then_classes_then_regions() -> None:
    image = whole_part(labelled(), np.array([1]))
    assert image.shape == (SIZE[1], 3 * SIZE[0], 3)
    true, recognised, regions = thirds(image)
    assert hues(true) == {"planar", "helical"}
    assert hues(recognised) == {"planar", "spherical"}
    flat = regions[~outlined(regions) & (regions != 255).any(axis=2)]
    assert len(np.unique(flat, axis=0)) == 2  # one region, and the line between the faces
    # The same pixels are outlined in all three, about half of the part.
    assert outlined(true).any()
    assert np.array_equal(outlined(true), outlined(recognised))
    assert np.array_equal(outlined(true), outlined(regions))


def test_nothing_wrong_nothing_outlined() -> None:
    assert not outlined(whole_part(labelled(), np.zeros(0, dtype=int))).any()


def test_close_up_shows_the_face_large() -> None:
    part = labelled(planes=7)
    far, near = (
        hue_share(thirds(image)[0], "helical")
        for image in (whole_part(part, np.array([7])), close_up(part, 7))
    )
    assert near > 5 * far


def hue_share(picture: np.ndarray, name: str) -> float:
    colour = np.array(WHEEL[name])
    length = np.maximum(np.linalg.norm(picture.astype(float), axis=2), 1)
    return float((picture @ colour / np.linalg.norm(colour) / length > 0.9995).mean())
