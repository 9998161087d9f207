# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading meshes: each format gives the same tetrahedron; bad files give one clear line."""

import struct
from pathlib import Path

import numpy as np
import pytest

from gpswb.core.mesh import Mesh
from gpswb.errors import InputError
from gpswb.io.measured_file import read_measured


def read_mesh(path: Path) -> Mesh:
    return read_measured(path).mesh


POINTS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
FACES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]


def stl_binary(shift: float = 0.0) -> bytes:
    body = struct.pack("<80sI", b"tetrahedron", 4)
    for i, face in enumerate(FACES):
        corners = [c + (shift if i == 3 else 0.0) for v in face for c in POINTS[v]]
        body += struct.pack("<12fH", 0, 0, 0, *corners, 0)
    return body


def numbers(*values: float) -> str:
    return " ".join(f"{value:g}" for value in values)


def text(kind: str) -> bytes:
    if kind == "off":
        lines = ["OFF", "4 4 6", *(numbers(*p) for p in POINTS)]
        lines += [numbers(3, *f) for f in FACES]
    elif kind == "obj":
        lines = ["mtllib absent.mtl", *("v " + numbers(*p) for p in POINTS)]
        lines += ["f " + numbers(*(i + 1 for i in f)) for f in FACES]
    elif kind == "ply":
        lines = ["ply", "format ascii 1.0", "element vertex 4"]
        lines += [f"property float {axis}" for axis in "xyz"]
        lines += ["element face 4", "property list uchar int vertex_indices", "end_header"]
        lines += [numbers(*p) for p in POINTS] + [numbers(3, *f) for f in FACES]
    else:
        lines = ["solid t"]
        for f in FACES:
            lines += ["facet normal 0 0 0", "outer loop"]
            lines += ["vertex " + numbers(*POINTS[v]) for v in f]
            lines += ["endloop", "endfacet"]
        lines += ["endsolid t"]
    return ("\n".join(lines) + "\n").encode()


@pytest.mark.parametrize(
    ("suffix", "content"),
    [
        (".stl", stl_binary()),
        (".STL", text("stl")),
        (".off", text("off")),
        (".obj", text("obj")),
        (".ply", text("ply")),
    ],
    ids=["binary stl", "ascii stl", "off", "obj", "ply"],
)
def test_formats_agree(tmp_path: Path, suffix: str, content: bytes) -> None:
    path = tmp_path / f"tetrahedron{suffix}"
    path.write_bytes(content)
    mesh = read_mesh(path)
    assert sorted(map(tuple, mesh.vertices.tolist())) == sorted(POINTS)
    assert len(mesh.facet_pairs) == 6  # closed: each of the six edges has two facets
    corners = mesh.corners
    volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6
    assert volume == pytest.approx(1 / 6)


def test_rounding_of_single_precision_is_welded(tmp_path: Path) -> None:
    path = tmp_path / "rounded.stl"
    path.write_bytes(stl_binary(shift=1.2e-7))
    assert len(read_mesh(path).vertices) == 4


def test_what_is_really_apart_stays_apart(tmp_path: Path) -> None:
    path = tmp_path / "gap.stl"
    path.write_bytes(stl_binary(shift=1e-4))
    assert len(read_mesh(path).vertices) == 7


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("empty.stl", b""),
        ("no_facets.stl", struct.pack("<80sI", b"", 0)),
        ("truncated.stl", stl_binary()[:150]),
        ("garbage.ply", b"\x00\xff" * 40),
        ("text.off", b"hello\n"),
        ("no_faces.obj", b"v 0 0 0\nv 1 0 0\n"),
        ("bad_index.off", b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n"),
        ("flat.off", b"OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n"),
        ("nan.off", b"OFF\n3 1 0\n0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_bad_files_give_one_line(tmp_path: Path, name: str, content: bytes) -> None:
    (tmp_path / name).write_bytes(content)
    with pytest.raises(InputError) as error:
        read_mesh(tmp_path / name)
    assert "\n" not in str(error.value)
    assert name in str(error.value)


def test_missing_file(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"can't read .*absent\.stl: No such file"):
        read_mesh(tmp_path / "absent.stl")
