# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects that compute only what has changed, or wait to be told."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import DocumentCase

from freecad_trabecula import make
from freecad_trabecula.errors import KernelError
from freecad_trabecula.features import results
from freecad_trabecula.features.feature import Property, result
from freecad_trabecula.features.on_demand import OUT_OF_DATE, OnDemand, on_demand


class Doubled(OnDemand):
    """Twice a number, and a note of how often that was worked out."""

    KIND = "solid"
    PROPERTIES = (
        *on_demand(False),
        Property("App::PropertyInteger", "Number", "Base", "A number"),
        result("Integer", "Double", "Twice the number"),
    )
    made = 0

    def key(self, obj):
        return f"doubled {obj.Number}"

    def make(self, obj, progress):
        Doubled.made += 1
        return 2 * obj.Number

    def show(self, obj, value):
        if value > 100:
            raise KernelError(f"twice a number must be at most 100, got {value}")
        obj.Double = value

    def said(self, obj):
        return f"twice is {obj.Double}"


class OnDemandTest(DocumentCase):
    def setUp(self):
        super().setUp()
        Doubled.made = 0
        self.obj = self.document.addObject("App::FeaturePython", "Doubled")
        Doubled(self.obj)
        self.addCleanup(lambda: None)
        self.obj.Number = 4

    def tearDown(self):
        self.obj.Proxy = None
        super().tearDown()

    def state(self):
        self.document.recompute()
        return self.obj.Status, self.obj.UpToDate, self.obj.Double, Doubled.made

    def test_it_waits_until_it_is_updated(self):
        self.assertEqual(self.state(), (OUT_OF_DATE, False, 0, 0))
        make.update(self.obj)
        self.assertEqual(self.state(), ("twice is 8", True, 8, 1))

    def test_it_keeps_what_it_had_while_it_waits_and_knows_it_when_it_belongs_again(self):
        make.update(self.obj)
        results.clear()
        self.obj.Number = 5
        self.assertEqual(self.state(), (OUT_OF_DATE, False, 8, 1))
        self.obj.Number = 4
        self.assertEqual(self.state(), ("twice is 8", True, 8, 1))

    def test_it_takes_a_result_that_is_at_hand(self):
        results.keep("solid", "doubled 4", 8)
        self.assertEqual(self.state(), ("twice is 8", True, 8, 0))

    def test_it_follows_at_once_if_that_is_wanted(self):
        self.obj.AutoUpdate = True
        self.assertEqual(self.state(), ("twice is 8", True, 8, 1))
        self.obj.Number = 5
        self.assertEqual(self.state(), ("twice is 10", True, 10, 2))

    def test_a_result_that_is_refused_is_not_shown_and_is_no_success_the_next_time(self):
        make.update(self.obj)
        self.obj.Number = 60
        for _ in range(2):
            with self.assertRaisesRegex(KernelError, "Doubled could not be computed: twice .* got 120"):
                make.update(self.obj)
            self.assertEqual((self.obj.Double, self.obj.UpToDate), (8, False))
