# SPDX-License-Identifier: LGPL-2.1-or-later
"""Near-uniform meshing by gmsh, body by body, checked against the kernel's faces (design, 4, 8)."""

from __future__ import annotations

import importlib.util
import tempfile
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from gpswb.cad.faced import FacedMesh
from gpswb.cad.isolate import run_isolated
from gpswb.cad.kernel import Shape
from gpswb.core.mesh import FloatArray, IntArray
from gpswb.errors import KernelError

_AREA = 0.02, 0.35
"""Allowed relative difference of a face's area: gmsh's own figure (it must be the same face), and
the mesh's (a coarse mesh of a curved face is smaller)."""


def gmsh_available() -> bool:
    """Whether the gmsh wheel is installed in this Python."""
    return importlib.util.find_spec("gmsh") is not None


def gmsh_body(
    shape: Shape,
    faces: Sequence[int],
    size: float,
    per_turn: float = 0.0,
    timeout_s: float = 120.0,
) -> FacedMesh:
    """Mesh the given faces (of one body) with edge length ``size`` (mm).

    Args:
        shape: the shape.
        faces: indices of the body's faces.
        size: edge length, mm.
        per_turn: where a curved face would get fewer elements per full turn, edges become shorter.
        timeout_s: gmsh is killed after this time.

    Raises:
        KernelError: gmsh failed on a face, crashed or ran out of time; the message says which.
    """
    smallest = size / 16 if per_turn else size
    with tempfile.TemporaryDirectory(prefix="gpswb-") as folder:
        brep, out = Path(folder) / "body.brep", Path(folder) / "mesh.npz"
        shape.write_brep(brep, faces)
        about = run_isolated(
            "gpswb.cad.gmsh_worker:mesh_brep",
            [str(brep), str(out), size, smallest, per_turn],
            timeout_s,
        )
        _check_order(shape, faces, about["area"], about["centre"])
        with np.load(out) as data:
            vertices, triangles, local = data["vertices"], data["triangles"], data["face"]
    face = np.asarray(faces, dtype=np.int64)[local.astype(np.int64)]
    _check_cover(shape, faces, vertices, triangles, face)
    outward = np.array([f.outward for f in shape.faces])
    inward = outward[face] < 0
    triangles[inward] = triangles[inward][:, ::-1]
    return FacedMesh(vertices, triangles, face).compact()


def _check_order(
    shape: Shape, faces: Sequence[int], area: list[float], centre: list[list[float]]
) -> None:
    if len(area) != len(faces):
        raise KernelError(f"gmsh sees {len(area)} faces instead of {len(faces)}")
    reach = 1e-3 * shape.diagonal
    for i, a, c in zip(faces, area, centre, strict=True):
        face = shape.faces[i]
        if abs(a - face.area) > _AREA[0] * max(a, face.area) + reach**2 or (
            float(np.linalg.norm(np.array(c) - face.centre)) > reach
        ):
            raise KernelError(f"gmsh's face order doesn't match at Face{i + 1}")


def _check_cover(
    shape: Shape,
    faces: Sequence[int],
    vertices: FloatArray,
    triangles: IntArray,
    face: IntArray,
) -> None:
    corner = vertices[triangles]
    cross = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    area = np.bincount(face, 0.5 * np.linalg.norm(cross, axis=1), minlength=len(shape.faces))
    bad = [
        i
        for i in faces
        if abs(area[i] - shape.faces[i].area) > _AREA[1] * shape.faces[i].area
        and shape.faces[i].area > 1e-8 * shape.diagonal**2
    ]
    if bad:
        names = ", ".join(f"Face{i + 1}" for i in bad[:4]) + (" ..." if len(bad) > 4 else "")
        raise KernelError(f"gmsh doesn't mesh {len(bad)} faces ({names})")
