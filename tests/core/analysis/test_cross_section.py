# SPDX-License-Identifier: LGPL-2.1-or-later
"""One plane through a body: the same contours as all planes give, and closed forms."""

import math

import numpy as np
import pytest

from freecad_trabecula.core.analysis.contours import contour_measures
from freecad_trabecula.core.analysis.cross_section import Sections
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.slices import slice_contours


def box(low, high):
    """Triangles (12, 3, 3) of a box, counter-clockwise from outside."""
    corners = np.array([[(low, high)[k >> axis & 1][axis] for axis in range(3)] for k in range(8)], float)
    sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return np.array([corners[[a, b, c]] for a, b, c, d in sides for a, b, c in ((a, b, c), (a, c, d))])


def areas(contours):
    return contour_measures(contours, SliceParameters()).area


@pytest.mark.parametrize("axis, height, area", [("x", 0.5, 6.0), ("y", 1.0, 3.0), ("z", 2.9, 2.0)])
def test_a_box_is_cut_into_its_rectangles(axis, height, area):
    assert areas(Sections(box((0, 0, 0), (1, 2, 3)), axis).at(height)).tolist() == pytest.approx([area])


def test_a_cube_cut_across_its_diagonal_gives_the_regular_hexagon():
    sections = Sections(box((0, 0, 0), (1, 1, 1)), "1,1,1")
    assert sections.bounds == pytest.approx((0.0, math.sqrt(3)))
    hexagon = sections.at(math.sqrt(3) / 2)
    assert areas(hexagon).tolist() == pytest.approx([3 * math.sqrt(3) / 2 * 0.5])  # side sqrt(1/2)


def test_a_void_is_negative():
    inner = box((1, 1, 1), (2, 2, 2))[:, ::-1]
    found = areas(Sections(np.concatenate([box((0, 0, 0), (3, 3, 3)), inner]), "z").at(1.5))
    assert sorted(found.tolist()) == pytest.approx([-1.0, 9.0])


def test_it_is_what_the_slicer_gives_for_all_planes_together():
    rng = np.random.default_rng(3)
    boxes = [box(low, low + rng.uniform(0.2, 1.0, 3)) for low in rng.uniform(0, 3, (40, 3))]
    triangles, heights = np.concatenate(boxes), np.linspace(0.1, 3.4, 12)
    every = slice_contours(triangles, "0.6,0,0.8", heights)
    measured = areas(every)
    sections = Sections(triangles, "0.6,0,0.8")
    for k, height in enumerate(heights):
        assert sorted(areas(sections.at(height))) == pytest.approx(sorted(measured[every.plane == k]), abs=1e-12)


def test_beside_the_body_there_is_nothing():
    assert len(Sections(box((0, 0, 0), (1, 2, 3)), "z").at(5.0).plane) == 0
