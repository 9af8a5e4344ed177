# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sliced areas drawn with the mouse: points made, dragged, taken away; what cannot be is refused; designs of them."""

import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui
from test_voxel_panel import HALF, VoxelCase
from window import settle

from freecad_trabecula import make
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.voxels.drawn_curves import DrawnCurves, curve_volumes
from freecad_trabecula.gui import voxel_form
from freecad_trabecula.gui.curve_dialog import CurveDialog

LEFT, RIGHT = QtCore.Qt.LeftButton, QtCore.Qt.RightButton
START = DrawnCurves((4.0, 4.0, 4.0), ((0.0, 0.5), (1.0, 0.5)), ((0.5, 0.5),), ((0.5, 0.5),))


class CurveTest(VoxelCase):
    def dialog(self, curves=START, analyses=()):
        dialog = CurveDialog(FreeCADGui.getMainWindow(), curves, analyses)
        dialog.show()
        settle(0.2)
        self.addCleanup(dialog.close)
        return dialog

    def mouse(self, view, kind, place, share, button=LEFT):
        x, y = view.pixel(place, share)
        where = QtCore.QPointF(round(x), round(y))
        spot = QtCore.QPointF(view.mapToGlobal(QtCore.QPoint(round(x), round(y))))
        event = QtGui.QMouseEvent(kind, where, spot, button, button, QtCore.Qt.NoModifier)
        QtGui.QApplication.sendEvent(view, event)

    def drag(self, view, start, end):
        self.mouse(view, QtCore.QEvent.MouseButtonPress, *start)
        for t in (0.3, 0.7, 1.0):
            place, share = (a + t * (b - a) for a, b in zip(start, end))
            self.mouse(view, QtCore.QEvent.MouseMove, place, share)
        self.mouse(view, QtCore.QEvent.MouseButtonRelease, *end)

    def test_points_are_made_dragged_and_taken_away(self):
        dialog = self.dialog()
        view = dialog.views[0]
        before = curve_volumes(dialog.curves())[0]
        self.drag(view, (0.5, 0.5), (0.4, 0.3))
        (place, share) = view.points[1]
        self.assertAlmostEqual(place, 0.4, delta=0.01)
        self.assertAlmostEqual(share, 0.3, delta=0.01)
        self.assertLess(curve_volumes(dialog.curves())[0], before)
        self.assertIn("The totals differ", dialog.message.text())
        self.mouse(view, QtCore.QEvent.MouseButtonPress, place, share, RIGHT)
        self.assertEqual(view.points, START.x)

    def test_a_curve_never_leaves_what_a_layer_holds(self):
        dialog = self.dialog()
        view = dialog.views[0]
        self.drag(view, view.points[0], (0.0, -0.2))
        self.assertEqual(view.points[0], (0.0, 0.0))
        self.drag(view, view.points[1], (1.0, 0.5))
        for start in (0.5, 0.6):  # the axis grows with the curve until it is full
            self.mouse(view, QtCore.QEvent.MouseButtonPress, *view.points[1])
            self.mouse(view, QtCore.QEvent.MouseMove, 1.0, 2.0 * start)
            self.assertTrue(0 <= view.points[1][1] <= 1)
            self.mouse(view, QtCore.QEvent.MouseMove, 1.0, 3.0)
            self.assertEqual(view.points[1], (1.0, 1.0))
            self.assertIn("must not be larger than its layer", dialog.message.text())
            self.mouse(view, QtCore.QEvent.MouseButtonRelease, 1.0, 1.0)
        self.assertTrue(dialog.buttons.button(QtGui.QDialogButtonBox.Ok).isEnabled())

    def test_a_point_is_not_dragged_past_its_neighbour_and_the_last_one_stays(self):
        dialog = self.dialog()
        view = dialog.views[0]
        self.drag(view, (0.5, 0.5), (0.5, 0.3))
        self.drag(view, view.points[1], (1.4, 0.3))
        self.assertEqual(len(view.points), 3)
        self.assertLess(view.points[1][0], 1.0)
        single = dialog.views[1]
        self.mouse(single, QtCore.QEvent.MouseButtonPress, *single.points[0], RIGHT)
        self.assertEqual(single.points, START.y)
        self.assertIn("at least one point", dialog.message.text())

    def test_one_total_and_bad_edges(self):
        dialog = self.dialog(DrawnCurves((4.0, 4.0, 4.0), ((0.5, 0.2),), ((0.5, 0.4),), ((0.5, 0.6),)))
        self.assertRegex(dialog.totals[1].text(), "along Y: 25[.,]6 mm³, 40[.,]00 % of the box")
        dialog.one_total.click()
        self.assertTrue(np.allclose(curve_volumes(dialog.curves()), 25.6, rtol=1e-5))
        self.assertEqual(dialog.message.text(), "")
        dialog.edges[0].set_value(0.0)
        self.assertIn("must be above 0", dialog.message.text())
        self.assertFalse(dialog.buttons.button(QtGui.QDialogButtonBox.Ok).isEnabled())

    def test_the_profiles_of_an_analysis_are_bent(self):
        analysis = make.make_analysis(self.document, self.bracket(), SliceParameters(thickness=0.5))
        dialog = self.dialog(None, [analysis])
        dialog.analysis.choose(analysis)
        curves = dialog.curves()
        self.assertTrue(np.allclose(curves.edges, 4.0))
        self.assertTrue(np.allclose(curve_volumes(curves), 48, rtol=0.02))
        self.assertEqual(len(curves.z), 2)
        self.assertTrue(np.allclose(dialog.views[2].profile, 0.75))

    def test_drawn_curves_are_designed_from_and_bent_again(self):
        panel = self.open_panel()
        asked, voxel_form.ask_for_curves = voxel_form.ask_for_curves, lambda *_: START
        try:
            panel.fields.draw.click()
        finally:
            voxel_form.ask_for_curves = asked
        self.assertIn("8 x 8 x 8 layers", panel.message.text())
        self.work(panel)
        (obj,) = self.designs()
        self.assertEqual((obj.Voxels, obj.Source, obj.File), (256, None, ""), self.dialogs)
        self.assertTrue(panel.fields.draw.isEnabled())
        less = DrawnCurves(START.edges, ((0.5, 0.25),), ((0.5, 0.25),), ((0.5, 0.25),))
        panel.fields.take_curves(less)
        self.work(panel)
        self.assertEqual((obj.Voxels, len(self.designs())), (128, 1), self.dialogs)
        panel.reject()
        obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
        settle(0.3)
        from freecad_trabecula.gui import panels

        self.assertEqual(panels.current().fields.curves(), less)

    def test_the_design_of_a_body_has_no_curves_to_bend(self):
        obj = make.make_voxel_design(self.document, self.bracket(), HALF)
        panel = self.open_panel(obj)
        self.assertFalse(panel.fields.draw.isEnabled())
        self.assertIsNone(panel.fields.curves())
