# SPDX-License-Identifier: LGPL-2.1-or-later
"""Renew the translation files from the texts in the code; translations that are there stay.

    .venv/bin/python gpswb/gui/translations/update.py && lrelease gpswb/gui/translations/*_*.ts

Qt's own tools for Python lose texts that stand on a line of their own, and letters beyond ASCII.
"""

from __future__ import annotations

import ast
import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from pathlib import Path

FOLDER = Path(__file__).parent
LANGUAGES = ("de",)
_MARKS = ("translate", "QT_TRANSLATE_NOOP")
_PACKAGES = FOLDER.parents[1]
_NOT_SHOWN = ("cli", "batch", "report")
"""Packages of whose sentences the window shows none."""
Text = tuple[str, str]
"""Context and source text."""


def texts() -> list[Text]:
    """Every text that the window shows, in order of context."""
    found: dict[Text, None] = {}
    for path in sorted(_PACKAGES.rglob("*.py")):
        if path.relative_to(_PACKAGES).parts[0] not in _NOT_SHOWN:
            found.update(dict.fromkeys(_sentences(path)))
    for path in sorted(FOLDER.parent.rglob("*.py")):
        found.update(dict.fromkeys(_in_code(path)))
    for path in sorted(FOLDER.parent.rglob("*.ui")):
        found.update(dict.fromkeys(_in_form(path)))
    return sorted(found)


def _in_code(path: Path) -> Iterator[Text]:
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") in _MARKS:
            values = [arg.value if isinstance(arg, ast.Constant) else None for arg in node.args]
            if len(values) == 2 and all(isinstance(value, str) for value in values):
                yield str(values[0]), str(values[1])


def _sentences(path: Path) -> Iterator[Text]:
    """Templates of `Sentence` that hold words."""
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "Sentence":
            template = node.args[0].value if isinstance(node.args[0], ast.Constant) else ""
            if any(c.isalpha() for c in re.sub(r"{[^}]*}", "", str(template))):
                yield "GPS", str(template)


def _in_form(path: Path) -> Iterator[Text]:
    root = ET.parse(path).getroot()  # noqa: S314 - our own form
    context = root.findtext("class") or ""
    for element in root.iter("string"):
        if element.text and element.text.strip():
            yield context, element.text


def translations(path: Path) -> dict[Text, str]:
    """Finished translations of a .ts file."""
    found = {}
    for context in ET.parse(path).getroot().iter("context"):  # noqa: S314 - our own file
        for message in context.iter("message"):
            made = message.find("translation")
            if made is not None and made.text and made.get("type") != "unfinished":
                source = message.findtext("source") or ""
                found[context.findtext("name") or "", source] = made.text
    return found


def write(path: Path, language: str, known: dict[Text, str]) -> None:
    """Write a .ts file with a message for each text."""
    root = ET.Element("TS", version="2.1", sourcelanguage="en", language=language)
    contexts: dict[str, ET.Element] = {}
    for context, source in texts():
        if context not in contexts:
            contexts[context] = ET.SubElement(root, "context")
            ET.SubElement(contexts[context], "name").text = context
        message = ET.SubElement(contexts[context], "message")
        ET.SubElement(message, "source").text = source
        made = ET.SubElement(message, "translation")
        made.text = known.get((context, source))
        if made.text is None:
            made.set("type", "unfinished")
    ET.indent(root)
    text = ET.tostring(root, encoding="unicode")
    head = '<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n'
    path.write_text(f"{head}{text}\n", encoding="utf-8")


def main() -> None:
    """Write the template and every language."""
    write(FOLDER / "gpswb.ts", "en", {})
    for language in LANGUAGES:
        path = FOLDER / f"gpswb_{language}.ts"
        write(path, language, translations(path) if path.exists() else {})


if __name__ == "__main__":
    main()
