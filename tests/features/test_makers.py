# SPDX-License-Identifier: LGPL-2.1-or-later
"""Functions that add objects: what they add is computed, and an error leaves the document as it was."""

import os
import sys
import tempfile
from pathlib import Path

import FreeCAD
import Part

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.parameters import FaceParameters
from freecad_trabecula.errors import EnvelopeError, ExportError, ParameterError
from freecad_trabecula.features.makers import all_or_nothing


class MakersTest(DocumentCase):
    def test_a_box_has_its_edges_and_is_up_to_date(self):
        box = make.make_box(self.document, 1, 2, 3, "Slab")
        self.assertEqual((box.Name, box.State), ("Slab", ["Up-to-date"]))
        self.assertAlmostEqual(box.Shape.Volume, 6)

    def test_an_envelope_from_a_file_knows_where_it_came_from_and_keeps_it(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "two.step")
            boxes = [Part.makeBox(1, 1, 1), Part.makeBox(2, 2, 2, FreeCAD.Vector(5, 0, 0))]
            Part.makeCompound(boxes).exportStep(path)
            envelope = make.make_envelope(self.document, path, "Solid2")
        self.assertAlmostEqual(envelope.Shape.Volume, 8, 6)
        envelope = self.reopened().getObject("Envelope")
        self.assertEqual((envelope.SourceFile, envelope.SourceSolid), (path, "Solid2"))
        self.assertAlmostEqual(envelope.Shape.Volume, 8, 6)
        self.assertGreater(make.make_face_sites(envelope, FaceParameters("Face1", c_u=0.5, c_v=0.5)).Count, 0)

    def test_a_tiny_envelope_is_noted_and_made(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "tiny.brep")
            Part.makeBox(0.4, 0.4, 0.4).exportBrep(path)
            envelope = make.make_envelope(self.document, path)
        self.assertRegex(" ".join(envelope.Notes), "only 0.4 mm large: was its file in metres")

    def test_each_function_refuses_what_it_cannot_make_and_adds_nothing(self):
        box = make.make_box(self.document)
        with tempfile.TemporaryDirectory() as folder:
            mesh = os.path.join(folder, "open.stl")
            Path(mesh).write_text("solid x\nendsolid x\n")
            shell = os.path.join(folder, "shell.brep")
            Part.makeShell(Part.makeBox(1, 1, 1).Faces[:5]).exportBrep(shell)
            for make_it, error, pattern in (
                (lambda: make.make_box(self.document, 0, 1, 1), ParameterError, "edge along X must be at least"),
                (lambda: make.make_box(self.document, float("nan"), 1, 1), ParameterError, "edge along X"),
                (lambda: make.make_envelope(self.document, mesh), (EnvelopeError, ExportError), "mesh"),
                (lambda: make.make_envelope(self.document, shell), EnvelopeError, "one closed solid"),
                (lambda: make.make_envelope(self.document, "x.txt"), EnvelopeError, "must end in one of .step"),
                (lambda: make.make_face_sites(box, FaceParameters("Edge1")), EnvelopeError, "lost their face Edge1"),
                (lambda: make.make_face_sites(box, FaceParameters("Face1", c_u=1e-4)), ParameterError, "at most"),
                (lambda: make.make_prism_sites(make.make_envelope(self.document, shell)), EnvelopeError, "closed"),
            ):
                with self.unchanged(), self.assertRaisesRegex(error, pattern):
                    make_it()

    def test_an_error_inside_removes_what_was_added_before_it(self):
        with self.unchanged(), self.assertRaises(ZeroDivisionError), all_or_nothing(self.document):
            make.make_box(self.document)
            make.make_box(self.document)
            raise ZeroDivisionError

    def test_a_network_of_no_rods_is_empty_and_no_error(self):
        wireframe = self.make(small_job()).wireframe
        wireframe.Couplings = [line.replace("}", ', "on": false}') for line in wireframe.Couplings]
        self.document.recompute()
        self.assertEqual((wireframe.Rods, wireframe.State), (0, ["Up-to-date"]))
        network = make.make_network(wireframe)
        self.assertEqual((network.Rods, network.RodVolume.Value), (0, 0))
