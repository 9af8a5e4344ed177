# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points between numpy and FreeCAD."""

import unittest

import FreeCAD
import numpy as np

from freecad_trabecula.geometry.vectors import point_array, vector, vectors


class Vectors(unittest.TestCase):
    def test_points_come_back_as_they_went(self):
        points = np.random.default_rng(1).normal(size=(5, 3))
        np.testing.assert_array_equal(point_array(vectors(points)), points)
        np.testing.assert_array_equal(tuple(vector(points[0])), points[0])

    def test_single_precision_and_integers_are_taken(self):
        self.assertEqual(tuple(vector(np.array([1, 2, 3]))), (1, 2, 3))
        self.assertEqual(tuple(vector(np.array([0.5, 2, 3], np.float32))), (0.5, 2, 3))
        self.assertEqual(tuple(vector(FreeCAD.Vector(1, 2, 3))), (1, 2, 3))

    def test_no_points_keep_their_shape(self):
        self.assertEqual((point_array([]).shape, vectors(np.zeros((0, 3)))), ((0, 3), []))

    def test_two_or_four_numbers_are_no_point(self):
        for numbers in ((1, 2), (1, 2, 3, 4)):
            with self.assertRaises(ValueError):
                vector(numbers)
