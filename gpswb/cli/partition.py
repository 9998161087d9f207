# SPDX-License-Identifier: LGPL-2.1-or-later
"""``gpswb partition``: one part in, its recognised regions and faces out."""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import TYPE_CHECKING

from gpswb.batch.settings import Settings
from gpswb.cli.guard import guarded
from gpswb.cli.options import (
    add_cache_option,
    add_density_option,
    add_noise_option,
    add_pipeline_options,
    add_unit_option,
)
from gpswb.io.whole import whole_directory

if TYPE_CHECKING:
    from gpswb.batch.one_part import Outcome

OWNED = ("result.json", "labels.npz", "mesh.ply", "faces.csv", "report.html")
"""Every file that this verb may write in the output directory."""

SAID = "printed.json"
"""The lines that were printed, beside the files in the cache."""


def register(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the verb to the command's parser."""
    parser = verbs.add_parser(
        "partition",
        help="partition one part, recognise its regions, validate against CAD",
        description="INPUT is a part (STEP, BREP, FCStd), a mesh (STL, PLY, OFF, OBJ, 3MF) or a "
        "point cloud (XYZ, PTS, ASC, TXT, CSV, PLY).",
    )
    parser.add_argument("input", type=Path, metavar="INPUT")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR")
    add_density_option(parser)
    add_pipeline_options(parser)
    add_unit_option(parser)
    add_noise_option(parser)
    add_cache_option(parser)
    parser.add_argument("--no-report", action="store_true", help="don't write report.html")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Do it; the exit code."""
    with whole_directory(args.out, OWNED) as draft:
        lines, names = guarded(lambda: _work(args, draft), str(args.input))
    for line in lines:
        print(line)
    print("wrote " + " ".join(str(args.out / name) for name in names))
    return 0


def _work(args: argparse.Namespace, draft: Path) -> tuple[list[str], list[str]]:
    """What is printed and the names of the files written in ``draft``."""
    from gpswb.batch.cache import Cache

    settings = Settings(
        args.density, args.mode, args.method, args.kernel, noise=args.noise, unit=args.unit
    )
    key = _key(args, settings) if args.cached else None
    cache = Cache.of_user()
    if key and (known := cache.get(key)):
        said = json.loads(known.pop(SAID))
        names = [name for name in known if name in OWNED]
        for name in names:
            (draft / name).write_bytes(known[name])
        return [*said, "", "this part was partitioned before: taken from the cache"], names
    lines, names = _partition(args, settings, draft)
    if key:
        files = {name: (draft / name).read_bytes() for name in names}
        cache.put(key, {**files, SAID: json.dumps(lines).encode()})
    return lines, names


def _key(args: argparse.Namespace, settings: Settings) -> str | None:
    """The name of the results in the cache; None where the part can't be read."""
    from gpswb.batch.cache import Cache

    # The path, because result.json and the report name it.
    what = {"what": "partition", "path": str(args.input), "report": not args.no_report}
    try:
        return Cache.key(args.input, args.kernel, {**what, "settings": settings.plain()})
    except OSError:
        return None


def _partition(
    args: argparse.Namespace, settings: Settings, draft: Path
) -> tuple[list[str], list[str]]:
    from gpswb.batch.one_part import examine
    from gpswb.cli.progress import stage_bar
    from gpswb.cli.table import result_lines

    with stage_bar() as progress:
        outcome = examine(args.input, settings, progress)
    return result_lines(outcome), write_all(draft, outcome, report=not args.no_report)


def write_all(directory: Path, outcome: Outcome, report: bool) -> list[str]:
    """Write what this verb writes; the names of the files, the main one first."""
    from gpswb.io.faces_csv import write_faces
    from gpswb.io.labels_npz import write_labels
    from gpswb.io.ply import write_ply
    from gpswb.io.result_json import result_document, write_result

    solid, partition, validation = outcome.solid, outcome.partition, outcome.validation
    document = result_document(solid, partition, validation)
    write_result(directory / "result.json", document)
    write_labels(directory / "labels.npz", partition, solid.facemap, solid.pointmap)
    write_ply(directory / "mesh.ply", partition)
    names = ["result.json", "labels.npz", "mesh.ply"]
    if validation:
        write_faces(directory / "faces.csv", validation.faces)
        names.append("faces.csv")
    if report:
        from gpswb.report.part_report import write_report

        write_report(directory / "report.html", document, partition, solid.facemap)
        names.append("report.html")
    return names
