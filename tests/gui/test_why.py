# SPDX-License-Identifier: LGPL-2.1-or-later
"""Why? in the window: every number that the panels show has its explanation, and a click tells it with both routes."""

import unittest
from unittest import mock

import FreeCADGui
from PySide import QtCore, QtGui
from window import WindowTest, settle, wait

from freecad_trabecula import make
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.booleans import manifold_available
from freecad_trabecula.core.explanations.registry import explanation
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.gui import analysis_plots, panels, voxel_figures, voxel_layers, why
from freecad_trabecula.gui.analysis_dock import dock_of_window, show_analyses
from freecad_trabecula.gui.figures import figures_of
from freecad_trabecula.gui.voxel_dock import show_layers, voxel_dock
from freecad_trabecula.gui.why import WhyPopup

HALF = SliceParameters(thickness=0.5)
NO_BOOLEANS = "manifold3d is not installed: nothing that needs mesh Booleans is tested"


def popups():
    return [one for one in QtGui.QApplication.topLevelWidgets() if isinstance(one, WhyPopup) and one.isVisible()]


def click(table, row, column=0):
    """Press and release the mouse in a cell of a table, and return the text that is told."""
    place = table.visualItemRect(table.item(row, column)).center()
    where = table.viewport()
    for kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonRelease):
        QtGui.QApplication.sendEvent(
            where, QtGui.QMouseEvent(kind, QtCore.QPointF(place), QtCore.QPointF(where.mapToGlobal(place)),
                                     QtCore.Qt.LeftButton, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier)
        )  # fmt: skip
    settle(0.2)
    found = popups()
    text = found[0].text() if found else ""
    for one in found:
        one.close()
    settle(0.1)
    return text


class WhyTest(WindowTest):
    def tearDown(self):
        dock_of_window().hide()
        voxel_dock().hide()
        super().tearDown()

    def row_of(self, table, words):
        rows = [row for row in range(table.rowCount()) if table.item(row, 0).text().startswith(words)]
        self.assertTrue(rows, words)
        return rows[0]

    def bracket(self):
        body = self.document.addObject("Part::Feature", "Bracket")
        body.Shape = make.make_box(self.document, 4, 4, 4).Shape.cut(make.make_box(self.document, 2, 2, 4).Shape)
        return body

    @unittest.skipUnless(manifold_available(), NO_BOOLEANS)
    def test_every_figure_of_a_design_tells_formula_source_and_both_routes(self):
        wireframe = make.make_design(self.document, preset("case1"), ("network", "scaffold")).wireframe
        rows = figures_of(wireframe)
        self.assertGreater(len(rows), 14)
        for row in rows:
            if any(letter.isdigit() for letter in row.value):
                self.assertTrue(explanation(row.key).formula, row)
        panels.open_results(self.document.Name, wireframe)
        panel = panels.current()
        settle(0.5)
        text = click(panel.figures, self.row_of(panel.figures, "Porosity"))
        for words in (
            "thesis Eq. 2.2",
            "V_envelope",
            "scaffold + channels + loose pieces = envelope, mm³: 1000 against",
        ):
            self.assertIn(words, text)
        last = panel.figures.columnCount() - 1
        self.assertIn("none", click(panel.figures, self.row_of(panel.figures, "Connected channels"), last))
        self.assertIn("75 against 75, 0 apart", click(panel.figures, self.row_of(panel.figures, "Rods"), last))
        self.assertEqual(click(panel.figures, self.row_of(panel.figures, "Engine")), "")
        panel.sections.open(3)
        settle(0.3)
        text = click(panel.couplings, 0)
        self.assertTrue("tables 4.2 and 4.5" in text and "sites left" in text)

    def test_every_number_of_analyses_and_their_comparison_has_an_explanation(self):
        body = self.bracket()
        first = make.make_analysis(self.document, body, HALF, morphometry=True)
        second = make.make_analysis(self.document, make.make_box(self.document, 4, 4, 4), HALF, morphometry=True)
        analyses = [make.analysis_of(one) for one in (first, second)]
        compared = analysis_plots.comparison_of(analyses)
        rows = [*analysis_plots.figures_of(analyses[0])[1], *analysis_plots.passport_of(compared, analyses)[1]]
        self.assertGreater(len(rows), 60)
        for row in rows:
            self.assertTrue(explanation(row.key).formula, row)
        for kinds in (analysis_plots.KEYS, analysis_plots.COMPARED_KEYS):
            self.assertEqual(list(kinds), [kind for kind, _ in analysis_plots.KINDS])
            self.assertTrue(all(explanation(key) for keys in kinds.values() for key in keys))
        dock = show_analyses([first])
        dock.tabs.setCurrentIndex(dock.tabs.count() - 1)
        settle(0.3)
        text = click(dock.figures, self.row_of(dock.figures, "Volume by slices"))
        self.assertIn("volume along x, sum of area x thickness against the mesh, mm³: 48 against 48", text)
        self.assertIn('<a href="https://doi.org/10.1137/1.9781611970081">', text)
        row = self.row_of(dock.figures, "BV/TV")
        dock.figures.scrollToItem(dock.figures.item(row, 0))
        self.assertIn("0.75 against 0.75, 0 of it apart", click(dock.figures, row))
        dock.tabs.setCurrentIndex(1)
        dock.why_plot.click()
        self.assertTrue(wait(popups, 5))
        self.assertIn("porosity of a slice", popups()[0].text())
        popups()[0].close()

    def test_every_number_of_voxels_has_an_explanation(self):
        design = make.make_voxel_design(self.document, self.bracket(), VoxelParameters(size=(0.5, 0.5, 0.5)))
        for row in voxel_figures.figures_of(design):
            self.assertTrue(explanation(row.key).formula, row)
        self.assertEqual(list(voxel_layers.KEYS), [kind for kind, _ in voxel_layers.KINDS])
        dock = show_layers(design)
        dock.tabs.setCurrentIndex(len(voxel_layers.KINDS))
        settle(0.3)
        text = click(dock.figures, self.row_of(dock.figures, "Volume of the voxels"))
        self.assertIn("volume of the mesh and of the voxels, mm³: 48 against 48", text)
        dock.tabs.setCurrentIndex(0)
        dock.why_plot.click()
        self.assertTrue(wait(popups, 5))
        self.assertIn("thesis Eq. 6.1", popups()[0].text())
        popups()[0].close()

    def test_it_has_the_ground_and_the_letters_of_the_theme(self):
        dark = QtGui.QColor(35, 38, 41), QtGui.QColor(235, 235, 235)
        with mock.patch.object(why, "paper_and_ink", lambda: dark):
            popup = WhyPopup("why", FreeCADGui.getMainWindow())
        picture = popup.grab().toImage()
        self.assertEqual(picture.pixelColor(4, 4).getRgb(), dark[0].getRgb())
        shades = {picture.pixelColor(x, y).lightness() for x in range(12, 60) for y in range(5, picture.height() - 5)}
        self.assertGreater(max(shades), 180)  # letters
        popup.close()
