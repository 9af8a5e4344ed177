# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wireframe in the document: it follows its inputs, keeps its last shape on an error, survives its file."""

import json
import sys
import unittest.mock
from dataclasses import replace
from pathlib import Path

import FreeCAD
import numpy as np

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core import recovery
from freecad_trabecula.core import wireframe as core
from freecad_trabecula.core.parameters import Coupling, FaceParameters
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.wireframe import WireframeParameters
from freecad_trabecula.errors import EnvelopeError, ParameterError


def computed(obj) -> core.Wireframe:
    return obj.Proxy.wireframe(obj)


class WireframeTest(DocumentCase):
    def test_case_6_has_147_rods_and_its_table_uses_every_site_once(self):
        wireframe = self.make(preset("case6")).wireframe
        self.assertEqual(wireframe.Rods, 147)
        rows = [json.loads(line) for line in wireframe.CouplingTable]
        self.assertEqual([(r["available_first"], r["rods"], r["left_second"]) for r in rows], [(49, 49, 0)] * 3)
        self.assertEqual(list(wireframe.Failed), [])
        self.assertEqual(len(wireframe.PoreSizes), 2 * 147)
        self.assertTrue(all(0.2 <= size <= 0.8 for size in wireframe.PoreSizes))

    def test_the_shape_shows_a_path_from_each_first_to_each_second_site(self):
        wireframe = self.make(small_job(kind="centre")).wireframe
        length = sum(edge.Length for edge in wireframe.Shape.childShapes()[0].Edges)
        paths = computed(wireframe).paths
        fine = np.linspace(0, 1, 400)[:, None]
        weights = [(1 - fine) ** 3, 3 * fine * (1 - fine) ** 2, 3 * fine**2 * (1 - fine), fine**3]
        curves = sum(w * paths[:, :, None, i] for i, w in enumerate(weights))
        expected = np.linalg.norm(np.diff(curves, axis=2), axis=3).sum()
        self.assertAlmostEqual(length / expected, 1, 4)

    def test_the_same_seed_gives_the_same_rods_in_another_document(self):
        first = computed(self.make(small_job(seed=7)).wireframe)
        other = FreeCAD.newDocument("Other")
        second = computed(make.make_design(other, small_job(seed=7)).wireframe)
        third = computed(make.make_design(other, small_job(seed=8)).wireframe)
        FreeCAD.closeDocument(other.Name)
        self.assertEqual(first.keys(), second.keys())
        self.assertFalse(set(first.keys()) & set(third.keys()))

    def test_sites_follow_the_box_wherever_it_is_put(self):
        design = self.make(small_job())
        design.envelope.Placement = FreeCAD.Placement(FreeCAD.Vector(5, -3, 2), FreeCAD.Rotation(30, 40, 50))
        design.envelope.Length = 14
        self.document.recompute()
        faces = dict(zip([f"Face{k}" for k in range(1, 7)], design.envelope.Shape.Faces))
        for label, sites in computed(design.wireframe).sites.items():
            normal = np.array(faces[label].normalAt(0.5, 0.5))
            corner = np.array(faces[label].Vertexes[0].Point)
            self.assertLess(np.abs((sites.points - corner) @ normal).max(), 1e-9)
            self.assertLess(np.abs(sites.normals - normal).max(), 1e-9)
        self.assertEqual(design.wireframe.State, ["Up-to-date"])

    def test_everything_is_there_and_editable_after_the_file_was_opened_again(self):
        design = self.make(preset("case6"))
        keys, parameters = computed(design.wireframe).keys(), design.wireframe.Proxy.parameters(design.wireframe)
        wireframe = self.reopened().getObject("Wireframe")
        self.assertEqual(wireframe.State, ["Up-to-date"])
        self.assertEqual(wireframe.Proxy.parameters(wireframe), parameters)
        self.assertEqual(computed(wireframe).keys(), keys)
        wireframe.PathKind = "straight"
        self.document.recompute()
        paths = computed(wireframe).paths
        bend = np.cross(paths[:, 1, 3] - paths[:, 0, 0], paths[:, 0, 3] - paths[:, 0, 0])
        self.assertLess(np.abs(bend).max(), 1e-9)

    def test_pores_of_faces_that_no_coupling_joins_are_neither_shown_nor_warned_of(self):
        wireframe = self.make(small_job(n=3)).wireframe
        edges = len(wireframe.Shape.Edges)
        self.assertEqual(edges, 27 * 2 + 54 * 4)
        wireframe.PoreSizeLaw, wireframe.PoreSizeLow = "constant", 4.1
        wireframe.Couplings = wireframe.Couplings[:1]
        self.document.recompute()
        self.assertEqual(len(wireframe.Shape.Edges), 9 * 2 + 18 * 4)
        self.assertEqual(len(wireframe.Warnings), 4)
        self.assertNotIn("Face3", " ".join(wireframe.Warnings))

    def test_the_document_holds_the_wireframe_so_that_nothing_is_mended_again(self):
        wireframe = self.make(small_job(n=4, kind="box")).wireframe
        keys = computed(wireframe).keys()
        wireframe = self.reopened().getObject("Wireframe")
        with unittest.mock.patch("freecad_trabecula.core.history.mend", side_effect=AssertionError):
            self.document.recompute(None, True)
            self.assertEqual(wireframe.State, ["Up-to-date"])
            self.assertEqual(computed(wireframe).keys(), keys)
        with unittest.mock.patch("freecad_trabecula.core.history.mend", wraps=recovery.mend) as mended:
            make.set_pore(wireframe, "Face1.2.2", 0.5)
            self.assertEqual([len(call[0][0]) for call in mended.call_args_list], [1])

    def test_a_wireframe_of_another_version_is_computed_again(self):
        wireframe = self.make(small_job()).wireframe
        keys = computed(wireframe).keys()
        wireframe.Structure = wireframe.Structure.replace('"paths"', '"ways"')
        wireframe = self.reopened().getObject("Wireframe")
        self.assertEqual(computed(wireframe).keys(), keys)

    def test_one_site_switched_off_changes_few_rods(self):
        wireframe = self.make(small_job(n=5)).wireframe
        before = set(computed(wireframe).keys())
        make.switch_off_site(wireframe, "Face1.2.2")
        after = set(computed(wireframe).keys())
        self.assertEqual(wireframe.Rods, 74)
        self.assertLessEqual(len(before - after), 7)

    def test_with_the_envelope_its_pores_are_warned_of_when_they_overlap_or_reach_over(self):
        wireframe = self.make(small_job(n=3)).wireframe
        self.assertEqual(list(wireframe.Warnings), [])
        wireframe.PoreSizeLaw, wireframe.PoreSizeLow = "constant", 4.1  # spacing 4 mm, border distance 1 mm
        self.document.recompute()
        self.assertIn(
            "12 pairs of pores overlap on face Face1: pores must be smaller than their spacing", wireframe.Warnings
        )
        self.assertRegex(" ".join(wireframe.Warnings), "8 pores reach over the border of face Face1")


