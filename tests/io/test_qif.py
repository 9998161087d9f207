# SPDX-License-Identifier: LGPL-2.1-or-later
"""QIF 3.0 documents: order of elements, counts, references and values (ISO 23952)."""

from __future__ import annotations

from xml.etree import ElementTree as ET

import numpy as np
import pytest
from gps_parts import Part, X, Y, Z, flange, negative, plate, shaft

from gpswb.gps.annotation import annotate
from gpswb.gps.feature_table import feature_table
from gpswb.io.qif import NAMESPACE, write_qif

EVIL = "<b>&'\"\x07ä⌀\\.step"
_NOMINAL = ("Attributes", "Name", "UUID", "FeatureDefinitionId")
ORDER = {
    # Sequences of the schema as far as they are used; each element may be left out.
    "QIFDocument": ("QPId", "Attributes", "Header", "FileUnits", "DatumDefinitions",
                    "DatumReferenceFrames", "Features"),
    "Features": ("FeatureDefinitions", "FeatureNominals"),
    "DatumDefinition": ("DatumLabel", "DatumTargetIds", "FeatureNominalIds"),
    "DatumReferenceFrame": ("Datums", "Name"),
    "Datum": ("SimpleDatum", "Precedence"),
    "SimpleDatum": ("DatumDefinitionId", "MaterialModifier", "ReferencedComponent"),
    "CylinderFeatureDefinition": ("InternalExternal", "Diameter"),
    "SphereFeatureDefinition": ("InternalExternal", "Diameter"),
    "TorusFeatureDefinition": ("InternalExternal", "MinorDiameter", "MajorDiameter"),
    "ConeFeatureDefinition": ("InternalExternal", "Diameter", "HalfAngle", "LargeEndDistance",
                              "SmallEndDistance"),
    "OppositeParallelPlanesFeatureDefinition": ("InternalExternal", "Width", "EndType"),
    "SurfaceOfRevolutionFeatureDefinition": ("InternalExternal",),
    "GroupFeatureDefinition": ("IsCounterboredHole", "IsCountersunkHole"),
    "PlaneFeatureDefinition": (),
    "OtherSurfaceFeatureDefinition": (),
    "PlaneFeatureNominal": (*_NOMINAL, "Location", "Normal"),
    "CylinderFeatureNominal": (*_NOMINAL, "Axis"),
    "ConeFeatureNominal": (*_NOMINAL, "Axis"),
    "SphereFeatureNominal": (*_NOMINAL, "Location"),
    "TorusFeatureNominal": (*_NOMINAL, "Location", "AxisVector"),
    "SurfaceOfRevolutionFeatureNominal": (*_NOMINAL, "Axis"),
    "OppositeParallelPlanesFeatureNominal": (*_NOMINAL, "CenterPlane"),
    "GroupFeatureNominal": (*_NOMINAL, "FeatureNominalIds"),
    "OtherSurfaceFeatureNominal": _NOMINAL,
    "Axis": ("AxisPoint", "Direction"),
    "CenterPlane": ("Point", "Normal"),
}  # fmt: skip


def sunk(part):
    """Holes with a counterbore and a countersink, a ball, a ring, a thread, a swept face."""
    plate(part)
    part.cylinder((200.0, 0.0, 0.0), Z, 4.0, 30.0, hole=True)
    part.cylinder((200.0, 0.0, 30.0), Z, 8.0, 10.0, hole=True)
    part.cylinder((240.0, 0.0, 0.0), Z, 5.0, 30.0, hole=True)
    part.cone((240.0, 0.0, 30.0), Z, 5.0, 15.0, 10.0, hole=True)
    part.sphere((0.0, 300.0, 0.0), 8.0)
    part.thread((0.0, 200.0, 0.0), X, 5.0, 20.0, 1.5)
    turn = np.linspace(0.0, 2 * np.pi, 25)
    u, v = np.meshgrid(turn, turn, indexing="ij")
    out = np.stack([np.cos(u) * np.cos(v), np.sin(u) * np.cos(v), np.sin(v)], axis=-1)
    ring = np.stack([np.cos(u), np.sin(u), 0 * u], axis=-1)
    grid = np.array([0.0, 0.0, 200.0]) + 30.0 * ring + 6.0 * out
    sizes = {"major_radius": 30.0, "minor_radius": 6.0}
    part.add("torus", grid, out, {"point": (0.0, 0.0, 200.0), "direction": Z}, sizes)
    t = np.linspace(0, 1, 4)
    flat = np.stack([*np.meshgrid(t, t, indexing="ij"), np.zeros((4, 4))], axis=-1)
    part.add("extrusion", 10 * flat - 50, np.broadcast_to(Z, flat.shape), {"direction": Y})
    part.plane((-60.0, 0.0, 0.0), X, Y, 20.0, 20.0)
    part.plane((-40.0, 0.0, 0.0), negative(X), Y, 20.0, 20.0)


