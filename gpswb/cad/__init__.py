# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAD kernels, tessellation and the ground truth of B-rep faces."""
