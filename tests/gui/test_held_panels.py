# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels that were closed and are still held by Python give nothing of theirs to the next: neither boxes nor values."""

import itertools

import FreeCAD
import FreeCADGui
from PySide import QtGui
from window import WindowTest, settle, type_into, wait

from freecad_trabecula.core.presets import preset
from freecad_trabecula.gui import fields, panels
from freecad_trabecula.gui.qt import is_alive

TIMES = 50
EVERY_FEW = 10  # panels of a design take longer to open


class HeldPanelsTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.held, self.boxes, self.new = [], [], []
        self._quantity_box = fields.quantity_box

        def noted():
            self.new.append(self._quantity_box())
            return self.new[-1]

        fields.quantity_box = noted

    def tearDown(self):
        fields.quantity_box = self._quantity_box
        self.held.clear()
        super().tearDown()

    def look(self):
        """Look at the boxes of the panel that has just been opened, and at those of the panels before it."""
        self.assertGreater(len(self.new), 2)
        for number, box in enumerate(self.new):
            self.assertTrue(is_alive(box))
            self.assertFalse(any(box is other for other in self.boxes), "the wrapper of a closed panel's box")
            self.assertTrue(is_alive(box.findChild(QtGui.QLineEdit)))
            box.setProperty("value", FreeCAD.Units.Quantity(1.25 + number, FreeCAD.Units.Length))
        for number, box in enumerate(self.new):
            kept = float(box.property("rawValue"))
            low, high = float(box.property("minimum")), float(box.property("maximum"))
            self.assertAlmostEqual(kept, min(max(1.25 + number, low), high))
        self.assertEqual([box for box in self.boxes if is_alive(box)], [], "the box of a closed panel has come back")

    def close(self):
        panel = panels.current()
        panel.reject()
        self.assertTrue(wait(lambda: not FreeCADGui.Control.activeDialog(), 20))
        settle(0.05)
        self.held.append(panel)
        self.boxes += self.new
        self.new.clear()

    def test_each_of_fifty_panels_has_boxes_of_its_own(self):
        torus = self.torus()
        kinds = (
            lambda: panels.open_analysis(self.document, None, torus),
            lambda: panels.open_voxels(self.document, None, torus),
        )
        for number, show in zip(range(TIMES), itertools.cycle(kinds)):
            if number % EVERY_FEW == EVERY_FEW - 1:
                panels.open_new(self.document, preset("case1"))
            else:
                show()
            settle(0.05)
            self.look()
            if number < TIMES - 1:
                self.close()
        self.close()
        self.assertEqual((len(self.held), self.errors), (TIMES, []))

    def test_what_is_typed_reaches_the_panel_that_is_open(self):
        torus = self.torus()
        for number in range(5):
            panels.open_analysis(self.document, None, torus)
            settle(0.2)
            box = panels.current().fields.layers.fields["thickness"]
            type_into(box.widget, f"{0.2 + 0.1 * number:.1f}")
            self.assertAlmostEqual(box.value(), 0.2 + 0.1 * number)
            self.close()
