# SPDX-License-Identifier: LGPL-2.1-or-later
"""Semantic PMI in STEP files (ISO 10303-242): read from and appended to the Part 21 text."""
