# SPDX-License-Identifier: LGPL-2.1-or-later
"""The partition and recognition algorithms: numpy and scipy only, never CAD, never GUI."""
