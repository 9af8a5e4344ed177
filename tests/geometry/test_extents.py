# SPDX-License-Identifier: LGPL-2.1-or-later
"""The exact box around a solid."""

import math
import unittest
from pathlib import Path

import FreeCAD
import numpy as np
import Part

from freecad_trabecula.geometry.extents import exact_box

Vector = FreeCAD.Vector
EXAMPLES = Path(__file__).resolve().parent.parent.parent / "resources" / "examples"


class ExactBoxes(unittest.TestCase):
    def test_the_box_of_a_tilted_torus_has_its_closed_form(self):
        axis = Vector(1, 2, 2) * (1 / 3)
        low, high = exact_box(Part.makeTorus(5, 2, Vector(1, 2, 3), axis))
        # Half the extent along a unit vector e: R sqrt(1 - (a.e)^2) + r.
        half = [5 * math.sqrt(1 - c * c) + 2 for c in axis]
        np.testing.assert_allclose(low, np.array([1, 2, 3]) - half, atol=1e-8)
        np.testing.assert_allclose(high, np.array([1, 2, 3]) + half, atol=1e-8)

    def test_the_box_of_a_spline_is_the_same_before_and_after_triangulation(self):
        shape = Part.Shape()
        shape.read(str(EXAMPLES / "cranial_plate.step"))
        before = exact_box(shape)
        shape.tessellate(0.05)
        np.testing.assert_array_equal(before, exact_box(shape))
        # FreeCAD's box of the triangles, from inside; its box of the poles reaches to x = -45.
        box = shape.BoundBox
        np.testing.assert_allclose(before[0], [box.XMin, box.YMin, box.ZMin], atol=0.01)
        np.testing.assert_allclose(before[1], [box.XMax, box.YMax, box.ZMax], atol=0.01)

    def test_the_box_of_a_bulged_disc_reaches_to_the_middle_of_its_bulge(self):
        cap = Part.makeSphere(5).common(Part.makeBox(20, 20, 20, Vector(-10, -10, 3)))
        low, high = exact_box(cap)
        np.testing.assert_allclose(low, [-4, -4, 3], atol=1e-8)
        np.testing.assert_allclose(high, [4, 4, 5], atol=1e-8)

    def test_what_is_trimmed_away_does_not_count(self):
        wedge = Part.makeCylinder(5, 4, Vector(), Vector(0, 0, 1), 60)
        low, high = exact_box(wedge)
        np.testing.assert_allclose(low, [0, 0, 0], atol=1e-8)
        np.testing.assert_allclose(high, [5, 5 * math.sin(math.pi / 3), 4], atol=1e-8)
