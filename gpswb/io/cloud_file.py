# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading point clouds in text: XYZ, PTS, ASC, TXT, CSV. numpy parses."""

from __future__ import annotations

import io
import re
from pathlib import Path

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.errors import InputError

SUFFIXES = (".xyz", ".pts", ".asc", ".txt", ".csv")
"""Endings, in lower case, that `parse_cloud` takes."""

_MARKS = b"[](){},;:="
_BLANK = bytes.maketrans(_MARKS, b" " * len(_MARKS))
_NUMBER = rb"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?|nan"
_GAP = rb"[ \t]"
_POINT = re.compile(
    _GAP + rb"*(?:" + _NUMBER + rb")(?:" + _GAP + rb"+(?:" + _NUMBER + rb")){2}(?:\s|$)", re.I
)
_MOST_HEADER = 100


def parse_cloud(path: Path) -> FloatArray:
    """The points of a text file: the first three numbers of every line.

    Commas, semicolons and brackets count as spaces, ``#`` and ``//`` start a comment. Lines before
    the first point are a header (names of columns, the count of a PTS). What follows the third
    number (intensity, colour, normal) is left.

    Returns:
        (n, 3) float64 as they stand; a scanner writes NaN where it saw nothing.

    Raises:
        InputError: no such file, no points, or a line among them that is none.
    """
    try:
        data = path.read_bytes().translate(_BLANK)
    except OSError as error:
        raise InputError(f"can't read {path}: {error.strerror or error}") from error
    header = _header_lines(data)
    if header is None:
        raise InputError(f"{path} holds no points: no line starts with three numbers")
    try:
        points = np.loadtxt(
            io.BytesIO(data), usecols=(0, 1, 2), comments=("#", "//"), skiprows=header, ndmin=2
        )
    except ValueError as error:
        said = str(error).split(";")[0].rstrip(".")
        raise InputError(f"{path} is not a readable point cloud: {said}") from error
    return np.asarray(points, dtype=np.float64)


def _header_lines(data: bytes) -> int | None:
    """Number of lines before the first point; None where no point is found."""
    start = 0
    for number in range(_MOST_HEADER):
        if start >= len(data):
            return None
        if _POINT.match(data, start):
            return number
        end = data.find(b"\n", start)
        if end < 0:
            return None
        start = end + 1
    return None
