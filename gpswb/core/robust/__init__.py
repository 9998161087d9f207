# SPDX-License-Identifier: LGPL-2.1-or-later
"""The default mode: regions found by consensus on surfaces, positions first, normals as a guide."""
