# SPDX-License-Identifier: LGPL-2.1-or-later
"""What some work will take, as it is said in the window before the work begins."""

from __future__ import annotations

import FreeCAD

from ..core.estimates import Work, two_digits
from .child_work import time_text
from .language import local_number

translate = FreeCAD.Qt.translate


def work_text(work: Work) -> str:
    """Return time, memory and files; empty where it is so little that nothing need be said.

    Examples
    --------
    >>> work_text(Work(2.0)), work_text(Work(64.4, 3.14e8, 1.2e6))
    ('', 'about 1 min 4 s, 310 MB of memory, files of 1 MB')
    """
    if not work.is_heavy:
        return ""
    parts = [translate("Trabecula", "about {}").format(time_text(two_digits(work.seconds)))]
    for size, words in (
        (work.memory, translate("Trabecula", "{} of memory")),
        (work.files, translate("Trabecula", "files of {}")),
    ):
        parts += [words.format(_size(size))] if size else []
    return ", ".join(parts)


def _size(size: float) -> str:
    if size < 1e9:
        return f"{max(two_digits(size / 1e6), 1)} MB"
    return f"{local_number(size / 1e9, '.2g')} GB"
