# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measured parts: point clouds become meshes, meshes are repaired (numpy and scipy only)."""
