# SPDX-License-Identifier: LGPL-2.1-or-later
"""The annotation of a partition: its GPS features with the datums and specifications on them.

`gpswb.gui.datums` and `gpswb.gui.specifications` make these.
"""

from __future__ import annotations

from typing import Any

from gpswb.gps.annotation import Annotation, annotate
from gpswb.gui.annotation_rows import specification_rows
from gpswb.gui.annotation_state import refresh_annotations
from gpswb.gui.part_features import features_of
from gpswb.gui.partition_result import effective_result, stored_datums


def annotation_of(partition: Any) -> Annotation:
    """GPS features, datum system and specifications of a partition, as `gpswb annotate` has them.

    Raises:
        InputError: it has no result, or an annotation doesn't fit the part.
    """
    stored, _ = effective_result(partition)
    rows = specification_rows(partition)
    return annotate(features_of(stored), stored_datums(partition), rows, partition.DatumSystem)


def remove_annotation(partition: Any, obj: Any) -> None:
    """Remove an annotation; of a datum that specifications refer to, they say so afterwards."""
    partition.Document.removeObject(obj.Name)
    refresh_annotations(partition)
