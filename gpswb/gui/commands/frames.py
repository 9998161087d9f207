# SPDX-License-Identifier: LGPL-2.1-or-later
"""`GPS_Frames`: lay the frames out for the view as it is."""

from __future__ import annotations

from gpswb.gui.commands.command import ResultCommand
from gpswb.gui.compat import QT_TRANSLATE_NOOP, translate


class Command(ResultCommand):
    """Put the frames of a partition beside its part as the 3-D view shows it."""

    name = "GPS_Frames"
    text = QT_TRANSLATE_NOOP("GPS_Frames", "Place frames")
    tooltip = QT_TRANSLATE_NOOP(
        "GPS_Frames", "Lay the frames out beside the part as this view shows it, none over another"
    )
    shortcut = "G, F"
    faces = True

    def why_not(self) -> str:
        from gpswb.gui.objects.annotation import annotations_of
        from gpswb.gui.present_view import camera
        from gpswb.gui.selection import with_result

        reason = super().why_not()
        if not reason and not (annotations_of(with_result()) and camera() is not None):
            return str(translate("GPS", "there are no frames in this view"))
        return reason

    def run(self) -> None:
        from gpswb.gui.one_step import one_step
        from gpswb.gui.present_view import lay_out
        from gpswb.gui.selection import with_result

        partition = with_result()
        with one_step(partition.Document, translate("GPS_Frames", "Place frames")):
            lay_out(partition)
