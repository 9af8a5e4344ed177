# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work in two documents at once, each with its own bar and result; notices of what ends while one is elsewhere."""

from dataclasses import replace

import FreeCAD
from window import WindowTest, settle, wait

from freecad_trabecula import make
from freecad_trabecula.core.presets import preset
from freecad_trabecula.features import results
from freecad_trabecula.features.on_demand import COMPUTING
from freecad_trabecula.gui.building import Target, Writing
from freecad_trabecula.gui.child_work import Progress, progress_text
from freecad_trabecula.gui.document_work import Listener
from freecad_trabecula.gui.notice import notices
from freecad_trabecula.gui.recomputing import of_window


class ProgressTextTest(WindowTest):
    def test_the_time_left_is_said_in_round_numbers(self):
        cases = (
            (None, "rods"),
            (0.0, "rods, a few seconds left"),
            (12.0, "rods, about 15 s left"),
            (54.9, "rods, about 55 s left"),
            (55.0, "rods, about 1 min left"),
            (100.0, "rods, about 2 min left"),
            (3599.0, "rods, about 1 h 0 min left"),
            (5460.0, "rods, about 1 h 31 min left"),
        )
        for left, words in cases:
            self.assertEqual(progress_text(Progress(0.5, "rods", left)), words)


class TwoDocumentsTest(WindowTest):
    def setUp(self):
        super().setUp()
        results.clear()
        self.other = FreeCAD.newDocument("Other")
        self.first = make.make_design(self.document, preset("case6")).wireframe
        self.second = make.make_design(self.other, preset("case5")).wireframe

    def tearDown(self):
        notices().forget(self.document.Name)
        notices().forget(self.other.Name)
        super().tearDown()

    def change_both(self):
        for wireframe in (self.first, self.second):
            wireframe.Seed = 5
            wireframe.Document.recompute()
        settle(0.1)

    def wait_until_shown(self, *objects):
        self.assertTrue(wait(lambda: all(one.ResultKey == one.Proxy.key(one) for one in objects), 240))

    def test_both_are_computed_at_once_and_do_not_mix(self):
        self.change_both()
        for wireframe in (self.first, self.second):
            self.assertTrue(wireframe.Status.startswith(COMPUTING))
        self.assertEqual(len(of_window().bars()), 2)
        seen = set()

        def both_seen():
            seen.update(bar.what.text().partition(": ")[0] for bar in of_window().bars() if bar.bar.value() > 0)
            return seen == {self.document.Label, self.other.Label}

        self.assertTrue(wait(both_seen, 120), seen)
        self.wait_until_shown(self.first, self.second)
        for wireframe, name in ((self.first, "case6"), (self.second, "case5")):
            shown = make.wireframe_of(wireframe).paths.copy()
            results.clear()
            document = FreeCAD.newDocument("Alone")
            alone = make.make_design(document, replace(preset(name), seed=5)).wireframe
            self.assertLess(abs(make.wireframe_of(alone).paths - shown).max(), 1e-12)
            FreeCAD.closeDocument(document.Name)

    def test_cancelling_one_leaves_the_other(self):
        self.change_both()
        of_window().bars()[0].button.click()
        self.assertEqual(len(of_window().bars()), 1)
        self.wait_until_shown(self.second)
        self.assertNotEqual(self.first.ResultKey, self.first.Proxy.key(self.first))

    def test_two_designs_that_are_written_step_by_step_in_turn_do_not_mix(self):
        done = []
        for document, name in ((self.document, "case1"), (self.other, "case2")):
            listener = Listener(lambda _: None, lambda _: done.append(1), lambda error: self.fail(str(error)))
            Writing(Target(document.Name), preset(name), ("network",), listener).start()
        self.assertTrue(wait(lambda: len(done) == 2, 240))
        for document, name in ((self.document, "case1"), (self.other, "case2")):
            network = next(obj for obj in document.Objects if obj.Name.startswith("Network"))
            self.assertEqual(network.Document.Name, document.Name)
            self.assertEqual(network.Rods, len(make.wireframe_of(network.Wireframe)))
            pores = network.Wireframe.Proxy.parameters(network.Wireframe).pores
            self.assertEqual(pores, preset(name).pores)
            self.assertEqual(document.UndoNames.count("Design rods"), 1)

    def test_what_ends_elsewhere_is_told_until_it_is_seen_and_show_leads_there(self):
        self.first.Seed = 7
        self.document.recompute()
        FreeCAD.setActiveDocument(self.other.Name)
        self.wait_until_shown(self.first)
        self.assertTrue(wait(lambda: notices().texts(), 10))
        (text,) = notices().texts()
        self.assertEqual(text, f"{self.document.Label}: {self.first.Label} is done")
        settle(1.0)
        self.assertTrue(notices().isVisible())
        notices()._rows[0].show_button.click()
        self.assertEqual((FreeCAD.ActiveDocument.Name, notices().texts()), (self.document.Name, []))
        self.assertFalse(notices().isVisible())

    def test_what_fails_elsewhere_is_told_and_goes_with_its_document(self):
        self.first.Seed = 8
        self.document.recompute()
        self.first.Couplings = ['{"first": "Face1", "second": "Face9"}']
        self.document.recompute()
        FreeCAD.setActiveDocument(self.other.Name)
        self.assertTrue(wait(lambda: notices().texts(), 60))
        self.assertEqual(notices().texts(), [f"{self.document.Label}: {self.first.Label} failed"])
        FreeCAD.closeDocument(self.document.Name)
        self.assertEqual(notices().texts(), [])
        self.document = FreeCAD.newDocument("Next")
