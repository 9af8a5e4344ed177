# SPDX-License-Identifier: LGPL-2.1-or-later
"""The solid scaffold in a document: shown when complete, refused with how far it came, made by another process."""

import dataclasses
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import NO_BOOLEANS, DocumentCase

from freecad_trabecula import make
from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.core.parameters import ScaffoldParameters
from freecad_trabecula.core.presets import preset
from freecad_trabecula.errors import KernelError, ParameterError
from freecad_trabecula.features import results
from freecad_trabecula.features.on_demand import OUT_OF_DATE


def small(limit=2):
    job = preset("case1")
    return dataclasses.replace(job, couplings=tuple(dataclasses.replace(c, limit=limit) for c in job.couplings))


@unittest.skipUnless(manifold_available(), NO_BOOLEANS)
class SolidScaffoldTest(DocumentCase):
    def test_it_has_all_its_channels_and_the_meshes_volume(self):
        design = make.make_design(self.document, small())
        solid = make.make_solid_scaffold(design.wireframe)
        self.assertEqual((solid.RodsCut, solid.RodsWanted, solid.Complete), (6, 6, True))
        self.assertLess(solid.Difference, 0.2)
        self.assertEqual(len(solid.Shape.Solids), 1)
        self.assertAlmostEqual(solid.Porosity, 100 - solid.Shape.Volume / 10, 9)
        mesh = make.make_scaffold(solid.Wireframe)
        self.assertAlmostEqual(mesh.ScaffoldVolume.Value / solid.ScaffoldVolume.Value, 1, 3)

    def test_it_waits_after_an_edit_and_is_kept_with_its_file(self):
        solid = make.make_solid_scaffold(make.make_design(self.document, small(1)).wireframe)
        faces = len(solid.Shape.Faces)
        solid = self.reopened().getObject("SolidScaffold")
        self.document.recompute(None, True)
        self.assertTrue(solid.UpToDate)
        make.set_pore(solid.Wireframe, "Face1.1.1", 0.6)
        self.document.recompute()
        self.assertEqual((solid.Status, solid.UpToDate, len(solid.Shape.Faces)), (OUT_OF_DATE, False, faces))

    def test_a_cut_that_stopped_leaves_the_last_good_solid(self):
        solid = make.make_solid_scaffold(make.make_design(self.document, small(1)).wireframe)
        faces = len(solid.Shape.Faces)
        good = results.find("solid", solid.ResultKey)
        results.keep("solid", solid.ResultKey, good._replace(rods=2, reason="the time budget of 1 s is used up"))
        solid.ResultKey = ""
        solid.touch()
        self.document.recompute()
        self.assertFalse(solid.isValid())
        self.assertRegex(solid.Status, "came to 2 of 3 rods, then the time budget of 1 s is used up; the mesh")
        self.assertEqual(len(solid.Shape.Faces), faces)

    def test_it_needs_a_wireframe_and_a_budget(self):
        box = make.make_box(self.document)
        with self.unchanged(), self.assertRaisesRegex(ParameterError, "must be of the kind wireframe, got Envelope"):
            make.make_solid_scaffold(box)
        wireframe = make.make_design(self.document, small(1)).wireframe
        with self.unchanged(), self.assertRaisesRegex(ParameterError, "time budget must be at least 1, got 0 s"):
            make.make_solid_scaffold(wireframe, ScaffoldParameters(seconds=0.0))

    def test_an_unfinished_one_is_refused_and_the_document_stays_as_it_was(self):
        design = make.make_design(self.document, small(0))
        before = [obj.Name for obj in self.document.Objects]
        with self.assertRaisesRegex(KernelError, r"came to \d+ of 75 rods, then the time budget of 1 s"):
            make.make_solid_scaffold(design.wireframe, ScaffoldParameters(seconds=1.0))
        self.assertEqual([obj.Name for obj in self.document.Objects], before)

    def test_another_process_can_make_it(self):
        design = make.make_design(self.document, small(1))
        solid = self.document.addObject("Part::FeaturePython", "Solid")
        del solid  # an object of another kind in the document does no harm
        made = make.make_solid_scaffold(design.wireframe)
        with tempfile.TemporaryDirectory() as folder:
            make.write_task(folder, [made])
            make.run_task(folder)
            self.assertGreaterEqual(make.take_results(folder), 1)
        self.assertTrue(results.find("solid", made.Proxy.key(made)).complete)
