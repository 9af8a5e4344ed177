# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings what is out of date up to date with one click; what is made of it follows by itself."""

from __future__ import annotations

from typing import Any

import FreeCAD

from .. import make
from ..features.stages import stale_objects
from .recomputing import of_window
from .transactions import transaction

translate = FreeCAD.Qt.translate


def renew(document: Any) -> None:
    """Have all that is out of date computed in another process; the document is recomputed when it is there.

    Raises
    ------
    TrabeculaError
        If an object of no design cannot be computed; the document is as it was.
    """
    step = translate("Trabecula", "Bring up to date")
    for obj in stale_objects(document):
        if not of_window().take(obj, obj.Proxy.key(obj), step):
            with transaction(document, step):
                make.update(obj)
