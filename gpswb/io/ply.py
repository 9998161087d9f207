# SPDX-License-Identifier: LGPL-2.1-or-later
"""mesh.ply: the mesh with class, region and colour of every facet, binary little-endian PLY 1.0."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from gpswb.core.invariance import CLASSES
from gpswb.core.partition import Partition
from gpswb.io.colours import NONE, WHEEL
from gpswb.validation.face_result import facet_classes

_FACET = np.dtype(
    [
        ("n", "u1"),
        ("v", "<i4", (3,)),
        ("rgb", "u1", (3,)),
        ("class", "i1"),
        ("region", "<i4"),
    ]
)


def write_ply(path: Path, partition: Partition) -> None:
    """Write the mesh, mm, facets coloured by class; properties ``class`` and ``region`` beside.

    Raises:
        OSError: the file can't be written.
    """
    mesh = partition.mesh
    label = facet_classes(partition)
    palette = np.array([WHEEL[name] for name in CLASSES] + [NONE], dtype=np.uint8)
    facets = np.empty(len(mesh.triangles), dtype=_FACET)
    facets["n"] = 3
    facets["v"] = mesh.triangles
    facets["rgb"] = palette[label]
    facets["class"] = label
    facets["region"] = partition.region
    header = "\n".join(
        (
            "ply",
            "format binary_little_endian 1.0",
            "comment gpswb: millimetres; class -1 none, "
            + ", ".join(f"{i} {name}" for i, name in enumerate(CLASSES)),
            f"element vertex {len(mesh.vertices)}",
            *(f"property double {axis}" for axis in "xyz"),
            f"element face {len(facets)}",
            "property list uchar int vertex_indices",
            *(f"property uchar {colour}" for colour in ("red", "green", "blue")),
            "property char class",
            "property int region",
            "end_header\n",
        )
    )
    with path.open("wb") as file:
        file.write(header.encode("ascii"))
        file.write(mesh.vertices.astype("<f8").tobytes())
        file.write(facets.tobytes())
