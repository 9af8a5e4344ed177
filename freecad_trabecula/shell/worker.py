# SPDX-License-Identifier: LGPL-2.1-or-later
"""Computes a task that the window wrote (features/tasks.py), in a process of its own, started as launch.py says."""

from __future__ import annotations

from typing import Any, Callable, Dict

from .. import make


def run(options: Dict[str, Any], report: Callable[..., None]) -> int:
    """Run the task in ``options["folder"]``; return the exit code.

    Parameters
    ----------
    options : dict
        ``folder``: where ``make.write_task`` wrote the task, and where its results will be.
    report : callable
        Takes messages; ``report("progress", share=0..1, what=text)`` may raise ``errors.Cancelled``.
    """
    make.run_task(options["folder"], lambda done, total, what: report("progress", share=done / total, what=what))
    return 0
