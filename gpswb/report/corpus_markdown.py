# SPDX-License-Identifier: LGPL-2.1-or-later
"""The section of docs/validation.md for one run over many parts."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from gpswb.errors import OutputError
from gpswb.report.corpus_tables import (
    confusion_table,
    counts_sentence,
    figures_table,
    kinds_table,
    parts_table,
    recall_table,
)
from gpswb.validation.corpus import PartRow


def corpus_section(rows: Sequence[PartRow], title: str, command: str) -> str:
    """Markdown of one run: totals, failures by kind, recall, confusion, a row a part."""
    figures = figures_table(rows)
    lines = [f"## {title}", "", f"Made by `{command.replace('`', '')}`.", ""]
    lines += [counts_sentence(rows), "", *_table(figures.head, figures.rows), ""]
    for make in (kinds_table, recall_table, confusion_table, parts_table):
        table = make(rows)
        lines += [f"### {table.title}", "", *_table(table.head, table.rows), ""]
    return "\n".join(lines)


def renew_section(document: str, title: str, section: str) -> str:
    """Replace the section between the markers of ``title``, or append it with markers.

    Raises:
        OutputError: the markers are there but do not pair.
    """
    begin, end = f"<!-- gpswb:begin {title} -->", f"<!-- gpswb:end {title} -->"
    block = f"{begin}\n{section}{end}"
    if begin not in document and end not in document:
        gap = "" if not document or document.endswith("\n\n") else "\n"
        return f"{document}{gap}{block}\n"
    head, _, rest = document.partition(begin)
    tail = rest.partition(end)[2]
    if document.count(begin) != 1 or document.count(end) != 1 or end in head:
        raise OutputError(f"the markers of {title!r} in the document do not pair")
    return head + block + tail


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    """A Markdown table; cells can hold any text."""
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    return lines + ["| " + " | ".join(map(_cell, row)) + " |" for row in rows]


def _cell(text: str) -> str:
    for special in "&|<>`*[\\":  # the ampersand first: the others turn into one
        text = text.replace(special, f"&#{ord(special)};")
    return " ".join(text.split())
