# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a result depends on beside its input and settings: gpswb's own code and its libraries."""

from __future__ import annotations

import functools
import hashlib
import importlib.util
import sys
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import gpswb

DISTRIBUTIONS = ("numpy", "scipy", "numba", "cadquery-ocp", "gmsh", "trimesh", "networkx", "lxml")
"""Packages whose version may change a result."""

SOURCES = (".py", ".css", ".html", ".js")
"""Endings of the files of gpswb that count; each of its versions, released or not, is another."""


@functools.cache
def fingerprint(kernel: str) -> str:
    """A hash of the code, the libraries' versions and, for ``freecad``, of its installation."""
    digest = hashlib.sha256()
    root = Path(gpswb.__file__).parent
    for path in sorted(root.rglob("*")):
        if path.suffix in SOURCES:
            digest.update(path.relative_to(root).as_posix().encode() + b"\0")
            digest.update(hashlib.sha256(path.read_bytes()).digest())
    digest.update(sys.version.encode())
    for name in DISTRIBUTIONS:
        try:
            digest.update(f"{name} {version(name)}\n".encode())
        except PackageNotFoundError:
            digest.update(f"{name} absent\n".encode())
    if kernel == "freecad":
        digest.update(_freecad().encode())
    return digest.hexdigest()


def _freecad() -> str:
    """FreeCAD says its version only once it is loaded; its module for shapes tells as much."""
    spec = importlib.util.find_spec("Part")
    if spec is None or spec.origin is None or not Path(spec.origin).exists():
        return "absent"
    state = Path(spec.origin).stat()
    return f"{spec.origin} {state.st_size} {state.st_mtime_ns}"
