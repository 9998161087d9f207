# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pages without scripts: a heading, tables, pictures; self-contained and offline."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from importlib import resources

from gpswb.io.colours import WHEEL
from gpswb.report.corpus_tables import Table

POLICY = "default-src 'none'; style-src 'unsafe-inline'; img-src data:"
"""Content security policy: the page runs no script and loads nothing."""


@dataclass(frozen=True)
class Figure:
    """A picture, PNG, with its caption."""

    caption: str
    png: bytes


def static_page(title: str, body: Sequence[str]) -> str:
    """A whole page.

    Args:
        title: plain text.
        body: pieces of HTML, escaped already.
    """
    style = resources.files("gpswb.report").joinpath("corpus_page.css").read_text("utf-8")
    heading = escape(title)
    head = [
        '<meta charset="utf-8">',
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">',
        f"<title>{heading}</title>",
        f"<style>{style}</style>",
    ]
    content = f"<h1>{heading}</h1>{''.join(body)}"
    inside = f"<head>{''.join(head)}</head>\n<body><main>{content}</main></body>"
    return f'<!doctype html>\n<html lang="en">{inside}</html>\n'


def table_html(table: Table) -> str:
    """A table under its title."""
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


def legend_html() -> str:
    """The colours of the classes, with their names."""
    items = (
        f'<li><span style="background:rgb{colour}"></span>{escape(name)}</li>'
        for name, colour in WHEEL.items()
    )
    return f'<ul class="legend">{"".join(items)}</ul>'


def figures_html(figures: Sequence[Figure]) -> str:
    """Pictures with their captions."""
    items = []
    for figure in figures:
        caption = escape(figure.caption, quote=True)
        data = base64.b64encode(figure.png).decode("ascii")
        image = f'<img alt="{caption}" src="data:image/png;base64,{data}">'
        items.append(f"<figure>{image}<figcaption>{caption}</figcaption></figure>")
    return f'<div class="pictures">{"".join(items)}</div>'
