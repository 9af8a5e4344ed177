# SPDX-License-Identifier: LGPL-2.1-or-later
"""Designs as scripts: run in a new document, the lines make the same wireframes, voxels, profiles, bodies."""

import os
import tempfile
import unittest

import FreeCAD
import numpy as np
from document_case import NO_BOOLEANS, DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.core.parameters import Coupling, FaceParameters, PathParameters
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.voxels.drawn_curves import DrawnCurves
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.wireframe import WireframeParameters
from freecad_trabecula.errors import ParameterError
from freecad_trabecula.features import results

HALF = SliceParameters(thickness=0.5)


class ScriptCase(DocumentCase):
    def run_script(self, obj, into=None):
        """Run the script of an object with nothing at hand; return its variables and its text."""
        text = make.design_as_script(obj)
        results.clear()
        names = {}
        before = set(FreeCAD.listDocuments())
        if into is not None:
            FreeCAD.setActiveDocument(into)
        exec(text, names)  # noqa: S102  what a user does
        for name in set(FreeCAD.listDocuments()) - before:
            self.addCleanup(FreeCAD.closeDocument, name)
        return names, text

    def assert_same_rods(self, first, second):
        a, b = make.wireframe_of(first), make.wireframe_of(second)
        self.assertEqual(a.names, b.names)
        for name in ("coupling", "site_numbers", "paths"):
            np.testing.assert_array_equal(getattr(a, name), getattr(b, name))
        for end in ("first", "second"):
            for name in ("size", "corners", "angles"):
                np.testing.assert_array_equal(getattr(getattr(a.ends, end), name), getattr(getattr(b.ends, end), name))


class RodScripts(ScriptCase):
    def test_a_prism_with_changes_by_hand_is_the_same(self):
        design = self.make(small_job(seed=12))
        make.set_pore(design.wireframe, "Face1.1.2", size=0.35)
        make.move_site(design.wireframe, "Face2.1.1", (10.0, 1.25, 1.5))
        make.switch_off_site(design.wireframe, "Face3.1.1")
        make.add_site(design.wireframe, "Face1", (0, 3, 3.2))
        names, text = self.run_script(design.wireframe)
        self.assertIsNot(names["document"], self.document)
        self.assertEqual(names["wireframe"].Edits, design.wireframe.Edits)
        self.assert_same_rods(design.wireframe, names["wireframe"])
        self.assertNotIn("# Needs", text)

    def test_only_what_differs_from_the_defaults_is_written(self):
        design = self.make(preset("case6"))
        text = make.design_as_script(design.wireframe)
        self.assertIn("make.make_box(document)", text)
        self.assertIn("make.make_prism_sites(envelope)", text)
        for word in ("PoreParameters", "RodParameters", "seed", "n_x"):
            self.assertNotIn(word, text)
        self.assertLess(len(text.splitlines()), 30)

    def test_every_design_of_the_thesis_in_a_prism_is_the_same(self):
        for name in ("case1", "case3", "case5", "case6"):
            with self.subTest(design=name):
                wireframe = self.make(preset(name)).wireframe
                self.assert_same_rods(wireframe, self.run_script(wireframe)[0]["wireframe"])

    def test_a_box_that_was_moved_and_turned_stays_where_it_is(self):
        design = self.make(small_job())
        design.envelope.Length = 12.5
        design.envelope.Placement = FreeCAD.Placement(FreeCAD.Vector(1, 2, 3), FreeCAD.Rotation(20, 30, 40))
        self.document.recompute()
        names, _ = self.run_script(design.wireframe)
        for old, new in zip(design.envelope.Placement.toMatrix().A, names["envelope"].Placement.toMatrix().A):
            self.assertAlmostEqual(old, new, delta=1e-14)
        a, b = make.wireframe_of(design.wireframe), make.wireframe_of(names["wireframe"])
        self.assertEqual(a.names, b.names)
        np.testing.assert_allclose(a.paths, b.paths, rtol=0, atol=1e-12)

    def test_sites_on_faces_of_a_step_file_are_the_same_and_the_file_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "my block.step")
            make.make_box(self.document, 6, 7, 8).Shape.exportStep(path)
            envelope = make.make_envelope(self.document, path)
            faces = (FaceParameters("Face1", "A"), FaceParameters("Face2", "B", c_u=1.25))
            sites = [make.make_face_sites(envelope, one) for one in faces]
            wireframe = make.make_wireframe(
                envelope, sites, WireframeParameters(path=PathParameters("centre"), couplings=(Coupling("A", "B"),))
            )
            names, text = self.run_script(wireframe)
            self.assert_same_rods(wireframe, names["wireframe"])
            self.assertIn(f"# Needs the file {path}.", text)
        self.assertIn(f"# Needs the file {path}; it is not there now.", make.design_as_script(wireframe))

    def test_a_body_that_was_modelled_is_asked_for_by_name_and_used(self):
        cylinder = self.document.addObject("Part::Cylinder", "Can")
        self.document.recompute()
        sites = [make.make_face_sites(cylinder, FaceParameters(f"Face{k}", c_u=1, c_v=1)) for k in (2, 3)]
        wireframe = make.make_wireframe(cylinder, sites, WireframeParameters(couplings=(Coupling("Face2", "Face3"),)))
        text = make.design_as_script(wireframe)
        self.assertRegex(text.splitlines()[1], r"^# Needs the body Can \(Can, Part::Cylinder\) in the active document")
        names, _ = self.run_script(wireframe, into=self.document.Name)
        self.assertEqual(names["body"], cylinder)
        self.assert_same_rods(wireframe, names["wireframe"])
        other = FreeCAD.newDocument("Empty")
        self.addCleanup(FreeCAD.closeDocument, other.Name)
        with self.assertRaisesRegex(ParameterError, "must have the body 'Can', got none in Empty"):
            self.run_script(wireframe, into=other.Name)
        self.assertEqual(other.Objects, [])

    def test_an_empty_document_has_no_script(self):
        with self.assertRaisesRegex(ParameterError, "design, an analysis or voxels to make, got none"):
            make.design_as_script(self.document)

    def test_an_object_in_error_has_no_script(self):
        design = self.make(small_job())
        design.wireframe.Couplings = ['{"first": "Nowhere", "second": "Face2"}']
        self.document.recompute()
        with self.assertRaisesRegex(ParameterError, "must be without error to be written .*Nowhere"):
            make.design_as_script(design.wireframe)

    @unittest.skipUnless(manifold_available(), NO_BOOLEANS)
    def test_bodies_and_analyses_come_with_the_design_and_are_compared(self):
        design = make.make_design(self.document, small_job(seed=3), ("network", "scaffold"))
        design.wireframe.Label = "Mine"
        made = [
            make.make_analysis(self.document, design.scaffold, HALF),
            make.make_analysis(self.document, make.body_objects(design.scaffold)[0], HALF, envelope=None),
        ]
        names, text = self.run_script(design.sites[0])
        self.assertEqual(text.count("make_scaffold"), 1)
        self.assertEqual(names["wireframe"].Label, "Mine")
        self.assertEqual(names["scaffold"].Porosity, design.scaffold.Porosity)
        self.assertEqual(names["network"].RodVolume.Value, design.network.RodVolume.Value)
        for old, new in zip(made, (names["analysis"], names["analysis_2"])):
            self.assertEqual(old.Label, new.Label)
            for axis, profile in make.analysis_of(old).profiles.items():
                again = make.analysis_of(new).profiles[axis]
                np.testing.assert_array_equal(profile.sliced_area, again.sliced_area)
                np.testing.assert_array_equal(profile.porosity, again.porosity)
        compared = make.compare_analyses(made).axes["z"].values["sliced_area"]
        np.testing.assert_array_equal(compared, names["comparison"].axes["z"].values["sliced_area"])


