# SPDX-License-Identifier: LGPL-2.1-or-later
"""Voxel designs in a document: made, changed, saved, followed, refused; counts against the sample's own sections."""

import os
import tempfile
import unittest

import Mesh
import numpy as np
from document_case import NO_BOOLEANS, DocumentCase

from freecad_trabecula import make
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.drawn_curves import DrawnCurves
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.errors import InfeasibleError, KernelError, ParameterError
from freecad_trabecula.features import results
from freecad_trabecula.features.voxel_design import packed_bits, unpacked_bits

HALF = VoxelParameters(size=(0.5, 0.5, 0.5))


class VoxelDesigns(DocumentCase):
    def bracket(self):
        """A box of 4 mm less one of 2 x 2 x 4 mm: 48 mm3, layers along Z of 12 mm2."""
        bracket = self.document.addObject("Part::Feature", "Bracket")
        whole, less = make.make_box(self.document, 4, 4, 4), make.make_box(self.document, 2, 2, 4)
        bracket.Shape = whole.Shape.cut(less.Shape)
        return bracket

    def counts(self, obj):
        voxels = make.voxel_design_of(obj).voxels
        return [voxels.sum(axes).tolist() for axes in ((0, 1), (0, 2), (1, 2))]

    def test_every_layer_has_the_area_of_the_body_s_own_section(self):
        bracket = self.bracket()
        design = make.make_voxel_design(self.document, bracket, HALF)
        # sections by hand: 2 x 4 or 4 x 4 mm2 across X and Y, 12 mm2 across Z; 0.25 mm2 a voxel
        across = [32] * 4 + [64] * 4
        self.assertEqual(self.counts(design), [across, across, [48] * 8])
        self.assertTrue(design.Exact and design.Watertight)
        self.assertEqual((design.Components, design.ClosedCavities), (1, 0))
        self.assertAlmostEqual(design.VoxelVolume.Value, 48, places=9)
        self.assertAlmostEqual(design.MeshVolume.Value, 48, places=9)
        self.assertTrue(design.Mesh.isSolid())

    def test_an_analysis_is_a_sample_too(self):
        analysis = make.make_analysis(self.document, self.bracket(), SliceParameters(thickness=0.5))
        design = make.make_voxel_design(self.document, analysis, HALF)
        self.assertEqual(design.Voxels, 384)
        with self.assertRaisesRegex(ParameterError, "as large as the layers"), self.unchanged():
            make.make_voxel_design(self.document, analysis, VoxelParameters(size=(0.4, 0.4, 0.4)))

    def test_it_follows_its_source_and_its_properties(self):
        bracket = self.bracket()
        design = make.make_voxel_design(self.document, bracket, HALF)
        bracket.Shape = make.make_box(self.document, 4, 4, 4).Shape.cut(make.make_box(self.document, 2, 2, 2).Shape)
        self.document.recompute()
        self.assertEqual(design.Voxels, 448)
        design.VoxelSeed = 5
        self.document.recompute()
        self.assertTrue(design.UpToDate)
        self.assertEqual(make.voxel_design_of(design).parameters.seed, 5)

    def test_it_is_the_same_after_saving_and_needs_no_computing(self):
        made = make.make_voxel_design(self.document, self.bracket(), HALF)
        voxels, name = make.voxel_design_of(made).voxels.copy(), made.Name
        found = self.reopened().getObject(name)
        self.assertTrue((make.voxel_design_of(found).voxels == voxels).all())
        self.assertEqual(make.voxel_design_of(found).targets.sample, None)
        self.document.recompute()
        self.assertTrue(found.UpToDate)
        self.assertIsNone(results.find("voxels", found.ResultKey))

    def test_the_same_seed_gives_the_same_voxels_and_another_seed_others(self):
        # of a bracket's layers there is one design only: blotches of noise have many
        noise = Stream(1, "sample").uniform(18**3).reshape(18, 18, 18)
        blurred = sum(np.roll(noise, (i, j, k), (0, 1, 2)) for i in range(4) for j in range(4) for k in range(4))
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = os.path.join(folder.name, "sample.npy")
        np.save(path, blurred > np.median(blurred))

        def voxels(seed):
            results.clear()
            parameters = VoxelParameters(size=HALF.size, seed=seed)
            return make.voxel_design_of(make.make_voxel_design(self.document, path, parameters)).voxels

        first = voxels(1)
        self.assertTrue((voxels(1) == first).all())
        self.assertFalse((voxels(2) == first).all())

    def test_a_smooth_surface_keeps_the_volume_and_other_outsides_are_refused(self):
        bracket = self.bracket()
        design = make.make_voxel_design(self.document, bracket, HALF, surface="smooth")
        self.assertAlmostEqual(design.MeshVolume.Value / 48, 1, delta=0.02)
        with self.assertRaisesRegex(ParameterError, "blocks, smooth, got 'rough'"), self.unchanged():
            make.make_voxel_design(self.document, bracket, HALF, surface="rough")

    def test_voxels_lie_within_an_envelope(self):
        bracket = self.bracket()
        design = make.make_voxel_design(self.document, bracket, HALF, envelope=bracket)
        # the envelope is the sample itself: only one design fills it
        self.assertEqual(design.BoneFraction, 100)
        self.assertFalse(make.voxel_design_of(design).voxels[:, :4, :4].any())

    def test_layers_become_wires_and_solids(self):
        design = make.make_voxel_design(self.document, self.bracket(), HALF)
        solids = make.make_layer_shapes(design, [0, 3], solid=True)
        self.assertAlmostEqual(solids.Shape.Volume, 2 * 48 * 0.125, places=9)
        self.assertTrue(make.make_layer_shapes(design, [0]).Shape.Wires)
        with self.assertRaisesRegex(ParameterError, r"0\.\.7, got 8"), self.unchanged():
            make.make_layer_shapes(design, [8])

    @unittest.skipUnless(manifold_available(), NO_BOOLEANS)
    def test_a_design_is_added_to_a_body_and_cut_from_it(self):
        design = make.make_voxel_design(self.document, self.bracket(), HALF)
        half = make.make_box(self.document, 4, 4, 2)  # 32 mm3, of which the bracket fills 24
        volumes = {"union": 48 + 32 - 24, "difference": 8, "intersection": 24}
        for kind, volume in volumes.items():
            found = make.combine_with_body(design, half, kind)
            self.assertAlmostEqual(found.Mesh.Volume, volume, places=3)
            self.assertTrue(found.Mesh.isSolid())
        with self.assertRaisesRegex(ParameterError, "must be one of .* got 'glue'"), self.unchanged():
            make.combine_with_body(design, half, "glue")
        apart = make.make_box(self.document, 1, 1, 1)
        apart.Placement.Base.z = 50
        with self.assertRaisesRegex(ParameterError, "must leave some volume"), self.unchanged():
            make.combine_with_body(design, apart, "intersection")

    def test_a_task_for_another_process_gives_the_same(self):
        design = make.make_voxel_design(self.document, self.bracket(), HALF)
        voxels = make.voxel_design_of(design).voxels.copy()
        results.clear()
        with tempfile.TemporaryDirectory() as folder:
            make.write_task(folder, [design])
            make.run_task(folder)
            results.clear()
            self.assertEqual(make.take_results(folder), 1)
        self.assertTrue((make.voxel_design_of(design).voxels == voxels).all())
        self.assertIsNotNone(results.find("voxels", design.ResultKey))

    def test_files_of_meshes_and_of_voxels_are_samples(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "bracket.stl")
            Mesh.Mesh(self.bracket().Shape.tessellate(0.1)).write(path)
            self.assertEqual(make.make_voxel_design(self.document, path, HALF).Voxels, 384)
            array = np.zeros((4, 4, 4), bool)
            array[:, :, 1:3] = True
            np.save(os.path.join(folder, "voxels.npy"), array)
            design = make.make_voxel_design(self.document, os.path.join(folder, "voxels.npy"), HALF)
            self.assertEqual(self.counts(design)[0], [0, 16, 16, 0])

    def test_the_estimate_knows_the_layers_before_anything_is_made(self):
        bracket = self.bracket()
        analysis = make.make_analysis(self.document, bracket, SliceParameters(thickness=0.5))
        with tempfile.TemporaryDirectory() as folder:
            mesh, table = os.path.join(folder, "bracket.stl"), os.path.join(folder, "voxels.npy")
            Mesh.Mesh(bracket.Shape.tessellate(0.1)).write(mesh)
            np.save(table, np.arange(60).reshape(3, 4, 5) % 2)
            for sample, layers in ((bracket, (8, 8, 8)), (analysis, (8, 8, 8)), (mesh, (8, 8, 8)), (table, (5, 4, 3))):
                self.assertEqual(make.estimate_voxel_design(sample, HALF).layers, layers)
            for sample in (bracket, mesh):
                with self.assertRaisesRegex(ParameterError, "would take about"):
                    make.estimate_voxel_design(sample, VoxelParameters(size=(0.002, 0.002, 0.002)))
            with self.assertRaisesRegex(ParameterError, "slice it again"):
                make.estimate_voxel_design(analysis, VoxelParameters(size=(0.4, 0.4, 0.4)))

    def test_what_cannot_be_is_refused_and_the_document_stays_as_it_was(self):
        box = make.make_box(self.document, 4, 4, 4)
        with self.unchanged():
            with self.assertRaisesRegex(ParameterError, "must have voids"):
                make.make_voxel_design(self.document, box, HALF)
            with self.assertRaisesRegex(ParameterError, "must not be larger than the sample"):
                make.make_voxel_design(self.document, box, VoxelParameters(size=(5.0, 5.0, 5.0)))
            with self.assertRaises((ParameterError, KernelError)):
                make.make_voxel_design(self.document, "no such file.stl", HALF)
        bracket = self.bracket()
        with self.assertRaises((ParameterError, InfeasibleError)), self.unchanged():
            make.make_voxel_design(self.document, bracket, VoxelParameters(size=HALF.size, cap_alpha=1))

    def test_given_tables_are_filled_kept_and_taken_back(self):
        plain = VoxelParameters(size=HALF.size, strategy="random-layers")
        obj = make.make_voxel_design(self.document, self.bracket(), plain)
        design = make.voxel_design_of(obj)
        chosen = VoxelParameters(size=HALF.size, strategy="sequential", seed=3)
        make.change_voxel_design(obj, chosen, tables=(design.alpha, design.beta))
        found = make.voxel_design_of(obj)
        self.assertTrue((found.alpha == design.alpha).all() and (found.beta == design.beta).all())
        self.assertEqual(list(obj.Alpha), design.alpha.ravel().tolist())
        name = obj.Name
        again = self.reopened().getObject(name)
        self.assertTrue((make.voxel_design_of(again).targets.tables[0] == design.alpha).all())
        make.change_voxel_design(again, chosen)
        self.assertEqual((list(again.Alpha), make.voxel_design_of(again).targets.tables), ([], None))

    def test_tables_that_do_not_go_are_refused(self):
        obj = make.make_voxel_design(self.document, self.bracket(), HALF)
        design = make.voxel_design_of(obj)
        tables = (design.alpha, design.beta)
        with self.assertRaisesRegex(
            ParameterError, "given tables need a strategy that fills layers from them .*got trab"
        ):
            make.change_voxel_design(obj, HALF, tables=tables)
        chosen = VoxelParameters(size=HALF.size, strategy="sequential")
        wrong = design.alpha.copy()
        wrong[0, 0] += 1
        with self.assertRaisesRegex(ParameterError, "table alpha: row 0 sums to"):
            make.change_voxel_design(obj, chosen, tables=(wrong, design.beta))
        with self.assertRaisesRegex(ParameterError, "table alpha must have 8 x 8 cells for these targets, got 3"):
            make.change_voxel_design(obj, chosen, tables=([1, 2, 3], [1, 2, 3]))


