# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jobs to wireframes with the kernel, without a document."""

import math
import unittest
from dataclasses import replace

import FreeCAD
import numpy as np
import Part

from freecad_trabecula.core.assembly import make_wireframe
from freecad_trabecula.core.history import History
from freecad_trabecula.core.job import Job, opposite_couplings
from freecad_trabecula.core.laws import Region, constant
from freecad_trabecula.core.parameters import (
    Coupling,
    FaceParameters,
    PathParameters,
    PoreParameters,
    PrismParameters,
    SiteEdit,
)
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.sites import prism_sites
from freecad_trabecula.core.wireframe import WireframeParameters
from freecad_trabecula.errors import EnvelopeError, ParameterError
from freecad_trabecula.geometry import design
from freecad_trabecula.geometry.envelopes import envelope_from_shape


class MakeDesignTest(unittest.TestCase):
    def test_case_6_is_the_same_with_and_without_the_kernels_envelope(self):
        job = preset("case6")
        found = design.make_design(job).wireframe
        region = Region((0.0, 0.0, 0.0), (10.0, 10.0, 10.0), (5.0, 5.0, 5.0))
        sites = prism_sites(job.prism)
        plain = make_wireframe(job.wireframe, sites, region, lambda p: ((p >= 0) & (p <= 10)).all(1))
        self.assertEqual(found.names, plain.names)
        self.assertLess(np.abs(found.paths - plain.paths).max(), 1e-9)
        self.assertEqual(found.recoveries, plain.recoveries)

    def test_faces_of_a_prism_replace_its_own_sites(self):
        faces = (FaceParameters("Face5", "A", c_u=2, c_v=2, b_u=1, b_v=1), FaceParameters("Face6", "B", c_u=2, c_v=2))
        job = Job(
            prism=PrismParameters(), faces=faces, couplings=(Coupling("A", "B"),), path=PathParameters("straight")
        )
        found = design.make_design(job)
        self.assertEqual(sorted(found.faces), ["A", "B"])
        self.assertEqual(len(found.wireframe), 25)

    def test_progress_grows_to_1(self):
        shares = []
        design.make_design(preset("case1"), lambda done, total, what: shares.append(done / total))
        self.assertEqual(shares, sorted(shares))
        self.assertLessEqual(shares[-1], 1)

    def test_a_face_that_is_not_there_is_refused(self):
        job = Job(prism=PrismParameters(), faces=(FaceParameters("Face7"),), couplings=(Coupling("Face7", "Face7"),))
        with self.assertRaisesRegex(EnvelopeError, "Face1..Face6.*got 'Face7'"):
            design.make_design(job)

    def test_too_many_rods_are_refused_with_an_estimate(self):
        envelope = design.job_envelope(preset("case1"))
        faces = design.placed_prism_sites(PrismParameters(n_x=150, n_y=150, n_z=2), envelope)
        parameters = WireframeParameters(couplings=(Coupling("Face5", "Face6"),))
        with self.assertRaisesRegex(ParameterError, "at most 20,000 rods; .*hours.*GB, got 22,500 rods"):
            design.design_wireframe(parameters, envelope, faces, History(), "")


class PlacedPrismTest(unittest.TestCase):
    def test_sites_of_a_turned_prism_lie_on_its_turned_faces(self):
        solid = Part.makeBox(10, 8, 6)
        solid.Placement = FreeCAD.Placement(FreeCAD.Vector(1, 2, 3), FreeCAD.Rotation(20, 30, 40))
        envelope = envelope_from_shape(solid)
        for name, (sites, face) in design.placed_prism_sites(PrismParameters(10, 8, 6), envelope).items():
            self.assertTrue(face.isSame(envelope.face(name)))
            for point, normal in zip(sites.points, sites.normals):
                self.assertLess(face.distToShape(Part.Vertex(FreeCAD.Vector(*point)))[0], 1e-9)
                self.assertGreater(FreeCAD.Vector(*normal).dot(face.normalAt(0.5, 0.5)), 1 - 1e-9)


