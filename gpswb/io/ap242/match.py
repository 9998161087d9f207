# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which entity of the text each B-rep face is: by surface and border, never by order."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from gpswb.cad.solid import FaceMap
from gpswb.core.mesh import FloatArray, IntArray, Mesh
from gpswb.errors import InputError
from gpswb.io.ap242.part21 import Part21, Ref
from gpswb.io.ap242.structure import ShapeOfProduct
from gpswb.io.ap242.surfaces import TextFace, text_face, unit

_CANDIDATES = 12
_BORDER = 0.05
"""Borders may differ by this fraction of the face's size: both are cut into chords."""
_SURFACE = 5e-3
"""Vertices may on average lie off the text's surface by this fraction of the face's size: edges of
real files stray from their surfaces by as much."""
_SIDE = 1e-3
"""Weight of the side on which the face lies: it tells the halves of a sphere apart, which have one
border. The normals, a fifth of that, do so where two solids touch. Neither can be relied upon:
files hold faces and shells that are turned round, which kernels mend."""
_PAIRS = 400_000
"""Of a long border every n-th segment is compared, so that at most so many pairs are."""


@dataclass(frozen=True)
class FaceEntity:
    """The entity behind a B-rep face: its number, and the index of the shape that holds it."""

    number: Ref
    shape: int


@dataclass(frozen=True, eq=False)
class _Outline:
    """Border (k, 2, 3), the way into the face and its normal there (k, 3), vertices (v, 3),
    centre and size."""

    border: FloatArray
    inward: FloatArray
    normal: FloatArray
    vertices: FloatArray
    key: FloatArray


def match_faces(
    file: Part21, shapes: tuple[ShapeOfProduct, ...], mesh: Mesh, facemap: FaceMap
) -> dict[str, FaceEntity]:
    """Entity of each face, by its name; faces that no entity fits are left out.

    An entity that occurs several times in an assembly is the entity of several faces.

    Args:
        mesh: in mm, of the whole shape, made from the same file.
    """
    placed: list[tuple[TextFace, FloatArray, FaceEntity, _Outline]] = []
    for index, shape in enumerate(shapes):
        for number in shape.faces:
            try:
                face = text_face(file, number, shape.units)
            except InputError:
                continue  # a face that can't be understood can't be annotated
            placed += [
                (face, place, FaceEntity(number, index), _text_outline(face, place))
                for place in shape.places
            ]
    if not placed:
        return {}
    tree = cKDTree(np.array([outline.key for *_, outline in placed]))
    pairs: list[tuple[float, int, int]] = []
    names = [face.name for face in facemap.faces]
    order = np.argsort(facemap.face_of_triangle, kind="stable")
    ends = np.searchsorted(facemap.face_of_triangle[order], np.arange(len(names) + 1))
    for i in range(len(names)):
        triangles = mesh.triangles[order[ends[i] : ends[i + 1]]]
        if not len(triangles):
            continue
        outline = _mesh_outline(mesh.vertices, triangles)
        near = np.atleast_1d(tree.query(outline.key, k=min(_CANDIDATES, len(placed)))[1])
        for j in near.tolist():
            face, place, _, text = placed[j]
            cost = _cost(face, place, text, outline)
            if cost is not None:
                pairs.append((cost, i, j))
    found: dict[str, FaceEntity] = {}
    taken: set[int] = set()
    for _, i, j in sorted(pairs):
        if names[i] not in found and j not in taken:
            found[names[i]] = placed[j][2]
            taken.add(j)
    return found


def _text_outline(face: TextFace, place: FloatArray) -> _Outline:
    turn, shift = place[:3, :3], place[:3, 3]
    border = face.border @ turn.T + shift
    inward, normal = face.inward @ turn.T, face.normal @ turn.T
    middle = (place @ face.frame)[:3, 3]
    return _Outline(border, inward, normal, border.reshape(-1, 3), _key(border, middle))


def _mesh_outline(vertices: FloatArray, triangles: IntArray) -> _Outline:
    corners = vertices[triangles]
    edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]], axis=2).reshape(-1, 2)
    _, first, count = np.unique(edges, axis=0, return_index=True, return_counts=True)
    rim = np.sort(first[count == 1])
    border = vertices[edges[rim]]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal = unit(np.asarray(across, dtype=np.float64))[rim // 3]
    into = corners[rim // 3].mean(axis=1) - border.mean(axis=1)
    along = unit(border[:, 1] - border[:, 0])
    inward = unit(into - along * np.einsum("ij,ij->i", into, along)[:, None])
    own = vertices[np.unique(triangles)]
    middle = (own.min(axis=0) + own.max(axis=0)) / 2
    return _Outline(border, inward, normal, own, _key(border, middle))


def _key(border: FloatArray, middle: FloatArray) -> FloatArray:
    """(4,) centroid of the border (or the middle of a face without one) and its size, mm."""
    if not len(border):
        return np.append(middle, 0.0)
    length = np.linalg.norm(border[:, 1] - border[:, 0], axis=1)
    centre = np.average(border.mean(axis=1), axis=0, weights=np.maximum(length, 1e-12))
    return np.append(centre, np.linalg.norm(np.ptp(border.reshape(-1, 3), axis=0)))


def _cost(face: TextFace, place: FloatArray, text: _Outline, mesh: _Outline) -> float | None:
    """How badly a face of the text fits one of the mesh, 0 to about 1; None if not at all."""
    size = float(np.linalg.norm(np.ptp(mesh.vertices, axis=0))) or 1.0
    off = float(face.distance(mesh.vertices, place).mean())
    if off > _SURFACE * size:
        return None
    if not len(text.border) or not len(mesh.border):
        if len(text.border) or len(mesh.border):
            return None
        return off / size
    apart, unlike = [], 0.0
    for one, other in ((mesh, text), (text, mesh)):
        step = 1 + len(one.border) * len(other.border) // _PAIRS
        distance, nearest = _to_segments(one.border[::step, 0], other.border)
        if float(distance.max()) > _BORDER * size:
            return None
        apart.append(float(distance.mean()))
        for a, b, weight in (
            (one.inward, other.inward, 1.0),
            (one.normal, other.normal, 0.2),
        ):
            unlike += weight * float(np.mean(1.0 - np.einsum("ij,ij->i", a[::step], b[nearest])))
    # The mesh's vertices lie on the edges, the text's are up to a chord's height off the mesh's.
    return (apart[0] + off) / size + (_SIDE * unlike if text.inward.any() else 0.0)


def _to_segments(points: FloatArray, segments: FloatArray) -> tuple[FloatArray, IntArray]:
    """Distance (k,) from points (k, 3) to the nearest of segments (s, 2, 3), and which (k,)."""
    start, along = segments[:, 0], segments[:, 1] - segments[:, 0]
    squared = np.maximum(np.einsum("ij,ij->i", along, along), 1e-300)
    relative = points[:, None] - start
    share = np.clip(np.einsum("ksj,sj->ks", relative, along) / squared, 0.0, 1.0)
    gap = np.linalg.norm(relative - share[..., None] * along, axis=2)
    nearest = gap.argmin(axis=1)
    return gap[np.arange(len(points)), nearest], nearest
