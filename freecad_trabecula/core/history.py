# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rods that were mended before: after a change only those are mended again whose numbers changed (thesis 7.1).

What a rod becomes depends on itself alone: its numbers before mending, its name (whose streams it draws from), the path
of its coupling, and what is the same for all rods. So the outcome is the same as without a history. Numbers are
compared to 1e-7 mm, so that a file written and read, or another machine's last bits, make no difference.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import replace
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from .laws import Region
from .pores import Pores
from .progress import Progress, silent
from .records import to_record
from .recovery import FAULTS, mend
from .wireframe import Contains, Recovery, Wireframe, WireframeParameters, without

_DIGITS = 7  # of mm and radians: no solid differs by less
_MOST = 50_000  # rods, some 100 MB


class Mended(NamedTuple):
    """A mended wireframe, and what a history must know to give it again.

    Attributes
    ----------
    wireframe : Wireframe
    keys : tuple of str
        One for each rod that was coupled, in order, also for those that failed.
    failed : tuple of bool
        Which of them failed and are not in the wireframe.
    """

    wireframe: Wireframe
    keys: Tuple[str, ...]
    failed: Tuple[bool, ...]


class _Rod(NamedTuple):
    """One rod after mending; ``arrays`` as ``_columns`` lists them."""

    arrays: List[np.ndarray]
    recovery: Optional[Recovery]
    failed: bool
    outside: bool


class History:
    """Outcomes of mending, by all that they depend on."""

    def __init__(self) -> None:
        self._rods: Dict[str, _Rod] = {}

    def __len__(self) -> int:
        return len(self._rods)

    def mend(
        self,
        raw: Wireframe,
        parameters: WireframeParameters,
        region: Region,
        contains: Optional[Contains],
        envelope: str = "",
        progress: Progress = silent,
    ) -> Mended:
        """Return what ``recovery.mend`` would return.

        Parameters
        ----------
        raw, parameters, region, contains
            As for ``recovery.mend``.
        envelope : str
            Tells envelopes (``contains`` and ``region``) apart.
        progress : callable
        """
        keys = _keys(raw, parameters, envelope)
        known = {key: self._rods.get(key) for key in keys}  # held here, whatever another thread does
        unknown = np.array([k for k, key in enumerate(keys) if known[key] is None], int)
        if len(unknown):
            some = without(raw, unknown)
            mended = mend(some, parameters, region, contains, progress)
            for k, rod in zip(unknown.tolist(), _outcomes(mended, _failed(some, mended))):
                known[keys[k]] = rod
            self._keep({keys[k]: known[keys[k]] for k in unknown.tolist()})
        rods: List[Any] = [known[key] for key in keys]
        return Mended(_joined(raw, rods), tuple(keys), tuple(rod.failed for rod in rods))

    def count_unknown(self, raw: Wireframe, parameters: WireframeParameters, envelope: str = "") -> int:
        """Return how many rods ``mend`` would have to look at."""
        return sum(key not in self._rods for key in _keys(raw, parameters, envelope))

    def learn(self, mended: Mended) -> None:
        """Take over what was mended before, elsewhere."""
        if len(mended.wireframe):
            self._keep(dict(zip(mended.keys, _outcomes(mended.wireframe, mended.failed))))

    def _keep(self, rods: Dict[str, Any]) -> None:
        if len(self._rods) + len(rods) > _MOST:
            self._rods = {}
        self._rods.update(rods)


def rounded_keys(wireframe: Wireframe) -> List[str]:
    """Return a hash of each rod's numbers to 1e-7: equal keys, equal rods, also after a file or on another machine."""
    if not len(wireframe):
        return []
    flat = np.concatenate([a.reshape(len(wireframe), -1) for a in _columns(wireframe)], 1)
    rows = np.round(flat, _DIGITS) + 0.0  # adding 0 turns -0 into 0
    return [hashlib.blake2b(row.tobytes(), digest_size=12).hexdigest() for row in rows]


def _keys(raw: Wireframe, parameters: WireframeParameters, envelope: str) -> List[str]:
    common = [to_record(one, everything=True) for one in (parameters.pores, parameters.rods)]
    paths = [c.path or parameters.path for c in parameters.couplings]
    shared = []
    for path in paths:
        text = json.dumps([envelope, parameters.seed, common, to_record(path, everything=True)], sort_keys=True)
        shared.append(hashlib.blake2b(text.encode(), digest_size=12).hexdigest())
    own = zip(raw.coupling.tolist(), raw.names, rounded_keys(raw))
    return [f"{shared[coupling]} {name} {key}" for coupling, name, key in own]


def _columns(wireframe: Wireframe) -> List[np.ndarray]:
    """All arrays (R, ...) that mending may change."""
    ends = wireframe.ends
    pores = [getattr(p, name) for p in (ends.first, ends.second) for name in Pores.__dataclass_fields__]
    return [wireframe.paths, ends.frames, ends.leans, *pores]


def _failed(raw: Wireframe, mended: Wireframe) -> List[bool]:
    """Which rods of ``raw``, in its order, are missing in ``mended``."""
    found, at = [], 0
    for name, coupling in zip(raw.names, raw.coupling.tolist()):
        there = at < len(mended) and (name, coupling) == (mended.names[at], int(mended.coupling[at]))
        found.append(not there)
        at += there
    return found


def _outcomes(mended: Wireframe, failed: Sequence[bool]) -> List[_Rod]:
    """What became of each rod, in the order of ``failed``."""
    recoveries: Dict[str, List[Recovery]] = {}
    for recovery in mended.recoveries:
        recoveries.setdefault(recovery.rod, []).append(recovery)
    columns, outside, lost = _columns(mended), set(mended.outside), iter(mended.failed)
    empty = [np.zeros(column.shape[1:]) for column in columns]
    found, at = [], 0
    for bad in failed:
        name = next(lost) if bad else mended.names[at]
        own = recoveries.get(name)
        arrays = empty if bad else [column[at].copy() for column in columns]
        found.append(_Rod(arrays, own.pop(0) if own else None, bad, not bad and name in outside))
        at += not bad
    return found


def _joined(raw: Wireframe, rods: Sequence[_Rod]) -> Wireframe:
    """The wireframe of rods in the order of ``raw``, lists in the order in which ``recovery.mend`` gives them."""
    if not rods:
        return raw
    paths, frames, leans, *pores = (np.stack(column) for column in zip(*(rod.arrays for rod in rods)))
    half = len(pores) // 2
    ends = replace(raw.ends, frames=frames, leans=leans, first=Pores(*pores[:half]), second=Pores(*pores[half:]))
    failed = np.array([rod.failed for rod in rods])
    mended = [rod.recovery for rod in rods if rod.recovery is not None]
    return replace(
        without(replace(raw, paths=paths, ends=ends), ~failed),
        recoveries=tuple(sorted(mended, key=lambda recovery: FAULTS.index(recovery.fault))),
        failed=tuple(name for name, rod in zip(raw.names, rods) if rod.failed),
        outside=tuple(name for name, rod in zip(raw.names, rods) if rod.outside),
    )
