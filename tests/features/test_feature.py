# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all objects share: nothing kept in proxies, migrations, errors, being computed again."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.parameters import RodParameters
from freecad_trabecula.errors import KernelError, ParameterError
from freecad_trabecula.features import feature, migrations
from freecad_trabecula.features.wireframe import Wireframe


class Renamed(Wireframe):
    """A wireframe of the next schema, in which a property has another name."""

    MIGRATIONS = {0: lambda obj: setattr(obj, "Seed", obj.Seed + 100)}


class FeatureTest(DocumentCase):
    def test_a_proxy_keeps_nothing(self):
        proxy = self.make(small_job()).wireframe.Proxy
        self.assertEqual(vars(proxy), {})
        for state in (proxy.dumps(), proxy.loads(None), proxy.__getstate__(), proxy.__setstate__(None)):
            self.assertIsNone(state)

    def test_an_object_of_an_older_schema_is_brought_up_step_by_step(self):
        wireframe = self.make(small_job()).wireframe
        wireframe.SchemaVersion = 0
        wireframe.removeProperty("RodRedraws")
        Renamed.onDocumentRestored(Renamed.__new__(Renamed), wireframe)
        self.assertEqual(wireframe.SchemaVersion, migrations.SCHEMA_VERSION)
        self.assertEqual(wireframe.Seed, 101)
        self.assertEqual(wireframe.RodRedraws, RodParameters().redraws)

    def test_an_object_of_a_later_schema_is_left_as_it_is_and_says_so(self):
        wireframe = self.make(small_job()).wireframe
        wireframe.SchemaVersion = 99
        wireframe = self.reopened().getObject("Wireframe")
        shown = len(wireframe.Shape.Edges)
        wireframe.touch()
        self.document.recompute()
        self.assertFalse(wireframe.isValid())
        self.assertRegex(wireframe.Status, "later version.*schema must be at most 1, got 99")
        self.assertEqual(len(wireframe.Shape.Edges), shown)

    def test_results_are_read_only_and_do_not_touch_their_object(self):
        wireframe = self.make(small_job()).wireframe
        self.assertIn("ReadOnly", wireframe.getEditorMode("Rods"))
        wireframe.Status = "something"
        self.assertEqual(wireframe.State, ["Up-to-date"])

    def test_an_unforeseen_error_leaves_the_object_in_error_with_a_status(self):
        class Broken(feature.Feature):
            def compute(self, obj):
                raise ZeroDivisionError

        obj = self.document.addObject("App::FeaturePython", "Broken")
        proxy = Broken(obj)
        with self.assertRaises(ZeroDivisionError):
            proxy.execute(obj)
        self.assertRegex(obj.Status, "^error: ")
        obj.Proxy = None


class UpdateTest(DocumentCase):
    def test_what_is_wrong_is_raised_as_an_error_of_ours(self):
        wireframe = self.make(small_job()).wireframe
        wireframe.PoreSizeHigh = 0.1
        with self.assertRaisesRegex(ParameterError, "low <= high"):
            make.update(wireframe)

    def test_an_object_that_the_kernel_refuses_is_named(self):
        box = make.make_box(self.document)
        box.Length = 0
        with self.assertRaisesRegex(KernelError, "Envelope could not be computed"):
            make.update(box)

    def test_only_that_object_is_computed_and_is_then_up_to_date(self):
        design = self.make(small_job())
        design.wireframe.Seed = 5
        make.update(design.wireframe)
        self.assertEqual([obj.State for obj in self.document.Objects], [["Up-to-date"]] * 3)
