# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part made, read, partitioned and validated with FreeCAD's own kernel."""

from __future__ import annotations

import tempfile
import unittest
from pathlib import Path

import FreeCAD
import Part

from gpswb.cad.density import Density
from gpswb.cad.read import read_solid
from gpswb.core.pipeline import partition
from gpswb.errors import InputError
from gpswb.validation.validate import validate


class PartCase(unittest.TestCase):
    """A block with a hole and a spherical dome, by way of a STEP file."""

    def setUp(self) -> None:
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = Path(directory.name)

    def test_every_face_gets_its_class(self) -> None:
        hole = Part.makeCylinder(6.0, 20.0, FreeCAD.Vector(12.0, 15.0, 0.0))
        dome = Part.makeSphere(8.0, FreeCAD.Vector(32.0, 15.0, 20.0))
        block = Part.makeBox(44.0, 30.0, 20.0).cut(hole).fuse(dome)
        path = self.directory / "part.step"
        block.exportStep(str(path))
        expected = {"Plane": "planar", "Cylinder": "cylindrical", "Sphere": "spherical"}

        solid = read_solid(path, Density.parse("medium"), kernel="freecad")
        assert solid.facemap is not None
        result = validate(partition(solid.mesh), solid.facemap)

        self.assertEqual(len(result.faces), len(block.Faces))
        for face, made in zip(result.faces, block.Faces, strict=True):
            with self.subTest(face=face.name):
                self.assertEqual(face.invariance_class, expected[type(made.Surface).__name__])
                self.assertEqual(face.true_class, face.invariance_class)

    def test_a_file_that_is_no_part(self) -> None:
        path = self.directory / "part.step"
        path.write_text("not a part")
        with self.assertRaises(InputError):
            read_solid(path, Density.parse("coarse"), kernel="freecad")
