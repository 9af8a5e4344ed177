# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects as envelopes: checked once, refused with their name."""

import sys
from pathlib import Path

import Part

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import DocumentCase

from freecad_trabecula import make
from freecad_trabecula.errors import EnvelopeError
from freecad_trabecula.features import results
from freecad_trabecula.features.envelope import envelope_of, mark_of


class EnvelopeTest(DocumentCase):
    def shape_object(self, shape, name="Body"):
        obj = self.document.addObject("Part::Feature", name)
        obj.Shape = shape
        return obj

    def test_the_same_shape_is_checked_once(self):
        box = make.make_box(self.document)
        first = envelope_of(box)
        self.assertIs(envelope_of(box).envelope, first.envelope)
        self.assertEqual(mark_of(box), first.mark)
        other = make.make_box(self.document)
        self.assertIs(envelope_of(other).envelope, first.envelope)
        box.Length = 11
        self.document.recompute()
        self.assertNotEqual(mark_of(box), first.mark)
        self.assertAlmostEqual(envelope_of(box).envelope.volume, 1100, 6)

    def test_a_solid_inside_out_is_turned(self):
        body = envelope_of(self.shape_object(Part.makeBox(1, 2, 3).reversed()))
        self.assertAlmostEqual(body.envelope.volume, 6)
        self.assertTrue(body.envelope.notes)

    def test_what_is_no_single_solid_is_refused_with_the_objects_name(self):
        box = Part.makeBox(1, 1, 1)
        empty = self.document.addObject("Part::Feature", "Empty")
        for obj, pattern in (
            (None, "must have a shape, got nothing"),
            (empty, "must have a shape, got Empty without one"),
            (self.document.addObject("App::FeaturePython", "Text"), "got Text without one"),
            (self.shape_object(box.Shells[0], "Shell"), "Shell: an envelope must be one closed solid"),
            (self.shape_object(Part.makeShell(box.Faces[:5]), "Open"), "Open: an envelope must be one closed solid"),
            (self.shape_object(Part.makeCompound([box, Part.makeSphere(9)]), "Two"), "Two: one solid of 2 must be"),
        ):
            with self.assertRaisesRegex(EnvelopeError, pattern):
                envelope_of(obj)
        self.assertFalse([key for key in results._kept if key[0] == "envelope"])
