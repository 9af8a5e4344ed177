# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that FreeCAD opens, imports and exports through us, called as FreeCAD calls them."""

import importlib
import json
import os
import tempfile
import unittest
from pathlib import Path

import FreeCAD
import numpy as np
from document_case import DocumentCase

from freecad_trabecula import make
from freecad_trabecula.core.job import job_to_json
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.voxels.volume_files import read_npy, read_nrrd
from freecad_trabecula.errors import ParameterError

OURS = "freecad_trabecula.document_files"


class DocumentFilesTest(DocumentCase):
    def setUp(self):
        super().setUp()
        self.files = importlib.import_module(OURS)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name, text=None):
        """Return a file's path; with a text the file is written."""
        path = os.path.join(self.folder, name)
        if text is not None:
            Path(path).write_text(text, encoding="utf-8")
        return path

    def test_freecad_knows_which_files_are_ours(self):
        self.assertIn(OURS, FreeCAD.getImportType("json"))
        for kind in ("json", "npy", "nrrd", "vti"):
            self.assertIn(OURS, FreeCAD.getExportType(kind), kind)

    def test_a_job_is_opened_in_a_document_of_its_own_and_written_again_as_it_was(self):
        document = self.files.open(self.path("own.json", job_to_json(preset("case1"))))
        self.addCleanup(FreeCAD.closeDocument, document.Name)
        wireframe = document.getObject("Wireframe")
        self.assertEqual(wireframe.Rods, 75)
        self.files.export([wireframe], self.path("again.json"))
        first, second = (json.loads(Path(self.path(name)).read_text("utf-8")) for name in ("own.json", "again.json"))
        self.assertEqual({**first, "name": ""}, {**second, "name": ""})

    def test_a_job_is_inserted_into_the_document_that_is_open(self):
        self.files.insert(self.path("own.json", job_to_json(preset("case1"))), self.document.Name)
        self.assertEqual(self.document.getObject("Wireframe").Rods, 75)

    def test_what_is_no_job_is_refused_and_no_document_stays(self):
        before = set(FreeCAD.listDocuments())
        for text in ("no json", '{"schema": 1, "porez": {}}'):
            with self.assertRaises(ParameterError):
                self.files.open(self.path("bad.json", text))
            with self.assertRaises(ParameterError):
                self.files.insert(self.path("bad.json"), self.document.Name)
        with self.assertRaisesRegex(ParameterError, "cannot be read"):
            self.files.open(self.path("missing.json"))
        self.assertEqual((set(FreeCAD.listDocuments()), self.document.Objects), (before, []))

    def test_voxels_are_written_as_they_are(self):
        box = make.make_box(self.document, 2, 2, 2)
        parameters = VoxelParameters(size=(0.5, 0.5, 0.5), strategy="minimum-zeros")
        with self.assertRaises(ParameterError):
            make.make_voxel_design(self.document, box, parameters)  # full: nothing is left that could be designed
        network = make.make_network(make.make_design(self.document, preset("case1")).wireframe)
        design = make.make_voxel_design(self.document, network, parameters)
        voxels = make.voxel_design_of(design).voxels
        self.files.export([design], self.path("design.npy"))
        np.testing.assert_array_equal(read_npy(self.path("design.npy")), voxels)
        self.files.export([network, design], self.path("design.nrrd"))
        np.testing.assert_array_equal(read_nrrd(self.path("design.nrrd")).values > 0, voxels)

    def test_objects_that_have_no_such_file_are_refused(self):
        box = make.make_box(self.document, 2, 2, 2)
        for name in ("box.json", "box.npy"):
            with self.assertRaisesRegex(ParameterError, "must be selected"):
                self.files.export([box], self.path(name))
            self.assertFalse(os.path.exists(self.path(name)))


if __name__ == "__main__":
    unittest.main()
