# SPDX-License-Identifier: LGPL-2.1-or-later
"""The solid scaffold in a document: shown when complete, refused with how far it came, made by another process."""

import dataclasses
import tempfile

from document_case import DocumentCase

from freecad_trabecula import make
from freecad_trabecula.core.parameters import ScaffoldParameters
from freecad_trabecula.core.presets import preset
from freecad_trabecula.errors import KernelError
from freecad_trabecula.features import results


def small(limit=2):
    job = preset("case1")
    return dataclasses.replace(job, couplings=tuple(dataclasses.replace(c, limit=limit) for c in job.couplings))


class SolidScaffoldTest(DocumentCase):
    def test_it_has_all_its_channels_and_the_meshes_volume(self):
        design = make.make_design(self.document, small())
        solid = make.make_solid_scaffold(design.wireframe)
        self.assertEqual((solid.RodsCut, solid.RodsWanted, solid.Complete), (6, 6, True))
        self.assertLess(solid.Difference, 0.2)
        self.assertEqual(len(solid.Shape.Solids), 1)

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
