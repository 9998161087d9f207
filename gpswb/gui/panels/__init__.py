# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panels and the legend; what they do, a script can do by the functions that they call."""
