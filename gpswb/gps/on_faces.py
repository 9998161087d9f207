# SPDX-License-Identifier: LGPL-2.1-or-later
"""The features that a choice of B-rep faces, or of names in the feature table, means."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from difflib import get_close_matches

from gpswb.errors import InputError
from gpswb.gps.gps_feature import GpsFeature
from gpswb.sentence import Sentence


def features_on(
    features: Sequence[GpsFeature], faces: Iterable[str]
) -> tuple[tuple[GpsFeature, ...], tuple[str, ...]]:
    """Features that a set of faces means, and the faces of the set that are in no feature.

    A compound whose faces are exactly these is that compound (two opposed planes: the slot);
    otherwise the integral features that the faces belong to, by falling area. A face stands for
    the whole of its maximal feature: half a split hole means the hole.
    """
    wanted = set(faces)
    for feature in features:
        if feature.kind != "integral" and wanted and set(feature.faces) == wanted:
            return (feature,), ()
    integral = [f for f in features if f.kind == "integral" and wanted.intersection(f.faces)]
    known = {name for feature in integral for name in feature.faces}
    return tuple(integral), tuple(sorted(wanted - known))


def with_hint(said: Sentence, near: Sequence[str]) -> Sentence:
    """A sentence on a wrong word, with what may have been meant."""
    return Sentence("{said}; did you mean {word!r}?", said=said, word=near[0]) if near else said


def chosen_features(features: Sequence[GpsFeature], text: str) -> tuple[GpsFeature, ...]:
    """Features of a choice as ``Face5+Face6`` or ``Hole 2``.

    Raises:
        InputError: a name is neither a feature nor a face in one.
    """
    by_name = {feature.name.casefold(): feature for feature in features}
    named: list[GpsFeature] = []
    faces: list[str] = []
    for word in (part.strip() for part in text.split("+")):
        feature = by_name.get(word.casefold())
        if feature is not None:
            named.append(feature)
        else:
            faces.append(word)
    found, unknown = features_on(features, faces)
    if unknown:
        known = [*(f.name for f in features), *(name for f in features for name in f.faces)]
        near = get_close_matches(unknown[0], known, 1)
        wrong: str = Sentence("{word!r}", word=unknown[0])
        if unknown[0] != text.strip():
            wrong = Sentence("{word!r} in {text!r}", word=unknown[0], text=text)
        said = Sentence("{wrong} is neither a feature nor a face of one", wrong=wrong)
        raise InputError(with_hint(said, near))
    return tuple(dict.fromkeys([*named, *found]))
