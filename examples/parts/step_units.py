# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write a shape as STEP in a length unit of choice."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import cadquery as cq
from OCP.IFSelect import IFSelect_RetDone
from OCP.Interface import Interface_Static
from OCP.Message import Message
from OCP.STEPControl import STEPControl_AsIs, STEPControl_Writer

Unit = Literal["MM", "M", "INCH"]


def write_step(shape: cq.Shape, file: Path, unit: Unit = "MM") -> None:
    """Write ``shape`` (mm) so that the file states its lengths in ``unit``.

    Raises:
        OSError: the file can't be written.
    """
    for printer in list(Message.DefaultMessenger_s().Printers()):
        Message.DefaultMessenger_s().RemovePrinter(printer)
    writer = STEPControl_Writer()
    Interface_Static.SetCVal_s("write.step.unit", unit)
    try:
        writer.Transfer(shape.wrapped, STEPControl_AsIs)
        if writer.Write(str(file)) != IFSelect_RetDone:
            raise OSError(f"{file} can't be written")
    finally:
        Interface_Static.SetCVal_s("write.step.unit", "MM")
