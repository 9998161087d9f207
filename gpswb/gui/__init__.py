# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench in FreeCAD's window, and its document objects, which scripts can use without one.

Imported at FreeCAD's start: whatever is heavy is imported where it is used.
"""
