# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every text has its German one, in the file that FreeCAD loads."""

import ast
import sys
from pathlib import Path
from typing import get_args

import FreeCADGui
from window import settle

import gpswb.gui
from gpswb.cad.kernel import SurfaceKind
from gpswb.core.invariance import CLASSES
from gpswb.errors import GpswbError
from gpswb.gui.colouring import AGREEMENT, COLOUR_BY, CONSTRAINT
from gpswb.gui.compat import QtCore
from gpswb.gui.exports import FORMATS
from gpswb.gui.words import WORDS
from gpswb.io.colours import SHAPE_TYPES

ERRORS = [each.__name__ for each in GpswbError.__subclasses__()]
FOLDER = Path(gpswb.gui.__file__).parent / "translations"
sys.path.append(str(FOLDER))

import update  # noqa: E402 - the tool that stands beside the files


def test_the_template_is_that_of_the_code():
    path = FOLDER / "gpswb.ts"
    before = path.read_text(encoding="utf-8")
    try:
        update.write(path, "en", {})
        assert path.read_text(encoding="utf-8") == before, "run translations/update.py"
    finally:
        path.write_text(before, encoding="utf-8")


def test_german_is_complete_and_compiled():
    known = update.translations(FOLDER / "gpswb_de.ts")
    translator = QtCore.QTranslator()
    assert translator.load(str(FOLDER / "gpswb_de.qm"))
    for context, source in update.texts():
        assert (context, source) in known, source
        assert translator.translate(context, source) == known[context, source]


def test_errors_of_the_window_and_its_logic_are_sentences():
    """Only so can the window say them in the user's language."""
    plain = []
    for package in ("gui", "gps"):
        for path in sorted((FOLDER.parents[1] / package).rglob("*.py")):
            for node in ast.walk(ast.parse(path.read_text("utf-8"))):
                raised = node.exc if isinstance(node, ast.Raise) else None
                if isinstance(raised, ast.Call) and raised.func.id in ERRORS:
                    said = raised.args[0]
                    if isinstance(said, ast.Constant | ast.JoinedStr):
                        plain.append(f"{path.name}:{node.lineno}")
    assert plain == []


def test_words_of_other_packages_are_listed():
    rows = [name for name, _ in (*AGREEMENT, *CONSTRAINT, *SHAPE_TYPES)]
    kinds = [kind for kind, _ in FORMATS.values()]
    needed = {*CLASSES, *COLOUR_BY, *get_args(SurfaceKind), *rows, *kinds}
    assert needed <= set(WORDS)


def test_the_window_in_german():
    try:
        FreeCADGui.setLocale("German")
        settle()
        window = FreeCADGui.getMainWindow()
        (menu,) = (a for a in window.menuBar().actions() if a.text().replace("&", "") == "GPS")
        texts = [action.text().replace("&", "") for action in menu.menu().actions()]
        assert "Partitionieren…" in texts
    finally:
        FreeCADGui.setLocale("English")
        settle()
