# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in another process whose progress the status bar shows, with a button that ends it."""

from __future__ import annotations

from typing import Callable, List

from ..errors import TrabeculaError
from .child_work import TIDY_GRACE, ChildWork, start_task
from .recomputing import WorkBar
from .transactions import told

_works: List[ChildWork] = []  # those that go on


def work_in_status_bar(write_task: Callable[[str], None], done: Callable[[str], None], estimate: str = "") -> None:
    """Do a task; an error is told in a dialog.

    Parameters
    ----------
    write_task : callable
        Takes the folder in which the other process finds its work.
    done : callable
        Takes the folder with the results, which is removed afterwards.
    estimate : str
        What it will take.

    Raises
    ------
    TrabeculaError
        If the work cannot be started.
    """

    def end() -> None:
        bar.close_bar()
        _works.remove(work)

    def succeed(folder: str) -> None:
        end()
        with told():
            done(folder)

    def fail(text: str) -> None:
        end()
        with told():
            raise TrabeculaError(text)

    def cancel() -> None:
        work.cancel(TIDY_GRACE)
        end()

    bar = WorkBar(cancel)
    try:
        work = start_task(write_task, bar.show_progress, succeed, fail)
    except TrabeculaError:
        bar.close_bar()
        raise
    _works.append(work)
    bar.show_start(estimate)


def is_working() -> bool:
    """Return whether such work is on its way."""
    return bool(_works)
