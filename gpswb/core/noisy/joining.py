# SPDX-License-Identifier: LGPL-2.1-or-later
"""Neighbours joined where one swept or freeform surface describes them for less than their own."""

from __future__ import annotations

import heapq
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gpswb.core.mesh import IntArray
from gpswb.core.noisy.border_angle import meet_at_crease
from gpswb.core.noisy.expansion import OUTSIDE, border_prices
from gpswb.core.noisy.freeform import Freeform
from gpswb.core.noisy.general_surface import LEAST, general_surface, priced
from gpswb.core.noisy.merging import REGION, facets_of, length_of, smooth_neighbours
from gpswb.core.noisy.models import Model, Surface
from gpswb.core.noisy.noisy_mesh import NoisyMesh
from gpswb.core.noisy.profile_chain import profile_chain
from gpswb.core.noisy.swept import Swept
from gpswb.core.slippage import SlippageMoments, slippage_moments

TRIAL = 60.0
"""What a union may lose by itself: a profile of three arcs is dearer than two cylinders, and only
with the next neighbours it gets cheaper."""

CONTACT = 3
"""Edges that pieces of one face have in common at least."""

AXIS = 45.0
"""Price of each piece but the first in a surface of revolution: a turned part is one as a whole and
its faces share an axis, of which each has four unknowns to itself in its own description."""

FLAT = 40.0
"""Price of a plane in a union: planes are the commonest faces, and curved ones are hardly ever flat
anywhere."""


@dataclass(frozen=True, eq=False)
class _Piece:
    """Facets (k,), what they lie on (None for nothing), what they cost in the best division, and
    the price of the borders between the regions that they consist of."""

    facets: IntArray
    surface: Surface | None
    length: float
    moments: SlippageMoments
    borders: float = 0.0
    parts: tuple[_Piece, ...] = ()

    @property
    def pieces(self) -> int:
        """Number of regions that it consists of."""
        return sum(part.pieces for part in self.parts) if self.parts else 1

    @property
    def planes(self) -> int:
        """Number of planes that it consists of."""
        if self.parts:
            return sum(part.planes for part in self.parts)
        return int(_flat(self))


def join_regions(
    noisy: NoisyMesh, models: Sequence[Surface], label: IntArray
) -> tuple[list[Surface], IntArray]:
    """Join regions, and facets that nothing explains, where one surface of both is cheaper.

    Description length decides, as in `merging`. Pairs that gain most are joined first, whatever the
    prior of such a region; that is charged in the end, when each union is taken or divided again.

    Args:
        noisy: the mesh and its noise.
        models: the surfaces.
        label: (m,) the number of each facet's surface, -1 for none.
    """
    pieces = _pieces(noisy, models, label)
    home = np.full(len(label), -1, dtype=np.int64)
    for i, piece in enumerate(pieces):
        home[piece.facets] = i
    alive = dict(enumerate(pieces))
    near = _neighbours(noisy, home)
    price = border_prices(noisy)
    queue: list[tuple[float, int, int, int, _Piece]] = []

    def push(a: int, b: int) -> None:
        border = _border(noisy, home, a, b)
        if len(border) < CONTACT or _creased(noisy, alive[a], alive[b], border):
            return
        union = _joined(noisy, alive[a], alive[b], 2.0 * float(price[border].sum()))
        if union is not None:
            gain = alive[a].length + alive[b].length - union.length
            if gain > -TRIAL:
                heapq.heappush(queue, (-gain, a, b, len(queue), union))

    for a in near:
        for b in near[a]:
            if a < b:
                push(a, b)
    count = len(pieces)
    while queue:
        _, a, b, _, union = heapq.heappop(queue)
        if a not in alive or b not in alive:
            continue
        del alive[a], alive[b]
        alive[count] = union
        home[union.facets] = count
        around = (near.pop(a) | near.pop(b)) - {a, b}
        near[count] = around
        for c in around:
            near[c] = (near[c] - {a, b}) | {count}
            push(c, count)
        count += 1
    return _taken(noisy, list(alive.values()), label)


def _flat(piece: _Piece) -> bool:
    return isinstance(piece.surface, Model) and piece.surface.kind == "plane"


def _creased(noisy: NoisyMesh, a: _Piece, b: _Piece, border: IntArray) -> bool:
    """Whether two pieces meet at a crease."""
    if a.surface is None or b.surface is None:
        return False
    return meet_at_crease(noisy, (a.surface, b.surface), (a.facets, b.facets), border)


def _taken(
    noisy: NoisyMesh, pieces: Sequence[_Piece], label: IntArray
) -> tuple[list[Surface], IntArray]:
    """Surfaces and labels of the pieces, or of their parts where those are cheaper."""
    out = np.full_like(label, -1)
    surfaces: list[Surface] = []
    for piece in pieces:
        for facets, surface in _divided(noisy, piece)[1]:
            out[facets] = len(surfaces)
            surfaces.append(surface)
    return surfaces, out


