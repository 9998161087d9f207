# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options that several verbs share."""

from __future__ import annotations

import argparse
import math
from typing import get_args

from gpswb.batch.settings import Kernel
from gpswb.cad.density import FORMS, Density
from gpswb.io.length_units import MILLIMETRES

MODES = ("robust", "corrected", "paper")
METHODS = ("hybrid", "curvature", "slippage")


def add_pipeline_options(parser: argparse.ArgumentParser) -> None:
    """Add ``--mode``, ``--method`` and ``--kernel``."""
    parser.add_argument("--mode", choices=MODES, default="robust", help="default: %(default)s")
    parser.add_argument("--method", choices=METHODS, default="hybrid", help="default: %(default)s")
    parser.add_argument("--kernel", choices=kernels(), default="ocp", help="default: %(default)s")


def add_density_option(parser: argparse.ArgumentParser) -> None:
    """Add ``--density``."""
    parser.add_argument(
        "--density", type=density, default=Density("auto"), help=f"{FORMS}; default: %(default)s"
    )


def kernels() -> tuple[str, ...]:
    """Names of the CAD kernels."""
    names: tuple[str, ...] = get_args(Kernel)
    return names


def add_noise_option(parser: argparse.ArgumentParser) -> None:
    """Add ``--noise``."""
    parser.add_argument(
        "--noise",
        type=non_negative,
        metavar="SIGMA",
        help="standard deviation of the vertices, mm; default: estimated from the mesh",
    )


def add_unit_option(parser: argparse.ArgumentParser) -> None:
    """Add ``--unit``."""
    parser.add_argument(
        "--unit",
        choices=tuple(MILLIMETRES),
        help="of a mesh or point cloud that names none; default: mm",
    )


def add_cache_option(parser: argparse.ArgumentParser) -> None:
    """Add ``--no-cache``, stored as ``cached``."""
    parser.add_argument(
        "--no-cache",
        dest="cached",
        action="store_false",
        help="do unchanged parts again, too, and don't keep their results",
    )


def add_corpus_options(parser: argparse.ArgumentParser) -> None:
    """Add ``--jobs``, ``--time-limit``, ``--memory-limit`` and ``--no-cache``."""
    add_cache_option(parser)
    parser.add_argument("--jobs", type=positive_int, default=2, metavar="N", help="at once; 2")
    parser.add_argument(
        "--time-limit", type=positive, default=300.0, metavar="SECONDS", help="a file; 300"
    )
    parser.add_argument(
        "--memory-limit", type=positive, default=6.0, metavar="GB", help="a file; 6"
    )


def density(text: str) -> Density:
    """Argparse type of a density."""
    try:
        return Density.parse(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def non_negative(text: str) -> float:
    """Argparse type of a finite number that is not negative."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not (math.isfinite(value) and value >= 0):
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of at least 0")
    return value


def positive(text: str) -> float:
    """Argparse type of a finite number above zero."""
    value = non_negative(text)
    if value == 0:
        raise argparse.ArgumentTypeError("must be above 0")
    return value


def whole(text: str) -> int:
    """Argparse type of a whole number of at least 0."""
    if not (text.isascii() and text.isdigit()):
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number of at least 0")
    return int(text)


def positive_int(text: str) -> int:
    """Argparse type of a whole number of at least 1."""
    if whole(text) == 0:
        raise argparse.ArgumentTypeError("must be at least 1")
    return int(text)