class VoxelScripts(ScriptCase):
    def bracket_file(self, folder, name="bracket.step"):
        whole, less = make.make_box(self.document, 4, 4, 4), make.make_box(self.document, 2, 2, 4)
        path, bracket = os.path.join(folder, name), whole.Shape.cut(less.Shape)
        bracket.exportStl(path) if name.endswith("stl") else bracket.exportStep(path)
        return path

    def test_voxels_of_a_body_and_of_its_analysis_are_the_same(self):
        parameters = VoxelParameters(size=(0.5, 0.5, 0.5), seed=9)
        with tempfile.TemporaryDirectory() as folder:
            body = make.make_envelope(self.document, self.bracket_file(folder))
            first = make.make_voxel_design(self.document, body, parameters, surface="smooth")
            analysis = make.make_analysis(self.document, body, HALF)
            second = make.make_voxel_design(self.document, analysis, parameters)
            names, text = self.run_script(self.document)
        self.assertEqual(text.count("make_envelope"), 1)
        for old, new in ((first, names["voxels"]), (second, names["voxels_2"])):
            np.testing.assert_array_equal(make.voxel_design_of(old).voxels, make.voxel_design_of(new).voxels)
            self.assertEqual(old.Surface, new.Surface)

    def test_drawn_curves_and_given_tables_are_written_too(self):
        curves = DrawnCurves((3.0, 3.0, 3.0), ((0.0, 0.25), (1.0, 0.75)), ((0.0, 0.5),), ((0.5, 0.5),))
        parameters = VoxelParameters(size=(0.5, 0.5, 0.5), strategy="random-layers")
        obj = make.make_voxel_design(self.document, curves, parameters)
        design = make.voxel_design_of(obj)
        make.change_voxel_design(obj, parameters, tables=(design.alpha, design.beta))
        names, text = self.run_script(self.document)
        self.assertIn("DrawnCurves(edges=(3.0, 3.0, 3.0)", text)
        self.assertEqual(names["voxels"].Alpha, obj.Alpha)
        np.testing.assert_array_equal(make.voxel_design_of(names["voxels"]).voxels, make.voxel_design_of(obj).voxels)

    def test_a_file_of_an_analysis_is_named_once(self):
        with tempfile.TemporaryDirectory() as folder:
            path = self.bracket_file(folder, "bracket.stl")
            analysis = make.make_analysis(self.document, path, HALF, unit="mm")
            voxels = make.make_voxel_design(self.document, path, VoxelParameters(size=(0.5, 0.5, 0.5)))
            names, text = self.run_script(self.document)
        self.assertEqual(text.count("# Needs"), 1)
        self.assertEqual((names["analysis"].Unit, names["analysis"].Slices), ("mm", analysis.Slices))
        self.assertEqual(names["voxels"].Voxels, voxels.Voxels)
