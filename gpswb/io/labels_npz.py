# SPDX-License-Identifier: LGPL-2.1-or-later
"""labels.npz: the mesh with region, class and face of every triangle."""

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
    each −1 for none. What the first step found is beside them, under the names of `Partition`:
    ``shape_type``, ``initial_region`` (m,), and by vertex ``shape_index``, ``curvedness``,
    ``vertex_shape_type`` (n,); and ``feature_of_face`` (f,) of the face map. For a point cloud
    also ``point`` (n, 3), ``point_vertex``, ``point_region`` and ``point_class`` (n,): every point
    as read, those that were thinned away included, with the vertex that stands for it.

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
        "shape_type": partition.shape_type.astype(np.int8),
        "initial_region": partition.initial_region,
        "shape_index": partition.shape_index.astype(np.float32),
        "curvedness": partition.curvedness.astype(np.float32),
        "vertex_shape_type": partition.vertex_shape_type.astype(np.int8),
        "feature_of_face": np.empty(0, np.int64) if facemap is None else facemap.feature_of_face,
    }
    if pointmap is not None:
        index = region_of_points(partition, pointmap.vertex_of_point)
        classes = [CLASSES.index(region.invariance_class) for region in partition.regions]
        arrays["point"] = pointmap.points
        arrays["point_vertex"] = pointmap.vertex_of_point
        arrays["point_region"] = ids[index]
        arrays["point_class"] = np.array([*classes, -1], dtype=np.int64)[index]
    with path.open("wb") as file:
        np.savez_compressed(file, **arrays)
