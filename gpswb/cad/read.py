# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read a CAD file and tessellate it: the door of `cad`."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from pathlib import Path
from typing import Literal

import numpy as np

from gpswb.cad.brepmesh import brepmesh
from gpswb.cad.density import STL_DEFLECTION, Density
from gpswb.cad.features import maximal_features
from gpswb.cad.kernel import Shape
from gpswb.cad.refine import refine
from gpswb.cad.sizing import SizeRule
from gpswb.cad.sniff import sniff
from gpswb.cad.solid import Face, FaceMap, Solid
from gpswb.cad.truth import face_truth
from gpswb.cad.weld import Tessellation
from gpswb.core.mesh import Mesh
from gpswb.errors import InputError, KernelError

Kernel = Literal["ocp", "freecad"]
Progress = Callable[[str, float], None]

AUTO_TURN = 24
"""Elements per full turn for density `auto`."""
AUTO_DIVISIONS = 8
"""Least number of elements across any curved face for density `auto`."""
_COARSEST = 20
"""No side is longer than this fraction of the part's diagonal where density follows curvature."""
_START_DEFLECTION = 0.004
"""Linear deflection of the mesh that refinement starts from, as a fraction of the diagonal. BRepMesh
doesn't resolve edges below a tenth of it, so the angle alone can't be relied upon."""
_ARC_FACTOR = 1.95
"""BRepMesh cuts a full arc into sides of about half its angular deflection [measured]."""
_CAP = 250_000


def read_solid(
    path: str | Path,
    density: Density,
    kernel: Kernel = "ocp",
    progress: Progress | None = None,
) -> Solid:
    """Read a STEP, BREP or FCStd file and tessellate it.

    Args:
        path: the file.
        density: how fine.
        kernel: ``ocp`` or ``freecad`` (FreeCAD's Part; the only one for FCStd).
        progress: called with the stage's name and the share done, 0 to 1.

    Raises:
        InputError: the file is missing, broken, of another format, or holds nothing to mesh.
        KernelError: the kernel isn't installed in this Python.
    """
    source = Path(path)
    form, sha256 = sniff(source)
    start = time.perf_counter()
    _tell(progress, "read", 0.0)
    shape = _load(source, form, kernel)
    _tell(progress, "read", 1.0)
    read_s = time.perf_counter() - start
    start = time.perf_counter()
    tessellation, mesher, notes = tessellate(shape, density, progress)
    if not len(tessellation.triangles):
        raise InputError(f"{source}: no face of the shape can be tessellated")
    mesh_s = time.perf_counter() - start
    start = time.perf_counter()
    truths = [face_truth(face) for face in shape.faces]
    truth_s = time.perf_counter() - start
    faces = tuple(
        Face(f"Face{i + 1}", face.area, face.solid, truth)
        for i, (face, truth) in enumerate(zip(shape.faces, truths, strict=True))
    )
    bare = np.setdiff1d(np.arange(len(faces)), tessellation.face)
    if len(bare):
        names = ", ".join(faces[i].name for i in bare[:5]) + (" ..." if len(bare) > 5 else "")
        notes = (*notes, f"{len(bare)} of {len(faces)} faces have no triangles: {names}")
    return Solid(
        mesh=Mesh(tessellation.vertices, tessellation.triangles),
        facemap=FaceMap(tessellation.face, faces, maximal_features(shape, truths)),
        source=str(path),
        unit=shape.unit,
        density=str(density),
        mesher=mesher,
        notes=(*shape.notes, *notes),
        sha256=sha256,
        timings={"read": read_s, "tessellate": mesh_s, "truth": truth_s},
    )


def _load(source: Path, form: str, kernel: Kernel) -> Shape:
    try:
        if kernel == "ocp":
            from gpswb.cad import ocp_read

            return ocp_read.read(source, form)  # type: ignore[arg-type]
        from gpswb.cad import freecad_read

        return freecad_read.read(source, form)
    except ImportError as error:
        raise KernelError(f"kernel {kernel!r} isn't available in this Python ({error})") from None


def tessellate(
    shape: Shape, density: Density, progress: Progress | None = None
) -> tuple[Tessellation, str, tuple[str, ...]]:
    """Mesh a shape: the tessellation, the mesher's name and notes for the user."""
    _tell(progress, "tessellate", 0.0)
    if density.rule in ("stl", "deflection"):
        linear, angular = STL_DEFLECTION
        if density.rule == "deflection":
            linear, angular = density.value, math.radians(density.angle_deg)
        return brepmesh(shape, linear, angular), "brepmesh", ()
    diagonal = shape.diagonal
    turn = density.value if density.rule == "turn" else AUTO_TURN
    angle = 2 * math.pi / turn
    start = brepmesh(shape, _START_DEFLECTION * diagonal, min(_ARC_FACTOR * angle, 0.5))
    rule = SizeRule(
        max_length=diagonal / _COARSEST,
        max_turn=angle * 1.05,
        divisions=AUTO_DIVISIONS if density.rule == "auto" else 0,
        max_triangles=_CAP,
    )
    mesh, capped = refine(start, shape, rule, progress)
    notes = (f"refinement stopped at the cap of {_CAP} triangles",) if capped else ()
    return mesh, "brepmesh+refine", notes


def _tell(progress: Progress | None, stage: str, share: float) -> None:
    if progress is not None:
        progress(stage, share)