def _border(noisy: NoisyMesh, home: IntArray, a: int, b: int) -> IntArray:
    """The interior edges between two regions, as rows of the graph's pairs."""
    first, second = home[noisy.graph.pairs].T
    return np.flatnonzero(((first == a) & (second == b)) | ((first == b) & (second == a)))


def _axis_price(surface: Swept | Freeform, pieces: int) -> float:
    return AXIS * (pieces - 1) if surface.invariance_class == "revolute" else 0.0


def _divided(noisy: NoisyMesh, piece: _Piece) -> tuple[float, list[tuple[IntArray, Surface]]]:
    """The cheapest of a union, of its parts, and of a chain of simple surfaces of its motion, with
    the prior of what isn't simple: facets and surface of each region."""
    whole = piece.length
    if isinstance(piece.surface, Swept | Freeform):
        whole = whole - piece.surface.cost + priced(piece.surface)
    found = (whole, [] if piece.surface is None else [(piece.facets, piece.surface)])
    if piece.parts:
        divided = [_divided(noisy, part) for part in piece.parts]
        apart = sum(length for length, _ in divided)
        if apart < whole:
            found = (apart, [part for _, parts in divided for part in parts])
    if isinstance(piece.surface, Swept):
        chain = profile_chain(noisy, piece.facets, piece.surface)
        # A chain pays for the axis once, too: no need to charge the spline for that.
        plain = whole - _axis_price(piece.surface, piece.pieces)
        if chain is not None and chain.length < min(found[0], plain):
            return chain.length, list(chain.parts)
    return found


def _pieces(noisy: NoisyMesh, models: Sequence[Surface], label: IntArray) -> list[_Piece]:
    """Regions, then what hangs together without a surface."""
    groups = [(m, g) for m, g in zip(models, facets_of(label, len(models)), strict=True) if len(g)]
    none = np.flatnonzero((label < 0) & (noisy.mesh.areas > 0.0))
    both = np.logical_and(*(label < 0)[noisy.graph.pairs].T)
    part = noisy.graph.components(both, len(label))[none]
    order = np.argsort(part, kind="stable")
    loose = np.split(none[order], np.flatnonzero(np.diff(part[order])) + 1)
    number = np.full(len(label), -1, dtype=np.int64)
    # Few facets are strays: they go to a neighbour later.
    everything = [g for _, g in groups] + [g for g in loose if len(g) >= LEAST]
    for i, facets in enumerate(everything):
        number[facets] = i
    mesh = noisy.mesh
    moments = slippage_moments(
        mesh.centroids, noisy.normals, mesh.areas, number, max(len(everything), 1)
    )
    pieces = []
    for i, facets in enumerate(everything):
        own = SlippageMoments(moments.motion[i : i + 1], moments.metric[i : i + 1])
        if i < len(groups):
            model = groups[i][0]
            pieces.append(_Piece(facets, model, length_of(noisy, model, facets), own))
            continue
        length = 0.5 * OUTSIDE**2 * len(facets) + REGION
        piece = _Piece(facets, None, length, own)
        one = general_surface(noisy, facets, own, ())
        if one is not None and one.cost + REGION < length:
            piece = _Piece(facets, one, one.cost + REGION, own, 0.0, (piece,))
        pieces.append(piece)
    return pieces


def _neighbours(noisy: NoisyMesh, home: IntArray) -> dict[int, set[int]]:
    """The pieces that each piece meets without a crease."""
    near: dict[int, set[int]] = {i: set() for i in range(int(home.max(initial=-1)) + 1)}
    for a, b in smooth_neighbours(noisy, home):
        near[a].add(b)
        near[b].add(a)
    return near


def _joined(noisy: NoisyMesh, a: _Piece, b: _Piece, border: float) -> _Piece | None:
    """The union of two pieces on one swept or freeform surface.

    Faces meet where they touch or cross, but the borders of a patchwork run anywhere and have to be
    told: a freeform surface saves their price.
    """
    if _flat(a) and _flat(b):
        return None
    facets = np.concatenate([a.facets, b.facets])
    moments = SlippageMoments(
        a.moments.motion + b.moments.motion, a.moments.metric + b.moments.metric
    )
    one = general_surface(noisy, facets, moments, (a.surface, b.surface))
    if one is None:
        return None
    length = one.cost + REGION + FLAT * (a.planes + b.planes)
    length += _axis_price(one, a.pieces + b.pieces)
    borders = a.borders + b.borders + border
    if one.invariance_class == "complex":
        length -= borders
    return _Piece(facets, one, length, moments, borders, (a, b))
