# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading and writing: one file a format."""
