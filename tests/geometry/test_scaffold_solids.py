# SPDX-License-Identifier: LGPL-2.1-or-later
"""The B-Rep engine: right volumes, budgets obeyed, how far it came told, wrong steps never kept."""

import dataclasses
import math
import unittest

import FreeCAD
import numpy as np
import Part

from freecad_trabecula.core.parameters import Coupling, LayerParameters, ScaffoldParameters
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.wireframe import without
from freecad_trabecula.errors import Cancelled, KernelError, ParameterError
from freecad_trabecula.geometry import scaffold_solids
from freecad_trabecula.geometry.design import make_design
from freecad_trabecula.geometry.envelopes import envelope_from_shape
from freecad_trabecula.geometry.scaffold_solids import VOLUME_TOLERANCE, cut_solid


def few(name, limit):
    """Return the job of a preset with at most so many rods a coupling."""
    job = preset(name)
    return dataclasses.replace(job, couplings=tuple(dataclasses.replace(c, limit=limit) for c in job.couplings))


def never(*_):
    raise KernelError("not today")


def cut(job, scaffold=None, progress=lambda *_: None):
    design = make_design(job)
    return design, cut_solid(design.envelope, design.wireframe, job.rods, scaffold or job.scaffold, progress)


class ScaffoldSolidTest(unittest.TestCase):
    def test_channels_that_do_not_cross_take_away_their_cylinders(self):
        job = few("case1", 0)
        job = dataclasses.replace(job, couplings=(dataclasses.replace(job.couplings[2], limit=6),))
        design, made = cut(job)
        sizes = design.wireframe.ends.first.size
        self.assertTrue(made.complete)
        self.assertEqual(made.shape.ShapeType, "Solid")
        self.assertAlmostEqual(made.shape.Volume, 1000 - 10 * math.pi / 4 * float((sizes**2).sum()), delta=1e-3)

    def test_crossing_straight_and_curved_rods_have_the_meshes_volume(self):
        for name in ("case2", "case4", "case6"):
            with self.subTest(name):
                _, made = cut(few(name, 2))
                self.assertTrue(made.complete, made.reason)
                self.assertTrue(made.shape.isValid())
                self.assertLess(abs(made.volume / made.mesh_volume - 1), VOLUME_TOLERANCE)

    def test_rods_are_cut_away_one_after_the_other_where_patches_do_not_make_a_solid(self):
        patches = scaffold_solids.patch_solids
        job = few("case6", 1)
        _, of_patches = cut(job)
        scaffold_solids.patch_solids = never
        try:
            _, made = cut(job)
        finally:
            scaffold_solids.patch_solids = patches
        self.assertTrue(made.complete, made.reason)
        self.assertEqual(made.reason, "")
        self.assertAlmostEqual(made.volume, of_patches.volume, delta=1e-6 * made.volume)

    def test_in_a_cylinder_the_kernel_cuts_the_rods_away(self):
        wireframe = make_design(few("case1", 1)).wireframe
        round_one = envelope_from_shape(Part.makeCylinder(20, 10, FreeCAD.Vector(5, 5, 0)))
        job = preset("case1")
        made = cut_solid(round_one, without(wireframe, np.array([2])), job.rods, job.scaffold)
        size = float(wireframe.ends.first.size[2])
        self.assertTrue(made.complete, made.reason)
        self.assertAlmostEqual(made.volume, math.pi * 4000 - 10 * math.pi / 4 * size**2, delta=1e-2)

    def test_a_used_up_time_budget_is_told_with_how_far_it_came(self):
        job = few("case1", 0)
        limits = dataclasses.replace(job.scaffold, seconds=1.0)
        _, made = cut(job, limits)
        self.assertFalse(made.complete)
        self.assertLess(made.rods, made.wanted)
        self.assertIn("time budget of 1 s", made.reason)
        self.assertLess(abs(made.volume / made.mesh_volume - 1), VOLUME_TOLERANCE)

    def test_a_wrong_step_is_never_kept(self):
        job = few("case1", 1)
        right, patches = scaffold_solids.read_brep, scaffold_solids.patch_solids

        def half(text):
            shape = right(text)
            return shape.common(scaffold_solids.Part.makeBox(5, 10, 10))

        scaffold_solids.read_brep, scaffold_solids.patch_solids = half, never
        try:
            _, made = cut(job)
        finally:
            scaffold_solids.read_brep, scaffold_solids.patch_solids = right, patches
        self.assertFalse(made.complete)
        self.assertIn("no solid of patches: not today; then", made.reason)
        self.assertIn("wrongly in every way tried", made.reason)
        self.assertAlmostEqual(made.volume, made.mesh_volume, delta=1e-6 * made.volume)

    def test_it_can_be_cancelled_between_steps(self):
        def stop(done, total, what):
            raise Cancelled("stopped")

        with self.assertRaises(Cancelled):
            cut(few("case1", 1), progress=stop)

    def test_compact_layers_are_refused(self):
        layers = LayerParameters(faces=("Face5",))
        with self.assertRaisesRegex(ParameterError, "no compact layers, got 1 face"):
            cut(few("case1", 1), ScaffoldParameters(layers=layers))

    def test_no_rod_leaves_the_envelope(self):
        job = few("case1", 1)
        job = dataclasses.replace(job, couplings=(*(dataclasses.replace(c, on=False) for c in job.couplings),
                                                  Coupling("Face1", "Face2", on=False)))  # fmt: skip
        _, made = cut(job)
        self.assertAlmostEqual(made.shape.Volume, 1000.0)


if __name__ == "__main__":
    unittest.main()
