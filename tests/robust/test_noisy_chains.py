# SPDX-License-Identifier: LGPL-2.1-or-later
"""Under noise, a turned or extruded chain of tangent faces is divided by its profile: straights and
arcs where it was drawn so, one spline where it wasn't."""

from __future__ import annotations

import numpy as np
import pytest
from analytic_meshes import TURN, sheet

from gpswb.core.invariance import InvarianceClass
from gpswb.core.mesh import FloatArray, Mesh
from gpswb.core.noisy.general_surface import priced
from gpswb.core.noisy.merging import REGION
from gpswb.core.noisy.noisy_mesh import NoisyMesh
from gpswb.core.noisy.profile_chain import Chain, profile_chain
from gpswb.core.noisy.swept import Swept
from gpswb.core.noisy.swept_fit import fit_swept
from gpswb.core.pipeline import partition
from gpswb.core.reference import Reference

SIGMA = 0.05
ROUND = 0.4
"""Radius of the round, mm: eight sigma."""


def profile(s: FloatArray) -> FloatArray:
    """(n, 2) radius and height at lengths s: a flat, a round from 0 on, a straight wall."""
    arc = 0.25 * TURN * ROUND
    t = np.clip(s, 0.0, arc) / ROUND
    rho = 10.0 - ROUND + np.minimum(s, 0.0) + ROUND * np.sin(t)
    return np.column_stack([rho, ROUND * (np.cos(t) - 1.0) - np.maximum(s - arc, 0.0)])


def lengths() -> FloatArray:
    """Where a mesh of that profile has its vertices: dense in the round, as tessellations are."""
    arc = 0.25 * TURN * ROUND
    flat, wall = np.linspace(-5.0, 0.0, 12), np.linspace(arc, arc + 6.0, 14)
    return np.concatenate([flat[:-1], np.linspace(0.0, arc, 7), wall[1:]])


def swept_mesh(name: InvarianceClass, curve: FloatArray) -> Mesh:
    """A profile (k, 2), turned by half a turn about z or drawn along z, with noise."""
    k, turns = len(curve), 90

    def surface(u: FloatArray, v: FloatArray) -> FloatArray:
        at = curve[np.rint(u * (k - 1)).astype(np.int64)]
        if name == "prismatic":
            return np.column_stack([at, 20.0 * v])
        phi = 0.5 * TURN * v
        return np.column_stack([at[:, 0] * np.cos(phi), at[:, 0] * np.sin(phi), at[:, 1]])

    mesh = sheet(surface, k - 1, turns)
    moved = mesh.vertices + np.random.default_rng(3).normal(0.0, SIGMA, mesh.vertices.shape)
    return Mesh(moved, mesh.triangles)


def described(name: InvarianceClass, curve: FloatArray) -> tuple[Swept, Chain | None]:
    """The surface of a profile as a spline and as a chain."""
    mesh = swept_mesh(name, curve)
    known, facets = NoisyMesh.of(mesh, SIGMA), np.arange(len(mesh.triangles))
    axis = Reference(np.zeros(3), np.array([0.0, 0.0, 1.0]))
    swept = fit_swept(known, facets, name, [axis])
    assert swept is not None
    return swept, profile_chain(known, facets, swept)


@pytest.mark.parametrize(
    ("name", "kinds"),
    [
        ("revolute", ("plane", "torus", "cylinder")),
        ("prismatic", ("plane", "cylinder", "plane")),
    ],
)
def test_a_round_of_eight_sigma_is_a_piece_of_its_own(
    name: InvarianceClass, kinds: tuple[str, ...]
) -> None:
    swept, chain = described(name, profile(lengths()))
    assert chain is not None
    assert chain.length < priced(swept) + REGION
    found = [model for _, model in chain.parts]
    if found[0].kind != kinds[0] or (name == "revolute" and found[-1].kind == "plane"):
        found = found[::-1]
    assert tuple(model.kind for model in found) == kinds
    # Where it begins is known to about two sigma, and so is its radius.
    small = found[1].surface[7 if name == "revolute" else 6]
    assert small == pytest.approx(ROUND, abs=2.0 * SIGMA)


@pytest.mark.parametrize("name", ["revolute", "prismatic"])
def test_a_curve_of_growing_curvature_stays_a_spline(name: InvarianceClass) -> None:
    # A clothoid: its curvature is the length along it.
    s = np.linspace(-1.5, 1.5, 60)
    step = 8.0 * (s[1] - s[0])
    clothoid = np.column_stack([np.cumsum(step * np.cos(s**2)), np.cumsum(step * np.sin(s**2))])
    swept, chain = described(name, clothoid + np.array([30.0, 0.0]))
    assert chain is None or chain.length > priced(swept) + REGION


def test_a_turned_edge_is_three_faces() -> None:
    mesh = swept_mesh("revolute", profile(lengths()))
    found = partition(mesh)
    share = {
        name: sum(r.area for r in found.regions if r.invariance_class == name) / mesh.areas.sum()
        for name in ("planar", "revolute", "cylindrical")
    }
    s = profile(lengths())
    flat = (s[11, 0] ** 2 - s[0, 0] ** 2) * 0.25 * TURN
    wall = 0.5 * TURN * 10.0 * 6.0
    both = float(flat + wall)
    assert share["planar"] == pytest.approx(flat / both, abs=0.08)
    assert share["cylindrical"] == pytest.approx(wall / both, abs=0.08)
    assert share["revolute"] < 0.1
