# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random numbers that belong to a thing (a site, a pair, a rod), not to the order of drawing.

numpy promises its frozen streams only for the legacy generator, and one generator for all would reshuffle every later
rod when one more number is drawn. Hashing seed and identity by BLAKE2b (RFC 7693) gives the same numbers on every
machine and version.
"""

from __future__ import annotations

import hashlib
from typing import SupportsInt, Union

import numpy as np

_NUMBERS_PER_BLOCK = 8  # a BLAKE2b digest has 64 bytes


class Stream:
    """Uniform random numbers for one identity.

    Parameters
    ----------
    seed : int
        The design's one seed, any integer >= 0.
    *identity : str or int
        What the numbers are for, e.g. ``"pore", "Face1.2.3"``.

    Examples
    --------
    >>> bool((Stream(7, "pore", "Face1.0.0").uniform(3) == Stream(7, "pore", "Face1.0.0").uniform(3)).all())
    True
    """

    def __init__(self, seed: int, *identity: Union[str, SupportsInt]) -> None:
        # repr tells 1 from "1" and guards the joints between the parts
        parts = (int(seed), *(i if isinstance(i, str) else int(i) for i in identity))
        self._base = repr(parts).encode()
        self._block = 0
        self._left: list = []

    def integers(self, count: int) -> np.ndarray:
        """Return the next ``count`` random 64-bit integers, ndarray (count,) of uint64."""
        while len(self._left) < count:
            digest = hashlib.blake2b(self._base + b"#%d" % self._block).digest()
            self._left.extend(int.from_bytes(digest[8 * i : 8 * i + 8], "little") for i in range(_NUMBERS_PER_BLOCK))
            self._block += 1
        taken, self._left = self._left[:count], self._left[count:]
        return np.array(taken, dtype=np.uint64)

    def uniform(self, count: int) -> np.ndarray:
        """Return the next ``count`` numbers in [0, 1), ndarray (count,) of float64 with 53 random bits each."""
        return (self.integers(count) >> np.uint64(11)).astype(np.float64) * 2.0**-53

    def many(self, count: int) -> np.ndarray:
        """Return numbers as ``uniform`` does, (count,), all from the next integer by ``mix``: 10^6 take 30 ms."""
        counters = np.arange(count, dtype=np.uint64)
        return (mix(self.integers(1), counters)[0] >> np.uint64(11)).astype(np.float64) * 2.0**-53


def mix(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return one random 64-bit integer per pair, (A, B) uint64, from keys a (A,) and b (B,) (uint64).

    The finaliser of SplitMix64 (Steele, Lea, Flood 2014, doi:10.1145/2714064.2660195) on a + 0x9E37...15 * b:
    whole-number arithmetic, the same everywhere, and 10^5 pairs cost a millisecond.
    """
    z = a[:, None] + np.uint64(0x9E3779B97F4A7C15) * b[None, :]
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return z ^ (z >> np.uint64(31))
