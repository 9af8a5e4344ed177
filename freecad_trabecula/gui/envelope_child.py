# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads and checks an envelope in a process of its own, which ``envelope_source`` starts; it needs no window."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Callable, Dict

import Part

from ..features.packing import write_value
from ..geometry.envelopes import envelope_from_shape, load_envelope

SHAPE, ENVELOPE = "shape.bin", "envelope"


def run(options: Dict[str, Any], report: Callable[..., None]) -> int:
    """Read the envelope in ``file``, or that of the shape in ``folder`` if there is none; write it into ``folder``.

    Parameters
    ----------
    options : dict
        ``folder``, ``file`` and ``solid`` (name or number of the solid in the file).
    report : callable
    """
    folder = Path(options["folder"])
    report("progress", share=0.1, what="reading the envelope")
    if options["file"]:
        envelope = load_envelope(options["file"], options["solid"])
    else:
        shape = Part.Shape()
        shape.importBinary(str(folder / SHAPE))
        envelope = envelope_from_shape(shape)
    report("progress", share=0.9, what="writing the envelope")
    write_value(envelope, folder / ENVELOPE)
    return 0
