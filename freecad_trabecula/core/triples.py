# SPDX-License-Identifier: LGPL-2.1-or-later
"""Three things, one along X, Y and Z each, as what they are: a tuple of three."""

from __future__ import annotations

from typing import Iterable, Tuple, TypeVar

from ..errors import ParameterError

T = TypeVar("T")


def triple(values: Iterable[T]) -> Tuple[T, T, T]:
    """Return three values as a tuple of three.

    Raises
    ------
    ParameterError
        If there are more or fewer.

    Examples
    --------
    >>> triple(2 * n for n in (1, 2, 3))
    (2, 4, 6)
    """
    found = tuple(values)
    if len(found) != 3:
        raise ParameterError(f"there must be three values, one along X, Y and Z each, got {len(found)}")
    return found[0], found[1], found[2]
