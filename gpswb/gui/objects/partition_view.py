# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a partition is seen: the source's faces coloured, or the mesh with a colour a facet."""

from __future__ import annotations

from contextlib import suppress
from typing import Any

import numpy as np
from pivy import coin

from gpswb.cad.freecad_measured import is_measurement
from gpswb.errors import GpswbError
from gpswb.gui import compat, preferences
from gpswb.gui.colouring import COLOUR_BY, Colouring, colouring
from gpswb.gui.compat import QtCore
from gpswb.gui.facet_scene import FacetScene
from gpswb.gui.facet_selection import follow_selection
from gpswb.gui.icons import icon
from gpswb.gui.objects.annotation import annotations_of
from gpswb.gui.objects.feature import features
from gpswb.gui.objects.partition import STALE, partitions
from gpswb.gui.objects.stateless import Stateless
from gpswb.gui.panels.legend import refresh_legend
from gpswb.gui.panels.watch import Slices
from gpswb.gui.partition_result import effective_result, stored_datums
from gpswb.gui.selection import chosen_faces
from gpswb.gui.source_colours import restore_colours, show_colours, watch
from gpswb.io.stored_result import StoredResult

FACES, FACETS = "Faces", "Facets"
_PROPERTIES = (
    # type, name, editor mode (0 free, 2 hidden), what it is
    ("App::PropertyEnumeration", "ColourBy", 0, "What the colours show"),
    ("App::PropertyEnumeration", "Elements", 0, "What has the colours"),
    ("App::PropertyBool", "FacetEdges", 0, "Whether facets of the shown mesh have dark edges"),
    ("App::PropertyBool", "HidSource", 2, "Whether the part was hidden to show its mesh"),
    ("App::PropertyColorList", "UserColours", 2, "The user's own colours, while ours are shown"),
)
_CHOICES = {"ColourBy": COLOUR_BY, "Elements": (FACES, FACETS)}
_SHOWN = ("Visibility", "ColourBy", "Elements", "FacetEdges")


