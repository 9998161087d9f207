# SPDX-License-Identifier: LGPL-2.1-or-later
"""Defects of the tessellation: ``python benchmarks/mesh_quality.py FILES [--density auto ...]``.

For each part and density, on OCP:

- flat: triangles without area;
- folded: pairs of adjacent facets of one face that turn by over 120 degrees;
- gaps: sides of one triangle only, in bodies whose B-rep is closed;
- crowded: sides of more than two triangles, or of two that look opposite ways, in bodies whose
  B-rep has no such edge;
- against: facets that look against the exact normal of their surface;
- bare: faces that have a surface and area, but no triangle;
- chord: largest distance of a facet's middle from its surface, and of it what was asked for;
- aspect: longest side over the height on it, the worst of the triangles with area.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import numpy as np
from OCP.BRep import BRep_Tool
from OCP.gp import gp_Pnt, gp_Pnt2d
from OCP.ShapeAnalysis import ShapeAnalysis_Surface

from gpswb.cad.defects import facet_normals, find_defects, flat_triangles
from gpswb.cad.density import STL_DEFLECTION, Density
from gpswb.cad.faced import FacedMesh
from gpswb.cad.mesher import tessellate
from gpswb.cad.ocp import OcpFace, OcpShape
from gpswb.cad.ocp_read import read
from gpswb.cad.sniff import sniff
from gpswb.cad.surface import outward_normals
from gpswb.errors import GpswbError

_PRECISION = 1e-7
"""Of projections on a surface, mm."""


@dataclass(frozen=True)
class Row:
    """Figures of one file at one density; ``status`` says why there are none."""

    file: str
    density: str
    status: str = "done"
    faces: int = 0
    triangles: int = 0
    flat: int = 0
    folded: int = 0
    gaps: int = 0
    crowded: int = 0
    against: int = 0
    bare: int = 0
    chord_mm: float = 0.0
    chord_share: float = 0.0
    aspect: float = 0.0
    seconds: float = 0.0
    mesher: str = ""
    worst_faces: str = ""

    @property
    def sound(self) -> bool:
        """No defect of any kind."""
        counts = self.flat, self.folded, self.gaps, self.crowded, self.against, self.bare
        return self.status == "done" and not any(counts)


def figures(path: Path, density: Density) -> Row:
    """All figures of one file."""
    shape = read(path, sniff(path)[0])
    start = time.process_time()
    mesh, mesher, _ = tessellate(shape, density)
    seconds = time.process_time() - start
    found, gaps, crowded = find_defects(mesh), 0, 0
    body = np.array([face.solid for face in shape.faces])
    for solid in np.unique(body):
        part = FacedMesh(mesh.vertices, mesh.triangles[body[mesh.face] == solid], mesh.face[:0])
        closed, simple = _kind_of_body([f for f in shape.faces if f.solid == solid])
        mine = find_defects(FacedMesh(part.vertices, part.triangles, np.zeros(len(part.triangles))))
        gaps += mine.single * closed
        crowded += mine.crowded * simple
    normal, height = facet_normals(mesh)
    flat = flat_triangles(mesh, height)
    chord, against = _against_surface(shape, mesh, normal, flat)
    corner = mesh.vertices[mesh.triangles]
    longest = np.linalg.norm(np.roll(corner, -1, axis=1) - corner, axis=2).max(axis=1)
    count = np.bincount(mesh.face, minlength=len(shape.faces))
    bare = [i for i, f in enumerate(shape.faces) if not count[i] and f.kind and f.area > 0]
    owners = Counter({"flat": mesh.face[flat], "against": mesh.face[against]})
    names = {what: Counter(f.tolist()).most_common(4) for what, f in owners.items()}
    asked = {"stl": STL_DEFLECTION[0], "deflection": density.value}.get(density.rule, 0.0)
    return Row(
        file=path.name,
        density=str(density),
        faces=len(shape.faces),
        triangles=len(mesh.triangles),
        flat=found.flat,
        folded=found.folded,
        gaps=gaps,
        crowded=crowded,
        against=len(against),
        bare=len(bare),
        chord_mm=float(chord.max(initial=0.0)),
        chord_share=float(chord.max(initial=0.0)) / asked if asked else 0.0,
        aspect=float((longest[~flat] / height[~flat]).max(initial=0.0)),
        seconds=seconds,
        mesher=mesher,
        worst_faces=f"{names} bare {bare[:5]}",
    )


def _kind_of_body(faces: Sequence[OcpFace]) -> tuple[bool, bool]:
    """Whether the faces share every edge with another, and none with more than one."""
    passes = Counter(number for f in faces for number, _, edge in f.passes if not _degenerate(edge))
    return min(passes.values(), default=2) >= 2, max(passes.values(), default=2) <= 2


def _degenerate(edge: Any) -> bool:
    return bool(BRep_Tool.Degenerated_s(edge))


def _against_surface(
    shape: OcpShape, mesh: FacedMesh, normal: np.ndarray, flat: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """(m,) distance of the triangles' middles from their surface, mm, and the triangles that look
    against its normal there."""
    middle = mesh.vertices[mesh.triangles].mean(axis=1)
    chord, against = np.zeros(len(middle)), []
    for i, face in enumerate(shape.faces):
        rows = np.flatnonzero((mesh.face == i) & ~flat)
        if face.kind is None or not len(rows):
            continue
        points, exact = _nearest(face, middle[rows], mesh.vertices[mesh.triangles[rows]])
        chord[rows] = np.linalg.norm(points - middle[rows], axis=1)
        against.append(rows[np.einsum("ij,ij->i", exact, normal[rows]) < 0])
    return chord, np.concatenate([np.empty(0, np.int64), *against])


def _nearest(face: OcpFace, at: np.ndarray, corner: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Points of the surface nearest to the points (k, 3), and the outward normals there.

    The search starts from a corner of the triangle, which lies on the surface: the other side of a
    thin face may be nearer. The nearest point of an elementary surface is known at once.
    """
    analysis = ShapeAnalysis_Surface(face.surface)
    uv = np.empty((len(at), 2))
    for k, (p, c) in enumerate(zip(at.tolist(), corner[:, 0].tolist(), strict=True)):
        if face.elementary is not None:
            found = analysis.ValueOfUV(gp_Pnt(*p), _PRECISION)
        else:
            start = analysis.ValueOfUV(gp_Pnt(*c), _PRECISION)
            from_corner = gp_Pnt2d(start.X(), start.Y())
            found = analysis.NextValueOfUV(from_corner, gp_Pnt(*p), _PRECISION, 1.0)
        uv[k] = found.X(), found.Y()
    return face.derivatives(uv)[0], outward_normals(face, uv)


