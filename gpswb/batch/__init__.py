# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts through the whole pipeline: one, or many in processes of their own, here or on a cluster.

What the command line and the workbench share above the reports; nothing here prints or exits.
"""
