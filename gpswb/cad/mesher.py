# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mesh a shape at the density asked for: choose the mesher, fall back where it fails."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from gpswb.cad.brepmesh import brepmesh
from gpswb.cad.density import PRESETS, STL_DEFLECTION, Density
from gpswb.cad.faced import FacedMesh, join
from gpswb.cad.gmsh_mesher import gmsh_available, gmsh_body
from gpswb.cad.kernel import Shape
from gpswb.cad.refine import refine
from gpswb.cad.sizing import SizeRule
from gpswb.cad.spanned import span
from gpswb.cad.stitch import outward, stitch
from gpswb.cad.weld import Tessellation, weld
from gpswb.errors import InputError, KernelError
from gpswb.sentence import Sentence

Progress = Callable[[str, float], None]

AUTO_TURN = 24
"""Elements per full turn for density `auto`."""
AUTO_DIVISIONS = 8
"""Least number of elements across any curved face for density `auto`."""
_COARSEST = 20
"""No side is longer than this fraction of the part's diagonal where density follows curvature."""
_START_DEFLECTION = 0.004
"""Linear deflection of the mesh that refinement starts from, as a fraction of the diagonal. It
must be small: BRepMesh doesn't resolve what lies below a tenth of it."""
_ARC_FACTOR = 1.95
"""BRepMesh cuts a full arc into sides of about half its angular deflection [measured]."""
_CAP = 100_000
"""Most triangles of a density that follows curvature."""
_MOST = 20_000_000
"""Most triangles of any density."""
_UNIFORM_FACTOR = 1.35
"""Longest side over mean side of a mesh that was refined by halving [measured]."""
_COUNT_TOLERANCE, _COUNT_TRIES = 0.08, 5
_NEGLIGIBLE = 1e-7
"""Faces smaller than this fraction of the diagonal's square are spanned by their border where the
mesher leaves them out; for a larger one another mesher is asked."""
_STITCH = 1e-6
"""Distance at which open borders are welded, as a fraction of the diagonal."""


@dataclass
class _Job:
    """What the meshing of one shape has learnt so far."""

    shape: Shape
    progress: Progress | None
    bodies: list[list[int]]
    failed: dict[int, str] = field(default_factory=dict)
    notes: list[str] = field(default_factory=list)
    used: set[str] = field(default_factory=set)
    start: Tessellation | None = None


def tessellate(
    shape: Shape, density: Density, progress: Progress | None = None
) -> tuple[FacedMesh, str, tuple[str, ...]]:
    """Mesh a shape.

    Returns:
        The mesh, the name of the mesher (or meshers), and notes for the user.

    Raises:
        InputError: the density would make more triangles than can be handled.
    """
    job = _Job(shape, progress, _bodies(shape))
    bare = sum(face.kind is None for face in shape.faces)
    if bare:
        job.notes.append(f"{bare} faces have no surface, only a triangulation: it is kept as it is")
    if bare == len(shape.faces):
        mesh = _finish(job, weld(shape.tessellate(1.0, 0.5), shape.faces))
        job.used.add("the file's own triangulation")
    elif density.rule in ("stl", "deflection"):
        linear, angular = STL_DEFLECTION
        if density.rule == "deflection":
            linear, angular = density.value, math.radians(density.angle_deg)
        mesh = _finish(job, brepmesh(shape, linear, angular))
        job.used.add("brepmesh")
    elif density.rule in ("auto", "turn"):
        mesh = _adaptive(job, density)
    elif density.rule in ("vertices", "triangles"):
        mesh = _counted(job, density)
    elif density.rule == "edge":
        mesh = _uniform(job, density.value, 0)
    else:
        fraction, turn = PRESETS[density.rule]
        mesh = _uniform(job, shape.diagonal / fraction, turn)
    for body, why in job.failed.items():
        job.notes.append(f"{_body_name(body)}: {why}; meshed by BRepMesh and refinement instead")
    return mesh, " and ".join(sorted(job.used)), tuple(job.notes)


def _adaptive(job: _Job, density: Density) -> FacedMesh:
    shape = job.shape
    turns = density.value if density.rule == "turn" else AUTO_TURN
    angle = 2 * math.pi / turns
    start = brepmesh(shape, _START_DEFLECTION * shape.diagonal, min(_ARC_FACTOR * angle, 0.5))
    rule = SizeRule(
        max_length=shape.diagonal / _COARSEST,
        max_turn=angle * 1.05,
        divisions=AUTO_DIVISIONS if density.rule == "auto" else 0,
        max_triangles=_CAP,
    )
    refined, capped = refine(start, shape, rule, job.progress)
    job.used.add("brepmesh+refine")
    if capped:
        job.notes.append(f"refinement stopped at its cap of {_CAP} triangles")
    return _finish(job, refined, _bodies_by_gmsh(job, start, density, turns))


def _bodies_by_gmsh(
    job: _Job, start: Tessellation, density: Density, turns: float
) -> dict[int, FacedMesh]:
    """Bodies with a face that BRepMesh gives no triangulation for, meshed by gmsh."""
    shape = job.shape
    meshed = np.zeros(len(shape.faces), dtype=bool)
    meshed[start.face] = True
    lost = {
        face.solid
        for face, done in zip(shape.faces, meshed, strict=True)
        if not done and face.kind is not None and face.area > _NEGLIGIBLE * shape.diagonal**2
    }
    found: dict[int, FacedMesh] = {}
    if not gmsh_available():
        return found
    for faces in job.bodies:
        body = shape.faces[faces[0]].solid
        if body not in lost:
            continue
        try:
            found[body] = gmsh_body(shape, faces, shape.diagonal / _COARSEST, turns)
        except KernelError as error:
            job.notes.append(f"gmsh can't replace BRepMesh: {error}")
            continue
        job.used.add("gmsh")
        job.notes.append(
            f"{_body_name(body)}: BRepMesh doesn't mesh all its faces; meshed by gmsh for {density}"
        )
    return found


