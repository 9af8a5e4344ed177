# SPDX-License-Identifier: LGPL-2.1-or-later
"""The example projects: whole, without error, and taken from another process without computing anything again."""

import tempfile
import time
from unittest import mock

import FreeCAD
from document_case import DocumentCase

from freecad_trabecula import make
from freecad_trabecula.core.presets import example_file
from freecad_trabecula.errors import ParameterError, TrabeculaError
from freecad_trabecula.features import results
from freecad_trabecula.features.examples import EDGE, EXAMPLES
from freecad_trabecula.features.on_demand import Keyed
from freecad_trabecula.features.tasks import write_example_task

#: What each must hold, by the kinds of its objects.
KINDS = {
    "rods": {"PrismSites": 1, "Wireframe": 1, "Scaffold": 1, "Body": 3, "Analysis": 2},
    "measure": {"Analysis": 2},
    "voxels": {"VoxelDesign": 1, "Analysis": 2},
}


class ExamplesTest(DocumentCase):
    def kinds(self):
        found = {}
        for obj in self.document.Objects:
            kind = getattr(getattr(obj, "Proxy", None), "Type", "")
            if kind:
                found[kind.split("::")[1]] = found.get(kind.split("::")[1], 0) + 1
        return found

    def test_each_is_whole_without_error_and_computed_in_20_s(self):
        for name in EXAMPLES:
            with self.subTest(example=name):
                results.clear()
                started = time.process_time()
                make.make_example(self.document, name)
                self.assertLess(time.process_time() - started, 20)
                self.assertEqual(self.kinds(), KINDS[name])
                for obj in self.document.Objects:
                    self.assertTrue(obj.isValid(), obj.Label)
                    self.assertTrue(getattr(obj, "UpToDate", True), obj.Label)
                for obj in list(self.document.Objects)[::-1]:
                    self.document.removeObject(obj.Name)

    def test_sliced_areas_of_each_specimen_sum_up_to_the_volume_of_its_triangles(self):
        make.make_example(self.document, "measure")
        for obj in self.document.Objects:
            if hasattr(obj, "SliceVolume"):
                volume = obj.Source.Mesh.Volume
                self.assertAlmostEqual(obj.SliceVolume.Value / volume, 1, delta=0.005)
                self.assertAlmostEqual(obj.BoneFraction, 100 * volume / EDGE**3, delta=0.2)

    def test_the_voxels_equal_the_bone_in_every_layer_within_half_a_voxel(self):
        make.make_example(self.document, "voxels")
        bone, design = (make.analysis_of(obj) for obj in self.document.Objects if hasattr(obj, "SliceVolume"))
        for axis, profile in bone.profiles.items():
            apart = abs(design.profiles[axis].sliced_area - profile.sliced_area)
            self.assertLess(apart.max(), 0.1 * 0.1 * 3)  # rounding and the common total of the three axes

    def test_what_another_process_computed_is_taken_over_whole(self):
        for name in EXAMPLES:
            with self.subTest(example=name), tempfile.TemporaryDirectory() as folder:
                results.clear()
                write_example_task(folder, name)
                make.run_task(folder)
                self.assertEqual([one for one in FreeCAD.listDocuments() if one.startswith("Example")], [])
                results.clear()
                self.assertGreater(make.take_results(folder), 0)
                with mock.patch.object(Keyed, "_made", side_effect=AssertionError("computed again")):
                    make.make_example(self.document, name)
                self.assertTrue(all(obj.isValid() for obj in self.document.Objects))

    def test_an_unknown_example_is_refused_and_leaves_nothing(self):
        with self.assertRaisesRegex(ParameterError, "rods, measure, voxels, got 'other'"):
            make.make_example(self.document, "other")
        self.assertEqual(self.document.Objects, [])

    def test_an_example_whose_bone_is_missing_leaves_nothing(self):
        module = "freecad_trabecula.features.examples.example_file"
        refused = self.assertRaisesRegex(TrabeculaError, "nothing.ply")
        with mock.patch(module, lambda name: example_file("nothing.ply")), refused:
            make.make_example(self.document, "measure")
        self.assertEqual(self.document.Objects, [])
