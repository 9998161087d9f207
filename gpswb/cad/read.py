# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read a CAD file and tessellate it: the door of `cad`."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import Literal

import numpy as np

from gpswb.cad.defects import find_defects
from gpswb.cad.density import Density
from gpswb.cad.features import maximal_features
from gpswb.cad.kernel import Shape
from gpswb.cad.mesher import tessellate
from gpswb.cad.sniff import Format, sniff
from gpswb.cad.solid import Face, FaceMap, Solid
from gpswb.cad.truth import face_truth
from gpswb.core.mesh import Mesh
from gpswb.errors import InputError, KernelError
from gpswb.sentence import Sentence

Kernel = Literal["ocp", "freecad"]
Progress = Callable[[str, float], None]


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
        kernel: ``ocp`` or ``freecad`` (FreeCAD's Part).
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
    _tell(progress, "tessellate", 0.0)
    faced, mesher, notes = tessellate(shape, density, progress)
    if not len(faced.triangles):
        raise InputError(Sentence("{path}: no face of the shape can be tessellated", path=source))
    mesh_s = time.perf_counter() - start
    start = time.perf_counter()
    truths = [face_truth(face) for face in shape.faces]
    truth_s = time.perf_counter() - start
    faces = tuple(
        Face(f"Face{i + 1}", face.area, face.solid, truth)
        for i, (face, truth) in enumerate(zip(shape.faces, truths, strict=True))
    )
    bare = np.setdiff1d(np.arange(len(faces)), faced.face)
    if len(bare):
        names = ", ".join(faces[i].name for i in bare[:5]) + (" ..." if len(bare) > 5 else "")
        notes = (*notes, f"{len(bare)} of {len(faces)} faces have no triangles: {names}")
    defects = find_defects(faced)
    if defects.flat or defects.folded:
        notes = (
            *notes,
            f"the mesh has {defects.flat} triangles without area and {defects.folded} folds",
        )
    return Solid(
        mesh=Mesh(faced.vertices, faced.triangles),
        facemap=FaceMap(faced.face, faces, maximal_features(shape, truths)),
        source=str(path),
        unit=shape.unit,
        density=str(density),
        mesher=mesher,
        notes=(*shape.notes, *notes),
        sha256=sha256,
        timings={"read": read_s, "tessellate": mesh_s, "truth": truth_s},
    )


def _load(source: Path, form: Format, kernel: Kernel) -> Shape:
    try:
        if kernel == "ocp":
            from gpswb.cad import ocp_read

            return ocp_read.read(source, form)
        from gpswb.cad import freecad_read

        return freecad_read.read(source, form)
    except ImportError as error:
        raise KernelError(f"kernel {kernel!r} isn't available in this Python ({error})") from None


def _tell(progress: Progress | None, stage: str, share: float) -> None:
    if progress is not None:
        progress(stage, share)
