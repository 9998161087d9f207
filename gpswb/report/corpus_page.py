# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html of a run over many parts: one self-contained offline page."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from gpswb.report.corpus_tables import (
    confusion_table,
    counts_sentence,
    figures_table,
    kinds_table,
    parts_table,
    recall_table,
)
from gpswb.report.static_page import Figure, figures_html, legend_html, static_page, table_html
from gpswb.validation.corpus import PartRow


def corpus_page(
    rows: Sequence[PartRow],
    title: str,
    command: str,
    kinds: Sequence[Figure],
    worst: Sequence[Figure],
) -> str:
    """The page: totals, failures by kind, recall, confusion, pictures of the worst, all parts.

    Args:
        rows: one a file.
        title: of the run.
        command: that made it.
        kinds: close-ups of each kind of failure.
        worst: pictures of the worst parts, the worst first.
    """
    body = [
        f"<p><code>{escape(command)}</code></p>",
        f"<p>{escape(counts_sentence(rows))}</p>",
        *(table_html(make(rows)) for make in (figures_table, kinds_table)),
        "<h2>Each kind, close up</h2>",
        "<p>The truth, the classes recognised, the regions; the face in question outlined.</p>",
        legend_html(),
        figures_html(kinds),
        "<h2>The worst parts</h2>",
        "<p>The truth, the classes recognised, the regions; wrong faces outlined.</p>",
        figures_html(worst),
        *(table_html(make(rows)) for make in (recall_table, confusion_table, parts_table)),
    ]
    return static_page(f"Validation: {title}", body)
