# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids of patches: valid, with the volumes of closed forms and of quadrature, the same after STEP."""

import dataclasses
import math
import tempfile
import unittest
from pathlib import Path

import FreeCAD
import numpy as np
import Part

from freecad_trabecula.core.paths import straight_paths
from freecad_trabecula.core.pores import circles
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.rods import RodEnds
from freecad_trabecula.core.strips import rod_strips
from freecad_trabecula.errors import Cancelled, KernelError
from freecad_trabecula.geometry import patch_solids as module
from freecad_trabecula.geometry.design import make_design
from freecad_trabecula.geometry.envelopes import box_envelope, envelope_from_shape
from freecad_trabecula.geometry.patch_solids import patch_solids, planes_of

AXES = np.array([[[1.0, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 0], [0, 0, 1], [1, 0, 0]]])


def cylinders(diameters, middle, length):
    """Strips of cylinders along z and x through points (R, 3)."""
    axes = AXES[: len(diameters)]
    sizes = circles(np.array(diameters))
    ends = RodEnds(np.repeat(axes[:, None], 2, 1), sizes, sizes, np.zeros(len(diameters)))
    middle = np.array(middle, float)
    return rod_strips(straight_paths(middle - axes[:, 2] * length / 2, middle + axes[:, 2] * length / 2), ends, 1, 0.2)


def common_of(large, small, apart):
    """Volume inside two cylinders with crossing directions whose axes are ``apart``: an integral of rectangles."""
    nodes, weights = np.polynomial.legendre.leggauss(400)
    angle = nodes * math.pi / 2
    y = apart + small * np.sin(angle)
    heights = 2 * small * np.cos(angle) * 2 * np.sqrt(large**2 - y**2)
    return float((weights * math.pi / 2 * heights * small * np.cos(angle)).sum())


class PatchSolidsTest(unittest.TestCase):
    def test_one_channel_takes_its_cylinder_away(self):
        made = patch_solids(cylinders([1.2], [[2, 2, 2]], 4), box_envelope(4, 4, 4).mesh)
        (solid,) = made.solids
        self.assertTrue(solid.isValid())
        self.assertEqual(len(solid.Faces), 10)
        self.assertEqual(made.rough, 0)
        self.assertAlmostEqual(solid.Volume, 64 - math.pi * 0.36 * 4, delta=1e-3)

    def test_two_crossing_channels_share_what_the_integral_says_before_and_after_step(self):
        made = patch_solids(cylinders([1.2, 0.8], [[2, 2, 2], [2, 2.1, 2]], 4), box_envelope(4, 4, 4).mesh)
        true = 64 - math.pi * 4 * (0.6**2 + 0.4**2) + common_of(0.6, 0.4, 0.1)
        self.assertTrue(made.solids[0].isValid())
        self.assertAlmostEqual(made.solids[0].Volume, true, delta=3e-3)
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "crossing.step")
            made.solids[0].exportStep(path)
            again = Part.Shape()
            again.read(path)
        self.assertTrue(again.isValid())
        self.assertAlmostEqual(again.Volume, made.solids[0].Volume, delta=1e-4)

    def test_a_prism_with_slanted_sides_keeps_its_planes(self):
        corners = [(0, 0, 0), (4, 0, 0), (5, 4, 0), (0, 4, 0), (0, 0, 0)]
        base = Part.Face(Part.makePolygon([FreeCAD.Vector(*corner) for corner in corners]))
        prism = envelope_from_shape(base.extrude(FreeCAD.Vector(0, 0, 4)))
        made = patch_solids(cylinders([1.0], [[2, 2, 2]], 4), prism.mesh)
        self.assertEqual(len(planes_of(prism.mesh)[0]), 6)
        self.assertAlmostEqual(made.volume, 72 - math.pi * 0.25 * 4, delta=1e-3)

    def test_pieces_that_a_channel_cuts_off_are_made_on_demand(self):
        strips, mesh = cylinders([3.0], [[2, 0.5, 2]], 4), box_envelope(4, 1, 4).mesh
        largest, all_of_it = patch_solids(strips, mesh), patch_solids(strips, mesh, all_pieces=True)
        # the channel, 3 mm wide about the middle of a plate 1 mm thick, leaves a piece on either side
        half = 1.5**2 * math.asin(0.5 / 1.5) + 0.5 * math.sqrt(1.5**2 - 0.25)
        self.assertEqual([len(largest.solids), len(all_of_it.solids)], [1, 2])
        self.assertAlmostEqual(all_of_it.volume, 16 - 8 * half, delta=6e-3)
        self.assertAlmostEqual(largest.solids[0].Volume, 8 - 4 * half, delta=3e-3)
        self.assertAlmostEqual(largest.volume, all_of_it.volume, delta=0.03)  # one piece by its triangles

    def test_seams_of_faces_that_the_kernel_refuses_go_back_to_the_triangles(self):
        class Doubting:
            """A solid that is refused once."""

            refusals = 1

            def __init__(self, shape):
                self._shape = shape

            def isValid(self):  # noqa: N802
                Doubting.refusals -= 1
                return Doubting.refusals < 0 and self._shape.isValid()

            def __getattr__(self, name):
                return getattr(self._shape, name)

        right = module.read_brep
        module.read_brep = lambda text: Doubting(right(text))
        try:
            made = patch_solids(cylinders([1.2, 0.8], [[2, 2, 2], [2, 2.1, 2]], 4), box_envelope(4, 4, 4).mesh)
        finally:
            module.read_brep = right
        true = 64 - math.pi * 4 * (0.6**2 + 0.4**2) + common_of(0.6, 0.4, 0.1)
        self.assertGreater(made.rough, 0)
        self.assertGreater(made.tolerance, 1e-5)
        self.assertTrue(made.solids[0].isValid())
        self.assertAlmostEqual(made.volume, true, delta=0.03)

    def test_a_body_that_the_kernel_never_takes_is_refused(self):
        right, attempts = module._settled, module._ATTEMPTS
        module._settled, module._ATTEMPTS = (lambda *_: (None, set())), 2
        try:
            with self.assertRaisesRegex(KernelError, "bounded by seams that do not cross, got 0 of"):
                patch_solids(cylinders([1.2], [[2, 2, 2]], 4), box_envelope(4, 4, 4).mesh)
        finally:
            module._settled, module._ATTEMPTS = right, attempts

    def test_it_can_be_cancelled(self):
        def stop(done, total, what):
            raise Cancelled("stopped")

        with self.assertRaises(Cancelled):
            patch_solids(cylinders([1.2], [[2, 2, 2]], 4), box_envelope(4, 4, 4).mesh, progress=stop)

    def test_curved_spline_rods_that_cross_make_a_valid_solid(self):
        job = preset("case6")
        job = dataclasses.replace(job, couplings=tuple(dataclasses.replace(c, limit=4) for c in job.couplings))
        design = make_design(job)
        strips = rod_strips(design.wireframe.paths, design.wireframe.ends, 4, 0.2)
        made = patch_solids(strips, design.envelope.mesh)
        self.assertTrue(made.solids[0].isValid())
        self.assertLess(made.tolerance, 0.01)


if __name__ == "__main__":
    unittest.main()
