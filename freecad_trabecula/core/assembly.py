# SPDX-License-Identifier: LGPL-2.1-or-later
"""From parameters and sites to the mended wireframe (thesis 2.4)."""

from __future__ import annotations

from typing import Dict, List, Optional, Sequence, Tuple

import numpy as np

from .couplings import CouplingRow, Pairs, couple
from .laws import Region
from .path_laws import PATH_LAWS, PathEnds, draw_paths
from .pores import Pores, draw_pores, edit_pores, join_pores, mirrored
from .progress import Progress, part, silent
from .recovery import mend
from .rods import RodEnds
from .sites import Sites
from .wireframe import Contains, Wireframe, WireframeParameters, end_frames


def make_wireframe(
    parameters: WireframeParameters,
    sites: Dict[str, Sites],
    region: Region,
    contains: Optional[Contains] = None,
    progress: Progress = silent,
) -> Wireframe:
    """Return the wireframe of a design, faulty rods mended (thesis 2.4, 3.3.5, 4.2.4).

    Parameters
    ----------
    parameters : WireframeParameters
    sites : dict of Sites, by face
        Already edited by hand.
    region : Region
        Box and centre of the envelope.
    contains : callable, optional
        Tells which points lie in the envelope; without it no rod is looked for outside.

    Raises
    ------
    ParameterError
        If a coupling cannot be made.
    """
    raw = draft_wireframe(parameters, sites, region, part(progress, 0.0, 0.1))
    progress(0.1, 1, "faults")
    mended = mend(raw, parameters, region, contains, part(progress, 0.1, 1.0))
    progress(1, 1, "wireframe")
    return mended


def draft_wireframe(
    parameters: WireframeParameters, sites: Dict[str, Sites], region: Region, progress: Progress = silent
) -> Wireframe:
    """Return the wireframe before faults are looked for: what a preview shows while a value is being dragged.

    Arguments and errors are those of ``make_wireframe``.
    """
    progress(0, 3, "couplings")
    pairs, rows = couple(parameters.couplings, sites, parameters.seed)
    progress(1, 3, "pores and paths")
    drawn = {
        face: edit_pores(
            parameters.pores, draw_pores(parameters.pores, parameters.seed, s, region), s.names, parameters.edits
        )
        for face, s in sites.items()
    }
    return _assemble(parameters, sites, drawn, pairs, tuple(rows), region)


def _assemble(
    parameters: WireframeParameters,
    sites: Dict[str, Sites],
    drawn: Dict[str, Pores],
    pairs: Sequence[Pairs],
    rows: Tuple[CouplingRow, ...],
    region: Region,
) -> Wireframe:
    names: List[str] = []
    blocks = []
    for pair in pairs:
        coupling = parameters.couplings[pair.coupling]
        a, b = sites[coupling.first], sites[coupling.second]
        own = [f"{p}-{q}" for p, q in zip(np.array(a.names)[pair.first], np.array(b.names)[pair.second])]
        path = coupling.path or parameters.path
        frames = end_frames(a, pair.first, b, pair.second)
        first, second = mirrored(drawn[coupling.first].take(pair.first)), drawn[coupling.second].take(pair.second)
        goal = _feet(a, pair.first, b, pair.second) if PATH_LAWS[path.kind].to_feet else b.points[pair.second]
        between = PathEnds(own, a.points[pair.first], frames[:, 0, 2], goal, frames[:, 1, 2])
        paths = draw_paths(path, between, region, parameters.seed)
        numbers = np.stack([pair.first, pair.second], 1)
        blocks.append((np.full(len(own), pair.coupling), numbers, paths, frames, first, second))
        names += own
    if not blocks:
        empty = Pores(np.zeros(0), np.zeros((0, 4, 2)), np.zeros((0, 4)), np.zeros((0, 4)))
        ends = RodEnds(np.zeros((0, 2, 3, 3)), empty, empty, np.zeros(0))
        return Wireframe(sites, drawn, rows, (), np.zeros(0, int), np.zeros((0, 2), int), np.zeros((0, 2, 4, 3)), ends)
    coupling_numbers, numbers, paths, frames = (np.concatenate([b[i] for b in blocks]) for i in range(4))
    ends = RodEnds(
        frames,
        join_pores([b[4] for b in blocks]),
        join_pores([b[5] for b in blocks]),
        np.full(len(names), parameters.rods.lean),
        parameters.pores.sections == 2,
    )
    return Wireframe(sites, drawn, rows, tuple(names), coupling_numbers, numbers, paths, ends)


def _feet(a: Sites, first: np.ndarray, b: Sites, second: np.ndarray) -> np.ndarray:
    """Ends of orthogonal paths: where the inner normal at the first site meets the plane of the second (3.2.4)."""
    start, along, normal = a.points[first], -a.normals[first], b.normals[second]
    slope = (along * normal).sum(1)
    reach = ((b.points[second] - start) * normal).sum(1) / np.where(np.abs(slope) < 1e-9, 1e-9, slope)
    return start + reach[:, None] * along
