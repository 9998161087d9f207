# SPDX-License-Identifier: LGPL-2.1-or-later
"""Specifications of a partition, as document objects.

    from gpswb.gui.specifications import add_specification
    add_specification(partition, ["Face7"], "perpendicularity", value=0.1, datums="A")

It works without a window. What doesn't fit the part is refused and leaves the document as it was.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from gpswb.gps.annotation import annotate
from gpswb.gui.annotation_record import SpecificationRecord
from gpswb.gui.annotation_rows import choice_of
from gpswb.gui.annotation_state import refresh_annotations
from gpswb.gui.face_keys import named_faces
from gpswb.gui.objects.annotation import put_annotation
from gpswb.gui.part_features import features_of
from gpswb.gui.partition_result import effective_result, stored_datums
from gpswb.io.specification_file import specification_row


def add_specification(
    partition: Any,
    faces: Sequence[str],
    characteristic: str,
    value: float | str = "?",
    datums: str = "",
    **words: float | str,
) -> Any:
    """Put a specification on the feature that the faces make up.

    Args:
        faces: names.
        characteristic: of ISO 1101, or ``size``.
        value: width or diameter of the zone, mm; "?" is open.
        datums: datum section, as ``A|B``.
        words: ``modifiers`` (M, L, R), ``upper``, ``lower``, ``fit``, as for ``--specs``.

    Raises:
        InputError: it can't be said of that feature, or a datum isn't there.
    """
    return set_specification(
        partition, None, faces, characteristic=characteristic, value=value, datums=datums, **words
    )


def set_specification(partition: Any, obj: Any, faces: Sequence[str], **words: float | str) -> Any:
    """Change a specification, or with None for it add one; see `add_specification`.

    Raises:
        InputError: it can't be said of that feature, or a datum isn't there.
    """
    stored, _ = effective_result(partition)
    record = SpecificationRecord(
        named_faces(stored, faces), {name: str(value) for name, value in words.items()}
    )
    row = specification_row("specification", {"feature": choice_of(record.faces), **record.words})
    annotate(features_of(stored), stored_datums(partition), [row], partition.DatumSystem)
    obj = put_annotation(partition, obj, record)
    refresh_annotations(partition)
    return obj
