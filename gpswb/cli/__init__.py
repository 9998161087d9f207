# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: one file a verb."""
