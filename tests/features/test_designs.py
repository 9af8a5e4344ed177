# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whole designs: from jobs into documents and back, one into another, all or nothing."""

import os
import sys
import tempfile
from dataclasses import replace
from pathlib import Path

import Part

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.job import Job
from freecad_trabecula.core.parameters import Coupling, FaceParameters, PathParameters, PrismParameters
from freecad_trabecula.core.presets import PRESETS, preset
from freecad_trabecula.errors import Cancelled, EnvelopeError, ExportError, ParameterError


def wedge_job(folder):
    """Return a job on a STEP file: a wedge whose slanting face is coupled with its bottom."""
    wedge = Part.makeWedge(0, 0, 0, 0, 0, 12, 8, 12, 8, 12)
    path = os.path.join(folder, "wedge.step")
    wedge.exportStep(path)
    names = [f"Face{k + 1}" for k in range(len(wedge.Faces))]
    largest = sorted(names, key=lambda name: -wedge.Faces[names.index(name)].Area)[:2]
    faces = tuple(FaceParameters(name, label, c_u=2, c_v=2, b_u=1, b_v=1) for name, label in zip(largest, "AB"))
    return Job(
        name="wedge", envelope=path, faces=faces, path=PathParameters("straight"), couplings=(Coupling("A", "B"),)
    )


class DesignsTest(DocumentCase):
    def test_every_preset_of_a_prism_comes_back_from_the_document_as_it_was(self):
        for name in PRESETS:
            job = preset(name)
            if job.prism is not None and not job.faces:
                with self.subTest(preset=name):
                    back = make.job_of(self.make(job).wireframe)
                    self.assertEqual(replace(back, name=job.name), job)

    def test_a_job_on_a_file_comes_back_with_its_file_and_faces(self):
        with tempfile.TemporaryDirectory() as folder:
            job = wedge_job(folder)
            design = self.make(job)
            self.assertGreater(design.wireframe.Rods, 5)
            self.assertEqual([one.Label for one in design.sites], ["Sites A", "Sites B"])
            self.assertEqual(replace(make.job_of(design.wireframe), name="wedge"), job)

    def test_all_parts_are_made_when_they_are_asked_for(self):
        shares = []
        design = make.make_design(
            self.document, small_job(), ("network",), progress=lambda done, total, what: shares.append(done / total)
        )
        self.assertEqual(design.network.Rods, 27)
        self.assertIsNone(design.scaffold)
        self.assertEqual(shares, sorted(shares))
        self.assertLessEqual(shares[-1], 1)

    def test_a_body_that_is_there_is_filled(self):
        cylinder = self.document.addObject("Part::Cylinder", "Can")
        cylinder.Radius, cylinder.Height = 6, 10
        self.document.recompute()
        flat = [f"Face{k + 1}" for k, f in enumerate(cylinder.Shape.Faces) if isinstance(f.Surface, Part.Plane)]
        faces = tuple(FaceParameters(name, c_u=2, c_v=2, b_u=1, b_v=1) for name in flat)
        job = Job(prism=PrismParameters(), faces=faces, couplings=(Coupling(*flat),), path=PathParameters("straight"))
        design = make.make_design(self.document, job, envelope=cylinder)
        self.assertEqual(design.envelope, cylinder)
        self.assertGreater(design.wireframe.Rods, 5)
        cylinder.Radius = 8
        before = design.wireframe.Rods
        self.document.recompute()
        self.assertGreater(design.wireframe.Rods, before)

    def test_cancelling_leaves_the_document_as_it_was(self):
        def cancel(done, total, what):
            if done / total > 0.35:
                raise Cancelled("stopped")

        with self.unchanged(), self.assertRaises(Cancelled):
            make.make_design(self.document, small_job(), progress=cancel)

    def test_what_is_wrong_leaves_the_document_as_it_was(self):
        box = Part.makeBox(1, 1, 1)
        with tempfile.TemporaryDirectory() as folder:
            open_shell = os.path.join(folder, "open.brep")
            Part.makeShell(box.Faces[:5]).exportBrep(open_shell)
            faces = (FaceParameters("Face1"), FaceParameters("Face9"))
            coupling = (Coupling("Face1", "Face9"),)
            for job, error, pattern in (
                (Job(envelope=open_shell, faces=faces, couplings=coupling), EnvelopeError, "closed solid"),
                (Job(envelope="no.step", faces=faces, couplings=coupling), ExportError, "readable, got no.step"),
                (Job(prism=PrismParameters(), faces=faces, couplings=coupling), EnvelopeError, "lost their face Face9"),
            ):
                with self.unchanged(), self.assertRaisesRegex(error, pattern):
                    self.make(job)


class ChangeTest(DocumentCase):
    def test_a_design_becomes_another_preset_in_place(self):
        design = self.make(preset("case1"))
        names = [obj.Name for obj in self.document.Objects]
        make.change_design(design.wireframe, preset("prism420"))
        self.assertEqual(design.wireframe.Rods, 420)
        self.assertEqual(design.envelope.Length.Value, 51)
        self.assertEqual([obj.Name for obj in self.document.Objects], names)
        self.assertEqual(replace(make.job_of(design.wireframe), name="prism420"), preset("prism420"))

    def test_faces_that_are_left_out_lose_their_sites_and_new_ones_get_some(self):
        with tempfile.TemporaryDirectory() as folder:
            job = wedge_job(folder)
            design = self.make(job)
            other = replace(job.faces[1], face="Face1", name="C")
            self.assertNotIn("Face1", [one.face for one in job.faces])
            make.change_design(
                design.wireframe, replace(job, faces=(job.faces[0], other), couplings=(Coupling("A", "C"),))
            )
            self.assertEqual([one.Label for one in design.wireframe.Sites], ["Sites A", "Sites C"])
            self.assertEqual(len(self.document.Objects), 4)

    def test_a_change_that_is_refused_says_so(self):
        design = self.make(small_job())
        with self.assertRaisesRegex(ParameterError, "coupled with itself"):
            make.change_design(design.wireframe, replace(small_job(), couplings=(Coupling("Face1", "Face1"),)))
