# SPDX-License-Identifier: LGPL-2.1-or-later
"""labels.npz: the mesh with region, class and face of every triangle (design, section 10)."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from gpswb.cad.solid import FaceMap, PointMap
from gpswb.core.invariance import CLASSES
from gpswb.core.partition import Partition
from gpswb.scan.point_regions import region_of_points
from gpswb.validation.face_result import facet_classes


def write_labels(
    path: Path,
    partition: Partition,
    facemap: FaceMap | None,
    pointmap: PointMap | None = None,
) -> None:
    """Write ``vertices`` (n, 3), ``triangles`` (m, 3) and ``region``, ``class``, ``face`` (m,).

    ``region`` holds region ids, ``class`` indices into ``CLASSES``, ``face`` 0-based face numbers;
    each −1 for none. For a point cloud also ``point`` (n, 3), ``point_region`` and
    ``point_class`` (n,): every point as read, those that were thinned away included.

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
    if pointmap is not None:
        index = region_of_points(partition, pointmap.vertex_of_point)
        classes = [CLASSES.index(region.invariance_class) for region in partition.regions]
        arrays["point"] = pointmap.points
        arrays["point_region"] = ids[index]
        arrays["point_class"] = np.array([*classes, -1], dtype=np.int64)[index]
    with path.open("wb") as file:
        np.savez_compressed(file, **arrays)