def _body_name(body: int) -> str:
    return "free faces" if body < 0 else f"solid {body + 1}"


def _counted(job: _Job, density: Density) -> FacedMesh:
    """Near-uniform mesh with about so many vertices or triangles: the size is corrected by what
    the last one gave, since small faces and curved borders take more than their share."""
    wanted = density.value
    area = sum(face.area for face in job.shape.faces)
    per_triangle = 0.5 if density.rule == "vertices" else 1.0
    size = math.sqrt(4 / math.sqrt(3) * area * per_triangle / wanted)
    best: tuple[float, FacedMesh] | None = None
    for _ in range(_COUNT_TRIES):
        mesh = _uniform(job, size, 0)
        count = len(mesh.vertices if density.rule == "vertices" else mesh.triangles)
        error = abs(math.log(max(count, 1) / wanted))
        if best is None or error < best[0]:
            best = error, mesh
        if error <= _COUNT_TOLERANCE:
            break
        size *= math.sqrt(max(count, 1) / wanted)
    assert best is not None
    if best[0] > 0.15:
        mesh = best[1]
        count = len(mesh.vertices if density.rule == "vertices" else mesh.triangles)
        job.notes.append(
            f"asked for {int(wanted)} {density.rule}, got {count}: the nearest that was found"
        )
    return best[1]


def _uniform(job: _Job, size: float, turn: int) -> FacedMesh:
    """Edge length ``size`` (mm) everywhere; shorter where a full turn would get fewer than ``turn``
    elements (0: never)."""
    area = sum(face.area for face in job.shape.faces)
    expected = 4 / math.sqrt(3) * area / size**2
    if expected > _MOST:
        raise InputError(
            Sentence(
                "an edge length of {size:.3g} mm would make about {expected:.2g} triangles; at "
                "most {most} are possible",
                size=size,
                expected=expected,
                most=_MOST,
            )
        )
    meshes: list[FacedMesh] = []
    for k, faces in enumerate(job.bodies):
        body = job.shape.faces[faces[0]].solid
        mesh = None
        surfaces = all(job.shape.faces[i].kind is not None for i in faces)
        if gmsh_available() and surfaces and body not in job.failed:
            try:
                mesh = gmsh_body(job.shape, faces, size, turn, 60 + expected / 2000)
                job.used.add("gmsh")
            except KernelError as error:
                job.failed[body] = str(error)
        if mesh is None:
            mesh = _uniform_fallback(job, faces, size, turn)
        meshes.append(_repair(job, mesh))
        if job.progress is not None:
            job.progress("tessellate", (k + 1) / len(job.bodies))
    return join(meshes)


def _uniform_fallback(job: _Job, faces: list[int], size: float, turn: int) -> FacedMesh:
    if job.start is None:
        job.start = brepmesh(job.shape, _START_DEFLECTION * job.shape.diagonal, 0.5)
    inside = np.zeros(len(job.shape.faces), dtype=bool)
    inside[faces] = True
    start = job.start.subset(inside[job.start.face])
    rule = SizeRule(
        max_length=_UNIFORM_FACTOR * size,
        max_turn=1.05 * 2 * math.pi / turn if turn else math.inf,
        graded=False,
        max_triangles=_MOST,
    )
    refined, _ = refine(start, job.shape, rule, None)
    job.used.add("brepmesh+refine")
    return _spanned(job, refined, faces).compact()


def _finish(
    job: _Job, mesh: Tessellation, instead: Mapping[int, FacedMesh] | None = None
) -> FacedMesh:
    """Repair body by body; those in ``instead`` are taken from there."""
    whole = _spanned(job, mesh, range(len(job.shape.faces)))
    body_of_face = np.array([face.solid for face in job.shape.faces])
    parts = []
    for faces in job.bodies:
        body = job.shape.faces[faces[0]].solid
        if instead and body in instead:
            parts.append(_repair(job, instead[body]))
            continue
        mine = body_of_face[whole.face] == body
        part = replace(whole, triangles=whole.triangles[mine], face=whole.face[mine])
        parts.append(_repair(job, part.compact()))
    return join(parts)


def _spanned(job: _Job, mesh: Tessellation, faces: Iterable[int]) -> FacedMesh:
    """The mesh with small ones of ``faces`` that BRepMesh left out: across a large one there may be
    a surface of any shape."""
    done = set(mesh.face.tolist())
    out = [(i, job.shape.faces[i]) for i in faces if i not in done]
    least = _NEGLIGIBLE * job.shape.diagonal**2
    return span(mesh, [(i, f) for i, f in out if f.kind is not None and f.area <= least])


def _repair(job: _Job, mesh: FacedMesh) -> FacedMesh:
    return outward(stitch(mesh, _STITCH * job.shape.diagonal))


def _bodies(shape: Shape) -> list[list[int]]:
    """Faces of each solid, the free faces (solid -1) last."""
    groups: dict[int, list[int]] = {}
    for i, face in enumerate(shape.faces):
        groups.setdefault(face.solid, []).append(i)
    return [groups[k] for k in sorted(groups, key=lambda k: (k < 0, k))]
