# SPDX-License-Identifier: LGPL-2.1-or-later
"""A property that changes in the window: what takes long is computed elsewhere, and the window never waits."""

import time
from dataclasses import replace
from unittest import mock

import FreeCAD
from window import Heartbeat, WindowTest, settle, wait

from freecad_trabecula import make
from freecad_trabecula.core.presets import preset
from freecad_trabecula.features import on_demand, results
from freecad_trabecula.features.on_demand import COMPUTING, OUT_OF_DATE
from freecad_trabecula.gui.recomputing import of_window

LONGEST = 0.2  # s of processor time that the window's thread may spend at once


class RecomputingCase(WindowTest):
    def wait_until_shown(self, *objects):
        done = wait(lambda: all(one.ResultKey == one.Proxy.key(one) for one in objects), 180)
        self.assertTrue(done, [one.Status for one in objects])
        settle(0.2)


class RecomputingTest(RecomputingCase):
    def setUp(self):
        super().setUp()
        results.clear()
        self.wireframe_object = make.make_design(self.document, preset("case6")).wireframe

    def change_seed(self, seed):
        """Change the seed as the property editor does: a step to undo with a recompute in it."""
        self.document.openTransaction("Edit")
        self.wireframe_object.Seed = seed
        self.document.recompute()
        self.document.commitTransaction()
        settle(0.05)

    def points(self):
        return make.wireframe_of(self.wireframe_object).paths

    def test_a_new_seed_is_computed_elsewhere_and_the_window_answers_meanwhile(self):
        before = self.points().copy()
        with Heartbeat() as beat:
            self.change_seed(5)
            self.assertTrue(self.wireframe_object.Status.startswith(COMPUTING))
            self.assertEqual(self.wireframe_object.Rods, 147)  # as it was
            settle(0.5)
            self.assertFalse(of_window().bars()[0].isHidden())
            self.wait_until_shown(self.wireframe_object)
        self.assertLess(beat.busiest, LONGEST)
        self.assertEqual(of_window().bars(), [])
        self.assertGreater(abs(self.points() - before).max(), 0.1)
        shown = self.points().copy()
        results.clear()
        other = FreeCAD.newDocument("Other")
        here = make.wireframe_of(make.make_design(other, replace(preset("case6"), seed=5)).wireframe)
        self.assertLess(abs(here.paths - shown).max(), 1e-12)

    def test_the_network_follows_from_the_same_work(self):
        network = make.make_network(self.wireframe_object)
        before = network.RodVolume.Value
        self.change_seed(5)
        self.assertEqual((network.Status, network.UpToDate), (COMPUTING, False))
        self.wait_until_shown(self.wireframe_object, network)
        self.assertTrue(network.UpToDate)
        self.assertNotEqual(network.RodVolume.Value, before)
        self.assertLess(network.LargestDifference, 0.2)

    def test_one_pore_is_shown_at_once(self):
        make.make_network(self.wireframe_object)
        self.wireframe_object.Edits = ['{"site": "Face1.2.3", "action": "pore", "size": 0.5}']
        with mock.patch.object(on_demand, "PATIENCE", 1.0):  # a busy machine takes more than 0.08 s now and then
            self.document.recompute()
        self.assertEqual(self.wireframe_object.ResultKey, self.wireframe_object.Proxy.key(self.wireframe_object))
        self.assertEqual(self.document.getObject("Network").Rebuilt, 1)

    def test_cancel_answers_at_once_and_what_was_shown_stays(self):
        before = self.points().copy()
        key = self.wireframe_object.ResultKey
        self.change_seed(5)
        settle(0.3)
        started = time.monotonic()
        of_window().cancel()
        self.assertLess(time.monotonic() - started, 1.0)
        settle(3.0)
        self.assertEqual((self.wireframe_object.Status, self.wireframe_object.ResultKey), (OUT_OF_DATE, key))
        self.wireframe_object.Seed = 1
        self.document.recompute()
        self.assertLess(abs(self.points() - before).max(), 1e-12)

    def test_undo_before_and_after_the_result_comes_gives_back_what_there_was(self):
        before, numbers = self.points().copy(), list(self.wireframe_object.Numbers)
        for waits in (False, True):
            self.change_seed(6 + waits)
            if waits:
                self.wait_until_shown(self.wireframe_object)
                self.assertNotEqual(list(self.wireframe_object.Numbers), numbers)
            self.document.undo()
            self.wait_until_shown(self.wireframe_object)
            self.assertLess(abs(self.points() - before).max(), 1e-12)
            self.assertEqual(list(self.wireframe_object.Numbers), numbers)

    def test_what_the_other_process_refuses_is_an_error_of_the_object(self):
        self.change_seed(8)
        self.wireframe_object.Couplings = ['{"first": "Face1", "second": "Face9"}']
        self.document.recompute()
        self.assertTrue(wait(lambda: self.wireframe_object.Status.startswith("error"), 60))
        self.assertIn("Face9", self.wireframe_object.Status)
        self.assertFalse(self.wireframe_object.isValid())

    def test_a_document_that_is_closed_meanwhile_leaves_nothing_behind(self):
        self.change_seed(5)
        settle(0.2)
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.newDocument("Next")
        settle(3.0)
        self.assertEqual(of_window().bars(), [])
        self.assertEqual(self.document.Objects, [])
