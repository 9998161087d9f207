# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command ``gpswb``: exit 0 done, 1 the input could not be processed, 2 wrong usage."""

from __future__ import annotations

import argparse
import os
import signal
import sys
from collections.abc import Sequence
from types import FrameType

import gpswb
from gpswb.batch.messages import internal_error, one_line
from gpswb.cli import annotate, batch, cache, compare, partition, sweep, validate
from gpswb.cli.guard import ChildError
from gpswb.errors import GpswbError

VERBS = (partition, validate, sweep, annotate, compare, batch, cache)


def main(argv: Sequence[str] | None = None) -> int:
    """Run one verb and return the exit code; every failure is one line on stderr."""
    try:
        args = _parser().parse_args(argv)
    except SystemExit as stop:  # argparse has printed its usage
        return stop.code if isinstance(stop.code, int) else 2
    try:
        signal.signal(signal.SIGTERM, _terminate)
        code: int = args.run(args)
        sys.stdout.flush()
        return code
    except GpswbError as error:
        return _fail(str(error))
    except KeyboardInterrupt:
        _fail("interrupted")
        return 130
    except BrokenPipeError:
        # Whoever read our output has gone; what was to be written is written.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except MemoryError:
        return _fail("out of memory; try a coarser --density")
    except ChildError as error:
        return _fail(str(error))
    except Exception as error:  # noqa: BLE001 - the promise is one line, whatever went wrong
        return _fail(internal_error(error))


def _fail(message: str) -> int:
    print(f"gpswb: {one_line(message)}", file=sys.stderr)
    return 1


def _terminate(number: int, frame: FrameType | None) -> None:
    """Turn a polite kill into an exception, so that drafts are cleared away."""
    raise KeyboardInterrupt


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="gpswb",
        description="Partition CAD parts and meshes into ISO GPS invariance classes.",
    )
    parser.add_argument("--version", action="version", version=f"gpswb {gpswb.__version__}")
    verbs = parser.add_subparsers(metavar="VERB", required=True)
    for verb in VERBS:
        verb.register(verbs)
    return parser
