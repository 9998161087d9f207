# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html of a run over many parts: one self-contained offline page."""

from __future__ import annotations

import base64
from collections.abc import Mapping, Sequence
from html import escape
from importlib import resources

from gpswb.io.colours import WHEEL
from gpswb.report.corpus_tables import (
    Table,
    confusion_table,
    counts_sentence,
    figures_table,
    kinds_table,
    parts_table,
    recall_table,
)
from gpswb.validation.corpus import PartRow

POLICY = "default-src 'none'; style-src 'unsafe-inline'; img-src data:"
"""Content security policy: the page runs no script and loads nothing."""


def corpus_page(
    rows: Sequence[PartRow], title: str, command: str, pictures: Mapping[str, bytes]
) -> str:
    """The page: totals, failures by kind, recall, confusion, pictures of the worst, all parts.

    Args:
        rows: one a file.
        title: of the run.
        command: that made it.
        pictures: PNG by the part's name, the worst part first.
    """
    style = resources.files("gpswb.report").joinpath("corpus_page.css").read_text("utf-8")
    by_name = {row.name: row for row in rows}
    figures = [_figure(by_name[name], png) for name, png in pictures.items()]
    heading = f"Validation: {escape(title)}"
    body = [
        f"<h1>{heading}</h1>",
        f"<p><code>{escape(command)}</code></p>",
        f"<p>{escape(counts_sentence(rows))}</p>",
        *(_table(make(rows)) for make in (figures_table, kinds_table)),
        "<h2>The worst parts</h2>",
        "<p>Left the truth, right what was recognised; wrong faces outlined.</p>",
        _legend(),
        f'<div class="pictures">{"".join(figures)}</div>',
        *(_table(make(rows)) for make in (recall_table, confusion_table, parts_table)),
    ]
    head = [
        '<meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">',
        f"<title>{heading}</title>",
        f"<style>{style}</style>",
    ]
    inside = f"<head>{''.join(head)}</head>\n<body><main>{''.join(body)}</main></body>"
    return f'<!doctype html>\n<html lang="en">{inside}</html>\n'


def _table(table: Table) -> str:
    cells = "".join(f'<th scope="col">{escape(name)}</th>' for name in table.head)
    rows = "".join(
        f'<tr><th scope="row">{escape(first)}</th>'
        + "".join(f"<td{_numeric(text)}>{escape(text)}</td>" for text in rest)
        + "</tr>"
        for first, *rest in table.rows
    )
    inside = f"<thead><tr>{cells}</tr></thead><tbody>{rows}</tbody>"
    return f'<h2>{escape(table.title)}</h2><div class="wide"><table>{inside}</table></div>'


def _numeric(text: str) -> str:
    return ' class="n"' if text[:1].isdigit() and len(text) < 24 else ""


def _legend() -> str:
    items = (
        f'<li><span style="background:rgb{colour}"></span>{escape(name)}</li>'
        for name, colour in WHEEL.items()
    )
    return f'<ul class="legend">{"".join(items)}</ul>'


def _figure(row: PartRow, png: bytes) -> str:
    figures = row.figures
    caption = f"{row.name}: {figures['right_faces']} of {figures['judged_faces']} faces right"
    data = base64.b64encode(png).decode("ascii")
    return (
        f'<figure><img alt="{escape(caption, quote=True)}" src="data:image/png;base64,{data}">'
        f"<figcaption>{escape(caption)}</figcaption></figure>"
    )
