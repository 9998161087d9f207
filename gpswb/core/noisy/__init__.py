# SPDX-License-Identifier: LGPL-2.1-or-later
"""Surfaces of noisy meshes: statistical tests in place of tolerances."""
