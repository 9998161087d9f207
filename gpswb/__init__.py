# SPDX-License-Identifier: LGPL-2.1-or-later
"""gpswb: partition of parts into ISO GPS invariance classes, for FreeCAD and the command line."""

__version__ = "0.1.0"
