# SPDX-License-Identifier: LGPL-2.1-or-later
"""PMI that files hold against what is recognised: ``python benchmarks/pmi_review.py FILES``.

For each file: every datum feature that resolves to faces, its class from recognition and from the
exact surfaces of its faces, and whether the recognised features cover the same faces; tolerances
whose magnitude was read; characteristics that would be called not allowed.
"""

from __future__ import annotations

import sys
from pathlib import Path

from gpswb.batch.one_part import examine
from gpswb.batch.settings import Settings
from gpswb.cad.density import Density
from gpswb.cad.solid import FaceTruth
from gpswb.cli.annotate import features_of
from gpswb.cli.annotation_files import read_present
from gpswb.errors import GpswbError
from gpswb.gps.invariance_of_union import invariance_of_union
from gpswb.gps.on_faces import features_on
from gpswb.gps.review import class_of, review
from gpswb.gps.twists import Frame, SituationFeature, vector


def say(line: str) -> None:
    sys.stdout.write(line + "\n")
    sys.stdout.flush()


def exact_class(truths: list[FaceTruth], frame: Frame) -> str:
    """Class of the union of the faces' exact surfaces."""
    places = []
    for truth in truths:
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


def one(path: Path) -> bool:
    outcome = examine(path, Settings(Density("auto"), "robust", "hybrid", "ocp"))
    table = features_of(outcome)
    present, note = read_present(path, outcome.solid)
    if present is None:
        say(f"{path.name}: {note or 'no PMI'}")
        return True
    truth = {face.name: face.truth for face in outcome.solid.facemap.faces}
    resolved = [datum for datum in present.datums if datum.faces]
    good = 0
    for datum in resolved:
        features, _ = features_on(table.features, datum.faces)
        exact = exact_class([truth[name] for name in datum.faces], table.frame)
        found = class_of(features, table) if features else "nothing"
        covered = {name for feature in features for name in feature.faces}
        same = covered == set(datum.faces)
        good += exact == found and same
        if exact != found or not same:
            say(f"  datum {datum.letter} {datum.faces}: exact {exact}, recognised {found}, "
                f"{[f.name for f in features]} cover {sorted(covered)}")  # fmt: skip
    read = sum(each.value is not None and each.value > 0 for each in present.tolerances)
    refused = [remark for remark in review(present, table) if "not allowed" in remark.text]
    for remark in refused:
        say(f"  {remark.subject}: {remark.text}")
    say(
        f"{path.name}: {good} of {len(resolved)} datum features on faces have the exact class and "
        f"faces ({len(present.datums)} datums in all); {read} of {len(present.tolerances)} "
        f"magnitudes read; {len(refused)} tolerances called not allowed"
    )
    return good == len(resolved) and read == len(present.tolerances) and not refused


def main(paths: list[str]) -> int:
    good = 0
    for path in paths:
        try:
            good += one(Path(path))
        except GpswbError as error:
            say(str(error))
    say(f"{good} of {len(paths)} files as they should be")
    return 0 if good == len(paths) else 1


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