def _work(send: Connection, path: Path, density: str) -> None:
    try:
        send.send(figures(path, Density.parse(density)))
    except GpswbError as error:
        send.send(Row(path.name, density, f"refused: {error}"))


def _isolated(path: Path, density: str, limit: float) -> Row:
    receive, send = multiprocessing.Pipe(duplex=False)
    process = multiprocessing.Process(target=_work, args=(send, path, density))
    process.start()
    send.close()
    try:
        return receive.recv() if receive.poll(limit) else Row(path.name, density, "timeout")
    except EOFError:
        return Row(path.name, density, "crash")
    finally:
        process.kill()
        process.join()


def line(row: Row) -> str:
    """One line a row."""
    if row.status != "done":
        return f"{row.file[:36]:36} {row.density[:16]:16} {row.status}"
    counts = "".join(
        f"{value:>8}"
        for value in (
            row.triangles, row.flat, row.folded, row.gaps, row.crowded, row.against, row.bare
        )
    )  # fmt: skip
    share = f" ({row.chord_share:.2f})" if row.chord_share else ""
    return (
        f"{row.file[:36]:36} {row.density[:16]:16}{counts}  {row.chord_mm:.3g} mm{share}"
        f"  {row.aspect:.3g}  {row.seconds:.1f} s"
    )


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("files", type=Path, nargs="+", metavar="FILE")
    parser.add_argument("--density", nargs="+", default=["auto", "stl", "triangles=20000"])
    parser.add_argument("--limit", type=float, default=300.0, help="seconds a run; 300")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the figures there, too")
    args = parser.parse_args()
    print(
        f"{'file':36} {'density':16}"
        + "".join(
            f"{name:>8}" for name in ("tri", "flat", "folded", "gaps", "crowded", "against", "bare")
        )
        + "  chord  aspect  CPU"
    )
    rows = []
    for path in sorted(args.files, key=lambda path: path.name.lower()):
        for density in args.density:
            rows.append(_isolated(path, density, args.limit))
            print(line(rows[-1]), flush=True)
            if args.json:
                args.json.write_text(json.dumps([asdict(row) for row in rows], indent=1))
    done = [row for row in rows if row.status == "done"]
    print(f"{sum(row.sound for row in done)} of {len(done)} meshes without a defect")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
