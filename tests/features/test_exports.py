# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of objects: what is shown is written, what is not right is not."""

import os
import sys
import tempfile
import unittest
from pathlib import Path

import Part

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import NO_BOOLEANS, DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.core.meshes import is_closed, mesh_volume
from freecad_trabecula.core.stl import read_stl
from freecad_trabecula.errors import ExportError, ParameterError


class ExportTest(DocumentCase):
    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    @unittest.skipUnless(manifold_available(), NO_BOOLEANS)
    def test_the_stl_of_a_scaffold_has_its_volume_and_one_out_of_date_is_not_written(self):
        scaffold = make.make_scaffold(self.make(small_job()).wireframe)
        make.export(scaffold, self.path("scaffold.stl"))
        mesh = read_stl(self.path("scaffold.stl"))
        self.assertTrue(is_closed(mesh))
        self.assertLess(abs(mesh_volume(mesh) - scaffold.ScaffoldVolume.Value), 1e-3)
        scaffold.Wireframe.Seed = 3
        self.document.recompute()
        with self.assertRaisesRegex(ParameterError, "Scaffold must be up to date"):
            make.export(scaffold, self.path("old.stl"))
        with self.assertRaisesRegex(ParameterError, "Voids must be up to date|Voids must have triangles"):
            make.export(make.body_objects(scaffold)[2], self.path("voids.stl"))
        self.assertEqual(os.listdir(self.folder), ["scaffold.stl"])

    def test_the_step_of_an_envelope_is_read_again_as_it_was(self):
        make.export(make.make_box(self.document, 1, 2, 3), self.path("box.step"))
        self.assertAlmostEqual(Part.read(self.path("box.step")).Volume, 6, 9)

    def test_an_object_in_error_is_not_written(self):
        wireframe = self.make(small_job()).wireframe
        wireframe.PoreSizeHigh = 0.1
        self.document.recompute()
        with self.assertRaisesRegex(ParameterError, "must be without error.*low <= high"):
            make.export(wireframe, self.path("wires.step"))

    def test_the_wrong_kind_of_file_and_a_folder_that_is_not_there_are_refused(self):
        box = make.make_box(self.document)
        with self.assertRaisesRegex(ParameterError, "extension must be one of .*got 'box.stl'"):
            make.export(box, self.path("box.stl"))
        with self.assertRaisesRegex(ExportError, "could not be written"):
            make.export(box, os.path.join(self.folder, "none", "box.step"))
        with self.assertRaisesRegex(ParameterError, "must have a mesh or a shape"):
            make.export(self.document.addObject("App::FeaturePython", "Text"), self.path("text.step"))
        self.assertEqual(os.listdir(self.folder), [])
