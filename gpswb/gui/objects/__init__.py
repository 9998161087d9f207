# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects and their views; the objects work without a window, too."""
