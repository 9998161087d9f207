# SPDX-License-Identifier: LGPL-2.1-or-later
"""``gpswb cache``: what results are kept for unchanged parts, and away with them."""

from __future__ import annotations

import argparse


def register(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the verb to the command's parser."""
    parser = verbs.add_parser(
        "cache",
        help="results kept for unchanged parts: show how many, or clear them",
        description="Results are kept by the content of the input, the settings and the version; "
        "partition, validate, sweep and batch take them from there unless --no-cache is given.",
    )
    parser.add_argument("action", choices=("show", "clear"))
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Do it; the exit code."""
    from gpswb.batch.cache import Cache
    from gpswb.errors import OutputError

    cache = Cache.of_user()
    if args.action == "show":
        count, size = cache.usage()
        print(f"{cache.directory}: {count} results, {size / 1e6:.1f} MB of {cache.most / 1e6:.0f}")
        return 0
    try:
        count, size = cache.clear()
    except OSError as error:
        raise OutputError(f"can't clear {cache.directory}: {error.strerror or error}") from error
    print(f"{cache.directory}: removed {count} results, {size / 1e6:.1f} MB")
    return 0
