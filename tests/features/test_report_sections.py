# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document's report: what its objects hold, told in one page; what cannot be told is named."""

import os
import tempfile
import unittest
from unittest import mock

from document_case import NO_BOOLEANS, DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.core.html_report.sections import Picture
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.errors import ExportError, ParameterError
from freecad_trabecula.features import report_sections
from freecad_trabecula.features.tasks import write_report_task

HALF = SliceParameters(thickness=0.5)


class ReportCase(DocumentCase):
    def page(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "report.html")
            notes = make.write_report(self.document, path)
            with open(path, encoding="utf-8") as file:
                return file.read(), notes

    def bracket(self):
        bracket = self.document.addObject("Part::Feature", "Bracket")
        bracket.Shape = make.make_box(self.document, 4, 4, 4).Shape.cut(make.make_box(self.document, 2, 2, 4).Shape)
        return bracket

    @unittest.skipUnless(manifold_available(), NO_BOOLEANS)
    def test_it_tells_of_design_analyses_and_comparison_without_computing_again(self):
        design = make.make_design(self.document, small_job(seed=4), ("network", "scaffold"))
        design.wireframe.Label = "<b>Mine</b>"
        make.make_analysis(self.document, design.scaffold, HALF)
        make.make_analysis(self.document, design.envelope, HALF)
        with mock.patch("freecad_trabecula.features.scaffold.cut", side_effect=AssertionError("cut again")):
            page, notes = self.page()
        self.assertEqual(notes, ())
        self.assertIn("&lt;b&gt;Mine&lt;/b&gt;", page)
        self.assertNotIn("<b>Mine", page)
        self.assertIn(f"{design.scaffold.Porosity:.2f}", page)
        for words in ("Slice analysis: Analysis Scaffold", "Comparison: Analysis Scaffold, Analysis Envelope",
                      "scaffold + channels + loose pieces = envelope, mm³", "volume of the rods, solids against meshes",
                      "Kolmogorov-Smirnov", "FreeCAD"):  # fmt: skip
            self.assertIn(words, page)

    def test_a_design_without_its_scaffold_is_named_and_the_rest_told(self):
        make.make_design(self.document, small_job())
        make.make_analysis(self.document, make.make_box(self.document, 2, 3, 4), HALF)
        page, notes = self.page()
        self.assertEqual(len(notes), 1)
        self.assertIn("Wireframe: a design must have its scaffold to be told of", notes[0])
        self.assertIn("must have its scaffold", page)

    def test_voxels_are_told_with_the_volume_of_their_mesh(self):
        make.make_voxel_design(self.document, self.bracket(), VoxelParameters(size=(0.5, 0.5, 0.5)))
        page, _ = self.page()
        self.assertIn("volume of the mesh and of the voxels, mm³: 48 against 48", page)

    def test_another_process_makes_the_same_records(self):
        """Of a design without scaffold, analyses with their comparison, voxels: all that is handed over as files."""
        make.make_design(self.document, small_job())
        box = make.make_box(self.document, 4, 4, 4)
        for parameters in (HALF, SliceParameters(thickness=1.0)):
            make.make_analysis(self.document, box, parameters)
        design = make.make_voxel_design(self.document, self.bracket(), VoxelParameters(size=(0.5, 0.5, 0.5)))
        pictures, told = {design.Name: (Picture("View", "image/png", bytes(range(256))),)}, []
        found = report_sections.facts_of(self.document)
        with tempfile.TemporaryDirectory() as folder:
            paths = [os.path.join(folder, name) for name in ("here.html", "there.html")]
            notes = make.write_report(self.document, paths[0], pictures=pictures)
            write_report_task(folder, found)
            make.run_task(folder, lambda done, total, what: told.append(done / total))
            again = report_sections.write_page(found, report_sections.read_records(folder), paths[1], pictures)
            pages = []
            for path in paths:
                with open(path, encoding="utf-8") as file:
                    pages.append(file.read())
        self.assertEqual((len(notes), again), (1, notes))
        self.assertEqual(*pages)
        self.assertIn("Comparison: ", pages[0])
        self.assertIn(pictures[design.Name][0].address, pages[1])
        self.assertEqual((told, told[0]), (sorted(told), 0.0))

    def test_an_empty_document_is_refused_and_no_file_is_left(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "report.html")
            with self.assertRaisesRegex(ParameterError, "must have something to tell, got nothing in T"):
                make.write_report(self.document, path)
            self.assertEqual(os.listdir(folder), [])

    def test_a_folder_that_is_missing_is_refused(self):
        make.make_analysis(self.document, make.make_box(self.document, 2, 3, 4), HALF)
        with self.assertRaisesRegex(ExportError, "nowhere"):
            make.write_report(self.document, "/nowhere/report.html")

    def test_a_body_that_no_job_can_hold_goes_by_its_label(self):
        design = make.make_design(self.document, small_job())
        design.envelope.Placement.Base.x = 1
        self.document.recompute()
        self.assertEqual(report_sections._job(design.wireframe, None).prism.n_x, 3)
