# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sites of a prism in the document: Eq. 2.1 on a box that may be edited and moved."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.core.parameters import PrismParameters
from freecad_trabecula.errors import ParameterError


class PrismSitesTest(DocumentCase):
    def test_their_number_is_that_of_equation_2_1(self):
        sites = make.make_prism_sites(make.make_box(self.document), PrismParameters(n_x=3, n_y=4, n_z=5))
        self.assertEqual(sites.Count, 2 * (3 * 4 + 4 * 5 + 5 * 3))
        self.assertEqual(len(sites.Shape.Vertexes), sites.Count)

    def test_one_site_per_direction_is_refused_where_it_is_made(self):
        for n in (0, 1):
            with self.assertRaisesRegex(ParameterError, "sites along X must be at least 2 .*got " + str(n)):
                make.make_prism_sites(make.make_box(self.document), PrismParameters(n_x=n))

    def test_border_distance_of_half_the_edge_is_refused(self):
        sites = self.make(small_job()).sites[0]
        sites.BorderX = 5
        self.document.recompute()
        self.assertRegex(sites.Status, "0 <= a < edge / 2 = 5 mm, got 5 mm")
        self.assertFalse(sites.isValid())

    def test_prism_sites_need_a_box(self):
        sites = self.make(small_job()).sites[0]
        sites.Box = None
        self.document.recompute()
        self.assertRegex(sites.Status, "must be linked to a box, got nothing")
