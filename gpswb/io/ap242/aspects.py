# SPDX-License-Identifier: LGPL-2.1-or-later
"""From shape aspects to the faces that they mean (ISO 10303-47, recommended practices for PMI)."""

from __future__ import annotations

from collections.abc import Mapping

from gpswb.io.ap242.part21 import Part21, Ref, Value, references

_USAGES = ("GEOMETRIC_ITEM_SPECIFIC_USAGE", "ITEM_IDENTIFIED_REPRESENTATION_USAGE")
_RELATIONS = ("SHAPE_ASPECT_RELATIONSHIP", "SHAPE_ASPECT_DERIVING_RELATIONSHIP")
_WHOLE = (
    "COMPOSITE_SHAPE_ASPECT", "COMPOSITE_GROUP_SHAPE_ASPECT", "ALL_AROUND_SHAPE_ASPECT",
    "COMPOSITE_UNIT_SHAPE_ASPECT", "CONTINUOUS_SHAPE_ASPECT", "BETWEEN_SHAPE_ASPECT",
    "CENTRE_OF_SYMMETRY", "DERIVED_SHAPE_ASPECT", "COMMON_DATUM", "SYMMETRIC_SHAPE_ASPECT",
    "DATUM_FEATURE",
)  # fmt: skip
"""Aspects that are made of others."""
_DIMENSIONS = ("DIMENSIONAL_SIZE", "ANGULAR_SIZE", "DIMENSIONAL_SIZE_WITH_PATH")


class Aspects:
    """Shape aspects of a file.

    Args:
        faces: names of the B-rep faces of each face entity.
    """

    def __init__(self, file: Part21, faces: Mapping[int, tuple[str, ...]]) -> None:
        self.file = file
        self._faces = faces
        self._items: dict[Value, list[Value]] = {}
        for number in file.of(*_USAGES):
            for keyword in _USAGES:
                usage = file[number].get(keyword, ())
                if len(usage) > 4:
                    self._items.setdefault(usage[2], []).append(usage[4])
        self._related: dict[Value, list[Ref]] = {}
        self._relating: dict[Value, list[Ref]] = {}
        for number in file.of(*_RELATIONS, "FEATURE_FOR_DATUM_TARGET_RELATIONSHIP"):
            for parameters in file[number].values():
                pair = [value for value in parameters[2:4] if isinstance(value, Ref)]
                if len(pair) == 2:
                    self._related.setdefault(pair[0], []).append(pair[1])
                    self._relating.setdefault(pair[1], []).append(pair[0])

    def around(self, number: int) -> tuple[Ref, ...]:
        """Aspects related to one, in either direction."""
        key = Ref(number)
        return tuple(self._relating.get(key, [])) + tuple(self._related.get(key, []))

    def faces(self, aspect: Value) -> set[str]:
        """Names of the faces that an aspect, a dimension or a whole of aspects is made of."""
        found: set[str] = set()
        seen: set[Ref] = set()
        waiting = [aspect]
        while waiting:
            each = waiting.pop()
            if not isinstance(each, Ref) or each in seen or each not in self.file:
                continue
            seen.add(each)
            keywords = self.file.keywords(each)
            waiting += [self.file[each][k][0] for k in _DIMENSIONS if k in keywords]
            for item in self._items.get(each, []):
                for reference in self._members(item):
                    found.update(self._faces.get(reference, ()))
            if any(keyword in _WHOLE for keyword in keywords):
                waiting += [a for a in self._related.get(each, []) if not self._is_datum(a)]
        return found

    def _is_datum(self, aspect: Ref) -> bool:
        return aspect in self.file and "DATUM" in self.file.keywords(aspect)

    def _members(self, item: Value) -> list[Ref]:
        """The items themselves: a reference, or a set of them."""
        if isinstance(item, Ref):
            kept = self.file.get(item, "SET_REPRESENTATION_ITEM")
            if kept is None:
                kept = self.file.get(item, "COMPOUND_REPRESENTATION_ITEM")
            return [item] if kept is None else list(references(kept))
        return list(references((item,)))
