# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shapes of a FreeCAD document, read from its archive without opening the document.

Opening a document in FreeCAD restores the Python objects in it; a file is untrusted, so only its
XML and its BREP members are read.
"""

from __future__ import annotations

import zipfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.errors import InputError

_MOST_BYTES = 2_000_000_000
_MOST_XML = 200_000_000
_DEEPEST = 32


@dataclass(frozen=True, eq=False)
class StoredShape:
    """One final shape of a document: its BREP text and the (4, 4) placement of its containers."""

    brep: bytes
    placement: FloatArray


def stored_shapes(path: Path) -> list[StoredShape]:
    """The shapes that no other shape of the document is made from, in the document's order.

    Raises:
        InputError: the archive is broken, too large, or holds no BREP shape.
    """
    with open_document(path) as (archive, root):
        shapes = [
            StoredShape(read_member(archive, name), placement) for name, placement in _final(root)
        ]
    if not shapes:
        raise InputError(f"{path}: the document holds no shape")
    return shapes


def holds_shape(path: Path) -> bool:
    """Is there a BREP shape in the document?

    Raises:
        InputError: the archive is broken.
    """
    with open_document(path) as (_, root):
        return any(_shape_file(item) for item in stored_objects(root).values())


@contextmanager
def open_document(path: Path) -> Iterator[tuple[zipfile.ZipFile, ET.Element]]:
    """The archive of a document and the root of its XML; what goes wrong is an `InputError`."""
    try:
        with zipfile.ZipFile(path) as archive:
            text = read_member(archive, "Document.xml", _MOST_XML)
            if b"<!DOCTYPE" in text:
                raise ValueError("Document.xml declares entities")
            yield archive, ET.fromstring(text)  # noqa: S314 - bounded, and without entities
    except (zipfile.BadZipFile, ET.ParseError, KeyError, OSError, ValueError) as error:
        raise InputError(f"{path}: not a FreeCAD document that can be read ({error})") from None


def read_member(archive: zipfile.ZipFile, name: str, most: int = _MOST_BYTES) -> bytes:
    """A member's bytes.

    Raises:
        KeyError: there is none of this name.
        ValueError: it is larger than ``most`` bytes.
    """
    if archive.getinfo(name).file_size > most:
        raise ValueError(f"{name} is larger than {most} bytes")
    return archive.read(name)


def stored_objects(root: ET.Element) -> dict[str, ET.Element]:
    """The stored properties of each object, by its name."""
    return {o.get("name", ""): o for o in root.findall("./ObjectData/Object")}


def _final(root: ET.Element) -> Iterator[tuple[str, FloatArray]]:
    data = stored_objects(root)
    files = {name: file for name, item in data.items() if (file := _shape_file(item))}
    used = {
        dep.get("Name", "")
        for deps in root.findall("./Objects/ObjectDeps")
        if deps.get("Name") in files
        for dep in deps.findall("Dep")
    }
    parent = containers({name: item for name, item in data.items() if name not in files})
    for name, file in files.items():
        if name not in used:
            yield file, placement_above(name, parent, data)


def containers(data: Mapping[str, ET.Element]) -> dict[str, str]:
    """The container of each object that is in one."""
    return {
        link.get("value", ""): name
        for name, item in data.items()
        for link in item.findall("./Properties/Property[@name='Group']/LinkList/Link")
    }


def placement_above(
    name: str, parent: Mapping[str, str], data: Mapping[str, ET.Element]
) -> FloatArray:
    """(4, 4) placement of an object's containers together."""
    placement = np.eye(4)
    above = parent.get(name)
    for _ in range(_DEEPEST):
        if above is None:
            break
        placement = own_placement(data[above]) @ placement
        above = parent.get(above)
    return placement


def _shape_file(item: ET.Element) -> str | None:
    part = item.find("./Properties/Property[@name='Shape']/Part")
    file = None if part is None else part.get("file")
    return file if file and file.lower().endswith((".brp", ".brep")) else None


def own_placement(item: ET.Element) -> FloatArray:
    """(4, 4) placement stored with an object; the identity where there is none."""
    stored = item.find("./Properties/Property[@name='Placement']/PropertyPlacement")
    matrix = np.eye(4)
    if stored is None:
        return matrix
    x, y, z, w = (float(stored.get(k, "0")) for k in ("Q0", "Q1", "Q2", "Q3"))
    matrix[:3, 3] = [float(stored.get(k, "0")) for k in ("Px", "Py", "Pz")]
    matrix[:3, :3] = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    return matrix
