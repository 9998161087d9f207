# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long FreeCAD's window stands still while a large part is partitioned.

    GPSWB_GUI_LIMIT=3600 sh tests/gui/run.sh build/alive benchmarks/window_alive.py

The part is a plate with 494 holes, 500 faces; it is meshed with about 500,000 triangles. A timer
that should beat every 5 ms tells how long the window was not served, in all and of it at work (CPU
time of its thread: what is left on a machine with nothing else to do), and an alarm clock what the
window was at meanwhile, as far as that was Python.
"""

import os
import signal
import sys
import time
from collections import Counter
from pathlib import Path

import FreeCAD
import FreeCADGui
import Part
from PySide import QtCore

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "gui"))

from window_job import start

TRIANGLES = int(os.environ.get("GPSWB_TRIANGLES", "500000"))
MODE = os.environ.get("GPSWB_MODE", "robust")
BEAT_MS = 5
LOOK_S = 0.02
"""Between two looks at what the window does."""


class Heart:
    """Notes the longest time between two beats, by what was going on, and where in our code."""

    def __init__(self):
        self.longest = {}
        self.at_work = {}
        self.places = {}
        self.doing = "idle"
        self._seen = Counter()
        self._last = time.perf_counter()
        self._last_work = time.thread_time()
        # No thread: it might be the last to hold one of Qt's objects, and crash on letting it go.
        signal.signal(signal.SIGALRM, self._look)
        signal.setitimer(signal.ITIMER_REAL, LOOK_S, LOOK_S)
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._beat)
        self._timer.start(BEAT_MS)

    def _beat(self):
        now, work = time.perf_counter(), time.thread_time()
        self.at_work[self.doing] = max(self.at_work.get(self.doing, 0.0), work - self._last_work)
        self._last_work = work
        seen, self._seen = self._seen, Counter()
        if now - self._last > self.longest.get(self.doing, 0.0):
            self.longest[self.doing] = now - self._last
            self.places[self.doing] = seen
        self._last = now

    def _look(self, _, frame):
        while frame is not None and "/gpswb/" not in frame.f_code.co_filename:
            frame = frame.f_back
        if frame is not None:
            self._seen[f"{Path(frame.f_code.co_filename).stem}.{frame.f_code.co_name}"] += 1


def plate():
    holes = [
        Part.makeCylinder(2.0, 10.0, FreeCAD.Vector(10.0 + 8.0 * i, 10.0 + 8.0 * j, 0.0))
        for i in range(26)
        for j in range(19)
    ]
    return Part.makeBox(220.0, 164.0, 10.0).cut(Part.makeCompound(holes))


def wait(until, seconds):
    loop, end = QtCore.QEventLoop(), time.monotonic() + seconds
    timer = QtCore.QTimer()
    timer.timeout.connect(lambda: (until() or time.monotonic() > end) and loop.quit())
    timer.start(20)
    loop.exec_()
    if not until():
        raise TimeoutError


def rest(seconds):
    """Let the window live for a while."""
    end = time.monotonic() + seconds
    wait(lambda: time.monotonic() > end, 10 * seconds)


def measure():
    from gpswb.gui.objects.partition import partitions
    from gpswb.gui.panels.partition import PartitionPanel
    from gpswb.gui.panels.show import show_panel, shown_panel

    FreeCADGui.activateWorkbench("GpsWorkbench")
    document = FreeCAD.newDocument("Plate")
    part = document.addObject("Part::Feature", "Plate")
    part.Shape = plate()
    document.recompute()
    FreeCADGui.SendMsgToActiveView("ViewFit")
    print(f"faces {len(part.Shape.Faces)}")
    heart = Heart()
    rest(3)
    panel = PartitionPanel(source=part)
    panel.density.set_density(f"triangles={TRIANGLES}")
    panel.mode.setCurrentIndex(panel.mode.findData(MODE))
    show_panel(panel)
    heart.doing = "start"
    start = time.perf_counter()
    panel.accept()
    rest(1)
    heart.doing = "run"
    wait(lambda: not panel.change or not panel.change.run.running, 1800)
    ran = time.perf_counter()
    heart.doing = "result into the document"
    wait(lambda: shown_panel() is None, 300)
    done = time.perf_counter()
    heart.doing = "after"
    rest(3)
    (partition,) = partitions(document)
    heart.doing = "mesh shown"
    partition.ViewObject.Elements = "Facets"
    rest(3)
    print(f"triangles {partition.Triangles}, features {len(partition.Group)}")
    print(f"run {ran - start:.1f} s, result into the document {done - ran:.1f} s")
    for doing, longest in heart.longest.items():
        places = ", ".join(f"{name} {n}" for name, n in heart.places[doing].most_common(4))
        ms = f"{1000 * longest:.0f} ms, at work {1000 * heart.at_work[doing]:.0f} ms"
        print(f"longest standstill, {doing}: {ms} ({places})")


start(measure)