class PartitionView(Stateless):
    """Behaviour of the view."""

    def __init__(self, view: Any) -> None:
        _add_properties(view)
        compat.add_group_view(view)
        view.Proxy = self

    def attach(self, view: Any) -> None:
        """Make a place for the mesh.

        It is no display mode: a group that has one shows all its members anew at every change.
        """
        watch()
        follow_selection()
        self.obj = view.Object
        self.mesh = coin.SoSeparator()
        self.scene: FacetScene | None = None
        self.filling: Slices | None = None
        self.found: Colouring | None = None
        view.RootNode.addChild(self.mesh)

    def isShow(self) -> bool:
        """The tree asks, which knows of display modes only."""
        return bool(self.obj.Visibility)

    def updateData(self, obj: Any, name: str) -> None:
        """Follow the object: ``Status`` is the last property that a run sets."""
        if name in ("Status", "Datums", "DatumSystem") and hasattr(obj.ViewObject, "ColourBy"):
            self.show(obj.ViewObject)
            obj.ViewObject.signalChangeIcon()

    def onChanged(self, view: Any, name: str) -> None:
        """Follow the view's own properties."""
        if name in ("Visibility", "ColourBy", "Elements", "FacetEdges") and hasattr(
            view, "UserColours"
        ):
            self.show(view)

    def show(self, view: Any) -> None:
        """Show what the properties say; what is hidden or stale gives the user's colours back."""
        if view.Object.Document.Restoring:
            return
        _add_properties(view)
        found = _colours_of(view) if view.Visibility else None
        self._stop_filling()
        self.found, self.scene = found, None
        self.mesh.removeAllChildren()
        QtCore.QTimer.singleShot(0, refresh_legend)
        if found is None:
            self.give_back(view)
            return
        for other in partitions(view.Object.Document):
            if other is not view.Object and other.Source is view.Object.Source:
                other.ViewObject.Visibility = False
        if view.Elements == FACETS or is_measurement(view.Object.Source):
            restore_colours(view)
            partition = effective_result(view.Object)[0].partition
            self.scene = FacetScene(partition.mesh, found, partition.region, edges=view.FacetEdges)
            self.mesh.addChild(self.scene.root)
            self.filling = Slices(self.scene.fill(), self._filled, compat.warn)
            _show_source(view, False)
        else:
            show_colours(view, found.face_colours)
            _show_source(view, True)

    def give_back(self, view: Any) -> None:
        """Leave the source as the user has it: its colours, and in sight."""
        restore_colours(view)
        _show_source(view, True)

    def highlight(self) -> None:
        """Show the facets of the chosen faces as FreeCAD shows what is selected."""
        if self.scene is None:
            return
        stored, _ = effective_result(self.obj)
        facemap = stored.solid.facemap
        assert facemap is not None
        chosen = set(chosen_faces(self.obj))
        marked = np.array([face.name in chosen for face in facemap.faces] + [False])
        self.scene.highlight(marked[facemap.face_of_triangle])

    def _stop_filling(self) -> None:
        if self.filling is not None:
            self.filling.stop()
            self.filling = None

    def _filled(self) -> None:
        with suppress(ReferenceError):  # the document may have been closed meanwhile
            self.highlight()

    def getElementPicked(self, picked: Any) -> str:
        """Name of the face that a facet of the shown mesh came from."""
        facemap = effective_result(self.obj)[0].solid.facemap
        facet = self.scene.facet_of(picked) if self.scene is not None else None
        if facemap is None or facet is None:
            return ""
        face = facemap.face_of_triangle[facet]
        return facemap.faces[face].name if face >= 0 else ""

    def onDelete(self, view: Any, subelements: Any) -> bool:
        """Give the user's colours back and take the features along."""
        self._stop_filling()
        self.give_back(view)
        for feature in [*features(view.Object), *annotations_of(view.Object)]:
            view.Object.Document.removeObject(feature.Name)
        return True

    def doubleClicked(self, view: Any) -> bool:
        """Open the panel, to run it again."""
        from gpswb.gui.panels.partition import PartitionPanel
        from gpswb.gui.panels.show import show_panel

        show_panel(PartitionPanel(partition=view.Object))
        return True

    def getIcon(self) -> str:
        """The wheel, faded where the result is out of date."""
        stale = getattr(self.obj, "Status", "") == STALE
        return icon("GPS_Partition_stale" if stale else "GPS_Partition")


def _colours_of(view: Any) -> Colouring | None:
    """The colours that a partition shows; None where it has none, or they are another part's."""
    obj = view.Object
    if not obj.Result or obj.Source is None:
        return None
    if not is_measurement(obj.Source) and len(obj.Classes) != len(obj.Source.Shape.Faces):
        return None
    try:
        stored, _ = effective_result(obj)
        asked = (view.ColourBy, preferences.palette(), stored_datums(obj), obj.DatumSystem)
        if not (_last and _last[0][0] is stored and _last[0][1] == asked):
            _last[:] = [(stored, asked, colouring(stored, *asked))]
        return _last[0][2]
    except GpswbError as error:
        compat.warn(str(error))
        return None


_last: list[tuple[StoredResult, Any, Colouring]] = []
"""The colours that were asked for last: a view that shows the same elsewhere asks again."""


def _add_properties(view: Any) -> None:
    """The view's properties; documents of older versions get those that came later."""
    for kind, name, editor, text in _PROPERTIES:
        if not hasattr(view, name):
            view.addProperty(kind, name, "GPS", text)
            view.setEditorMode(name, editor)
            if name in _CHOICES:
                setattr(view, name, list(_CHOICES[name]))


def _show_source(view: Any, wanted: bool) -> None:
    """Hide the source where its mesh is shown; show it again only if it was us who hid it."""
    source = getattr(view.Object.Source, "ViewObject", None)
    if source is None:
        return
    if not wanted and source.Visibility:
        view.HidSource, source.Visibility = True, False
    elif wanted and view.HidSource:
        view.HidSource, source.Visibility = False, True
