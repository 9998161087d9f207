# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stages of `gpswb partition` in mode robust, each as a function of what came before it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from gpswb.batch.one_part import Outcome
from gpswb.cad.density import Density
from gpswb.cad.read import read_solid
from gpswb.cli.partition import write_all
from gpswb.core.curvature import (
    curvedness,
    estimate_curvature,
    facet_tensors,
    principal,
    shape_index,
)
from gpswb.core.growing import grow_regions
from gpswb.core.initial import initial_partition
from gpswb.core.likelihood import log_likelihoods
from gpswb.core.mesh import Mesh
from gpswb.core.normals import wedge_normals
from gpswb.core.partition import Partition
from gpswb.core.pipeline import Mode, partition
from gpswb.core.projection import number_facet_regions
from gpswb.core.recognition import recognise, weigh
from gpswb.core.region_samples import confined_normals, region_samples
from gpswb.core.robust.leftover import label_leftover
from gpswb.core.robust.pipeline import TIERS, simple_surfaces
from gpswb.core.robust.polygons import certain_planes, coplanar_polygons
from gpswb.core.robust.topology import FacetGraph
from gpswb.core.shape_types import plane_by_sagitta, shape_types
from gpswb.core.sharp_edges import feature_edges
from gpswb.core.stages import StageClock
from gpswb.core.tolerances import Tolerances
from gpswb.core.voting import vote
from gpswb.core.wedges import find_wedges
from gpswb.validation.validate import validate

TOLERANCES = Tolerances()


class Run:
    """One part at one density; what a stage needs is computed when it is first asked for.

    Args:
        part: the STEP file.
        vertices: number of vertices asked for.
        out: directory to write results in.
    """

    def __init__(self, part: Path, vertices: int, out: Path) -> None:
        self.part, self.vertices, self.out = part, vertices, out
        self._known: dict[str, Any] = {}

    def __getitem__(self, stage: str) -> Any:
        if stage not in self._known:
            self._known[stage] = (STAGES.get(stage) or INPUTS[stage])(self)
        return self._known[stage]

    def keep(self, stage: str, result: Any) -> None:
        """Let the following stages use what a benchmark computed."""
        self._known.setdefault(stage, result)

    @property
    def mesh(self) -> Mesh:
        """The mesh."""
        mesh: Mesh = self["tessellation"].mesh
        return mesh


def tessellation(run: Run) -> Any:
    return read_solid(run.part, Density("vertices", run.vertices))


def normals_and_curvature(run: Run) -> Any:
    mesh = Mesh(run.mesh.vertices, run.mesh.triangles)  # nothing computed yet
    crease = feature_edges(mesh, TOLERANCES)
    wedges = find_wedges(mesh, crease)
    return crease, wedges, estimate_curvature(mesh, wedges, wedge_normals(mesh, wedges))


def types_voting_growing(run: Run) -> Any:
    mesh, (crease, wedges, curvature) = run.mesh, run["normals, curvature"]
    k_max, k_min, _ = principal(
        facet_tensors(mesh, curvature.normals[wedges.of_corner]), mesh.facet_normals
    )
    edges = np.linalg.norm(np.roll(mesh.corners, -1, axis=1) - mesh.corners, axis=2)
    limit = TOLERANCES.sagitta * mesh.diagonal
    plane = plane_by_sagitta(curvedness(k_max, k_min), edges.max(axis=1), limit)
    smooth = mesh.facet_pairs[~crease]
    types, _ = vote(shape_types(shape_index(k_max, k_min), plane), smooth)
    return grow_regions(types, smooth)


def initial(run: Run) -> Any:
    return initial_partition(run.mesh, 0.0, TOLERANCES, StageClock())


def polygons(run: Run) -> Any:
    fine = TIERS[0] * run.mesh.diagonal
    graph = FacetGraph.of(run.mesh)
    return graph, coplanar_polygons(run.mesh, graph, fine)


def consensus(run: Run) -> Any:
    graph, polygon = run["polygons"]
    certain = certain_planes(run.mesh, graph, polygon, TIERS[0] * run.mesh.diagonal)
    return simple_surfaces(run.mesh, graph, polygon, certain, run["initial"].region, StageClock())


def leftover(run: Run) -> Any:
    graph, polygon = run["polygons"]
    label = np.full(len(run.mesh.triangles), -1, dtype=np.int64)
    for number, grown in enumerate(run["consensus"]):
        label[grown.facets] = number
    return label_leftover(run.mesh, graph, run["initial"], polygon, label, 0.0, TOLERANCES)[0]


def samples(run: Run) -> Any:
    region, count = number_facet_regions(run["leftover merging"], run.mesh)
    normals = confined_normals(run.mesh, region, run["initial"].crease)
    return region, list(region_samples(run.mesh, region, count, normals))


def weighed(run: Run) -> Any:
    return [(s, weigh(s, 0.0, TOLERANCES)) for s in run["samples"][1]]


def recognition(run: Run) -> Any:
    first, (region, found) = run["initial"], samples(run)
    return Partition(
        mesh=run.mesh,
        shape_type=first.facet_type,
        initial_region=first.region,
        region=region,
        regions=tuple(recognise(i, s, 1, 0.0, TOLERANCES) for i, s in enumerate(found)),
        vertex_shape_type=first.vertex_type,
        shape_index=first.shape_index,
        curvedness=first.curvedness,
        initial_region_count=first.count,
        sharp_edge_regions=first.sharp_edge_regions,
        sigma=0.0,
        mode="robust",
        method="hybrid",
    )


def likelihood(run: Run) -> Any:
    return [
        log_likelihoods(s.vertices, evidence.references, evidence.distance["planar"])
        for s, evidence in run["weighed"]
    ]


def validation(run: Run) -> Any:
    return validate(run["recognition"], run["tessellation"].facemap)


def writing(run: Run) -> Any:
    outcome = Outcome(run["tessellation"], run["recognition"], run["validation"])
    return write_all(run.out, outcome, report=True)


def whole(run: Run, mode: Mode) -> Any:
    mesh = Mesh(run.mesh.vertices, run.mesh.triangles)  # nothing computed yet
    return partition(mesh, mode=mode)


INPUTS: dict[str, Callable[[Run], Any]] = {
    "initial": initial, "samples": samples, "weighed": weighed,
}  # fmt: skip
"""What stages need that no row of the table measures by itself."""

STAGES: dict[str, Callable[[Run], Any]] = {
    "tessellation": tessellation,
    "normals, curvature": normals_and_curvature,
    "shape types, voting, growing": types_voting_growing,
    "polygons": polygons,
    "consensus": consensus,
    "leftover merging": leftover,
    "recognition": recognition,
    "likelihood": likelihood,
    "validation": validation,
    "writing": writing,
}

MODES: tuple[Mode, ...] = ("paper", "corrected", "robust")
"""Modes of which the whole partition is timed, from the mesh to its recognised regions."""

NEEDS: dict[str, tuple[str, ...]] = {
    "tessellation": (),
    "normals, curvature": ("tessellation",),
    "shape types, voting, growing": ("normals, curvature",),
    "polygons": ("tessellation",),
    "consensus": ("polygons", "initial"),
    "leftover merging": ("polygons", "initial", "consensus"),
    "recognition": ("initial", "leftover merging"),
    "likelihood": ("weighed",),
    "validation": ("tessellation", "recognition"),
    "writing": ("validation",),
}
"""What has to be there before a stage is timed."""