class Curves(DocumentCase):
    CURVES = DrawnCurves((4.0, 4.0, 4.0), ((0.0, 0.25), (1.0, 0.75)), ((0.0, 0.5),), ((0.0, 0.75), (1.0, 0.25)))

    def test_a_design_has_the_shares_of_drawn_curves_and_follows_them(self):
        obj = make.make_voxel_design(self.document, self.CURVES, HALF)
        # straight from a quarter to three quarters of 64 cells: 18, 22 ... 46 by layers' middles
        rising = list(range(18, 47, 4))
        voxels = make.voxel_design_of(obj).voxels
        self.assertEqual(voxels.sum((0, 1)).tolist(), rising)
        self.assertEqual(voxels.sum((0, 2)).tolist(), [32] * 8)
        self.assertEqual(voxels.sum((1, 2)).tolist(), rising[::-1])
        name, key = obj.Name, obj.ResultKey
        found = self.reopened().getObject(name)
        self.document.recompute()
        self.assertEqual((found.UpToDate, found.ResultKey), (True, key))
        found.CurveX = [(0.0, 0.5, 0.0)]
        found.CurveZ = [(0.0, 0.5, 0.0)]
        self.document.recompute()
        self.assertEqual(make.voxel_design_of(found).voxels.sum((0, 1)).tolist(), [32] * 8)
        make.change_voxel_design(found, HALF, curves=self.CURVES)
        self.assertEqual(make.voxel_design_of(found).voxels.sum((0, 1)).tolist(), rising)

    def test_another_process_makes_the_same(self):
        obj = make.make_voxel_design(self.document, self.CURVES, HALF)
        voxels = make.voxel_design_of(obj).voxels.copy()
        results.clear()
        with tempfile.TemporaryDirectory() as folder:
            make.write_task(folder, [obj])
            make.run_task(folder)
            results.clear()
            self.assertEqual(make.take_results(folder), 1)
        self.assertTrue((make.voxel_design_of(obj).voxels == voxels).all())

    def test_what_cannot_be_drawn_is_refused(self):
        self.assertEqual(make.estimate_voxel_design(self.CURVES, HALF).layers, (8, 8, 8))
        with self.unchanged(), self.assertRaisesRegex(ParameterError, "must have material"):
            nothing = ((0.0, 0.0),)
            make.make_voxel_design(self.document, DrawnCurves((4.0,) * 3, nothing, nothing, nothing), HALF)
        obj = make.make_voxel_design(self.document, self.CURVES, HALF)
        obj.CurveX = [(0.0, 1.5, 0.0)]
        self.document.recompute()
        self.assertIn("must not be larger than its layer, got 1.5", obj.Status)
        other = make.make_voxel_design(self.document, VoxelDesigns.bracket(self), HALF)
        with self.assertRaisesRegex(ParameterError, "must be made of curves to get others"):
            make.change_voxel_design(other, HALF, curves=self.CURVES)


class Bits(unittest.TestCase):
    def test_bits_come_back_from_numbers_whatever_their_count(self):
        for count in (0, 1, 47, 48, 49, 1000):
            flags = np.arange(count) * 7 % 11 < 5
            numbers = packed_bits(flags)
            self.assertTrue((numbers == np.floor(numbers)).all())
            self.assertEqual(unpacked_bits(numbers, (count,)).tolist(), flags.tolist())


if __name__ == "__main__":
    unittest.main()
