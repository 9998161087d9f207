# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run by FreeCAD at its start, with or without a window."""

import FreeCAD

FreeCAD.__unit_test__ += ["gpswb.selftest"]
