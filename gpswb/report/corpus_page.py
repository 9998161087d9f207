# SPDX-License-Identifier: LGPL-2.1-or-later
"""report.html of a run over many parts: one self-contained offline page."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from dataclasses import dataclass
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


@dataclass(frozen=True)
class Figure:
    """A picture, PNG, with its caption."""

    caption: str
    png: bytes


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
    style = resources.files("gpswb.report").joinpath("corpus_page.css").read_text("utf-8")
    heading = f"Validation: {escape(title)}"
    body = [
        f"<h1>{heading}</h1>",
        f"<p><code>{escape(command)}</code></p>",
        f"<p>{escape(counts_sentence(rows))}</p>",
        *(_table(make(rows)) for make in (figures_table, kinds_table)),
        "<h2>Each kind, close up</h2>",
        "<p>The truth, the classes recognised, the regions; the face in question outlined.</p>",
        _legend(),
        _figures(kinds),
        "<h2>The worst parts</h2>",
        "<p>The truth, the classes recognised, the regions; wrong faces outlined.</p>",
        _figures(worst),
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


def _figures(figures: Sequence[Figure]) -> str:
    items = []
    for figure in figures:
        caption = escape(figure.caption, quote=True)
        data = base64.b64encode(figure.png).decode("ascii")
        image = f'<img alt="{caption}" src="data:image/png;base64,{data}">'
        items.append(f"<figure>{image}<figcaption>{caption}</figcaption></figure>")
    return f'<div class="pictures">{"".join(items)}</div>'
