# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small parts put together by hand: facets, faces, truths and regions are all chosen."""

from collections.abc import Sequence

import numpy as np

from gpswb.cad.solid import Face, FaceMap, FaceTruth, Solid
from gpswb.core.invariance import CLASSES, InvarianceClass
from gpswb.core.mesh import Mesh
from gpswb.core.partition import Partition, Region


def truth(
    nominal: InvarianceClass, surface: str = "Plane", ambiguous: bool = False, **parameters: tuple
) -> FaceTruth:
    return FaceTruth(surface, nominal, nominal, parameters, ambiguous)


def sheet(corners: Sequence[Sequence[float]], cells: tuple[int, int] = (1, 1)) -> tuple:
    """A grid of triangles over the quadrilateral ``corners``: vertices and triangles."""
    a, b, c, d = np.array(corners, dtype=float)
    i, j = cells
    s, t = np.meshgrid(np.linspace(0, 1, i + 1), np.linspace(0, 1, j + 1), indexing="ij")
    s, t = s.reshape(-1, 1), t.reshape(-1, 1)
    vertices = (1 - s) * (1 - t) * a + s * (1 - t) * b + s * t * c + (1 - s) * t * d
    k = np.arange((i + 1) * (j + 1)).reshape(i + 1, j + 1)
    p, q, r, u = (x.ravel() for x in (k[:-1, :-1], k[1:, :-1], k[1:, 1:], k[:-1, 1:]))
    return vertices, np.concatenate([np.column_stack([p, q, r]), np.column_stack([p, r, u])])


def arc(
    radius: float, from_deg: float, to_deg: float, steps: int, rows: int, z: float = 0
) -> tuple:
    """A piece of a cylinder about the z axis, one unit high: vertices and triangles."""
    flat, triangles = sheet([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], (steps, rows))
    angle = np.radians(from_deg + (to_deg - from_deg) * flat[:, 0])
    points = np.column_stack([radius * np.cos(angle), radius * np.sin(angle), z + flat[:, 1]])
    return points, triangles


def row_of_squares(n: int, cells: tuple[int, int] = (1, 1)) -> list[tuple]:
    """``n`` unit squares side by side in the plane z = 0."""
    return [sheet([[i, 0, 0], [i + 1, 0, 0], [i + 1, 1, 0], [i, 1, 0]], cells) for i in range(n)]


def put_together(
    patches: Sequence[tuple],
    truths: Sequence[FaceTruth | None],
    region: Sequence[int] | np.ndarray,
    classes: Sequence[InvarianceClass],
    features: Sequence[int] | None = None,
    undecided: tuple[InvarianceClass, ...] = (),
) -> tuple[Partition, FaceMap]:
    """Weld patches (one a face) into a mesh; ``region`` is given a patch or a facet."""
    vertices = np.concatenate([np.asarray(v).reshape(-1, 3) for v, _ in patches])
    offset = np.cumsum([0, *(len(v) for v, _ in patches)])
    triangles = np.concatenate(
        [
            np.asarray(t, dtype=int).reshape(-1, 3) + o
            for (_, t), o in zip(patches, offset[:-1], strict=True)
        ]
    )
    face = np.repeat(np.arange(len(patches)), [len(t) for _, t in patches])
    _, first, index = np.unique(
        np.round(vertices, 9), axis=0, return_index=True, return_inverse=True
    )
    mesh = Mesh(vertices[first], index.reshape(-1)[triangles])
    label = np.asarray(region, dtype=np.int64)
    if len(label) == len(patches) != len(face):
        label = label[face]
    areas = [float(mesh.areas[face == i].sum()) for i in range(len(patches))]
    faces = tuple(Face(f"Face{i + 1}", areas[i], 0, t) for i, t in enumerate(truths))
    number = np.arange(len(patches)) if features is None else np.asarray(features)
    return partition_of(mesh, label, classes, undecided), FaceMap(face, faces, number)


def partition_of(
    mesh: Mesh,
    region: np.ndarray,
    classes: Sequence[InvarianceClass],
    undecided: tuple[InvarianceClass, ...] = (),
) -> Partition:
    """A partition with these regions and classes; the rest is filled in plausibly."""
    regions = tuple(
        Region(
            id=i,
            invariance_class=name,
            area=float(mesh.areas[region == i].sum()),
            triangles=int((region == i).sum()),
            surface="plane",
            situation={"point": [0.0, 0.0, 0.0], "normal": [0.0, 0.0, 1.0]},
            intrinsic={"radius": 5.0} if name == "cylindrical" else {},
            residual=1e-9,
            margin=float("inf"),
            initial_regions=1,
            log_likelihood={c: -100.0 * (k + 1) for k, c in enumerate(CLASSES)},
            undecided=undecided,
        )
        for i, name in enumerate(classes)
    )
    n, m = len(mesh.vertices), len(mesh.triangles)
    return Partition(
        mesh=mesh,
        shape_type=np.full(m, 5, dtype=np.int64),
        initial_region=np.asarray(region, dtype=np.int64),
        region=np.asarray(region, dtype=np.int64),
        regions=regions,
        vertex_shape_type=np.full(n, 5, dtype=np.int64),
        shape_index=np.zeros(n),
        curvedness=np.zeros(n),
        initial_region_count=len(regions),
        sharp_edge_regions=0,
        sigma=0.0,
        mode="robust",
        method="hybrid",
        timings={"recognise": 0.25},
    )


def solid_of(mesh: Mesh, facemap: FaceMap | None, source: str = "part.step") -> Solid:
    return Solid(
        mesh, facemap, source, "mm", "stl", "brepmesh", ("a note",), "0" * 64, {"read": 1.0}
    )
