# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layers of voxels as shapes: volumes and lengths against counts of voxels and sides."""

import unittest

import numpy as np

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.errors import Cancelled, ParameterError
from freecad_trabecula.geometry.voxel_shapes import layer_solids, layer_wires, shape_estimate

VOXEL, ORIGIN = (0.1, 0.2, 0.3), (1.0, 2.0, 3.0)


def random_design():
    return Stream(7, "voxels").uniform(4 * 9 * 8).reshape(4, 9, 8) < 0.55


class VoxelShapes(unittest.TestCase):
    def test_solids_of_layers_hold_the_volume_of_their_voxels(self):
        voxels = random_design()
        shape = layer_solids(voxels, VOXEL, ORIGIN, range(4))
        self.assertAlmostEqual(shape.Volume, voxels.sum() * 0.006, places=9)
        for layer, compound in zip(voxels, shape.SubShapes):
            self.assertTrue(all(solid.isValid() for solid in compound.Solids))
            self.assertAlmostEqual(compound.Volume, layer.sum() * 0.006, places=9)

    def test_wires_are_as_long_as_the_sides_between_solid_and_void(self):
        voxels = random_design()
        shape = layer_wires(voxels, VOXEL, ORIGIN, [2])
        padded = np.pad(voxels[2], 1).astype(int)
        along_x, along_y = (int(np.abs(np.diff(padded, axis=axis)).sum()) for axis in (0, 1))
        self.assertAlmostEqual(shape.Length, along_x * 0.1 + along_y * 0.2, places=9)
        self.assertTrue(all(wire.isClosed() for wire in shape.Wires))
        self.assertAlmostEqual(shape.BoundBox.ZMin, 3.0 + 2 * 0.3, places=6)

    def test_an_island_in_a_hole_is_a_solid_of_its_own(self):
        layer = np.ones((1, 7, 7), bool)
        layer[0, 1:6, 1:6] = False
        layer[0, 3, 3] = True
        solids = layer_solids(layer, (1, 1, 1), (0, 0, 0), [0]).Solids
        self.assertEqual(sorted(round(solid.Volume, 6) for solid in solids), [1, 24])

    def test_the_estimate_counts_the_corners(self):
        voxels = random_design()
        found = shape_estimate(voxels, range(4), True)
        self.assertEqual(
            found.corners, sum(len(w.Vertexes) for w in layer_wires(voxels, VOXEL, ORIGIN, range(4)).Wires)
        )
        self.assertGreater(found.step, 0)

    def test_a_layer_that_is_not_there_is_refused(self):
        with self.assertRaisesRegex(ParameterError, r"one of 0\.\.3, got 4"):
            layer_wires(random_design(), VOXEL, ORIGIN, [4])

    def test_it_can_be_stopped(self):
        def stop(done, total, what):
            raise Cancelled("stopped")

        with self.assertRaises(Cancelled):
            layer_solids(random_design(), VOXEL, ORIGIN, [0], stop)


if __name__ == "__main__":
    unittest.main()
