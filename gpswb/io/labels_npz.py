# SPDX-License-Identifier: LGPL-2.1-or-later
"""labels.npz: the mesh with region, class and face of every triangle (design, section 10)."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from gpswb.cad.solid import FaceMap
from gpswb.core.partition import Partition
from gpswb.validation.face_result import facet_classes


def write_labels(path: Path, partition: Partition, facemap: FaceMap | None) -> None:
    """Write ``vertices`` (n, 3), ``triangles`` (m, 3) and ``region``, ``class``, ``face`` (m,).

    ``region`` holds region ids, ``class`` indices into ``CLASSES``, ``face`` 0-based face numbers;
    each −1 for none.

    Raises:
        OSError: the file can't be written.
    """
    m = len(partition.region)
    ids = np.array([region.id for region in partition.regions] + [-1], dtype=np.int64)
    face = np.full(m, -1, dtype=np.int64) if facemap is None else facemap.face_of_triangle
    arrays: dict[str, Any] = {
        "vertices": partition.mesh.vertices,
        "triangles": partition.mesh.triangles,
        "region": ids[partition.region],
        "class": facet_classes(partition),
        "face": face,
    }
    with path.open("wb") as file:
        np.savez_compressed(file, **arrays)
