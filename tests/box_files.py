# SPDX-License-Identifier: LGPL-2.1-or-later
"""STEP texts of boxes, written by hand, and the solids that a kernel would make of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gpswb.cad.solid import Face, FaceMap, FaceTruth, Solid
from gpswb.core.mesh import Mesh
from gpswb.gps.characteristics import RULES
from gpswb.gps.datum_system import Datum
from gpswb.gps.gps_feature import GpsFeature, Size
from gpswb.gps.specified import GeometricalTolerance, SizeTolerance

# Corners of the six sides, counter-clockwise seen from outside; in units of the sizes.
SIDES = (
    ((0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)),
    ((0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)),
    ((0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)),
    ((0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0)),
    ((0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)),
    ((1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)),
)
UNITS = {
    "mm": ("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))", 1.0),
    "m": ("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.))", 1000.0),
    "inch": (
        "(CONVERSION_BASED_UNIT('INCH',#{measure})LENGTH_UNIT()NAMED_UNIT(#{exponents}))",
        25.4,
    ),
}


@dataclass(frozen=True)
class Box:
    """A box in mm, and whether it is a cavity in the box before."""

    origin: tuple[float, float, float]
    size: tuple[float, float, float]
    void: bool = False

    def corners(self, side: int) -> np.ndarray:
        return np.array(self.origin) + np.array(SIDES[side]) * np.array(self.size)


class Text:
    """Entities gathered one by one."""

    def __init__(self, first: int = 10) -> None:
        self.lines: list[str] = []
        self.next = first

    def add(self, body: str) -> str:
        self.next += 1
        self.lines.append(f"#{self.next}={body};")
        return f"#{self.next}"

    def point(self, xyz) -> str:
        return self.add("CARTESIAN_POINT('',({}))".format(",".join(repr(float(v)) for v in xyz)))

    def frame(self, origin=(0, 0, 0), z=(0, 0, 1), x=(1, 0, 0)) -> str:
        where = self.point(origin)
        axes = [
            self.add("DIRECTION('',({}))".format(",".join(repr(float(v)) for v in d)))
            for d in (z, x)
        ]
        return self.add(f"AXIS2_PLACEMENT_3D('',{where},{axes[0]},{axes[1]})")

    def context(self, unit: str) -> str:
        form, _ = UNITS[unit]
        if "{" in form:
            mm = self.add(UNITS["mm"][0])
            measure = self.add(f"LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),{mm})")
            exponents = self.add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)")
            form = form.format(measure=measure[1:], exponents=exponents[1:])
        length = self.add(form)
        angle = self.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
        return self.add(
            "(GEOMETRIC_REPRESENTATION_CONTEXT(3)"
            f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle}))REPRESENTATION_CONTEXT('',''))"
        )

    def shell(self, box: Box, scale: float, order: Sequence[int]) -> str:
        points: dict[tuple, str] = {}
        edges: dict[tuple, tuple[str, bool]] = {}

        def vertex(xyz) -> str:
            key = tuple(np.round(xyz, 9))
            if key not in points:
                points[key] = self.add(f"VERTEX_POINT('',{self.point(np.array(xyz) / scale)})")
            return points[key]

        def edge(a, b) -> str:
            there, back = (vertex(a), vertex(b)), (vertex(b), vertex(a))
            if back in edges:
                return self.add(f"ORIENTED_EDGE('',*,*,{edges[back]},.F.)")
            step = np.array(b) - np.array(a)
            length = float(np.linalg.norm(step))
            way = self.add("DIRECTION('',({}))".format(",".join(repr(v) for v in step / length)))
            vector = self.add(f"VECTOR('',{way},1.)")
            line = self.add(f"LINE('',{self.point(np.array(a) / scale)},{vector})")
            edges[there] = self.add(f"EDGE_CURVE('',{there[0]},{there[1]},{line},.T.)")
            return self.add(f"ORIENTED_EDGE('',*,*,{edges[there]},.T.)")

        faces = []
        for side in order:
            corners = box.corners(side)
            if box.void:
                corners = corners[::-1]
            loop = [edge(corners[i], corners[(i + 1) % 4]) for i in range(4)]
            normal = np.cross(corners[1] - corners[0], corners[3] - corners[0])
            plane = self.add(
                "PLANE('',{})".format(
                    self.frame(
                        corners[0] / scale, normal / np.linalg.norm(normal), corners[1] - corners[0]
                    )
                )
            )
            bound = self.add(f"FACE_OUTER_BOUND('',{self.add(_loop(loop))},.T.)")
            faces.append(self.add(f"ADVANCED_FACE('',({bound}),{plane},.T.)"))
        return self.add(f"CLOSED_SHELL('',({','.join(faces)}))")

    def product(self, name: str = "'part'") -> tuple[str, str]:
        """A product definition and its shape."""
        application = self.add("APPLICATION_CONTEXT('mechanical design')")
        context = self.add(f"PRODUCT_CONTEXT('',{application},'mechanical')")
        product = self.add(f"PRODUCT({name},{name},'',({context}))")
        formation = self.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
        stage = self.add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')")
        definition = self.add(f"PRODUCT_DEFINITION('design','',{formation},{stage})")
        return definition, self.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")

    def whole(self, schema: str = "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }") -> str:
        head = [
            "ISO-10303-21;", "HEADER;", "FILE_DESCRIPTION((''),'2;1');",
            "FILE_NAME('a; FILE_SCHEMA','2024-01-01T00:00:00',(''),(''),'','','');",
            f"FILE_SCHEMA(('{schema}'));", "ENDSEC;", "DATA;",
        ]  # fmt: skip
        return "\n".join([*head, *self.lines, "ENDSEC;", "END-ISO-10303-21;", ""])


def _loop(edges: Sequence[str]) -> str:
    return f"EDGE_LOOP('',({','.join(edges)}))"


def boxes_text(
    boxes: Sequence[Box],
    unit: str = "mm",
    order: Sequence[int] = range(6),
    name: str = "'part'",
) -> str:
    """One product with a solid a box; a void goes with the box before. ``order`` of the faces."""
    text = Text()
    scale = UNITS[unit][1]
    context = text.context(unit)
    solids: list[str] = []
    outer = ""
    for box in boxes:
        shell = text.shell(box, scale, order)
        if box.void:
            solids.pop()
            inner = text.add(f"ORIENTED_CLOSED_SHELL('',*,{shell},.T.)")
            solids.append(text.add(f"BREP_WITH_VOIDS('',{outer},({inner}))"))
        else:
            outer = shell
            solids.append(text.add(f"MANIFOLD_SOLID_BREP('',{shell})"))
    shown = text.add(f"ADVANCED_BREP_SHAPE_REPRESENTATION('',({','.join(solids)}),{context})")
    _, shape = text.product(name)
    text.add(f"SHAPE_DEFINITION_REPRESENTATION({shape},{shown})")
    return text.whole()


def boxes_solid(boxes: Sequence[Box], order: Sequence[int] | None = None) -> Solid:
    """The tessellated boxes; ``order`` permutes the faces of all boxes together."""
    sides = [(box, side) for box in boxes for side in range(6)]
    sides = [sides[i] for i in (range(len(sides)) if order is None else order)]
    vertices, triangles, face_of, faces = [], [], [], []
    for i, (box, side) in enumerate(sides):
        corners = box.corners(side)
        if box.void:
            corners = corners[::-1]
        start = 4 * i
        vertices += corners.tolist()
        triangles += [[start, start + 1, start + 2], [start, start + 2, start + 3]]
        face_of += [i, i]
        faces.append(Face(f"Face{i + 1}", 1.0, 0, FaceTruth("Plane", "planar", "planar", {})))
    # Kernels weld the corners of neighbours.
    points, index = np.unique(np.round(np.array(vertices), 9), axis=0, return_inverse=True)
    mesh = Mesh(points, index.reshape(-1)[np.array(triangles)])
    facemap = FaceMap(np.array(face_of), tuple(faces), np.arange(len(faces)))
    return Solid(mesh, facemap, "boxes.step", "mm", "stl", "by hand", (), "0" * 64, {})


def a_feature(id_: int, name: str, faces: Sequence[str], size: Size | None = None) -> GpsFeature:
    return GpsFeature(
        id_, name, "integral", "planar", "plane", (), {}, {}, size, "neither", "", (),
        tuple(faces), 1.0,
    )  # fmt: skip


def every_pmi(
    names: Sequence[str],
) -> tuple[dict[str, tuple[GpsFeature, ...]], list[GeometricalTolerance | SizeTolerance]]:
    """Datums, every characteristic, sizes with all signs of deviation on six faces of one part."""
    letters = {
        "A": (a_feature(0, "one 'face' \\ ä", names[:1]),),
        "B": (a_feature(1, "<b>two</b>", names[1:3]),),
        "C": (a_feature(2, "three", names[3:6]),),
    }
    a, b, c = (Datum(letter, features) for letter, features in letters.items())
    common = Datum("A-B", (*letters["A"], *letters["B"]))
    orienting = Datum("A", letters["A"], orientation_only=True)
    sections: list[tuple[Datum, ...]] = [(a,), (a, b, c), (common, c), (orienting, b)]
    on = [a_feature(3, "single", names[3:4]), a_feature(4, "double", names[4:6])]
    tolerances: list[GeometricalTolerance | SizeTolerance] = []
    for i, (name, rule) in enumerate(RULES.items()):
        datums = () if rule.group == "form" else sections[i % 4]
        modifiers = ("CZ", "Ⓜ", "Ⓡ") if name == "position" else ("Ⓛ",) if name == "symmetry" else ()
        prefix = {"position": "Ø", "coaxiality": "SØ"}.get(name, "")
        tolerances.append(
            GeometricalTolerance(on[i % 2], name, 0.01 + 0.001 * i, datums, modifiers, prefix)
        )
    size, angle = Size("diameter", 12.7), Size("cone angle", 60.0)
    for i, (lower, upper) in enumerate([(-0.1, 0.02), (0.01, 0.03), (-0.03, -0.01), (0.0, 0.0)]):
        feature = a_feature(5 + i, f"size {i}", names[i : i + 1], size)
        tolerances.append(SizeTolerance(feature, lower, upper))
    tolerances.append(SizeTolerance(a_feature(9, "fit", names[4:5], size), None, None, "H7"))
    tolerances.append(SizeTolerance(a_feature(10, "cone", names[5:6], angle), -0.5, 0.25))
    return letters, tolerances
