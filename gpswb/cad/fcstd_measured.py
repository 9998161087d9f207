# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Mesh and Points objects of a FreeCAD document, read from its archive as its shapes are."""

from __future__ import annotations

import zipfile
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np

from gpswb.cad.fcstd import (
    containers,
    open_document,
    own_placement,
    placement_above,
    read_member,
    stored_objects,
)
from gpswb.core.mesh import FloatArray, IntArray
from gpswb.errors import InputError

_MAGIC, _VERSION = 0xA0B0C0D0, 0x010000
_HEAD = 8 + 256
"""Bytes of a mesh file before its counts: magic number, version, a text."""


@dataclass(frozen=True, eq=False)
class Measurement:
    """A measured mesh, or a point cloud if it has no triangles.

    Args:
        vertices: (n, 3) float64, mm.
        triangles: (m, 3) int64.
    """

    vertices: FloatArray
    triangles: IntArray

    def placed(self, placement: FloatArray) -> Measurement:
        """The same at another place, (4, 4)."""
        return Measurement(self.vertices @ placement[:3, :3].T + placement[:3, 3], self.triangles)


def stored_measurements(path: Path) -> list[Measurement]:
    """Every mesh and point cloud of a document, at its place.

    Raises:
        InputError: the archive is broken, too large, or holds neither.
    """
    found = []
    with open_document(path) as (archive, root):
        data = stored_objects(root)
        parent = containers(data)
        for name, item in data.items():
            stored = _stored(archive, item)
            if stored is not None:
                above = placement_above(name, parent, data)
                found.append(stored.placed(above @ own_placement(item)))
    if not found:
        raise InputError(f"{path}: the document holds no shape, no mesh and no points")
    return found


def _stored(archive: zipfile.ZipFile, item: ET.Element) -> Measurement | None:
    mesh = item.find("./Properties/Property[@type='Mesh::PropertyMeshKernel']/Mesh")
    if mesh is not None and mesh.get("file"):
        return read_mesh(read_member(archive, mesh.get("file", "")))
    points = item.find("./Properties/Property[@type='Points::PropertyPointKernel']/Points")
    if points is not None and points.get("file"):
        return read_points(read_member(archive, points.get("file", "")))
    return None


def read_mesh(data: bytes) -> Measurement:
    """A mesh in FreeCAD's binary format: points, then three corners and neighbours a facet.

    Raises:
        ValueError: it isn't in that format, or is cut short.
    """
    magic, version = np.frombuffer(data, "<u4", 2)
    if (magic, version) != (_MAGIC, _VERSION):
        raise ValueError("a mesh is stored in an unknown format")
    n, m = (int(k) for k in np.frombuffer(data, "<u4", 2, _HEAD))
    vertices = np.frombuffer(data, "<f4", 3 * n, _HEAD + 8).reshape(-1, 3)
    facets = np.frombuffer(data, "<u4", 6 * m, _HEAD + 8 + 12 * n).reshape(-1, 6)
    return Measurement(vertices.astype(np.float64), facets[:, :3].astype(np.int64))


def read_points(data: bytes) -> Measurement:
    """Points in FreeCAD's binary format: their number, then their coordinates.

    Raises:
        ValueError: it is cut short.
    """
    n = int(np.frombuffer(data, "<u4", 1)[0])
    points = np.frombuffer(data, "<f4", 3 * n, 4).reshape(-1, 3)
    return Measurement(points.astype(np.float64), np.zeros((0, 3), dtype=np.int64))
