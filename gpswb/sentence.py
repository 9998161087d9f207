# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences for people: English text that remembers how it was made.

The layers below the window write English, in files, reports and on the terminal. The window says
the same in its user's language: it translates what a sentence was made of.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, Self


class Sentence(str):
    """A text made of a template and values; to everybody else it is plain English text.

    Args:
        template: English, as for `str.format`, with named fields. It is what is translated, so it
            must stand in the code as a literal.
        values: what stands in the fields; they may be sentences.
    """

    template: str
    values: dict[str, Any]

    def __new__(cls, template: str, /, **values: Any) -> Self:
        """Make the English text."""
        made = super().__new__(cls, template.format(**values))
        made.template, made.values = template, values
        return made

    def __getnewargs_ex__(self) -> tuple[tuple[str], dict[str, Any]]:
        """Copies and pickles are made of the template, too."""
        return (self.template,), self.values

    def __str__(self) -> str:
        """Itself: an error of this text says a sentence."""
        return self

    def said(self, translate: Callable[[str], str]) -> str:
        """The text in another language.

        Args:
            translate: gives the translated template, with the same fields.
        """
        values = {
            name: value.said(translate) if isinstance(value, Sentence) else value
            for name, value in self.values.items()
        }
        return translate(self.template).format(**values)


def joined(separator: str, parts: Iterable[str]) -> Sentence:
    """Texts with a separator, which holds no word, between them."""
    values = {f"part{i}": part for i, part in enumerate(parts)}
    return Sentence(separator.join(f"{{{name}}}" for name in values), **values)


def packed(text: str) -> Any:
    """A text as values that JSON can hold; see `unpacked`."""
    if not isinstance(text, Sentence):
        return str(text)
    values = {k: packed(v) if isinstance(v, str) else v for k, v in text.values.items()}
    plain = (str, int, float, list)
    return [text.template, {k: v if isinstance(v, plain) else str(v) for k, v in values.items()}]


def unpacked(entry: Any) -> str:
    """The text that `packed` took."""
    if isinstance(entry, list):
        template, values = entry
        return Sentence(template, **{name: unpacked(value) for name, value in values.items()})
    return entry  # type: ignore[no-any-return]
