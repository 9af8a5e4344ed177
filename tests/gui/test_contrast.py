# SPDX-License-Identifier: LGPL-2.1-or-later
"""Words in colour can be read on light and dark themes: ratios of luminances as WCAG 2.1 defines them."""

import unittest

from freecad_trabecula.gui import curve_dialog, notice, outcome, propagation_dialog
from freecad_trabecula.gui.contrast import LEAST, contrast, luminance, readable

#: Papers of FreeCAD's own style sheets, light and dark, and the greys between.
PAPERS = [(255, 255, 255), (239, 239, 239), (35, 38, 41), (51, 51, 51), (30, 30, 30), (0, 0, 0), (119, 119, 119)]
LEAST_OF_WCAG = 4.5


def rgb(code):
    return tuple(int(code[k : k + 2], 16) for k in (1, 3, 5))


class ContrastTest(unittest.TestCase):
    def test_luminance_and_ratio_are_those_of_the_definition(self):
        self.assertAlmostEqual(luminance((255, 0, 0)), 0.2126, places=9)
        self.assertAlmostEqual(luminance((0, 255, 0)), 0.7152, places=9)
        self.assertAlmostEqual(luminance((0, 0, 10)), 0.0722 * 10 / 255 / 12.92, places=12)
        self.assertAlmostEqual(contrast((0, 0, 0), (255, 255, 255)), 21.0, places=9)
        self.assertAlmostEqual(contrast((119, 119, 119), (255, 255, 255)), 4.48, places=2)  # the usual example

    def test_every_colour_of_words_can_be_read_on_every_paper(self):
        codes = (outcome.RED, outcome.ORANGE, outcome.GREEN, notice._GOOD, notice._BAD, curve_dialog._BAD)
        for code in (*codes, propagation_dialog._TRUE, propagation_dialog._FALSE):
            for paper in PAPERS:
                best = max(contrast(one, paper) for one in ((0, 0, 0), (255, 255, 255)))
                found = contrast(rgb(readable(code, paper)), paper)
                self.assertGreaterEqual(round(found, 3), round(min(best, LEAST_OF_WCAG), 3), (code, paper))

    def test_a_colour_that_stands_out_stays_as_it_is(self):
        self.assertEqual(readable("#7c3a1e", (255, 255, 255)), "#7c3a1e")
        self.assertGreater(contrast(rgb("#7c3a1e"), (255, 255, 255)), LEAST)
