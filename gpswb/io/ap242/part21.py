# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entities of a Part 21 file (ISO 10303-21), found without disturbing its text."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

from gpswb.errors import InputError
from gpswb.io.ap242.strings import decode

_COMMENT = r"/\*[\s\S]*?\*/"
_GAP = re.compile(rf"(?:\s|{_COMMENT})*")
_STOP = re.compile(rf"'[^']*'|\"[^\"]*\"|{_COMMENT}|;")
"""What to step over in search of the semicolon that ends a statement."""
_NUMBERED = re.compile(rf"#(\d{{1,18}})(?:\s|{_COMMENT})*=")
_TOKEN = re.compile(
    rf"(?P<gap>\s+|{_COMMENT})"
    r"|(?P<string>'[^']*(?:''[^']*)*')"
    r"|(?P<reference>#\d{1,18})"
    r"|(?P<number>[+-]?\d+(?:\.\d*(?:[Ee][+-]?\d+)?)?)"
    r"|(?P<enumeration>\.\w+\.)"
    r"|(?P<keyword>!?[A-Za-z_]\w*)"
    r"|(?P<binary>\"[0-9A-Fa-f]*\")"
    r"|(?P<sign>[(),$*])"
)
_DEEPEST = 60


class Ref(int):
    """Reference to an entity by its number."""


class Word(str):
    """An enumeration value without its dots; ``*`` for a derived attribute."""

    __slots__ = ()


@dataclass(frozen=True)
class Typed:
    """A typed parameter as ``LENGTH_MEASURE(25.4)``."""

    keyword: str
    parameters: tuple[Value, ...]


Value = Ref | Word | Typed | str | float | int | None | tuple["Value", ...]
Record = Mapping[str, tuple[Value, ...]]
"""Parameters by keyword: one for a simple entity, several for a complex one."""


class Part21:
    """The text of a file and its entities.

    Args:
        text: of the file, bytes decoded as Latin-1 so that nothing is lost.

    Raises:
        InputError: it isn't a Part 21 file, or has no data.
    """

    def __init__(self, text: str) -> None:
        self.text = text
        self.schema: tuple[int, int] | None = None
        self.data_end = -1
        self._spans: dict[int, tuple[int, int]] = {}
        in_data = named = False
        at = 0
        for stop in _STOP.finditer(text):
            if stop[0] != ";":
                continue
            start = _after_gap(text, at)
            at = stop.end()
            numbered = _NUMBERED.match(text, start) if in_data else None
            if numbered is not None:
                self._spans.setdefault(int(numbered[1]), (numbered.end(), at - 1))
                continue
            word = text[start : start + 11].upper()
            if word.startswith("ISO-10303-"):
                named = True
            elif word == "FILE_SCHEMA":
                self.schema = start, at
            elif re.match(r"DATA\b", word):
                in_data = True
            elif in_data and word.startswith("ENDSEC"):
                in_data = False
                # With several data sections the first one takes what is added.
                self.data_end = start if self.data_end < 0 else self.data_end
        if not named or self.data_end < 0:
            raise InputError("not a STEP file with a data section")

    @property
    def highest(self) -> int:
        """The largest entity number."""
        return max(self._spans, default=0)

    def __contains__(self, number: object) -> bool:
        return number in self._spans

    def span(self, number: int) -> tuple[int, int]:
        """Where in the text an entity stands, from its equals sign to its semicolon."""
        return self._spans[number]

    def body(self, number: int) -> str:
        """Text of an entity after its equals sign."""
        start, end = self._spans[number]
        return self.text[start:end]

    @cached_property
    def _by_keyword(self) -> dict[str, list[int]]:
        found: dict[str, list[int]] = {}
        for number in self._spans:
            try:
                keywords = self.keywords(number)
            except InputError:
                continue  # what nobody asks for may be malformed
            for keyword in keywords:
                found.setdefault(keyword, []).append(number)
        return found

    def keywords(self, number: int) -> tuple[str, ...]:
        """Keywords of an entity, in upper case."""
        body = self.body(number)
        start = _after_gap(body, 0)
        if body[start : start + 1] != "(":
            match = re.match(r"!?\w+", body[start:])
            return (match[0].upper(),) if match else ()
        return tuple(self[number])

    def all_keywords(self) -> tuple[str, ...]:
        """Every keyword that the file uses."""
        return tuple(self._by_keyword)

    def of(self, *keywords: str) -> Iterator[int]:
        """Numbers of all entities with one of these keywords, in the file's order by keyword."""
        for keyword in keywords:
            yield from self._by_keyword.get(keyword, ())

    def __getitem__(self, number: int) -> Record:
        """Parameters of an entity.

        Raises:
            InputError: there is no such entity, or it is malformed.
        """
        if number not in self._spans:
            raise InputError(f"the STEP file refers to #{number}, which it doesn't hold")
        try:
            return _record(_tokens(self.body(number)))
        except (ValueError, StopIteration):
            raise InputError(f"entity #{number} of the STEP file is malformed") from None

    def get(self, number: Value, keyword: str) -> tuple[Value, ...] | None:
        """Parameters under a keyword of the entity referred to; None if it has none such."""
        if not isinstance(number, Ref) or number not in self._spans:
            return None
        if keyword not in self.keywords(number):
            return None
        return self[number].get(keyword)


