# SPDX-License-Identifier: LGPL-2.1-or-later
"""Variants by other seeds: each is what a design of that seed is; the document stays; the same in another process."""

import tempfile
import unittest

import numpy as np
from document_case import NO_BOOLEANS, DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.core.variants import RAYS, SCAFFOLD
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.errors import ParameterError
from freecad_trabecula.features import results
from freecad_trabecula.features.tasks import write_variants_task
from freecad_trabecula.features.variants import POROSITY, read_variants

HALF = VoxelParameters(size=(0.5, 0.5, 0.5))


class VariantCase(DocumentCase):
    def elsewhere(self, obj, seeds, by=RAYS):
        with tempfile.TemporaryDirectory() as folder:
            write_variants_task(folder, obj, seeds, by)
            results.clear()
            make.run_task(folder)
            return read_variants(folder)

    def assert_same(self, first, second):
        self.assertEqual([row.seed for row in first.rows], [row.seed for row in second.rows])
        for a, b in zip(first.rows, second.rows):
            self.assertEqual(a.numbers, b.numbers)
            np.testing.assert_array_equal(a.picture, b.picture)
        np.testing.assert_array_equal(first.overlap, second.overlap)

    def bracket(self):
        body = self.document.addObject("Part::Feature", "Bracket")
        body.Shape = make.make_box(self.document, 4, 4, 4).Shape.cut(make.make_box(self.document, 2, 2, 4).Shape)
        return body


class RodVariants(VariantCase):
    @unittest.skipUnless(manifold_available(), NO_BOOLEANS)
    def test_each_has_the_porosity_of_a_scaffold_with_its_seed_and_the_design_keeps_its_own(self):
        wireframe = self.make(small_job(seed=5)).wireframe
        before = (wireframe.Seed, wireframe.Numbers, len(self.document.Objects))
        exact = make.make_variants(wireframe, [6, 7], SCAFFOLD)
        quick = make.make_variants(wireframe, [6, 7])
        self.assertEqual((wireframe.Seed, wireframe.Numbers, len(self.document.Objects)), before)
        for number, seed in enumerate((6, 7)):
            own = make.make_scaffold(self.make(small_job(seed=seed)).wireframe)
            self.assertAlmostEqual(exact.rows[number].numbers[POROSITY], own.Porosity, places=9)
            error = quick.rows[number].numbers["standard error, %"]
            self.assertLess(abs(quick.rows[number].numbers[POROSITY] - own.UnionPorosity), 5 * error + 0.01)
            self.assertGreater((exact.rows[number].picture < 255).mean(), 0.3)

    def test_they_are_the_same_in_another_process_with_changes_by_hand(self):
        wireframe = self.make(small_job(seed=5)).wireframe
        make.switch_off_site(wireframe, "Face1.1.1")
        here = make.make_variants(wireframe, [5, 9])
        self.assertEqual([row.numbers["rods"] for row in here.rows], [26.0, 26.0])
        self.assert_same(here, self.elsewhere(wireframe, [5, 9]))

    def test_another_way_or_another_object_is_refused(self):
        design = self.make(small_job())
        with self.assertRaisesRegex(ParameterError, "one of estimate by rays, scaffold, got 'guess'"):
            make.make_variants(design.wireframe, [1], "guess")
        with self.assertRaisesRegex(ParameterError, "of a wireframe or of a voxel design, got Envelope"):
            make.make_variants(design.envelope, [1])


class VoxelVariants(VariantCase):
    def test_each_is_the_design_of_its_seed_and_overlaps_are_those_of_dice(self):
        design = make.make_voxel_design(self.document, self.bracket(), HALF)
        found = make.make_variants(design, [1, 2])
        voxels = []
        for seed in (1, 2):
            design.VoxelSeed = seed
            make.update(design)
            voxels.append(make.voxel_design_of(design).voxels.copy())
        common = np.count_nonzero(voxels[0] & voxels[1])
        self.assertAlmostEqual(found.overlap[0, 1], 2 * common / (voxels[0].sum() + voxels[1].sum()), places=12)
        self.assertAlmostEqual(found.rows[0].numbers["mean overlap, %"], 100 * found.overlap[0, 1], places=9)
        self.assertEqual(found.rows[0].numbers["connected parts"], 1.0)
        self.assert_same(found, self.elsewhere(design, [1, 2]))
