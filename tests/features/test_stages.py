# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a document has come, read from the document alone."""

import Part
from document_case import DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.features.stages import DONE, FAILED, NONE, STALE, stages_of, stale_objects, state_of


class StagesTest(DocumentCase):
    def solid(self, name="Body"):
        body = self.document.addObject("Part::Feature", name)
        body.Shape = Part.makeBox(3, 4, 5)
        return body

    def test_no_document_and_an_empty_one_hold_nothing(self):
        for document in (None, self.document):
            on = stages_of(document)
            self.assertEqual((on.bodies, on.wireframe, on.analyses, on.bones), ([], None, [], []))
        self.assertEqual(state_of(None), NONE)

    def test_a_body_that_is_measured_is_bone_and_no_longer_one_to_be_measured(self):
        body = self.solid()
        self.assertEqual(stages_of(self.document).bones, [body])
        analysis = make.make_analysis(self.document, body)
        on = stages_of(self.document)
        self.assertEqual((on.of_bone, on.bones), (analysis, []))
        self.assertEqual(state_of(analysis), DONE)

    def test_a_selected_body_comes_before_others(self):
        first, second = self.solid("First"), self.solid("Second")
        on = stages_of(self.document, [second, second])
        self.assertEqual((on.chosen, on.bones), ([second], [second, first]))
        self.assertEqual(stages_of(self.document).chosen, [])

    def test_an_envelope_is_no_bone_and_the_analysis_of_a_network_is_that_of_the_design(self):
        design = make.make_design(self.document, small_job(), ("network",))
        analysis = make.make_analysis(self.document, design.network)
        on = stages_of(self.document)
        self.assertEqual((on.bones, on.scaffold, on.of_scaffold, on.of_bone), ([], design.network, analysis, None))

    def test_what_is_made_of_something_stale_is_stale_too_and_only_the_first_is_to_be_updated(self):
        design = make.make_design(self.document, small_job(), ("network",))
        analysis = make.make_analysis(self.document, design.network)
        design.network.AutoUpdate = False
        design.wireframe.Seed += 1
        self.document.recompute()
        self.assertEqual([state_of(obj) for obj in (design.wireframe, design.network, analysis)], [DONE, STALE, STALE])
        self.assertEqual(stale_objects(self.document)[0], design.network)
        make.update(design.network)
        self.document.recompute()
        self.assertEqual([state_of(obj) for obj in (design.network, analysis)], [DONE, DONE])
        self.assertEqual(stale_objects(self.document), [])

    def test_an_object_in_error_has_failed_and_what_is_made_of_it_is_stale(self):
        body = self.solid()
        analysis = make.make_analysis(self.document, body)
        analysis.SliceThickness = -1
        self.document.recompute()
        self.assertEqual(state_of(analysis), FAILED)

    def test_of_two_designs_the_chosen_one_counts_else_the_latest(self):
        first = make.make_design(self.document, small_job()).wireframe
        second = make.make_design(self.document, small_job(2)).wireframe
        self.assertEqual(stages_of(self.document).wireframe, second)
        self.assertEqual(stages_of(self.document, [first.Sites[0]]).wireframe, first)