def _after_gap(text: str, at: int) -> int:
    match = _GAP.match(text, at)
    return match.end() if match else at


def references(values: Iterable[Value]) -> Iterator[Ref]:
    """All references among values, however deep."""
    for value in values:
        if isinstance(value, Ref):
            yield value
        elif isinstance(value, tuple):
            yield from references(value)
        elif isinstance(value, Typed):
            yield from references(value.parameters)


def _tokens(body: str) -> Iterator[tuple[str, str]]:
    at = 0
    while at < len(body):
        match = _TOKEN.match(body, at)
        if match is None:
            raise ValueError(body[at : at + 20])
        at = match.end()
        if match.lastgroup != "gap":
            yield str(match.lastgroup), match[0]
    yield "end", ""


def _record(tokens: Iterator[tuple[str, str]]) -> dict[str, tuple[Value, ...]]:
    kind, text = next(tokens)
    if kind == "keyword":
        return {text.upper(): _opened(tokens)}
    if text != "(":
        raise ValueError(text)
    record: dict[str, tuple[Value, ...]] = {}
    while (token := next(tokens))[0] == "keyword":
        record[token[1].upper()] = _opened(tokens)
    return record


def _opened(tokens: Iterator[tuple[str, str]]) -> tuple[Value, ...]:
    if next(tokens)[1] != "(":
        raise ValueError("no parameters")
    return _list(tokens, _DEEPEST)


def _list(tokens: Iterator[tuple[str, str]], deep: int) -> tuple[Value, ...]:
    """Values up to the closing parenthesis."""
    if deep == 0:
        raise ValueError("nested too deeply")
    values: list[Value] = []
    for kind, text in tokens:
        if text == ")":
            return tuple(values)
        if text == "(":
            values.append(_list(tokens, deep - 1))
        elif kind == "keyword":
            if next(tokens)[1] != "(":
                raise ValueError(text)
            values.append(Typed(text.upper(), _list(tokens, deep - 1)))
        elif text != ",":
            values.append(_atom(kind, text))
    raise ValueError("not closed")


def _atom(kind: str, text: str) -> Value:
    if kind == "reference":
        return Ref(text[1:])
    if kind == "number":
        return float(text) if "." in text else int(text)
    if kind == "string":
        return decode(text[1:-1])
    if kind == "enumeration":
        return Word(text[1:-1].upper())
    if text == "$":
        return None
    if text == "*":
        return Word("*")
    if kind == "binary":
        return text[1:-1]
    raise ValueError(text)
