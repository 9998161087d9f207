# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nothing that the panels show stays English: a made-up language changes every letter.

Its translation of a text is that text in full-width letters. An ASCII letter that is then seen is
either a name or a unit, or was never given to the translator.
"""

import re
from html import unescape

import FreeCADGui
import pytest
from test_partition_panel import CLASS_OF, true_classes
from window import settle

from gpswb.errors import InputError
from gpswb.gui import compat
from gpswb.gui.colouring import COLOUR_BY
from gpswb.gui.compat import QtCore, QtWidgets
from gpswb.gui.datums import set_datums
from gpswb.gui.exports import export
from gpswb.gui.importing import import_part
from gpswb.gui.objects.partition import add_override
from gpswb.gui.panels.annotate import AnnotatePanel
from gpswb.gui.panels.datums import DatumsPanel
from gpswb.gui.panels.legend import show_legend
from gpswb.gui.panels.partition import PartitionPanel
from gpswb.gui.panels.query import QueryPanel
from gpswb.gui.panels.show import show_panel
from gpswb.gui.panels.sweep import SweepPanel
from gpswb.gui.panels.validate import ValidatePanel
from gpswb.gui.specifications import add_specification

SAME_EVERYWHERE = (
    r"(Face|Region)\d+",  # FreeCAD's names of faces
    r"Block",  # the part's own name
    r"mm|cm|H7|[Xx]",  # units, a tolerance class, a count
    r"[A-F](?![a-z])",  # datum letters
    r"[MLRXYZN](?![a-z])",  # modifiers, axes, a number
    r"e[-+]\d+",  # of a number
    r"silly|wrong|part\.doc|/no/such\.step",  # what the test gives as input
    r"auto|coarse|medium|fine|turn=N|edge=MM|vertices=N|triangles=N|deflection=MM|DEGREES|stl",
    r"brepmesh\+refine|gmsh",
    r"\.[a-z0-9.]+",  # suffixes of files
    r"ISO|GPS|QIF|AP242|PMI|CSV|Ok|Cancel|Close",  # Qt translates its own buttons
)


class _FullWidth(QtCore.QTranslator):
    def translate(self, context, source, *_):
        def widen(match):
            return "".join(chr(ord(c) + 0xFEE0) if c.isalpha() else c for c in match.group())

        # Fields and HTML's tags stay.
        parts = re.split(r"({[^}]*}|<[^>]*>)", str(source))
        return "".join(
            part if i % 2 else re.sub("[A-Za-z]+", widen, part) for i, part in enumerate(parts)
        )


@pytest.fixture
def full_width():
    language = _FullWidth()
    QtCore.QCoreApplication.installTranslator(language)
    yield
    QtCore.QCoreApplication.removeTranslator(language)


def english(text):
    """The ASCII letters of a text that are no names, as they stand."""
    text = unescape(re.sub("</?[a-z][^>]*>", " ", text))
    for known in SAME_EVERYWHERE:
        text = re.sub(rf"(?<![A-Za-z]){known}(?![A-Za-z])", "", text)
    return text if re.search("[A-Za-z]", text) else ""


def texts_in(widget):
    """All that a widget and those in it say, seen or not yet."""
    for each in [widget, *widget.findChildren(QtWidgets.QWidget)]:
        yield each.toolTip()
        if isinstance(each, QtWidgets.QLabel | QtWidgets.QAbstractButton):
            yield each.text()
        elif isinstance(each, QtWidgets.QGroupBox):
            yield each.title()
        elif isinstance(each, QtWidgets.QLineEdit):
            yield each.placeholderText()
        elif isinstance(each, QtWidgets.QComboBox):
            yield from (each.itemText(i) for i in range(each.count()))
        elif isinstance(each, QtWidgets.QListWidget):
            yield from (each.item(i).text() for i in range(each.count()))
        elif isinstance(each, QtWidgets.QTableWidget):
            heads = [each.horizontalHeaderItem(i) for i in range(each.columnCount())]
            cells = [
                each.item(i, j) for i in range(each.rowCount()) for j in range(each.columnCount())
            ]
            yield from (item.text() for item in [*heads, *cells] if item is not None)
    yield widget.windowTitle()


def left_in(widget):
    settle(0.1)
    return sorted({found for text in texts_in(widget) if (found := english(text))})


def select(block, *names):
    FreeCADGui.Selection.clearSelection()
    for name in names:
        FreeCADGui.Selection.addSelection(block, name)
    settle(0.1)


def test_the_made_up_language_finds_what_is_not_translated(full_width):
    shown = compat.translate("GPS", "Partition")
    assert english(shown) == ""
    assert english(f"{shown} of Face3") != ""


def test_panels(block, partition, full_width):
    left = {}
    select(block, "Face1", "Face2")
    panels = (
        lambda: PartitionPanel(source=block),
        lambda: PartitionPanel(partition=partition),
        lambda: QueryPanel(partition),
        lambda: ValidatePanel(partition),
        lambda: SweepPanel(block),
    )
    for make in panels:
        panel = make()
        show_panel(panel)
        select(block, "Face1", "Face2")
        left[type(panel).__name__] = left_in(panel.form)
        panel.reject()
    assert left == {name: [] for name in left}


def test_datums(block, partition, full_width):
    panel = DatumsPanel(partition)
    show_panel(panel)
    left = left_in(panel.form)
    for rank in (0, 1):
        panel.suggest(rank)
        left += left_in(panel.form)
    for notation in ("A-B|C><", "A|B", "A", "silly", "A|F"):
        panel.notation.setText(notation)
        left += left_in(panel.form)
    panel.reject()
    assert left == []


def test_specifications(block, partition, full_width):
    left = []
    for datums in ([], [("A", ["Face1"]), ("B", ["Face2"]), ("C", ["Face5"])]):
        set_datums(partition, datums)
        panel = AnnotatePanel(partition)
        show_panel(panel)
        left += left_in(panel.form)
        for kind in CLASS_OF.values():
            select(block, f"Face{true_classes(block).index(kind) + 1}")
            for k in range(panel.features.count()):
                panel.features.setCurrentIndex(k)
                for name in panel.grid.buttons:
                    panel.grid.choose(name)
                    for value in ("0.1", "silly", "-1"):
                        panel.value.setText(value)
                        panel.upper.setText(value)
                        assert "&" not in panel.message.text()  # no HTML where none is shown
                        left += [text for label in (panel.reason, panel.message)
                                 if (text := english(label.text()))]  # fmt: skip
                left += left_in(panel.form)
        panel.reject()
    assert sorted(set(left)) == []


def test_legend(block, partition, full_width):
    legend = show_legend()
    left = []
    for by in COLOUR_BY:
        partition.ViewObject.ColourBy = by
        settle(0.1)
        legend.refresh()
        left += left_in(legend.widget())
    assert left == []


def test_labels_in_the_tree(block, partition, full_width):
    set_datums(partition, [("A", ["Face1"])])
    add_specification(partition, ["Face2"], "perpendicularity", 0.1, "A")
    made = [obj.Label for obj in partition.Group if hasattr(obj, "Annotation")]
    assert [english(label) for label in made] == [""] * 3


def test_errors(block, partition, full_width, tmp_path):
    wrong = (
        lambda: add_override(partition, "merge", ["Face1"]),
        lambda: add_override(partition, "split", ["Face99"]),
        lambda: export(partition, tmp_path / "part.doc"),
        lambda: import_part(tmp_path.__class__("/no/such.step"), block.Document),
        lambda: add_specification(partition, ["Face1"], "silly"),
        lambda: add_specification(partition, ["Face1"], "flatness", -1.0),
        lambda: add_specification(partition, ["Face1"], "flatness", 0.1, "A"),
        lambda: set_datums(partition, [("A", ["Face1"])], "wrong"),
    )
    left = []
    for call in wrong:
        with pytest.raises(InputError) as caught:
            call()
        left.append(english(compat.say(str(caught.value))))
    assert left == [""] * len(wrong)
