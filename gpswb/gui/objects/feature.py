# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document objects of a partition's regions: class, faces, situation, intrinsic values."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from gpswb.core.mesh import IntArray
from gpswb.core.partition import Region
from gpswb.gui import compat, preferences
from gpswb.gui.aside import aside
from gpswb.gui.objects.situation_shape import situation_shape
from gpswb.gui.objects.stateless import Stateless
from gpswb.io.stored_result import StoredResult
from gpswb.validation.face_result import faces_and_bodies

_PROPERTIES = (
    ("App::PropertyString", "Class", "GPS", "Invariance class"),
    ("App::PropertyString", "Surface", "GPS", "Kind of surface behind the class"),
    ("App::PropertyLinkSubList", "Faces", "GPS", "Faces of the part"),
    ("App::PropertyArea", "Area", "GPS", "Area of the region"),
    ("App::PropertyString", "Undecided", "GPS", "Classes that the mesh can't tell apart"),
    ("App::PropertyInteger", "Region", "GPS", "Number of the region in the result"),
    ("App::PropertyLength", "Residual", "GPS", "RMS distance of the vertices to the surface"),
    ("App::PropertyString", "LogLikelihood", "GPS", "log L of the seven models, best first"),
)
_SITUATION = {
    "point": ("App::PropertyVectorDistance", "Point", "Point of the situation feature"),
    "direction": ("App::PropertyVector", "Direction", "Direction of the situation feature"),
    "normal": ("App::PropertyVector", "Normal", "Normal of the situation feature"),
}
_INTRINSIC = {
    "radius": ("App::PropertyLength", "Radius", "Radius"),
    "major_radius": ("App::PropertyLength", "MajorRadius", "Radius of the centre circle"),
    "minor_radius": ("App::PropertyLength", "MinorRadius", "Radius of the tube"),
    "half_angle_deg": ("App::PropertyAngle", "HalfAngle", "Half angle of the cone"),
    # A left-handed screw has a negative lead, and a PropertyLength can't be negative.
    "lead": ("App::PropertyDistance", "Lead", "Advance a turn, right-handed positive"),
}


class FeatureProxy(Stateless):
    """Behaviour of the document object: none, the partition fills it."""

    Type = "GpsFeature"

    def __init__(self, obj: Any) -> None:
        obj.Proxy = self
        for kind, name, group, text in _PROPERTIES:
            if not hasattr(obj, name):
                obj.addProperty(kind, name, group, text)
                obj.setEditorMode(name, 1)

    def execute(self, obj: Any) -> None:
        """Nothing depends on anything that the partition doesn't know first."""


def is_feature(obj: Any) -> bool:
    """Whether a document object is a feature of ours."""
    return getattr(getattr(obj, "Proxy", None), "Type", "") == FeatureProxy.Type


def features(partition: Any) -> list[Any]:
    """The features of a partition, in the order of its regions."""
    return [obj for obj in partition.Group if is_feature(obj)]


def sync_features(partition: Any, stored: StoredResult) -> Iterator[None]:
    """Make a partition's features those of a result; a slice a feature, iterate to the end."""
    document = partition.Document
    on_region, _ = faces_and_bodies(stored.faces)
    regions = [(i, r) for i, r in enumerate(stored.partition.regions) if r.id in on_region]
    with_faces = bool(stored.document["faces"])
    facets = yield from aside(lambda: _facets_by_region(stored))
    mesh = stored.solid.mesh
    old = features(partition)
    count: Counter[str] = Counter()
    made: list[Any] = []
    for i, (place, region) in enumerate(sorted(regions, key=lambda entry: -entry[1].area)):
        obj = old[i] if i < len(old) else _new(document)
        count[region.surface] += 1
        _fill(obj, region)
        obj.Faces = [(partition.Source, tuple(on_region[region.id]))] if with_faces else []
        used = np.unique(mesh.triangles[facets[place]])
        obj.Shape = situation_shape(region, mesh.vertices[used])
        word = compat.translate("GPS", region.surface).capitalize()
        obj.Label = f"{word} {count[region.surface]}{_size(region)}"
        obj.purgeTouched()
        made.append(obj)
        yield
    others = [obj for obj in partition.Group if not is_feature(obj)]
    partition.Group = [*made, *others]
    for obj in old[len(regions) :]:
        document.removeObject(obj.Name)
        yield


def _size(region: Region) -> str:
    """What tells features of one surface apart in the tree; mm and degrees."""
    found = region.intrinsic
    if region.surface in ("cylinder", "sphere") and "radius" in found:
        return f", Ø{2 * found['radius']:.5g}"
    if region.surface == "torus" and "minor_radius" in found:
        return f", R{found['minor_radius']:.5g}"
    if region.surface == "cone" and "half_angle_deg" in found:
        return f", {2 * found['half_angle_deg']:.5g}°"
    return ""


def _new(document: Any) -> Any:
    obj = document.addObject("Part::FeaturePython", "GpsFeature")
    animate(obj)
    if compat.has_window():
        obj.ViewObject.Visibility = preferences.show_situation()
    return obj


def animate(obj: Any) -> None:
    """Give a document object and its view their behaviour."""
    FeatureProxy(obj)
    if compat.has_window():
        from gpswb.gui.objects.feature_view import FeatureView

        FeatureView(obj.ViewObject)


def _facets_by_region(stored: StoredResult) -> list[IntArray]:
    """Facets of the mesh in each region, by its place among the regions."""
    region = stored.partition.region
    order = np.argsort(region, kind="stable")
    ends = np.searchsorted(region[order], np.arange(len(stored.partition.regions) + 1))
    return np.split(order, ends)[1:-1]


def _fill(obj: Any, region: Region) -> None:
    obj.Class = region.invariance_class
    obj.Surface = region.surface
    obj.Area = region.area
    obj.Undecided = " ".join(region.undecided)
    obj.Region = region.id
    obj.Residual = region.residual
    ranking = sorted(region.log_likelihood.items(), key=lambda item: -item[1])
    obj.LogLikelihood = json.dumps({name: round(value, 3) for name, value in ranking})
    _set_optional(obj, _SITUATION, region.situation)
    _set_optional(obj, _INTRINSIC, region.intrinsic)


def _set_optional(
    obj: Any, table: Mapping[str, tuple[str, str, str]], values: Mapping[str, Any]
) -> None:
    """Set the properties that a region has; remove those that an earlier one had."""
    for key, (kind, name, text) in table.items():
        if key not in values:
            if hasattr(obj, name):
                obj.removeProperty(name)
            continue
        if not hasattr(obj, name):
            obj.addProperty(kind, name, "GPS", text)
            obj.setEditorMode(name, 1)
        value = values[key]
        setattr(obj, name, tuple(value) if isinstance(value, list) else value)
