# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results by the hash of all that they depend on: found here, or computed; or handed over as files by another process.

A key is made from inputs alone (parameters, fingerprints of shapes), never from what was computed on the way, so that
the window's child process and the document find the same key for the same design.
"""

from __future__ import annotations

import hashlib
import json
import threading
from collections import OrderedDict
from pathlib import Path
from typing import Any, Callable, List, Tuple, TypeVar

from ..core.records import to_record
from ..errors import ExportError
from .packing import read_value, write_value

T = TypeVar("T")

#: Kinds of results; each keeps its latest few.
KINDS = (
    "history",
    "envelope",
    "sites",
    "wireframe",
    "seen",
    "network",
    "scaffold",
    "solid",
    "analysis",
    "profiles",
    "contours",
    "voxels",
)
_MOST_KEPT = 16  # of a kind; contours of 300 slices are some 10 MB
_INDEX = "results.json"
_kept: OrderedDict[Tuple[str, str], Any] = OrderedDict()
_lock = threading.RLock()  # the window's preview computes in a thread of its own


def key_of(*inputs: Any) -> str:
    """Return the key of inputs: texts, numbers, parameter objects, and lists, tuples and dicts of them."""
    text = json.dumps([_plain(one) for one in inputs], sort_keys=True)
    return hashlib.blake2b(text.encode(), digest_size=12).hexdigest()


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {name: _plain(one) for name, one in value.items()}
    if isinstance(value, (list, tuple)) and not hasattr(value, "__dataclass_fields__"):
        return [_plain(one) for one in value]
    return to_record(value, everything=True)


def find(kind: str, key: str) -> Any:
    """Return the result of a key, None if there is none here."""
    with _lock:
        value = _kept.get((kind, key))
        if value is not None:
            _kept.move_to_end((kind, key))
        return value


def all_of(*kinds: str) -> List[Tuple[str, str]]:
    """Return where all results of some kinds are kept that are here."""
    with _lock:
        return [place for place in _kept if place[0] in kinds]


def keep(kind: str, key: str, value: T) -> T:
    """Keep a result, let the oldest of its kind go, and return it."""
    with _lock:
        _kept[kind, key] = value
        _kept.move_to_end((kind, key))
        of_kind = [one for one in _kept if one[0] == kind]
        for old in of_kind[:-_MOST_KEPT]:
            del _kept[old]
        return value


def found_or_made(kind: str, key: str, make: Callable[[], T]) -> T:
    """Return the result of a key; what is not here is made and kept."""
    value = find(kind, key)
    return value if value is not None else keep(kind, key, make())


def clear() -> None:
    """Let all results go."""
    with _lock:
        _kept.clear()


def save(folder: str, *which: Tuple[str, str]) -> None:
    """Write results, each given by (kind, key), into a folder: numbers as npz and JSON, shapes as binary BREP, meshes.

    The index is written last, so that a folder with an index is whole.
    """
    place = Path(folder)
    index = []
    for number, (kind, key) in enumerate(which):
        write_value(find(kind, key), place / f"{number}-{kind}")
        index.append({"kind": kind, "key": key, "name": f"{number}-{kind}"})
    part = place / (_INDEX + ".part")
    part.write_text(json.dumps(index), encoding="utf-8")
    part.replace(place / _INDEX)


def load(folder: str) -> int:
    """Keep the results that ``save`` wrote into a folder; return how many.

    Raises
    ------
    ExportError
        If there is no whole set of results.
    """
    place = Path(folder)
    try:
        index = json.loads((place / _INDEX).read_text(encoding="utf-8"))
        for one in index:
            keep(one["kind"], one["key"], read_value(place / one["name"]))
    except (OSError, ValueError, KeyError) as error:
        raise ExportError(f"the folder {folder} must hold results that were written to the end: {error}") from error
    return len(index)
