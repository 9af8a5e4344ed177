# SPDX-License-Identifier: LGPL-2.1-or-later
"""Volumes of crossing cylinders, by which case 1 is checked: no mesh, no kernel, no ray. Lengths mm, numpy only.

Case 1 of the thesis has straight round channels along X, Y and Z whose axes meet in the nodes of a grid; between the
nodes nothing crosses. So the union is the sum of the cylinders, less every pair's common part, plus what all three
have in common, node by node (inclusion and exclusion).
"""

import numpy as np

#: Gauss-Legendre nodes on 0..1; 64 give ten digits on these smooth integrands.
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(64)
_T, _W = (_NODES + 1) / 2, _WEIGHTS / 2


def two_cylinders(a, b):
    """Return the volume common to two cylinders of radii a and b (...,) whose axes cross at right angles.

    8 times the integral of sqrt(a^2 - x^2) sqrt(b^2 - x^2) over x = 0..min(a, b); 16/3 a^3 for a = b (Archimedes).
    """
    a, b = np.broadcast_arrays(np.asarray(a, float)[..., None], np.asarray(b, float)[..., None])
    least = np.minimum(a, b)
    angle = _T * np.pi / 2  # x = least sin(angle) takes the root's steep end away
    x = least * np.sin(angle)
    root = np.sqrt(np.maximum(a**2 - x**2, 0)) * np.sqrt(np.maximum(b**2 - x**2, 0))
    return (8 * root * least * np.cos(angle) * np.pi / 2 * _W).sum(-1)


def three_cylinders(a, b, c):
    """Return the volume common to three cylinders of radii a, b, c (...,) along X, Y, Z through one point.

    8 (2 - sqrt 2) a^3 for equal radii. The first quadrant's part of y^2 + z^2 <= a^2, y <= p, z <= q is integrated
    over x with p = sqrt(c^2 - x^2), q = sqrt(b^2 - x^2).
    """
    a, b, c = np.broadcast_arrays(*(np.asarray(r, float)[..., None] for r in (a, b, c)))
    least = np.minimum(b, c)
    total = 0.0
    # the integrand has kinks where p or q passes a and where y0 passes p: many short pieces keep the error small
    cuts = np.linspace(0, np.pi / 2, 41)
    for low, high in zip(cuts[:-1], cuts[1:]):
        angle = low + (high - low) * _T
        x = least * np.sin(angle)
        p, q = np.sqrt(np.maximum(c**2 - x**2, 0)), np.sqrt(np.maximum(b**2 - x**2, 0))
        start = np.minimum(p, np.sqrt(np.maximum(a**2 - q**2, 0)))
        end = np.minimum(p, a)
        area = q * start + np.where(end > start, _circle_part(end, a) - _circle_part(start, a), 0.0)
        total = total + (8 * area * least * np.cos(angle) * (high - low) * _W).sum(-1)
    return total


def _circle_part(y, a):
    return (y * np.sqrt(np.maximum(a**2 - y**2, 0)) + a**2 * np.arcsin(np.clip(y / a, -1, 1))) / 2


def case1_volumes(d_x, d_y, d_z, edge=10.0):
    """Return sum and union of the channels of case 1 in a cube.

    Parameters
    ----------
    d_x, d_y, d_z : ndarray (n, n)
        Diameters of the channels along X at (y, z), along Y at (x, z), along Z at (x, y), mm.
    edge : float
        Edge of the cube, mm.
    """
    n = len(d_x)
    a = np.broadcast_to(d_x[None, :, :], (n, n, n)) / 2
    b = np.broadcast_to(d_y[:, None, :], (n, n, n)) / 2
    c = np.broadcast_to(d_z[:, :, None], (n, n, n)) / 2
    total = np.pi / 4 * edge * sum((d**2).sum() for d in (d_x, d_y, d_z))
    pairs = two_cylinders(a, b).sum() + two_cylinders(b, c).sum() + two_cylinders(c, a).sum()
    return total, total - pairs + three_cylinders(a, b, c).sum()


def expected_case1_volumes(low=0.2, high=0.8, n=5, edge=10.0):
    """Return the expectations of sum and union over diameters uniform in low..high, mm3, by 12-point quadrature."""
    nodes, weights = np.polynomial.legendre.leggauss(12)
    r = (low + (high - low) * (nodes + 1) / 2) / 2
    w = weights / 2
    total = 3 * n * n * np.pi * edge * (w * r**2).sum()
    pair = (w[:, None] * w * two_cylinders(r[:, None], r)).sum()
    triple = (w[:, None, None] * w[:, None] * w * three_cylinders(r[:, None, None], r[:, None], r)).sum()
    return total, total - n**3 * (3 * pair - triple)
