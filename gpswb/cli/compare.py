# SPDX-License-Identifier: LGPL-2.1-or-later
"""``gpswb compare``: a scan against its nominal part, form deviation by feature."""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path

from gpswb.batch.settings import Kernel, Settings
from gpswb.cad.density import Density
from gpswb.cli.guard import guarded
from gpswb.cli.options import add_noise_option, add_unit_option, density, kernels
from gpswb.io.whole import whole_directory

OWNED = ("comparison.json", "comparison.csv", "result.json", "labels.npz", "report.html")
"""Every file that this verb may write in the output directory."""

FINE = Density("deflection", 0.005, 5.0)
"""Of the nominal part: elementary faces are compared exactly, others with this chord error, mm."""


def register(verbs: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the verb to the command's parser."""
    parser = verbs.add_parser(
        "compare",
        help="align a scan with its nominal part; form deviation of every feature",
        description="SCAN is a mesh or a point cloud, PART a CAD part (STEP, BREP, FCStd).",
    )
    parser.add_argument("scan", type=Path, metavar="SCAN")
    parser.add_argument("part", type=Path, metavar="PART")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR")
    parser.add_argument(
        "--place",
        type=place,
        default=(0.0,) * 6,
        metavar="X,Y,Z[,RX,RY,RZ]",
        help="rough place of the scan: mm, then degrees about x, y, z; refined by ICP",
    )
    parser.add_argument("--no-align", action="store_true", help="take --place as exact")
    parser.add_argument(
        "--density", type=density, default=FINE, help="of the nominal part; default: %(default)s"
    )
    parser.add_argument("--kernel", choices=kernels(), default="ocp", help="default: %(default)s")
    add_unit_option(parser)
    add_noise_option(parser)
    parser.add_argument("--no-report", action="store_true", help="don't write report.html")
    parser.set_defaults(run=run)


def place(text: str) -> tuple[float, ...]:
    """Argparse type of three or six finite numbers."""
    try:
        numbers = tuple(float(piece) for piece in text.split(","))
    except ValueError:
        numbers = ()
    if len(numbers) not in (3, 6) or not all(abs(x) < 1e9 for x in numbers):
        raise argparse.ArgumentTypeError(f"{text!r} is not X,Y,Z or X,Y,Z,RX,RY,RZ")
    return (*numbers, 0.0, 0.0, 0.0)[:6]


def run(args: argparse.Namespace) -> int:
    """Do it; the exit code."""
    with whole_directory(args.out, OWNED) as draft:
        lines, names = guarded(lambda: _work(args, draft), f"{args.scan}, {args.part}")
    for line in lines:
        print(line)
    print("wrote " + " ".join(str(args.out / name) for name in names))
    return 0


def _work(args: argparse.Namespace, draft: Path) -> tuple[list[str], list[str]]:
    """What is printed and the names of the files written in ``draft``."""
    from gpswb.batch.one_part import partition_solid
    from gpswb.cad.read import read_solid
    from gpswb.cli.progress import stage_bar
    from gpswb.cli.table import aligned
    from gpswb.core.mesh import Mesh
    from gpswb.io.comparison_file import comparison_document, write_comparison
    from gpswb.io.labels_npz import write_labels
    from gpswb.io.measured_file import read_measured
    from gpswb.io.result_json import result_document, write_result
    from gpswb.report.comparison_page import comparison_page, features_table
    from gpswb.validation.alignment import align, placement
    from gpswb.validation.comparison import compare
    from gpswb.validation.nominal import nominal_samples

    kernel: Kernel = args.kernel
    with stage_bar() as progress:
        scan = read_measured(args.scan, args.unit)
        part = read_solid(args.part, args.density, kernel, progress)
        nominal = nominal_samples(part)
        transform, alignment = placement(args.place), None
        if not args.no_align:
            alignment = align(scan.mesh.vertices, nominal.points, nominal.diagonal, transform)
            transform = alignment.transform
        vertices = scan.mesh.vertices @ transform[:3, :3].T + transform[:3, 3]
        scan = replace(scan, mesh=Mesh(vertices, scan.mesh.triangles))
        if scan.pointmap is not None:
            points = scan.pointmap.points @ transform[:3, :3].T + transform[:3, 3]
            scan = replace(scan, pointmap=replace(scan.pointmap, points=points))
        settings = Settings(args.density, "robust", "hybrid", kernel, noise=args.noise)
        scan, result = partition_solid(scan, settings, progress)
    comparison = compare(result, nominal)
    document = comparison_document(scan, part, result, alignment, comparison)
    names = write_comparison(draft, document)
    write_result(draft / "result.json", result_document(scan, result, None))
    write_labels(draft / "labels.npz", result, None, scan.pointmap)
    names += ["result.json", "labels.npz"]
    if not args.no_report:
        page = comparison_page(document, result, comparison)
        (draft / "report.html").write_text(page, encoding="utf-8")
        names.append("report.html")
    table = features_table(document)
    lines = [f"note: {note}" for note in document["notes"]]
    if alignment is not None:
        lines.append(f"aligned: {100 * alignment.paired:.1f} % of the points paired")
    lines.append(
        f"{document['vertices']} points, {document['far']} too far off, {document['extracted']} "
        f"extracted; rms distance {document['rms'] or 0.0:.4g} mm"
    )
    return [*lines, "", *aligned([table.head, *table.rows], right=range(3, 10))], names
