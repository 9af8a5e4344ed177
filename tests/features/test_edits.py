# SPDX-License-Identifier: LGPL-2.1-or-later
"""Changes by hand: the site or pore that is named changes, the rest stays, and what is refused changes nothing."""

import json
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import DocumentCase, small_job

from freecad_trabecula import make
from freecad_trabecula.errors import ParameterError


class EditsTest(DocumentCase):
    def setUp(self):
        super().setUp()
        self.wireframe = self.make(small_job(association="same")).wireframe

    def rods(self):
        wireframe = make.wireframe_of(self.wireframe)
        return dict(zip(wireframe.names, wireframe.keys()))

    def changed(self, before):
        after = self.rods()
        return {name for name in before.keys() | after.keys() if before.get(name) != after.get(name)}

    def test_the_size_of_one_pore_changes_its_rod_alone(self):
        before = self.rods()
        make.set_pore(self.wireframe, "Face1.2.3", 0.33, (0.1, 0.2, 0.3, 0.4))
        self.assertEqual(self.changed(before), {"Face1.2.3-Face2.2.3"})
        wireframe = make.wireframe_of(self.wireframe)
        k = wireframe.names.index("Face1.2.3-Face2.2.3")
        self.assertAlmostEqual(wireframe.ends.first.size[k], 0.33)

    def test_a_moved_site_moves_the_end_of_its_rod_onto_the_face(self):
        before = self.rods()
        make.move_site(self.wireframe, "Face1.2.2", (0.3, 4, 6))
        self.assertEqual(self.changed(before), {"Face1.2.2-Face2.2.2"})
        wireframe = make.wireframe_of(self.wireframe)
        k = wireframe.names.index("Face1.2.2-Face2.2.2")
        for value, expected in zip(wireframe.paths[k, 0, 0], (0, 4, 6)):
            self.assertAlmostEqual(value, expected)

    def test_a_site_that_is_off_has_no_rod_and_comes_back(self):
        before = self.rods()
        make.switch_off_site(self.wireframe, "Face1.2.2")
        self.assertEqual(self.changed(before), {"Face1.2.2-Face2.2.2"})
        make.take_back_edits(self.wireframe, "Face1.2.2")
        self.assertEqual(self.rods(), before)

    def test_sites_added_on_both_sides_make_one_more_rod(self):
        before = self.rods()
        names = [make.add_site(self.wireframe, face, (x, 3, 3)) for face, x in (("Face1", 0), ("Face2", 10))]
        self.assertEqual(names, ["Face1.hand.1", "Face2.hand.1"])
        self.assertEqual(self.changed(before), {"Face1.hand.1-Face2.hand.1"})
        self.assertEqual(make.add_site(self.wireframe, "Face1", (0, 7, 7)), "Face1.hand.2")
        make.take_back_edits(self.wireframe, "Face1.hand.1")
        self.assertNotIn("Face1.hand.1-Face2.hand.1", self.rods())

    def test_a_second_change_of_one_kind_replaces_the_first(self):
        make.set_pore(self.wireframe, "Face1.2.2", 0.3)
        make.set_pore(self.wireframe, "Face1.2.2", 0.4)
        make.move_site(self.wireframe, "Face1.2.2", (0, 4, 4))
        self.assertEqual([json.loads(line)["action"] for line in self.wireframe.Edits], ["pore", "move"])
        self.assertEqual(json.loads(self.wireframe.Edits[0])["size"], 0.4)

    def test_what_is_refused_leaves_all_as_it_was(self):
        make.set_pore(self.wireframe, "Face1.2.2", 0.3)
        before, edits = self.rods(), list(self.wireframe.Edits)
        for change, pattern in (
            (lambda: make.set_pore(self.wireframe, "Face1.2.2", -1), "must be at least 0.001, got -1 mm"),
            (lambda: make.set_pore(self.wireframe, "Face1.2.2", turns=(0.5, 0.5)), "takes 4 tangent components, got 2"),
            (lambda: make.set_pore(self.wireframe, "Face1.2.2", turns=(2, 0, 0, 0)), "must lie in 0..1, got 2"),
            (lambda: make.move_site(self.wireframe, "Face1.2.2", (5, 5, 5)), "distance of 5 mm"),
            (
                lambda: make.add_site(self.wireframe, "lid", (0, 0, 0)),
                r"lid.hand.1 \(add\): it must name a site of one",
            ),
            (lambda: make.switch_off_site(self.wireframe, "Face1.9.9"), r"Face1.9.9 \(off\): it must name a site of"),
            (lambda: make.switch_off_site(self.wireframe, "Face1"), "must read face.i.j, got 'Face1'"),
        ):
            with self.assertRaisesRegex(ParameterError, pattern):
                change()
            self.assertEqual(list(self.wireframe.Edits), edits)
            self.assertEqual(self.rods(), before)
            self.assertTrue(self.wireframe.isValid())
