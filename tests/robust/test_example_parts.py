# SPDX-License-Identifier: LGPL-2.1-or-later
"""The example parts end to end: every face right, however finely they are meshed."""

from __future__ import annotations

from pathlib import Path

import pytest
from example_parts import classes, expect_all_right, read, step_file


@pytest.mark.parametrize("density", ["coarse", "medium", "fine", "auto"])
@pytest.mark.parametrize("name", ["sphere_cube", "simple_part", "revolution_part"])
def test_the_papers_parts(name: str, density: str, tmp_path: Path) -> None:
    solid, facemap = read(step_file(name, tmp_path), density)
    expect_all_right(name, solid.mesh, facemap)


@pytest.mark.parametrize("name", ["bracket", "multi_solid", "thread"])
def test_the_other_parts(name: str, tmp_path: Path) -> None:
    solid, facemap = read(step_file(name, tmp_path), "auto")
    expect_all_right(name, solid.mesh, facemap)


@pytest.mark.parametrize("name", ["simple_part", "revolution_part"])
def test_a_twin_of_b_splines_has_the_same_classes(name: str, tmp_path: Path) -> None:
    native, facemap = read(step_file(name, tmp_path), "coarse")
    twin, its_facemap = read(step_file(name, tmp_path, nurbs=True), "coarse")
    assert {f.truth.surface for f in its_facemap.faces if f.truth} == {"BSpline"}
    assert classes(twin.mesh, its_facemap) == classes(native.mesh, facemap)
    expect_all_right(name, twin.mesh, its_facemap)
