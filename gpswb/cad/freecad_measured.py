# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh and Points objects of a document that FreeCAD has open."""

from __future__ import annotations

import io
import tempfile
import zipfile
from pathlib import Path
from typing import Any

import numpy as np

from gpswb.cad.fcstd_measured import Measurement, read_mesh, read_points


def is_measurement(item: Any) -> bool:
    """Whether a FreeCAD document object holds a mesh or points."""
    return bool(item.isDerivedFrom("Mesh::Feature") or item.isDerivedFrom("Points::Feature"))


def measurement_of(item: Any) -> Measurement:
    """What an object that `is_measurement` holds, at its place in its container, mm.

    It is taken in the form in which FreeCAD stores it: its lists of points and facets take ten
    times as long.
    """
    if item.isDerivedFrom("Mesh::Feature"):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "mesh.bms")
            item.Mesh.write(str(path))
            stored = read_mesh(path.read_bytes())
    else:
        content = item.Points.dumpContent(Compression=0)
        with zipfile.ZipFile(io.BytesIO(bytes(content))) as archive:
            stored = read_points(archive.read(archive.infolist()[-1]))
    placement = np.array(item.Placement.Matrix.A, dtype=np.float64).reshape(4, 4)
    return stored.placed(placement)