@pytest.fixture(scope="module", params=[plate, flange, shaft, sunk])
def written(request, tmp_path_factory):
    part = Part()
    request.param(part)
    table = feature_table(part.partition(), {r.id: [f"Face{r.id + 1}"] for r in part.regions})
    annotation = annotate(table)
    path = tmp_path_factory.mktemp("qif") / "part.qif"
    write_qif(path, annotation, EVIL)
    return annotation, ET.parse(path).getroot()


def tag(element):
    assert element.tag.startswith(f"{{{NAMESPACE}}}")
    return element.tag.partition("}")[2]


def ids(root, parent):
    found = root.find(f".//{{{NAMESPACE}}}{parent}")
    return {} if found is None else {each.get("id"): each for each in found}


def test_elements_stand_in_the_order_of_the_schema(written):
    _, root = written
    assert tag(root) == "QIFDocument"
    assert root.get("versionQIF") == "3.0.0"
    for element in root.iter():
        if "Feature" in tag(element) and element.get("id") is not None:
            assert tag(element) in ORDER
        order = ORDER.get(tag(element))
        if order is None:
            continue
        places = [order.index(tag(child)) for child in element]
        assert places == sorted(set(places)), tag(element)


def test_lists_are_counted_and_ids_are_unique(written):
    _, root = written
    found = [int(e.get("id")) for e in root.iter() if e.get("id") is not None]
    assert sorted(found) == list(range(1, len(found) + 1))
    assert root.get("idMax") == str(len(found))
    for element in root.iter():
        if element.get("n") is not None:
            assert int(element.get("n")) == len(element) > 0, tag(element)


def test_references_lead_where_they_should(written):
    annotation, root = written
    definitions, nominals = ids(root, "FeatureDefinitions"), ids(root, "FeatureNominals")
    datums = ids(root, "DatumDefinitions")
    assert len(nominals) == len(annotation.table.features)
    for element in root.iter():
        name, text = tag(element), element.text
        if name == "FeatureDefinitionId":
            assert text in definitions
        if name == "DatumDefinitionId":
            assert text in datums
        if name == "FeatureNominalIds":
            assert {each.text for each in element} <= set(nominals)
    for nominal in nominals.values():
        reference = nominal.find(f"{{{NAMESPACE}}}FeatureDefinitionId").text
        kind = tag(definitions[reference]).removesuffix("FeatureDefinition")
        assert tag(nominal) == f"{kind}FeatureNominal"


def test_values_are_those_of_the_features(written):
    annotation, root = written
    definitions, nominals = ids(root, "FeatureDefinitions"), ids(root, "FeatureNominals")
    by_name = {n.find(f"{{{NAMESPACE}}}Name").text: n for n in nominals.values()}
    for feature in annotation.table.features:
        nominal = by_name[feature.name]
        own = definitions[nominal.find(f"{{{NAMESPACE}}}FeatureDefinitionId").text]
        said = {tag(child): child.text for child in own}
        if "InternalExternal" in said:
            assert said["InternalExternal"] == feature.material.upper()
        if feature.surface in ("cylinder", "sphere"):
            assert float(said["Diameter"]) == pytest.approx(2 * feature.intrinsic["radius"])
        if feature.kind in ("slot", "rib"):
            assert float(said["Width"]) == pytest.approx(feature.size.value)
        if feature.surface == "cone":
            # The diameter stands at the small end; with the angle it gives the large one.
            tangent = np.tan(np.radians(float(said["HalfAngle"])))
            ends = [float(said["Diameter"]) / 2 + tangent * float(said[f"{e}EndDistance"])
                    for e in ("Small", "Large")]  # fmt: skip
            axis = np.array(feature.place.direction)
            arm = feature.points - feature.place.point
            rho = np.linalg.norm(arm - np.outer(arm @ axis, axis), axis=1)
            assert ends == pytest.approx([rho.min(), rho.max()])
        for child in nominal.iter():
            if tag(child) in ("Direction", "Normal", "AxisVector"):
                assert np.linalg.norm([float(x) for x in child.text.split()]) == pytest.approx(1.0)


def test_every_kind_of_feature_is_written():
    part = Part()
    sunk(part)
    table = feature_table(part.partition())
    assert {f.kind for f in table.compounds} >= {"slot", "counterbore", "countersink"}
    assert {f.surface for f in table.integral} >= {"torus", "sphere", "helicoid", "extrusion"}
