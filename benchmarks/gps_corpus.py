# SPDX-License-Identifier: LGPL-2.1-or-later
"""GPS features, datums and PMI over many parts: ``python benchmarks/gps_corpus.py FILES``.

For each STEP file: whether every face is in exactly one feature; diameters against CAD; whether the
suggested datum systems lock all that the part allows, each letter something; and for PMI that the
file holds, whether each datum feature has the class and the faces of its exact surfaces, how many
magnitudes are read and how many characteristics would be called not allowed.

Regions are the CAD surfaces' own; with ``--recognised`` what the pipeline makes of the mesh, and
how many of the CAD surfaces' features and compounds are found so. Density is auto. ``--docs
FILE.md`` renews the figures in a document.
"""

from __future__ import annotations

import argparse
import multiprocessing
import resource
import signal
from dataclasses import asdict, dataclass
from multiprocessing.connection import Connection
from pathlib import Path

import numpy as np
from docs_section import renew
from true_partition import true_partition

from gpswb.batch.one_part import examine
from gpswb.batch.settings import Settings
from gpswb.cad.density import Density
from gpswb.cad.read import read_solid
from gpswb.cad.solid import FaceTruth, Solid
from gpswb.cli.annotate import features_of
from gpswb.cli.annotation_files import read_present
from gpswb.errors import GpswbError
from gpswb.gps.annotation import annotate
from gpswb.gps.feature_table import FeatureTable, feature_table
from gpswb.gps.invariance_of_union import invariance_of_union
from gpswb.gps.on_faces import features_on
from gpswb.gps.review import class_of, review
from gpswb.gps.suggest_datums import Suggestion
from gpswb.gps.twists import Frame, SituationFeature, vector

DIAMETER_MM = 1e-3


@dataclass(frozen=True)
class Row:
    """Figures of one file; ``status`` says why there are none."""

    file: str
    status: str = "done"
    faces: int = 0
    features: int = 0
    compounds: int = 0
    amiss: int = 0  # faces in no feature or in several
    diameters: int = 0
    diameters_off: int = 0
    worst_mm: float = 0.0
    locks: str = ""
    needed: int = 0
    complete: bool = False
    runner_up: str = ""
    datums: int = 0
    datums_right: int = 0
    tolerances: int = 0
    read: int = 0
    refused: int = 0
    alike: int = 0  # features and compounds that are those of the CAD surfaces, by faces
    of_cad: int = 0


def figures(path: Path, *, recognised: bool) -> Row:
    """All figures of one file."""
    table, solid = _table(path, recognised=recognised)
    assert solid.facemap is not None
    truths = {face.name: face.truth for face in solid.facemap.faces}
    named = [name for feature in table.integral for name in feature.faces]
    expected = [name for name, truth in truths.items() if truth is not None]
    amiss = len(set(expected) - set(named)) + len(named) - len(set(named))
    off = [abs(size - cad) for size, cad in _diameters(table, truths)]
    suggestions = annotate(table).suggestions
    first = suggestions[0] if suggestions else None
    counts = _pmi(path, solid, table, truths)
    cad = _face_sets(_cad_table(solid)) if recognised else set()
    return Row(
        file=path.name,
        faces=len(truths),
        features=len(table.integral),
        compounds=len(table.compounds),
        amiss=amiss,
        diameters=len(off),
        diameters_off=sum(each > DIAMETER_MM for each in off),
        worst_mm=max(off, default=0.0),
        locks=_locks(first),
        needed=first.needed if first else 0,
        complete=bool(suggestions) and all(map(_good, suggestions)),
        runner_up=_locks(suggestions[1]) if len(suggestions) > 1 else "",
        alike=len(cad & _face_sets(table)),
        of_cad=len(cad),
        **counts,
    )


def _table(path: Path, *, recognised: bool) -> tuple[FeatureTable, Solid]:
    if recognised:
        outcome = examine(path, Settings(Density("auto"), "robust", "hybrid", "ocp"))
        return features_of(outcome), outcome.solid
    solid = read_solid(path, Density("auto"))
    return _cad_table(solid), solid


