# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window itself must compute and draw, without keeping it waiting.

Numbers are computed in a thread (numpy lets others run in its large calls); what only the window's thread may touch,
the scene and the document, is done in pieces, between which the event loop has its turn.
"""

from __future__ import annotations

import time
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Callable, Iterator, List

import numpy as np
from PySide import QtCore

from .qt import invoke_later

TURN = 0.03  # s of pieces in one turn of the event loop
_POINTS = 20_000  # of one piece


class _Aside(QtCore.QObject):
    """The thread; what it has computed arrives in the window's."""

    computed = QtCore.Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self._pool = ThreadPoolExecutor(1, "trabecula-aside")
        self.computed.connect(self._arrive)

    def start(self, compute: Callable[[], Any], take: Callable[[Any], None]) -> None:
        """Compute a value; ``take`` gets it in the window's thread."""
        self._pool.submit(compute).add_done_callback(lambda work: self.computed.emit((work, take)))

    def _arrive(self, pair: Any) -> None:
        work, take = pair
        take(work.result())  # what was raised there goes on here


_aside: List[_Aside] = []


def compute_aside(compute: Callable[[], Any], take: Callable[[Any], None]) -> None:
    """Compute a value in a thread and hand it over in the window's.

    Parameters
    ----------
    compute : callable
        Touches neither window nor document.
    take : callable
        Gets the value.

    Notes
    -----
    An exception goes on in the window's thread, to the report view, as if it had been raised there.
    """
    if not _aside:
        _aside.append(_Aside())
    _aside[0].start(compute, take)


def in_turns(steps: Iterator[Any], turn: float = TURN) -> None:
    """Run pieces of work, for some seconds in each turn of the event loop, until there are no more.

    Parameters
    ----------
    steps : iterator
    turn : float, s
        0: one piece in each turn.
    """
    end = time.perf_counter() + turn
    for _ in steps:
        if time.perf_counter() >= end:
            invoke_later(lambda: in_turns(steps, turn))
            return


def filled_in_pieces(field: Any, values: np.ndarray) -> Iterator[None]:
    """Put an array (N,) or (N, 3) into a field of a scene's node, piece by piece; it is told of the last.

    Points are taken by pivy as arrays of single precision, three times as fast as lists; whole numbers as lists only.
    """
    field.enableNotify(False)
    field.setNum(len(values))
    for start in range(0, len(values), _POINTS):
        piece = values[start : start + _POINTS]
        field.setValues(start, len(piece), np.ascontiguousarray(piece) if piece.ndim == 2 else piece.tolist())
        yield
    field.enableNotify(True)
    field.touch()
