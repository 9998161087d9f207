# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's own parser accepts package.xml, and what the file says is true of this tree."""

from pathlib import Path

import FreeCAD
import pytest

import gpswb

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def metadata():
    return FreeCAD.Metadata(str(ROOT / "package.xml"))


def test_version_is_the_packages(metadata):
    assert metadata.Version == gpswb.__version__


def test_licence_file_and_icon_exist(metadata):
    (licence,) = metadata.License
    assert licence["name"] == "LGPL-2.1-or-later"
    assert (ROOT / licence["file"]).is_file()
    assert (ROOT / metadata.Icon).is_file()


def test_workbench_is_found_in_the_addon_directory_itself(metadata):
    (workbench,) = metadata.Content["workbench"]
    assert workbench.Classname == "GpsWorkbench"
    assert (ROOT / workbench.Subdirectory).resolve() == ROOT
    assert metadata.supportsCurrentFreeCAD()
