# SPDX-License-Identifier: LGPL-2.1-or-later
"""Millions of links put in order: every node knows the next one, and wants its place along its chain (list ranking)."""

from __future__ import annotations

from typing import NamedTuple, Tuple

import numpy as np

_SHARES = (4, 2, 0)  # of nodes not reached yet, one in 2^k starts a run; at last every one


class Chains(NamedTuple):
    """Chains and rings of nodes.

    Attributes
    ----------
    place : ndarray (N,)
        Position of each node if chains lie one after another, each in its own order.
    sizes : ndarray (C,)
        Nodes of each chain.
    group : ndarray (C,)
        Group of each chain, ascending.
    """

    place: np.ndarray
    sizes: np.ndarray
    group: np.ndarray


def order_chains(follow: np.ndarray, group: np.ndarray) -> Chains:
    """Return the chains of all nodes, in the order of their groups.

    Parameters
    ----------
    follow : ndarray (N,) int32
        The node after each; itself at the end of an open chain. No two nodes have the same one after them.
    group : ndarray (N,)
        Group of each node, the same all along a chain.

    Notes
    -----
    Chains are cut into runs that are all walked at once, then the runs, a tenth as many, are ranked by pointer doubling
    (Wyllie 1979; Reid-Miller 1994, doi:10.1145/181014.181021). Doubling all nodes takes twice as long.
    """
    run, offset, first, after, size = _walked(follow)
    tail, left = _ranked(after, size)
    last = np.flatnonzero(tail == np.arange(len(tail)))  # one run of each chain
    group = group[first[last]]
    order = np.argsort(group, kind="stable")
    last = last[order]
    sizes = np.bincount(tail, size, len(tail)).astype(np.int64)[last]
    end = np.zeros(len(tail), np.int64)
    end[last] = np.cumsum(sizes)
    return Chains((end[tail] - left)[run] + offset, sizes, group[order])


def _walked(follow: np.ndarray) -> Tuple[np.ndarray, ...]:
    """Cut all chains into runs by walking from many nodes at once, until a run meets the start of another.

    Returns run (N,) and offset (N,) of each node; and first node (R,), next run (R,; itself at an open end), size (R,).
    """
    run, offset = np.full(len(follow), -1, np.int32), np.zeros(len(follow), np.int32)
    rest, runs, parts = np.arange(len(follow), dtype=np.int32), 0, []
    for share in _SHARES:
        start = rest[_scattered(rest, share)] if share else rest
        own = np.arange(runs, runs + len(start), dtype=np.int32)
        run[start] = own
        after, size = own.copy(), np.ones_like(own)
        here, who, steps = follow[start], own, 1
        while len(who):
            met = run[here]
            stop = met >= 0
            done = who[stop] - runs
            after[done], size[done] = met[stop], steps
            here, who = here[~stop], who[~stop]
            run[here], offset[here] = who, steps
            here, steps = follow[here], steps + 1
        parts.append((start, after, size))
        runs, rest = runs + len(start), rest[run[rest] < 0]
    first, after, size = (np.concatenate(column) for column in zip(*parts))
    return run, offset, first, after, size


def _scattered(nodes: np.ndarray, share: int) -> np.ndarray:
    """Whether each node is one of the one in 2^share that start a run: by a hash of its number, the same every time."""
    key = nodes.astype(np.uint32) * np.uint32(0x9E3779B1)
    key ^= key >> np.uint32(15)
    key *= np.uint32(0x85EBCA77)
    return key >> np.uint32(32 - share) == 0


def _ranked(after: np.ndarray, size: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Last run (R,) of each run's chain, rings being cut before their lowest run; nodes from its start to that end."""
    own = np.arange(len(after), dtype=np.int32)
    jump, least, before = after, own, None
    while before is None or (least != before).any():
        before, least = least, np.minimum(least, least[jump])
        jump = jump[jump]
    in_ring = after[jump] != jump
    jump = np.where(in_ring & (after == least), own, after)
    left, before = np.where(jump == own, 0, size), None
    while before is None or (jump != before).any():
        before, left = jump, left + left[jump]
        jump = jump[jump]
    return jump, left + size[jump]
