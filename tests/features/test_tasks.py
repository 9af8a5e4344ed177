# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work in another process: its results are found by the document's objects; failed, it gives none."""

import os
import sys
import tempfile
import time
import unittest
from pathlib import Path

import FreeCAD
import Part

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import NO_BOOLEANS, DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.core.job import Job
from freecad_trabecula.core.parameters import Coupling, FaceParameters, PrismParameters
from freecad_trabecula.errors import ExportError
from freecad_trabecula.features import results
from freecad_trabecula.features.tasks import job_inputs, write_job_task
from freecad_trabecula.shell.launch import Child

WORKER = "freecad_trabecula.shell.worker"


class TasksTest(DocumentCase):
    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def in_another_process(self):
        """Run the task; return exit code and messages."""
        messages = []
        return Child(WORKER, {"folder": self.folder}, messages.append).wait(), messages

    def test_the_other_process_makes_the_same_wireframe_with_progress(self):
        wireframe = self.make(small_job(kind="box")).wireframe
        here = make.wireframe_of(wireframe).keys()
        make.write_task(self.folder, [wireframe])
        code, messages = self.in_another_process()
        self.assertEqual((code, [m for m in messages if m["kind"] == "error"]), (0, []))
        shares = [m["share"] for m in messages if m["kind"] == "progress"]
        self.assertEqual(shares, sorted(shares))
        results.clear()
        self.assertEqual(make.take_results(self.folder), 3)  # and the envelope, and what is seen
        key = wireframe.Proxy.inputs(wireframe).key
        self.assertEqual(results.find("wireframe", key).wireframe.keys(), here)

    @unittest.skipUnless(manifold_available(), NO_BOOLEANS)
    def test_an_object_that_waits_takes_the_result_at_once(self):
        scaffold = make.make_scaffold(self.make(small_job(n=4)).wireframe)
        scaffold.Wireframe.Seed = 9
        self.document.recompute()
        self.assertFalse(scaffold.UpToDate)
        make.write_task(self.folder, [scaffold])
        make.run_task(self.folder)
        results.clear()
        make.take_results(self.folder)
        scaffold.touch()
        started = time.process_time()
        self.document.recompute()
        self.assertLess(time.process_time() - started, 0.2)
        self.assertTrue(scaffold.UpToDate)
        self.assertEqual([body.Status for body in make.body_objects(scaffold)], ["up to date"] * 3)

    def test_a_job_without_objects_is_computed_under_the_keys_that_its_objects_will_have(self):
        job = small_job(kind="centre")
        write_job_task(self.folder, job, Part.makeBox(10, 10, 10), ["wireframe"])
        make.run_task(self.folder)
        results.clear()
        make.take_results(self.folder)
        (key,) = (key for kind, key in results._kept if kind == "wireframe")
        wireframe = self.make(job).wireframe
        self.assertEqual(wireframe.Proxy.inputs(wireframe).key, key)

    def test_a_box_that_was_turned_is_the_same_in_the_other_process(self):
        design = self.make(small_job())
        design.envelope.Placement = FreeCAD.Placement(FreeCAD.Vector(1, 2, 3), FreeCAD.Rotation(10, 20, 30))
        self.document.recompute()
        make.write_task(self.folder, [design.wireframe])
        key = design.wireframe.Proxy.inputs(design.wireframe).key
        results.clear()
        make.run_task(self.folder)
        self.assertIsNotNone(results.find("wireframe", key))

    def test_sites_on_faces_have_the_same_key_from_a_job_and_from_objects(self):
        box = make.make_box(self.document)
        sites = make.make_face_sites(box, FaceParameters("Face6", "top"))
        key = [key for kind, key in results._kept if kind == "sites"]
        results.clear()
        job = Job(prism=PrismParameters(), faces=(sites.Proxy.parameters(sites),), couplings=(Coupling("top", "top"),))
        job_inputs(job, box.Shape)
        self.assertEqual([key for kind, key in results._kept if kind == "sites"], key)

    def test_a_task_that_was_not_run_to_its_end_gives_nothing(self):
        make.write_task(self.folder, [self.make(small_job()).wireframe])
        with self.assertRaisesRegex(ExportError, "written to the end"):
            make.take_results(self.folder)

    def test_a_folder_without_a_task_is_an_error_of_the_worker(self):
        code, messages = self.in_another_process()
        self.assertNotEqual(code, 0)
        self.assertTrue([m for m in messages if m["kind"] == "error"])

    def test_a_task_cannot_be_written_where_there_is_no_folder(self):
        wireframe = self.make(small_job()).wireframe
        with self.assertRaisesRegex(ExportError, "could not be written"):
            make.write_task(os.path.join(self.folder, "none"), [wireframe])
