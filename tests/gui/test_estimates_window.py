# SPDX-License-Identifier: LGPL-2.1-or-later
"""What heavy work will take is said in the window before it begins; of little work nothing is said."""

import tempfile
from pathlib import Path
from unittest.mock import patch

import FreeCADGui
from PySide import QtGui
from window import WindowTest, settle, wait

from freecad_trabecula import make
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.estimates import Work
from freecad_trabecula.core.mesh_formats import write_obj
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.stl import write_stl
from freecad_trabecula.core.variants import SCAFFOLD
from freecad_trabecula.features.analysis_source import body_of_source, object_source, soup_of_source
from freecad_trabecula.features.estimates import variants_work
from freecad_trabecula.geometry.mesh_objects import core_mesh
from freecad_trabecula.gui import analysis_saving, background, panels, recomputing
from freecad_trabecula.gui.analysing import analyse_at_once
from freecad_trabecula.gui.analysis_dock import dock_of_window
from freecad_trabecula.gui.child_work import Progress
from freecad_trabecula.gui.recomputing import WorkBar
from freecad_trabecula.gui.variants_dialog import VariantsDialog
from freecad_trabecula.gui.work_text import work_text


class EstimatesTest(WindowTest):
    def tearDown(self):
        dock_of_window().hide()
        super().tearDown()

    def test_little_work_is_not_spoken_of_and_more_in_two_digits(self):
        self.assertEqual(work_text(Work(4.9, 4e7, 4e7)), "")
        self.assertEqual(work_text(Work(137.2)), "about 2 min 20 s")
        self.assertEqual(work_text(Work(9.0, 1.234e10)), "about 9 s, 12 GB of memory")
        self.assertEqual(work_text(Work(1.0, 3.14e8, 6.6e7)), "about 1 s, 310 MB of memory, files of 66 MB")

    def test_the_status_bar_says_what_it_will_take_until_the_time_left_is_known(self):
        bar = WorkBar(lambda: None)
        bar.show_start("about 2 min")
        self.assertEqual(bar.what.text(), "being computed (about 2 min)")
        bar.show_progress(Progress(0.01, "rods", None))
        self.assertEqual(bar.what.text(), "rods (about 2 min)")
        bar.show_progress(Progress(0.2, "rods", 100.0))
        self.assertEqual(bar.what.text(), "rods, about 2 min left")
        bar.close_bar()

    def test_the_panel_says_it_of_a_solid_a_mesh_and_a_file(self):
        torus = self.torus()
        mesh = core_mesh(make.make_scaffold(make.make_design(self.document, preset("case1")).wireframe).Mesh)
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "a.stl")
            write_stl(path, mesh)
            for source in (torus, self.document.getObject("Scaffold"), path):
                panels.open_analysis(self.document, None, torus if source == path else source)
                panel = panels.current()
                if source == path:
                    panel.fields.set_file(path)
                fields = panel.fields
                fields.layers.fields["thickness"].set_value(0.5)
                self.assertRegex(panel.message.text(), r"^Slices: X \d+, Y \d+, Z \d+$")
                fields.layers.fields["thickness"].set_value(0.0005)
                self.assertRegex(panel.message.text(), r"^Slices: .*; about \d+ s, \d.* of memory$")
                fields.layers.fields["thickness"].set_value(0.5)
                fields.morphometry.setChecked(True)
                self.assertRegex(panel.message.text(), r"^Slices: .*; about \d+ s, \d.* of memory$")
                panel.reject()

    def test_the_panel_says_it_of_a_mesh_that_is_a_text(self):
        mesh = core_mesh(make.make_scaffold(make.make_design(self.document, preset("case1")).wireframe).Mesh)
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "a.obj")
            write_obj(path, mesh)
            panels.open_analysis_of_file(self.document, path)
            panel = panels.current()
            panel.fields.layers.fields["thickness"].set_value(0.0005)
            self.assertRegex(panel.message.text(), r"^Slices: X \d+, Y \d+, Z \d+; about \d+ s, \d.* of memory$")
            panel.reject()

    def test_a_recompute_says_it_in_the_status_bar(self):
        said, asked = [], []
        torus = self.torus()
        analysis = make.make_analysis(self.document, torus, SliceParameters(thickness=1.0))
        design = make.make_design(self.document, preset("case6"), ("scaffold",))
        wireframe, design.scaffold.AutoUpdate = design.wireframe, True
        with patch.object(recomputing, "work_of", lambda objects: asked.append(objects) or Work(64.0)), patch.object(
            WorkBar, "show_start", lambda bar, text="": said.append(text)
        ):
            analysis.setExpression("SliceThickness", "0.001 mm")
            wireframe.Seed = 5
            self.document.recompute()
            wanted = {analysis.Name, wireframe.Name}
            self.assertTrue(wait(lambda: wanted <= {objects[0].Name for objects in asked}, 60), asked)
            recomputing.of_window().cancel()
        self.assertEqual(set(said), {"about 1 min 4 s"})
        self.assertIn("Scaffold", [obj.Name for objects in asked for obj in objects])

    def test_triangles_of_solids_and_of_rods_are_told_within_a_half(self):
        wireframe = make.make_design(self.document, preset("case6")).wireframe
        for obj in (self.torus(), wireframe):
            source = object_source(obj)
            known = body_of_source(source).triangles / len(soup_of_source(source, "auto", 0.0).triangles)
            self.assertTrue(0.5 < known < 1.5, (obj.Label, known))

    def test_one_click_says_it_in_the_status_bar(self):
        said = []
        with patch("freecad_trabecula.gui.analysing.work_of_analysis", lambda *_: Work(64.0)), patch.object(
            background.WorkBar, "show_start", lambda bar, text="": said.append(text)
        ):
            found = []
            analyse_at_once(self.torus(), found.append)
            self.assertTrue(wait(lambda: found, 120), self.dialogs)
        self.assertEqual(said, ["about 1 min 4 s"])

    def test_saving_says_it_where_the_folder_is_asked_for(self):
        analysis, titles = make.make_analysis(self.document, make.make_box(self.document, 2, 3, 4)), []
        with patch.object(
            QtGui.QFileDialog, "getExistingDirectory", lambda parent, title, folder: titles.append(title) or ""
        ):
            analysis_saving.ask_and_save([analysis])
            with patch.object(analysis_saving, "work_of_saving", lambda *_: Work(64.0, files=8e7)):
                analysis_saving.ask_and_save([analysis, analysis])
        words = "Folder for tables, report and plots"
        self.assertEqual(titles, [words, f"{words}: about 1 min 4 s, files of 80 MB"])
        one, two = (analysis_saving.work_of(objects) for objects in ([analysis], [analysis, analysis]))
        self.assertGreater(one.files, 1e4)
        self.assertGreater(two.seconds, one.seconds)

    def test_other_seeds_say_it_beside_their_number(self):
        wireframe = make.make_design(self.document, preset("case6")).wireframe
        found = VariantsDialog(wireframe)
        found.count.setValue(1)
        self.assertEqual(found.estimate.text(), "")
        found.count.setValue(200)
        self.assertRegex(found.estimate.text(), r"^about \d+ min")
        by_rays = variants_work(wireframe, 200).seconds
        found.by.setCurrentIndex(1)
        self.assertGreater(variants_work(wireframe, 200, SCAFFOLD).seconds, 3 * by_rays)
        self.assertRegex(found.estimate.text(), r"^about \d+ min .* of memory$")
        with patch("freecad_trabecula.gui.variants_dialog.variants_work") as again:
            found.count.setValue(100)
        again.assert_not_called()  # the triangles of a variant are counted once, not at every key
        self.assertRegex(found.estimate.text(), r"^about \d+ min .* of memory$")
        found.close()
        settle(0.1)
        FreeCADGui.Selection.clearSelection()
