# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mapping recognised regions back on B-rep faces and judging them against CAD."""
