# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench's short test, run by FreeCAD: ``freecadcmd -t gpswb.selftest -M DIRECTORY``."""

from gpswb.selftest.core_case import CoreCase
from gpswb.selftest.part_case import PartCase

__all__ = ["CoreCase", "PartCase"]
