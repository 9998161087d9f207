# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user may write for a density."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gpswb.cad.density import Density

positive = st.floats(1e-4, 1e4).map(repr)
texts = st.one_of(
    st.sampled_from(["auto", "coarse", "medium", "fine", "stl"]),
    st.builds("edge={}".format, positive),
    st.builds("deflection={}".format, positive),
    st.builds("deflection={},{}".format, positive, st.floats(0.1, 170).map(repr)),
    st.builds("vertices={}".format, st.integers(4, 10**7)),
    st.builds("triangles={}".format, st.integers(4, 10**7)),
    st.builds("turn={}".format, st.integers(3, 720)),
)


@given(texts)
def test_text_round_trip(text: str) -> None:
    density = Density.parse(text)
    assert Density.parse(str(density)) == density


@given(texts)
def test_case_and_blanks_do_not_matter(text: str) -> None:
    assert Density.parse(f"  {text.upper()} ") == Density.parse(text)


@pytest.mark.parametrize(
    "text",
    [
        "", "finest", "edge", "edge=", "edge=-1", "edge=0", "edge=nan", "edge=inf", "edge=1,2",
        "turn=2", "turn=8.5", "vertices=1", "triangles=1e12", "deflection=1,2,3",
        "deflection=1,200", "auto=3", "=5", "medium=1", "edge=1;2",
    ],
)  # fmt: skip
def test_anything_else_is_told_with_the_valid_forms(text: str) -> None:
    with pytest.raises(ValueError, match="use one of auto, coarse, medium, fine, stl, deflection="):
        Density.parse(text)