def _cad_table(solid: Solid) -> FeatureTable:
    assert solid.facemap is not None
    partition, names, bodies = true_partition(solid)
    placed = {name for faces in names.values() for name in faces}
    without = [
        (face.name, face.solid)
        for face in solid.facemap.faces
        if face.truth is not None and face.name not in placed
    ]
    return feature_table(partition, names, bodies=bodies, without=without)


def _face_sets(table: FeatureTable) -> set[tuple[str, frozenset[str]]]:
    return {(feature.kind, frozenset(feature.faces)) for feature in table.features}


def _diameters(
    table: FeatureTable, truths: dict[str, FaceTruth | None]
) -> list[tuple[float, float]]:
    """Diameter of each cylinder with a size, and of its CAD cylinder."""
    found = []
    for feature in table.integral:
        if feature.size is None or feature.size.kind != "diameter":
            continue
        cads = [truths[name] for name in feature.faces]
        radii = [t.parameters["radius"][0] for t in cads if t and t.surface == "Cylinder"]
        if radii:
            found.append((feature.size.value, 2 * float(np.median(radii))))
    return found


def _good(suggestion: Suggestion) -> bool:
    return suggestion.complete and not suggestion.system.redundant


def _locks(suggestion: Suggestion | None) -> str:
    if suggestion is None:
        return "none"
    pairs = zip(suggestion.system.datums, suggestion.system.locks, strict=True)
    return ", ".join(f"{d.features[0].name} {lock.degrees}" for d, lock in pairs)


def _pmi(
    path: Path, solid: Solid, table: FeatureTable, truths: dict[str, FaceTruth | None]
) -> dict[str, int]:
    present, _ = read_present(path, solid)
    if present is None:
        return {}
    resolved = [datum for datum in present.datums if datum.faces and not datum.target]
    right = 0
    for datum in resolved:
        features, _ = features_on(table.features, datum.faces)
        covered = {name for feature in features for name in feature.faces}
        exact = exact_class([truths[name] for name in datum.faces], table.frame)
        right += covered == set(datum.faces) and class_of(features, table) == exact
    remarks = review(present, table)
    return {
        "datums": len(resolved),
        "datums_right": right,
        "tolerances": len(present.tolerances),
        "read": sum(each.value is not None for each in present.tolerances),
        "refused": sum("not allowed" in remark.text for remark in remarks),
    }


def exact_class(truths: list[FaceTruth | None], frame: Frame) -> str:
    """Class of the union of faces' exact surfaces."""
    places = []
    for truth in truths:
        assert truth is not None
        numbers = truth.parameters
        places.append(
            SituationFeature(
                truth.nominal,
                vector(numbers.get("point", (0.0, 0.0, 0.0))),
                vector(numbers.get("direction", (0.0, 0.0, 1.0))),
                numbers.get("lead", (0.0,))[0],
            )
        )
    return invariance_of_union(places, frame).invariance_class


def _isolated(path: Path, limit: float, *, recognised: bool) -> Row:
    """Figures from a process of their own: a file may crash the kernel, or take for ever."""
    end, other = multiprocessing.Pipe(duplex=False)
    child = multiprocessing.Process(target=_child, args=(other, path, limit, recognised))
    child.start()
    other.close()
    try:
        return end.recv()
    except EOFError:
        child.join()
        if child.exitcode == -signal.SIGXCPU:
            return Row(path.name, f"not done in {limit:g} s of CPU time")
        # Python ends with 1 after an error that nobody expected; a crash is a signal.
        return Row(path.name, "internal error" if child.exitcode == 1 else "crashed the kernel")
    finally:
        child.kill()
        child.join()


def _child(end: Connection, path: Path, limit: float, recognised: bool) -> None:
    # CPU time, so that what else the machine does can't change the figures.
    resource.setrlimit(resource.RLIMIT_CPU, (round(limit), resource.RLIM_INFINITY))
    try:
        end.send(figures(path, recognised=recognised))
    except GpswbError as error:
        end.send(Row(path.name, f"refused: {str(error).removeprefix(f'{path}: ')}"))


