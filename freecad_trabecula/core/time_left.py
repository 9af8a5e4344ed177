# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a work still takes, from reports of the share done: calm, so that it can be read."""

from __future__ import annotations

from typing import Callable, List, Optional, Tuple

_SURE_SHARE, _SURE_SECONDS = 0.05, 0.5  # from which on a guess is made
_WINDOW = 0.35  # of the time so far: the pace of late counts, since steps differ in pace
_TRUST = 0.3  # in the newest guess; the rest is that before
_SLOWER, _MOMENT = 1.3, 2.0  # more than so many times what was said, and seconds: the work is slower than thought


class TimeLeft:
    """Seconds left of one work.

    What is said runs down with the clock, faster when the work turns out faster, and stands still while it turns out a
    little slower; it goes up only if the work has become much slower. So it does not jump with every report.

    Parameters
    ----------
    clock : callable
        Seconds, as ``time.monotonic`` gives them.

    Examples
    --------
    >>> now = [0.0]
    >>> left = TimeLeft(lambda: now[0])
    >>> now[0] = 10.0
    >>> left.report(0.5)
    >>> left.seconds()
    10.0
    >>> now[0] = 12.0
    >>> left.seconds()
    8.0
    """

    def __init__(self, clock: Callable[[], float]) -> None:
        self._clock = clock
        self._reports: List[Tuple[float, float]] = [(clock(), 0.0)]
        self._end: Optional[float] = None
        self._said = float("inf")

    def report(self, share: float) -> None:
        """Take the share done, 0..1; one that is less than before is passed over."""
        now, start = self._clock(), self._reports[0][0]
        if share <= self._reports[-1][1]:
            return
        self._reports.append((now, min(share, 1.0)))
        if share < _SURE_SHARE or now - start < _SURE_SECONDS:
            return
        guess = now + (1.0 - share) * self._pace(now)
        self._end = guess if self._end is None else self._end + _TRUST * (guess - self._end)

    def _pace(self, now: float) -> float:
        """Seconds that the whole takes at the pace of late, mixed with that since the start."""
        start, share = self._reports[0][0], self._reports[-1][1]
        since = now - _WINDOW * (now - start)
        then, done = next(one for one in reversed(self._reports) if one[0] <= since)
        overall = (now - start) / share
        late = (now - then) / max(share - done, 1e-12)
        return (overall + late) / 2

    def seconds(self) -> Optional[float]:
        """Return how many seconds are left, never less than 0; None: not known yet."""
        if self._end is None:
            return None
        left = max(self._end - self._clock(), 0.0)
        if left < self._said or left > _SLOWER * self._said + _MOMENT:
            self._said = left
        return self._said
