# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels of others mapped onto invariance classes: ABC's features and Fit4CAD's primitives.

A plane is planar, a cylinder cylindrical, a sphere spherical; cone, torus and surface of revolution
are revolute, a linear extrusion is prismatic. B-splines and what is called `Other` may be of any
class: they are left out. A label says how a surface was modelled, which may hide a higher symmetry;
in the files here only plane, cylinder, cone, sphere and torus occur, which can't.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import yaml
from scipy.spatial import cKDTree

from gpswb.core.invariance import CLASSES
from gpswb.core.mesh import Mesh
from gpswb.io.mesh_file import parse_mesh

CLASS_OF = {
    "plane": "planar", "cylinder": "cylindrical", "sphere": "spherical", "cone": "revolute",
    "torus": "revolute", "revolution": "revolute", "extrusion": "prismatic",
}  # fmt: skip

PRIMITIVE = re.compile(r"Primitive(\d+)\s*:=\s*\[([^\]]*)")


def abc_labels(path: Path, mesh: Mesh) -> np.ndarray:
    """(m, 7) bool: the classes that are right for each facet of the mesh; none where left out.

    Args:
        path: the OBJ file; its labels stand beside it.
        mesh: as read: facets may have been dropped or reordered, which their centroids undo.
    """
    parsed = parse_mesh(path)
    right = np.zeros((len(parsed.triangles), len(CLASSES)), dtype=bool)
    labels = yaml.load(
        path.with_suffix(".features.yml").read_text(encoding="utf-8"), Loader=yaml.CSafeLoader
    )
    for surface in labels["surfaces"]:
        name = CLASS_OF.get(surface["type"].lower())
        if name is not None:
            right[surface["face_indices"], CLASSES.index(name)] = True
    centroids = parsed.vertices[parsed.triangles].mean(axis=1)
    return right[cKDTree(centroids).query(mesh.centroids)[1]]


def fit4cad_labels(path: Path, count: int) -> np.ndarray:
    """(n, 7) bool: the classes that are right for each point.

    A point near the border of two primitives belongs to both, and either class is right.

    Args:
        path: the cloud, ``PCn.txt``; its labels stand beside it.
        count: number of points.
    """
    kinds = {n: text.split(",")[0].strip().lower() for n, text in _primitives(path, "parametric")}
    right = np.zeros((count, len(CLASSES)), dtype=bool)
    for number, text in _primitives(path, "primitives"):
        points = np.array(text.split(), dtype=np.int64) - 1
        right[points, CLASSES.index(CLASS_OF[kinds[number]])] = True
    return right


def _primitives(path: Path, kind: str) -> list[tuple[str, str]]:
    beside = path.with_name(f"{path.stem}_{kind}.txt")
    return PRIMITIVE.findall(beside.read_text(encoding="utf-8"))
