# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts for the command line, made when they are needed."""

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[2] / "examples"))

Command = Callable[..., "subprocess.CompletedProcess[str]"]


@pytest.fixture(scope="session")
def gpswb() -> Command:
    def run(*words: object, **options: object) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [sys.executable, "-m", "gpswb", *map(str, words)],
            capture_output=True,
            text=True,
            timeout=300,
            check=False,
            **options,
        )

    return run


@pytest.fixture(scope="session")
def block_step(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A block 30 x 20 x 10 mm with a hole of 8 mm: six planes and a cylinder."""
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCylinder
    from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
    from OCP.STEPControl import STEPControl_StepModelType, STEPControl_Writer

    block = BRepPrimAPI_MakeBox(30.0, 20.0, 10.0).Shape()
    axis = gp_Ax2(gp_Pnt(15, 10, -1), gp_Dir(0, 0, 1))
    hole = BRepPrimAPI_MakeCylinder(axis, 4.0, 12.0).Shape()
    writer = STEPControl_Writer()
    kind = STEPControl_StepModelType.STEPControl_AsIs
    writer.Transfer(BRepAlgoAPI_Cut(block, hole).Shape(), kind)
    path = tmp_path_factory.mktemp("parts") / "block.step"
    writer.Write(str(path))
    return path
