# SPDX-License-Identifier: LGPL-2.1-or-later
"""The errors that gpswb raises for bad input; `cli` turns each into one line and exit code 1."""


class GpswbError(Exception):
    """Base of every error that the user can cause; its text is one clear line."""


class InputError(GpswbError):
    """The input can't be read or holds nothing to partition."""


class OutputError(GpswbError):
    """A result can't be written."""


class KernelError(GpswbError):
    """A CAD kernel is missing, crashed or ran out of time on this input."""
