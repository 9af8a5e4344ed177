# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress and cancelling: one callback for both."""

from __future__ import annotations

from typing import Callable

#: ``progress(done, total, what)``; it may raise ``errors.Cancelled``, which every function lets through.
Progress = Callable[[float, float, str], None]


def silent(done: float, total: float, what: str) -> None:
    """Take a progress report and do nothing with it: the default of every long function."""


def part(progress: Progress, start: float, end: float) -> Progress:
    """Return a callback for one part of a job: its 0..total becomes start..end of the whole (shares 0..1)."""

    def inner(done: float, total: float, what: str) -> None:
        progress(start + (end - start) * done / max(total, 1e-12), 1.0, what)

    return inner
