# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wireframe as shapes: pores as closed wires, paths as wires, sites as vertices."""

from __future__ import annotations

from typing import Iterable, List

import numpy as np
import Part

from ..core.pores import Pores, bezier_poles
from ..core.sites import Sites
from ..core.wireframe import Wireframe
from .vectors import vectors


def path_wires(paths: np.ndarray) -> List[Part.Wire]:
    """Return the paths (R, 2, 4, 3), mm, as wires of two cubic Bezier edges each."""
    return [_wire(pieces) for pieces in paths]


def pore_wires(sites: Sites, pores: Pores) -> List[Part.Wire]:
    """Return the pores of a face as closed wires of M cubic Bezier edges in the planes of their sites.

    Parameters
    ----------
    sites : Sites
    pores : Pores
        One for each site, in the sites' axes (u, n x u).
    """
    axes = np.stack([sites.u, np.cross(sites.normals, sites.u)], 1)
    poles = sites.points[:, None, None] + np.einsum("pmkc,pcx->pmkx", bezier_poles(pores), axes)
    return [_wire(pieces) for pieces in poles]


def site_vertices(sites: Iterable[Sites]) -> List[Part.Vertex]:
    """Return the sites that are on as vertices."""
    return [Part.Vertex(point) for one in sites for point in vectors(one.points[one.on])]


def wireframe_shape(wireframe: Wireframe) -> Part.Compound:
    """Return a compound of three: the pores of all sites that are on, the paths, and the sites."""
    pores: List[Part.Wire] = []
    for face, sites in wireframe.sites.items():
        on = sites.on
        shown = Sites(sites.face, sites.index[on], sites.points[on], sites.u[on], sites.normals[on], on[on])
        pores += pore_wires(shown, wireframe.pores[face].take(on))
    parts = (pores, path_wires(wireframe.paths), site_vertices(wireframe.sites.values()))
    return Part.makeCompound([Part.makeCompound(part) for part in parts])


def _wire(pieces: np.ndarray) -> Part.Wire:
    edges = []
    for piece in pieces:
        curve = Part.BezierCurve()
        curve.setPoles(vectors(piece))
        edges.append(curve.toShape())
    return Part.Wire(edges)
