# SPDX-License-Identifier: LGPL-2.1-or-later
"""Splines through many sections: the volume that is asked for, or nothing."""

import math
import unittest

import numpy as np

from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.wireframe import without
from freecad_trabecula.geometry.design import make_design
from freecad_trabecula.geometry.spline_solids import spline_solid


class SplineSolidTest(unittest.TestCase):
    def test_a_straight_round_rod_is_a_cylinder_and_another_volume_is_refused(self):
        rod = without(make_design(preset("case1")).wireframe, np.array([0]))
        volume = 10 * math.pi / 4 * float(rod.ends.first.size[0]) ** 2
        solid = spline_solid(rod, volume, 1e-6)
        self.assertTrue(solid.isValid())
        self.assertAlmostEqual(solid.Volume, volume, places=6)
        self.assertIsNone(spline_solid(rod, 1.1 * volume, 1e-3))


if __name__ == "__main__":
    unittest.main()