def sums(rows: list[Row]) -> list[str]:
    """A table of the figures over all files."""
    done = [row for row in rows if row.status == "done" and row.features]
    total = {key: sum(asdict(row)[key] for row in done) for key in (
        "faces", "amiss", "diameters", "diameters_off", "datums", "datums_right", "tolerances",
        "read", "refused", "alike", "of_cad",
    )}  # fmt: skip
    worst = max((row.worst_mm for row in done), default=0.0)
    n = len(done)
    near = total["diameters"] - total["diameters_off"]
    table = {
        "files with features": f"{n} of {len(rows)}",
        "faces in exactly one feature": f"{total['faces'] - total['amiss']} of {total['faces']}",
        f"diameters within {DIAMETER_MM:g} mm of CAD": f"{near} of {total['diameters']}",
        "the worst diameter is off by": f"{worst:.2g} mm",
        "parts whose suggestions lock all that the part allows, each letter something": (
            f"{sum(row.complete for row in done)} of {n}"
        ),
        "parts with a runner-up": f"{sum(bool(row.runner_up) for row in done)} of {n}",
        "files with semantic PMI": f"{sum(bool(r.tolerances or r.datums) for r in done)}",
        "datum features with the class and the faces of their exact surfaces": (
            f"{total['datums_right']} of {total['datums']}"
        ),
        "magnitudes of tolerances read": f"{total['read']} of {total['tolerances']}",
        "tolerances called not allowed": f"{total['refused']}",
    }
    if total["of_cad"]:
        table["features and compounds of the CAD surfaces that are found, with all their faces"] = (
            f"{total['alike']} of {total['of_cad']}"
        )
    return ["| | |", "|---|---|", *(f"| {name} | {value} |" for name, value in table.items())]


def markdown(rows: list[Row], *, recognised: bool) -> list[str]:
    """Sums and a table with a line a file."""
    what = "recognised from the mesh (density auto)" if recognised else "made of the CAD surfaces"
    lines = [f"### Regions {what}", "", *sums(rows), ""]
    lines += [
        "| file | faces | features | compounds | locked by each letter | runner-up | PMI |",
        "|---|---:|---:|---:|---|---|---|",
    ]
    for row in rows:
        if row.status == "done" and row.features:
            ok = "" if row.complete else f" **of {row.needed}**"
            pmi = f"{row.datums_right}/{row.datums}, {row.read}/{row.tolerances}"
            lines.append(
                f"| {row.file} | {row.faces} | {row.features} | {row.compounds} | "
                f"{row.locks}{ok} | {row.runner_up or '–'} | "
                f"{pmi if row.tolerances or row.datums else ''} |"
            )
    lines += ["", "What is not as it should be:", ""]
    lines += [f"- {row.file}: {'; '.join(said)}" for row in rows if (said := wrong(row))]
    without = [row for row in rows if row.status != "done" or not row.features]
    lines += ["", "Without features:", ""]
    lines += [f"- {r.file}: {r.status if r.status != 'done' else 'no surface'}" for r in without]
    return lines


def wrong(row: Row) -> list[str]:
    """What of a file's figures is not as it should be."""
    said = {
        "faces in no feature, or in several": row.amiss,
        f"of {row.diameters} diameters off, by up to {row.worst_mm:.2g} mm": row.diameters_off,
        f"of {row.datums} datum features not as their exact surfaces": row.datums
        - row.datums_right,
        f"of {row.tolerances} magnitudes not read": row.tolerances - row.read,
        "tolerances called not allowed": row.refused,
        f"of {row.of_cad} features and compounds of the CAD surfaces not found": row.of_cad
        - row.alike,
    }
    return [f"{count} {what}" for what, count in said.items() if count]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("files", type=Path, nargs="+", metavar="FILE")
    parser.add_argument("--recognised", action="store_true", help="regions of the pipeline")
    parser.add_argument(
        "--limit", type=float, default=120.0, help="seconds of CPU time a file; 120"
    )
    parser.add_argument("--docs", type=Path, metavar="FILE.md", help="renew the figures there")
    args = parser.parse_args()
    rows = []
    for path in sorted(args.files, key=lambda path: path.name.lower()):
        rows.append(_isolated(path, args.limit, recognised=args.recognised))
        print(rows[-1], flush=True)
    lines = markdown(rows, recognised=args.recognised)
    if args.docs:
        renew(args.docs, "recognised" if args.recognised else "cad", lines)
    print("\n".join(sums(rows)))
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
