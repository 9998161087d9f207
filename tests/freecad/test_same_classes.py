# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command, run by freecadcmd on FreeCAD's kernel, finds what it finds in the venv on OCP."""

import json
import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "build" / "examples"

# freecadcmd takes no arguments for a script, and ends with 0 whatever the script does.
SCRIPT = """
import os, sys
sys.path.insert(0, {root!r})
from gpswb.cli.main import main
status = main({arguments!r})
sys.stdout.flush()
os._exit(status)
"""


def classes(directory: Path) -> dict[str, str]:
    result = json.loads((directory / "result.json").read_text(encoding="utf-8"))
    return {face["name"]: face["class"] for face in result["faces"]}


def true_classes(directory: Path) -> dict[str, str]:
    result = json.loads((directory / "result.json").read_text(encoding="utf-8"))
    return {face["name"]: face["true_class"] for face in result["faces"]}


@pytest.mark.parametrize("name", ["sphere_cube", "simple_part", "revolution_part", "bracket"])
def test_same_classes_in_both_pythons(name, tmp_path):
    part = EXAMPLES / f"{name}.step"
    arguments = ["partition", str(part), "--density", "medium", "--no-report", "--out"]

    script = tmp_path / "in_freecad.py"
    freecad = [*arguments, str(tmp_path / "freecad"), "--kernel", "freecad"]
    script.write_text(SCRIPT.format(root=str(ROOT), arguments=freecad))
    run(["/usr/bin/freecadcmd", str(script)])
    venv = [*arguments, str(tmp_path / "ocp"), "--kernel", "ocp"]
    run([str(ROOT / ".venv" / "bin" / "gpswb"), *venv])

    found = classes(tmp_path / "freecad")
    assert found == classes(tmp_path / "ocp")
    assert found == true_classes(tmp_path / "freecad") == true_classes(tmp_path / "ocp")


def run(command: list[str]) -> None:
    environment = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    done = subprocess.run(
        command,
        env=environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
