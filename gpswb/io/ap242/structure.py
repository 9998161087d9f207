# SPDX-License-Identifier: LGPL-2.1-or-later
"""From products to faces: representations, their units and their places in the assembly."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from gpswb.core.mesh import FloatArray
from gpswb.io.ap242.part21 import Part21, Ref, Value
from gpswb.io.ap242.placement import placement
from gpswb.io.ap242.units import Units, units_of

_HOLDS_SHELLS = {
    "MANIFOLD_SOLID_BREP": (1,), "BREP_WITH_VOIDS": (1, 2), "FACETED_BREP": (1,),
    "SHELL_BASED_SURFACE_MODEL": (1,), "FACE_BASED_SURFACE_MODEL": (1,),
    "ORIENTED_CLOSED_SHELL": (2,), "ORIENTED_OPEN_SHELL": (2,),
    "CLOSED_SHELL": (1,), "OPEN_SHELL": (1,), "CONNECTED_FACE_SET": (1,),
    "CONNECTED_FACE_SUB_SET": (1,),
}  # fmt: skip
_MOST_PLACES = 20_000
_DEEPEST = 40


@dataclass(frozen=True, eq=False)
class ShapeOfProduct:
    """A representation that holds geometry.

    Args:
        representation: its entity. ``context``: its context's.
        definition: the PRODUCT_DEFINITION_SHAPE that aspects of this shape refer to; None if no
            product has this shape.
        units: of the context.
        faces: entities of its faces.
        places: (4, 4) transforms into the whole shape, mm; one an occurrence.
    """

    representation: Ref
    context: Value
    definition: Ref | None
    units: Units
    faces: tuple[Ref, ...]
    places: tuple[FloatArray, ...]


def shapes_of(file: Part21) -> tuple[ShapeOfProduct, ...]:
    """All representations that hold faces, with their places."""
    definitions = _definitions(file)
    same = _same_shape(file)
    places = _places(_occurrences(file, definitions, same))
    shapes: list[ShapeOfProduct] = []
    # Representations that no product has repeat shapes, for colours or validation: they come last.
    numbers = sorted(_representations(file), key=lambda n: not _shown(n, definitions, same))
    seen: set[Ref] = set()
    for number in numbers:
        _, items, context = _representation(file, number)
        faces = tuple(dict.fromkeys(face for item in items for face in _faces(file, item)))
        if not _shown(number, definitions, same):
            faces = tuple(face for face in faces if face not in seen)
        if not faces:
            continue
        seen.update(faces)
        group = [number, *sorted(same.get(number, ()))]
        first = min(group)
        definition = next((definitions[n] for n in group if n in definitions), None)
        shapes.append(
            ShapeOfProduct(
                Ref(number),
                context,
                definition,
                units_of(file, context),
                faces,
                tuple(places.get(first, (np.eye(4),))),
            )
        )
    return tuple(shapes)


def _shown(number: int, definitions: dict[int, Ref], same: dict[int, set[int]]) -> bool:
    return any(n in definitions for n in (number, *same.get(number, ())))


def _representations(file: Part21) -> Iterator[int]:
    """Representations of shape: all that have a name, a list of items and a context."""
    seen = set()
    for keyword in file.all_keywords():
        if not keyword.endswith("REPRESENTATION"):
            continue
        for number in file.of(keyword):
            if number not in seen and _representation(file, number)[1]:
                seen.add(number)
                yield number


def _representation(file: Part21, number: int) -> tuple[str, tuple[Value, ...], Value]:
    for keyword, parameters in file[number].items():
        if keyword.endswith("REPRESENTATION") and len(parameters) >= 3:
            name, items, context = parameters[:3]
            if isinstance(items, tuple) and isinstance(context, Ref):
                return str(name), items, context
    return "", (), None


def _faces(file: Part21, item: Value, deep: int = 8) -> Iterator[Ref]:
    """Faces of a solid, shell or surface model."""
    if isinstance(item, tuple):
        for each in item:
            yield from _faces(file, each, deep)
        return
    if not isinstance(item, Ref) or item not in file or deep == 0:
        return
    for keyword in file.keywords(item):
        if keyword in ("ADVANCED_FACE", "FACE_SURFACE"):
            yield item
        elif keyword == "ORIENTED_FACE":
            yield from _faces(file, file[item][keyword][2], deep - 1)
        elif keyword in _HOLDS_SHELLS:
            parameters = file[item][keyword]
            for i in _HOLDS_SHELLS[keyword]:
                if i < len(parameters):
                    yield from _faces(file, parameters[i], deep - 1)


def _definitions(file: Part21) -> dict[int, Ref]:
    """PRODUCT_DEFINITION_SHAPE by the representation that shows it."""
    found: dict[int, Ref] = {}
    for number in file.of("SHAPE_DEFINITION_REPRESENTATION"):
        shape, representation = file[number]["SHAPE_DEFINITION_REPRESENTATION"][:2]
        if isinstance(representation, Ref) and isinstance(shape, Ref):
            product = file.get(shape, "PRODUCT_DEFINITION_SHAPE")
            if (
                product is not None
                and file.get(product[-1], "NEXT_ASSEMBLY_USAGE_OCCURRENCE") is None
            ):
                found.setdefault(representation, shape)
    return found


def _same_shape(file: Part21) -> dict[int, set[int]]:
    """Representations of one shape: related without a transformation."""
    same: dict[int, set[int]] = {}
    for number in file.of("SHAPE_REPRESENTATION_RELATIONSHIP"):
        record = file[number]
        if "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION" in record:
            continue
        pair = [v for v in record["SHAPE_REPRESENTATION_RELATIONSHIP"] if isinstance(v, Ref)]
        if len(pair) == 2:
            group = same.get(pair[0], {pair[0]}) | same.get(pair[1], {pair[1]})
            for member in group:
                same[member] = group
    return same


@dataclass(frozen=True, eq=False)
class _Occurrence:
    """A shape placed in another; shapes stand for all that are related without a transformation."""

    child: int
    parent: int
    place: FloatArray


def _occurrences(
    file: Part21, definitions: dict[int, Ref], same: dict[int, set[int]]
) -> list[_Occurrence]:
    found = []
    of_product: dict[Value, set[int]] = {}
    for representation, shape in definitions.items():
        product = file[shape]["PRODUCT_DEFINITION_SHAPE"][-1]
        of_product.setdefault(product, set()).update(same.get(representation, {representation}))
    for number in file.of("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION"):
        relation, placed = file[number]["CONTEXT_DEPENDENT_SHAPE_REPRESENTATION"][:2]
        occurrence = _related(file, relation)
        if occurrence is None:
            continue
        one, other = occurrence[0], occurrence[1]
        first, second = occurrence[2], occurrence[3]
        definition = file.get(placed, "PRODUCT_DEFINITION_SHAPE")
        usage = file.get(definition[-1], "NEXT_ASSEMBLY_USAGE_OCCURRENCE") if definition else None
        # Systems disagree on which of the two is the component: the product structure decides.
        swapped = (
            usage is not None
            and len(usage) > 4
            and one in of_product.get(usage[3], ())
            and other in of_product.get(usage[4], ())
        )
        if swapped:
            one, other = other, one
        own, whole = _representation(file, one)[1], _representation(file, other)[1]
        as_listed = (first in own) + (second in whole)
        crosswise = (second in own) + (first in whole)
        if crosswise > as_listed or (crosswise == as_listed and swapped):
            first, second = second, first
        transform = _frame(file, second, other) @ np.linalg.inv(_frame(file, first, one))
        found.append(_Occurrence(one, other, transform))
    for number in [n for n in _representations(file) if _shown(n, definitions, same)]:
        for item in _representation(file, number)[1]:
            mapped = file.get(item, "MAPPED_ITEM")
            source = file.get(mapped[1], "REPRESENTATION_MAP") if mapped else None
            if mapped and source and isinstance(source[1], Ref):
                origin = _frame(file, source[0], source[1])
                transform = _frame(file, mapped[2], number) @ np.linalg.inv(origin)
                found.append(_Occurrence(source[1], number, transform))
    return [
        _Occurrence(min(same.get(o.child, {o.child})), min(same.get(o.parent, {o.parent})), o.place)
        for o in found
    ]


def _related(file: Part21, relation: Value) -> tuple[Ref, Ref, Value, Value] | None:
    """Two representations and the frames, one in each, that are to coincide."""
    pair = file.get(relation, "REPRESENTATION_RELATIONSHIP")
    how = file.get(relation, "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION")
    if pair is None or how is None or len(pair) < 4:
        return None
    one, other = pair[2], pair[3]
    frames = file.get(how[0], "ITEM_DEFINED_TRANSFORMATION")
    if frames is None or not isinstance(one, Ref) or not isinstance(other, Ref):
        return None
    return one, other, frames[2], frames[3]


def _frame(file: Part21, axes: Value, representation: int) -> FloatArray:
    mm = units_of(file, _representation(file, representation)[2]).mm
    return placement(file, axes, mm)


def _places(occurrences: list[_Occurrence]) -> dict[int, list[FloatArray]]:
    """Transforms of each representation into the representations that are nobody's child."""
    parents: dict[int, list[_Occurrence]] = {}
    for each in occurrences:
        parents.setdefault(each.child, []).append(each)
    known: dict[int, list[FloatArray]] = {}

    def places(number: int, deep: int) -> list[FloatArray]:
        if number not in parents or deep == 0:
            return [np.eye(4)]
        if number not in known:
            found = [
                upper @ each.place
                for each in parents[number]
                for upper in places(each.parent, deep - 1)
            ]
            known[number] = found[:_MOST_PLACES]
        return known[number]

    return {number: places(number, _DEEPEST) for number in list(parents)}