class RefusalTest(DocumentCase):
    def assert_refused(self, wireframe, pattern):
        shown = len(wireframe.Shape.Edges)
        self.document.recompute()
        self.assertFalse(wireframe.isValid())
        self.assertRegex(wireframe.Status, "^error: .*" + pattern)
        self.assertEqual(len(wireframe.Shape.Edges), shown)

    def test_bad_values_put_the_object_in_error_and_leave_its_last_good_shape(self):
        wireframe = self.make(small_job()).wireframe
        good = {
            name: getattr(wireframe, name) for name in ("PoreSizeHigh", "PoreSizeLow", "Couplings", "Edits", "PathBox")
        }
        bad = (
            ("PoreSizeHigh", 0.1, "low <= high, got 0.2 and 0.1"),
            ("PoreSizeLow", 0.0, "at least 0.001 mm, got 0 and 0.8 mm"),
            ("PoreSizeLow", float("nan"), "finite numbers, got nan"),
            ("Couplings", ['{"first": "Face1", "second": "Face9"}'], "join faces that have sites .*got 'Face9'"),
            ("Couplings", ['{"first": "Face1", "second": "Face1"}'], "coupled with itself only if it is curved.*Face1"),
            ("Couplings", ["Face1-Face2"], "coupling 1 must be one JSON object, got 'Face1-Face2'"),
            (
                "Edits",
                ['{"site": "Face1.9.9"}'],
                r"Face1.9.9 \(off\): it must name a site of face Face1, which has 9 sites",
            ),
            ("Edits", ['{"site": "Face7.1.1"}'], "Face7.1.1 .off.: it must name a site of one of the faces Face1, "),
            ("Edits", ['{"site": "Face1.1.1", "action": "move", "point": [5, 5, 5]}'], "distance of 5 mm"),
            ("PathBox", FreeCAD.Vector(-1, 0, 0), "box of middle points must be at least 0, got -1 mm"),
        )
        for name, value, pattern in bad:
            with self.subTest(property=name, value=str(value)):
                setattr(wireframe, name, value)
                self.assert_refused(wireframe, pattern)
                setattr(wireframe, name, good[name])
                self.document.recompute()
                self.assertEqual(wireframe.State, ["Up-to-date"])

    def test_no_sites_no_envelope_and_sites_of_another_body_are_refused(self):
        design = self.make(small_job())
        other = make.make_box(self.document)
        design.wireframe.Envelope = other
        self.assert_refused(design.wireframe, "sites Sites must be on faces of Envelope001, got Envelope")
        design.wireframe.Envelope = None
        self.assert_refused(design.wireframe, "envelope must have a shape, got nothing")
        design.wireframe.Envelope, design.wireframe.Sites = design.envelope, []
        self.assert_refused(design.wireframe, "join faces that have sites")

    def test_two_faces_of_one_name_are_refused(self):
        box = make.make_box(self.document)
        sites = [make.make_face_sites(box, FaceParameters(face, "A")) for face in ("Face1", "Face2")]
        with self.assertRaisesRegex(ParameterError, "named once, got 'A' again"), self.unchanged():
            make.make_wireframe(box, sites, WireframeParameters(couplings=(Coupling("A", "A"),)))

    def test_a_wireframe_that_cannot_be_made_leaves_the_document_as_it_was(self):
        box = make.make_box(self.document)
        sites = make.make_prism_sites(box)
        wrong = replace(preset("case1").wireframe, couplings=(Coupling("Face1", "lid"),))
        with self.assertRaisesRegex(ParameterError, "got 'lid'"), self.unchanged():
            make.make_wireframe(box, [sites], wrong)

    def test_an_envelope_of_two_solids_is_refused_with_their_number(self):
        boxes = [make.make_box(self.document), make.make_box(self.document)]
        compound = self.document.addObject("Part::Compound", "Both")
        compound.Links = boxes
        self.document.recompute()
        with self.assertRaisesRegex(EnvelopeError, "Both: one solid of 2 must be chosen"), self.unchanged():
            make.make_face_sites(compound, FaceParameters("Face1"))