class EditedTest(unittest.TestCase):
    def setUp(self):
        self.job = Job(prism=PrismParameters(n_x=3, n_y=3, n_z=3), couplings=opposite_couplings("same"))
        self.envelope = design.job_envelope(self.job)
        self.faces = design.job_faces(self.job, self.envelope)

    def test_a_site_that_is_moved_is_set_on_the_face_with_the_faces_own_axes(self):
        edit = SiteEdit("Face1.2.2", "move", (0.2, 3.0, 4.0))
        sites = design.edited(self.faces, [edit])["Face1"]
        k = sites.names.index("Face1.2.2")
        self.assertTrue(np.allclose(sites.points[k], (0, 3, 4)))
        self.assertTrue(np.allclose(sites.u[k], self.faces["Face1"].sites.u[k]))
        self.assertTrue(np.allclose(sites.normals[k], (-1, 0, 0)))

    def test_faces_that_no_edit_names_stay(self):
        found = design.edited(self.faces, [SiteEdit("Face1.1.1")])
        self.assertIs(found["Face2"], self.faces["Face2"].sites)

    def test_an_edit_of_an_unknown_face_is_refused(self):
        with self.assertRaisesRegex(ParameterError, r"lid.1.1 \(off\): .*one of the faces Face1, "):
            design.edited(self.faces, [SiteEdit("lid.1.1")])

    def test_all_edits_that_do_not_fit_are_named_at_once(self):
        edits = [
            SiteEdit("Face1.1.1"),
            SiteEdit("Face1.4.1", "pore", size=0.5),
            SiteEdit("Face2.1.1", "move", (13.0, 2.0, 2.0)),
            SiteEdit("Face1.x", "add", (0.0, 2.0, 2.0)),
            SiteEdit("Face1.hand.1", "pore", size=0.5),
        ]
        words = r"2 changes .*: Face1.4.1 \(pore\): .*9 sites; Face2.1.1 \(move\): .*1 mm, got a distance of 3 mm$"
        with self.assertRaisesRegex(ParameterError, words):
            design.edited(self.faces, edits)
        self.assertEqual(len(design.edited(self.faces, [edits[0], *edits[3:]])["Face1"]), 10)


class WarningsTest(unittest.TestCase):
    def warnings(self, size, **prism):
        pores = PoreParameters("circle", constant(size), sections=1)
        job = Job(prism=PrismParameters(**prism), pores=pores, couplings=opposite_couplings("same"))
        envelope = design.job_envelope(job)
        faces = design.job_faces(job, envelope)
        wireframe = design.design_wireframe(
            replace(job.wireframe, path=PathParameters("orthogonal")), envelope, faces, History(), ""
        ).wireframe
        return design.pore_warnings(wireframe, faces)

    def test_pores_that_fit_are_not_warned_of(self):
        self.assertEqual(self.warnings(1.0, n_x=3, n_y=3, n_z=3), [])

    def test_overlaps_are_counted_for_each_face(self):
        # 3 x 3 sites 4 mm apart: 12 pairs of neighbours along the axes, none along the diagonals
        found = self.warnings(4.5, n_x=3, n_y=3, n_z=3, a_x=1, a_y=1, a_z=1)
        self.assertEqual(len([text for text in found if text.startswith("12 pairs of pores overlap")]), 6)

    def test_pores_over_the_border_are_counted(self):
        found = self.warnings(2.2, n_x=3, n_y=3, n_z=3)
        self.assertEqual(len([text for text in found if text.startswith("8 pores reach over the border")]), 6)

    def test_distances_from_a_round_border_are_radius_less_distance_from_the_centre(self):
        face = Part.Face(Part.Wire(Part.makeCircle(5)))
        points = np.array([[0.0, 0, 0], [3, 0, 0], [0, -4.5, 0]])
        self.assertLess(np.abs(design.border_distances(face, points) - (5, 2, 0.5)).max(), 0.011)

    def test_a_sphere_has_no_border(self):
        self.assertEqual(
            design.border_distances(Part.makeSphere(3).Faces[0], np.array([[3.0, 0, 0]])).tolist(), [math.inf]
        )
