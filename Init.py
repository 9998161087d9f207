# SPDX-License-Identifier: LGPL-2.1-or-later
import FreeCAD

FreeCAD.__unit_test__ += ["gpswb.selftest"]
