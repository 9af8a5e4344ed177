# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scaffold in the document: figures by two routes, made on demand, kept with its file."""

import sys
import unittest
from dataclasses import replace
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import NO_BOOLEANS, DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.core.laws import constant
from freecad_trabecula.core.meshes import is_closed, mesh_volume
from freecad_trabecula.core.parameters import LayerParameters, PoreParameters, ScaffoldParameters
from freecad_trabecula.errors import EnvelopeError, KernelError, ParameterError
from freecad_trabecula.features import results
from freecad_trabecula.features.on_demand import OUT_OF_DATE
from freecad_trabecula.features.scaffold import Cut
from freecad_trabecula.geometry.mesh_objects import core_mesh


def figures(scaffold):
    return {name: getattr(scaffold, name) for name in ("Porosity", "ScaffoldVolume", "LoosePieces", "Pieces", "Checks")}


@unittest.skipUnless(manifold_available(), NO_BOOLEANS)
class ScaffoldTest(DocumentCase):
    def scaffold(self, job=None, **parameters):
        return make.make_scaffold(self.make(job or small_job()).wireframe, ScaffoldParameters(**parameters))

    def test_volumes_add_up_to_the_envelope_and_the_meshes_are_closed(self):
        scaffold = self.scaffold()
        total = sum(getattr(scaffold, name + "Volume").Value for name in ("Scaffold", "Channel", "Loose"))
        self.assertAlmostEqual(total / 1000, 1, 6)
        self.assertTrue(scaffold.Watertight)
        self.assertGreaterEqual(len(scaffold.Checks), 5)
        for obj in (scaffold, make.body_objects(scaffold)[0]):
            self.assertTrue(is_closed(core_mesh(obj.Mesh)))
        self.assertAlmostEqual(mesh_volume(core_mesh(scaffold.Mesh)), scaffold.ScaffoldVolume.Value, 3)

    def test_nine_straight_round_channels_that_do_not_meet_have_their_closed_form(self):
        job = small_job(
            kind="orthogonal", association="same", pores=PoreParameters("circle", constant(0.5), sections=1)
        )
        scaffold = self.scaffold(replace(job, couplings=job.couplings[:1]))
        channels = 9 * 3.14159265358979 / 4 * 0.25 * 10
        self.assertAlmostEqual(scaffold.ChannelVolume.Value, channels, 5)
        self.assertAlmostEqual(scaffold.Porosity, channels / 10, 6)
        self.assertAlmostEqual(scaffold.SumPorosity, scaffold.UnionPorosity, 6)
        self.assertEqual((scaffold.Pieces, scaffold.Openings, scaffold.LoosePieces), (1, 9, 0))

    def test_an_edit_of_a_pore_only_says_that_the_scaffold_is_out_of_date(self):
        scaffold = self.scaffold()
        before, facets = figures(scaffold), scaffold.Mesh.CountFacets
        make.set_pore(scaffold.Wireframe, "Face1.1.1", 0.5)
        self.document.recompute()
        self.assertEqual((scaffold.Status, scaffold.UpToDate), (OUT_OF_DATE, False))
        self.assertEqual([body.Status for body in make.body_objects(scaffold)], [OUT_OF_DATE] * 3)
        self.assertEqual((figures(scaffold), scaffold.Mesh.CountFacets), (before, facets))
        self.assertTrue(scaffold.isValid())
        make.update(scaffold)
        self.document.recompute()
        self.assertTrue(scaffold.UpToDate)
        self.assertNotEqual(figures(scaffold), before)
        self.assertEqual([body.Status for body in make.body_objects(scaffold)], ["up to date"] * 3)

    def test_an_edit_taken_back_makes_it_up_to_date_without_work(self):
        scaffold = self.scaffold()
        make.set_pore(scaffold.Wireframe, "Face1.1.1", 0.5)
        self.document.recompute()
        self.assertFalse(scaffold.UpToDate)
        make.take_back_edits(scaffold.Wireframe, "Face1.1.1")
        results.clear()
        self.document.recompute()
        self.assertTrue(scaffold.UpToDate)

    def test_with_auto_update_it_follows_every_edit(self):
        scaffold = self.scaffold()
        before = figures(scaffold)
        scaffold.AutoUpdate = True
        scaffold.Wireframe.Seed = 2
        self.document.recompute()
        self.assertTrue(scaffold.UpToDate)
        self.assertNotEqual(figures(scaffold), before)

    def test_nothing_is_lost_with_its_file_and_nothing_is_cut_again(self):
        scaffold = self.scaffold()
        before, facets = figures(scaffold), scaffold.Mesh.CountFacets
        scaffold = self.reopened().getObject("Scaffold")
        self.document.recompute(None, True)
        self.assertIsNone(results.find("scaffold", scaffold.ResultKey))
        self.assertEqual(figures(scaffold), before)
        self.assertEqual(scaffold.Mesh.CountFacets, facets)
        self.assertTrue(scaffold.UpToDate)
        self.assertEqual([body.Role for body in make.body_objects(scaffold)], ["channels", "loose", "voids"])
        scaffold.KeepLoose = True
        make.update(scaffold)
        self.assertTrue(scaffold.UpToDate)

    def test_a_failed_check_puts_it_in_error_and_says_which(self):
        scaffold = self.scaffold()
        facets = scaffold.Mesh.CountFacets
        good = results.find("scaffold", scaffold.ResultKey)
        bad = replace_first(good, second=999.0, difference=1e-3)
        results.keep("scaffold", scaffold.ResultKey, bad)
        scaffold.ResultKey = ""
        scaffold.touch()
        self.document.recompute()
        self.assertFalse(scaffold.isValid())
        self.assertRegex(scaffold.Status, "independent routes must agree.*envelope, mm3: .* against 999")
        self.assertEqual(scaffold.Mesh.CountFacets, facets)
        with self.assertRaisesRegex(KernelError, "against 999"):
            make.update(scaffold)

    def test_a_layer_closes_the_channels_of_its_faces(self):
        scaffold = self.scaffold(layers=LayerParameters(("Face5", "Face6"), 1.0))
        again = make.make_scaffold(scaffold.Wireframe)
        self.assertLess(scaffold.Porosity, again.Porosity)
        self.assertEqual(scaffold.AddedVolume.Value, 0)
        outward = make.make_scaffold(
            scaffold.Wireframe, ScaffoldParameters(layers=LayerParameters(("Face6",), 1.0, "outwards"))
        )
        self.assertAlmostEqual(outward.AddedVolume.Value, 100, 6)
        self.assertAlmostEqual(outward.Mesh.BoundBox.ZMax, 11, 6)

    def test_bodies_in_double_precision_are_those_of_the_object(self):
        scaffold = self.scaffold()
        bodies = make.bodies_of(scaffold)
        self.assertEqual(bodies.parts.scaffold_volume, scaffold.ScaffoldVolume.Value)
        results.clear()
        self.assertEqual(make.bodies_of(scaffold).parts.scaffold_volume, bodies.parts.scaffold_volume)


def replace_first(cut, **changes):
    checks = (cut.checks[0]._replace(**changes), *cut.checks[1:])
    return Cut(cut.figures, checks, cut.meshes)


class RefusalTest(DocumentCase):
    def test_a_scaffold_needs_a_wireframe(self):
        box = make.make_box(self.document)
        with self.assertRaisesRegex(ParameterError, "must be of the kind wireframe, got Envelope"), self.unchanged():
            make.make_scaffold(box)

    def test_a_layer_on_a_face_that_is_not_there_is_refused(self):
        wireframe = self.make(small_job()).wireframe
        with self.assertRaisesRegex(EnvelopeError, "got 'lid'"), self.unchanged():
            make.make_scaffold(wireframe, ScaffoldParameters(layers=LayerParameters(("lid",))))

    def test_a_cell_of_nothing_is_refused_in_the_document(self):
        wireframe = self.make(small_job()).wireframe
        scaffold = make.make_scaffold(wireframe, ScaffoldParameters("field", 0.15))
        facets = scaffold.Mesh.CountFacets
        scaffold.Cell = 0
        self.document.recompute()
        self.assertRegex(scaffold.Status, "cell must be greater than 0, got 0 mm")
        self.assertEqual(scaffold.Mesh.CountFacets, facets)
