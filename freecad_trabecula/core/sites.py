# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sites: the centres of pores on faces. Those of a prism (Eq. 2.1) are made here, those of other faces in geometry."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Dict, Sequence, Tuple

import numpy as np

from ..errors import ParameterError
from .parameters import PrismParameters, SiteEdit

#: Part::Box's own order: x = 0, x = l, y = 0, y = w, z = 0, z = h
PRISM_FACES = ("Face1", "Face2", "Face3", "Face4", "Face5", "Face6")
OPPOSITE_FACES = (("Face1", "Face2"), ("Face3", "Face4"), ("Face5", "Face6"))
HAND = 10**6  # second index of sites added by hand; no co-ordinate line reaches it


@dataclass(frozen=True)
class Sites:
    """The sites of one face.

    Attributes
    ----------
    face : str
        Name of the face (its label: ``A`` or ``Face1``).
    index : ndarray of shape (P, 2), int64
        Numbers (i, j) along the co-ordinate lines u and v; from 1 on prisms, around 0 elsewhere.
    points : ndarray of shape (P, 3), mm
    u : ndarray of shape (P, 3)
        Unit first axis in the tangent plane.
    normals : ndarray of shape (P, 3)
        Unit normals that point out of the envelope.
    on : ndarray of shape (P,), bool
        False for sites switched off by hand.
    """

    face: str
    index: np.ndarray
    points: np.ndarray
    u: np.ndarray
    normals: np.ndarray
    on: np.ndarray

    def __len__(self) -> int:
        return len(self.points)

    @property
    def names(self) -> Tuple[str, ...]:
        """Names such as ``Face1.2.-3``; sites added by hand are ``Face1.hand.1``."""
        return tuple(f"{self.face}.hand.{i}" if j == HAND else f"{self.face}.{i}.{j}" for i, j in self.index.tolist())

    @property
    def flat(self) -> bool:
        """True if all sites lie in one plane: then no rod can join two of them."""
        if len(self) < 2:
            return True
        return bool(np.abs((self.points - self.points[0]) @ self.normals[0]).max() < 1e-6)


def prism_sites(prism: PrismParameters) -> Dict[str, Sites]:
    """Return the sites of a prism's six faces, by face name (Eq. 2.1).

    Opposite faces have the same (i, j) and u, so that site (i, j) faces site (i, j) across the prism.
    """
    grids = [a + (size - 2 * a) / (n - 1) * np.arange(n) for _, size, n, a in prism.axes]
    sizes = [size for _, size, _, _ in prism.axes]
    sites = {}
    for axis in range(3):
        first, second = (axis + 1) % 3, (axis + 2) % 3
        i, j = (
            a.ravel() for a in np.meshgrid(np.arange(len(grids[first])), np.arange(len(grids[second])), indexing="ij")
        )
        for end in (0, 1):
            points = np.zeros((len(i), 3))
            points[:, first], points[:, second], points[:, axis] = grids[first][i], grids[second][j], end * sizes[axis]
            u, normal = np.zeros(3), np.zeros(3)
            u[first], normal[axis] = 1.0, 2.0 * end - 1.0
            name = PRISM_FACES[2 * axis + end]
            sites[name] = Sites(
                name,
                np.stack([i, j], 1).astype(np.int64) + 1,
                points,
                np.tile(u, (len(i), 1)),
                np.tile(normal, (len(i), 1)),
                np.ones(len(i), bool),
            )
    return sites


def edit_sites(
    sites: Sites, edits: Sequence[SiteEdit], placed: Dict[str, Tuple[np.ndarray, np.ndarray, np.ndarray]]
) -> Sites:
    """Return the sites of one face with the changes made by hand.

    Parameters
    ----------
    sites : Sites
    edits : sequence of SiteEdit
        Those of other faces are passed over.
    placed : dict
        For each ``move`` and ``add`` edit's site name: point (3,), u (3,) and outer normal (3,) on the face there; the
        caller, who knows the face, computes them.

    Raises
    ------
    ParameterError
        If an edit names a site that the face does not have.
    """
    own = [e for e in edits if e.site.split(".")[0] == sites.face]
    added = 0
    for edit in own:
        if edit.action == "add":
            added += 1
            sites = _with_site(sites, added, placed[edit.site])
            continue
        if edit.site not in sites.names:
            raise ParameterError(
                f"a change by hand must name a site of face {sites.face} ({len(sites)} sites), got {edit.site!r}"
            )
        k = sites.names.index(edit.site)
        if edit.action == "off":
            on = sites.on.copy()
            on[k] = False
            sites = replace(sites, on=on)
        elif edit.action == "move":
            columns = [a.copy() for a in (sites.points, sites.u, sites.normals)]
            for column, value in zip(columns, placed[edit.site]):
                column[k] = value
            sites = replace(sites, points=columns[0], u=columns[1], normals=columns[2])
    return sites


def _with_site(sites: Sites, number: int, place: Tuple[np.ndarray, np.ndarray, np.ndarray]) -> Sites:
    return Sites(
        sites.face,
        np.vstack([sites.index, [[number, HAND]]]),
        np.vstack([sites.points, place[0]]),
        np.vstack([sites.u, place[1]]),
        np.vstack([sites.normals, place[2]]),
        np.append(sites.on, True),
    )


def overlapping_pairs(points: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """Return the pairs of sites whose pores' circles (radius size / 2) overlap, ndarray (N, 2) of indices.

    Parameters
    ----------
    points : ndarray (P, 3), mm
    sizes : ndarray (P,), mm
    """
    found = []
    for k in range(len(points) - 1):  # row by row: memory stays linear for thousands of sites
        distance = np.linalg.norm(points[k + 1 :] - points[k], axis=1)
        hit = np.nonzero(distance < (sizes[k + 1 :] + sizes[k]) / 2)[0] + k + 1
        found.append(np.stack([np.full(len(hit), k), hit], 1))
    return np.concatenate(found) if found else np.zeros((0, 2), int)
