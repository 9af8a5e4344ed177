# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jobs of documents: what a job cannot hold is refused, not lost."""

import sys
from pathlib import Path

import FreeCAD

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.job import Job
from freecad_trabecula.core.parameters import Coupling, FaceParameters, PrismParameters
from freecad_trabecula.core.wireframe import WireframeParameters
from freecad_trabecula.errors import EnvelopeError, ParameterError


class JobsTest(DocumentCase):
    def test_faces_of_a_box_are_a_job_with_a_prism(self):
        faces = (FaceParameters("Face5", "A"), FaceParameters("Face6", "B"))
        job = Job(prism=PrismParameters(l=12), faces=faces, couplings=(Coupling("A", "B"),))
        back = make.job_of(self.make(job).wireframe)
        self.assertEqual((back.prism.l, back.faces, back.couplings), (12, faces, job.couplings))

    def test_changes_by_hand_and_the_scaffolds_parameters_are_in_it(self):
        wireframe = self.make(small_job()).wireframe
        make.switch_off_site(wireframe, "Face1.1.1")
        job = make.job_of(wireframe)
        self.assertEqual([(e.site, e.action) for e in job.edits], [("Face1.1.1", "off")])

    def test_a_prism_that_was_moved_is_refused(self):
        design = self.make(small_job())
        design.envelope.Placement.Base = FreeCAD.Vector(0, 0, 1)
        self.document.recompute()
        with self.assertRaisesRegex(ParameterError, "must be the identity, got .*of Envelope"):
            make.job_of(design.wireframe)

    def test_a_body_without_a_file_is_refused_with_what_to_do(self):
        cylinder = self.document.addObject("Part::Cylinder", "Can")
        self.document.recompute()
        sites = [make.make_face_sites(cylinder, FaceParameters(f"Face{k}", c_u=1, c_v=1)) for k in (2, 3)]
        wireframe = make.make_wireframe(cylinder, sites, WireframeParameters(couplings=(Coupling("Face2", "Face3"),)))
        with self.assertRaisesRegex(EnvelopeError, "box or come from a file .*got Can; export it"):
            make.job_of(wireframe)
        self.assertEqual(make.job_of(wireframe, envelope="can.step").envelope, "can.step")
