# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports people look at: pages and pictures made from results; standard library and numpy only."""
