# SPDX-License-Identifier: LGPL-2.1-or-later
"""Does long work in a FreeCAD window and measures for how long it does not answer; started by ``stalls.py``."""

import json
import os
import sys
import tempfile
import threading
import time
import traceback
from collections import Counter
from contextlib import contextmanager
from pathlib import Path

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "tests" / "gui")]
CHOICE = json.loads(os.environ["TRABECULA_STALLS"])
GOAL = 0.2  # s

from window import Heartbeat, wait  # noqa: E402  the folder comes first


class Watched(Heartbeat):
    """A heartbeat that says what the thread did in the busiest stretch."""

    def __init__(self):
        super().__init__()
        self.where = ""
        self._seen, self._ends = [], False
        self._main = threading.get_ident()
        self._watcher = threading.Thread(target=self._watch, daemon=True)

    def _watch(self):
        while not self._ends:
            frame = sys._current_frames().get(self._main)
            if frame is not None:
                self._seen.append(place(frame))
            time.sleep(0.01)

    def _beat(self):
        before, seen, start = self.busiest, self._seen, self._last_busy
        self._seen = []
        super()._beat()
        counts = Counter(seen).most_common(8)
        if self.busiest > before and counts:
            self.where = counts[0][0]
        if self._last_busy - start > GOAL / 2:
            told = "; ".join(f"{count} {words}" for words, count in counts)
            print(f"    {self._last_busy - start:.2f} s: {told}", file=sys.__stdout__, flush=True)

    def __enter__(self):
        self._watcher.start()
        return super().__enter__()

    def __exit__(self, *_):
        super().__exit__()
        self._ends = True
        self._watcher.join()


def place(frame):
    """Return the innermost line of ours of a stack, and the innermost of all."""
    lines = []
    while frame is not None:
        file = Path(frame.f_code.co_filename)
        is_ours = "freecad_trabecula" in file.parts
        if not lines or is_ours:
            lines.append(f"{file.stem}.{frame.f_code.co_name}:{frame.f_lineno}")
        if is_ours:
            break
        frame = frame.f_back
    return " < ".join(dict.fromkeys(lines))


class Steps:
    """What has been measured, step by step."""

    def __init__(self):
        self.rows = []

    @contextmanager
    def step(self, name):
        """Measure one step, from the click until what comes of it has been seen for a second."""
        wait(seconds=0.5)
        with Watched() as beats:
            yield
            wait(seconds=1.0)
        self.rows.append({"step": name, "wall": beats.longest, "busy": beats.busiest, "where": beats.where})
        Path(CHOICE["result"]).write_text(json.dumps(self.rows), encoding="utf-8")
        if CHOICE["pictures"]:
            file = f"{CHOICE['work']}-{len(self.rows)}.png"
            QtGui.QGuiApplication.primaryScreen().grabWindow(0).save(str(Path(CHOICE["pictures"]) / file))


def until(condition, seconds=600):
    """Run the event loop until a condition holds.

    Raises
    ------
    SystemExit
        If it does not in time.
    """
    if not wait(condition, seconds):
        raise SystemExit(f"not done in {seconds} s")


def arrange():
    """Give the window its size."""
    FreeCADGui.activateWorkbench("TrabeculaWorkbench")
    FreeCADGui.getMainWindow().setGeometry(0, 0, 1280, 800)
    wait(seconds=1.0)


def run(command):
    """Run a command as a click on its button does."""
    FreeCADGui.runCommand(command)


def select(*names):
    """Select objects of the active document."""
    FreeCADGui.Selection.clearSelection()
    for name in names:
        FreeCADGui.Selection.addSelection(FreeCAD.ActiveDocument.Name, name)


def fit():
    """Show all of the active document."""
    view = FreeCADGui.activeDocument().activeView()
    view.viewIsometric()
    view.fitAll()


def gyroid(document):
    """Add the mesh of a gyroid of some 400,000 triangles: large, curved, of one part, known without a file."""
    from freecad_trabecula.core.meshes import printable
    from freecad_trabecula.core.voxels.smooth_surface import cubes_surface
    from freecad_trabecula.geometry.mesh_objects import mesh_object

    z, y, x = (2 * np.pi * 4 * axis / 120 for axis in np.mgrid[:120, :120, :120])
    solid = np.sin(x) * np.cos(y) + np.sin(y) * np.cos(z) + np.sin(z) * np.cos(x) > 0.3
    obj = document.addObject("Mesh::Feature", "Gyroid")
    obj.Mesh = mesh_object(printable(cubes_surface(solid, (0.1, 0.1, 0.1), (0.0, 0.0, 0.0))))
    return obj


def built(steps, preset, *kinds, seconds=900):
    """Open a design, wait for its preview, build it; return the panel of its results."""
    from freecad_trabecula.gui import panels

    with steps.step(f"{preset}: preview and estimate"):
        run("Trabecula_Preset_" + preset)
        panel = panels.current()
        until(lambda: panel._drawn is not None and "≈" in panel.outcome.headline.text())
    for kind, box in panel.build_bar.boxes.items():
        box.setChecked(kind in kinds)
    with steps.step(f"{preset}: {' and '.join(kinds)}, built and shown"):
        panel.build()
        until(lambda: not panel.is_open, seconds)
        until(lambda: panels.current() is not panel, 30)
    return panels.current()


def analysed(steps, name, words):
    """Analyse an object at once, until its slice is seen."""
    from freecad_trabecula.gui.analysis_dock import dock_of_window
    from freecad_trabecula.gui.background import is_busy

    select(name)
    with steps.step(f"analysis of {words}"):
        run("Trabecula_AnalyseNow")
        until(lambda: not is_busy())
        until(lambda: dock_of_window().view.slice is not None)


def voxels_made(steps):
    """Design 100^3 voxels of drawn curves in the panel."""
    from freecad_trabecula.core.voxels.drawn_curves import DrawnCurves
    from freecad_trabecula.gui import panels

    run("Trabecula_Voxels")
    panel, share = panels.current(), ((0.5, 0.3),)
    panel.fields.take_curves(DrawnCurves((10.0, 10.0, 10.0), share, share, share))
    for edge in panel.fields.edges:
        edge.set_value(0.1)
    with steps.step("100^3 voxels, designed and shown"):
        panel.work()
        until(lambda: panel._work is None and panel.obj is not None)
    obj = panel.obj
    print(f"{obj.Voxels} voxels, {obj.Mesh.CountFacets} triangles", file=sys.__stdout__)
    panel.reject()
    return obj


# --------------------------------------------------------------------------------------------------------- the works


def rods(steps):
    """Case 6: preview, bodies, another seed by its property, undo of that."""
    built(steps, "case6", "network", "scaffold").reject()
    document = FreeCAD.ActiveDocument
    wireframe = next(obj for obj in document.Objects if obj.Name.startswith("Wireframe"))
    with steps.step("case6: seed changed, rods drawn anew"):
        wireframe.Seed = 5
        document.recompute()
        until(lambda: wireframe.ResultKey == wireframe.Proxy.key(wireframe))
    with steps.step("case6: scaffold brought up to date"):
        from freecad_trabecula.gui.renewing import renew

        scaffold = document.getObject("Scaffold")
        renew(document)
        until(lambda: scaffold.UpToDate)
    with steps.step("case6: file saved"):
        document.saveAs(os.path.join(tempfile.mkdtemp(), "case6.FCStd"))
    with steps.step("case6: section plane"):
        from freecad_trabecula.gui.section_dock import section_dock

        run("Trabecula_Section")
        until(lambda: section_dock().section._bodies)
        section_dock().place(3.0)


def femur(steps):
    """The femur: preview and scaffold."""
    built(steps, "femur", "scaffold", seconds=1100).reject()


def analysis(steps):
    """A large mesh: analysed, with morphometry, compared, another axis, saved."""
    from freecad_trabecula.core.analysis.parameters import SliceParameters
    from freecad_trabecula.gui import panels
    from freecad_trabecula.gui.analysis_dock import dock_of_window

    document = FreeCAD.newDocument("Large")
    body = gyroid(document)
    fit()
    analysed(steps, body.Name, f"{body.Mesh.CountFacets} triangles")
    dock = dock_of_window()
    for number in range(dock.tabs.count()):
        with steps.step(f"analysis: {dock.tabs.tabText(number)}"):
            dock.tabs.setCurrentIndex(number)
    dock.tabs.setCurrentIndex(0)
    select(body.Name)
    run("Trabecula_Analysis")
    panel = panels.current()
    panel.fields.set_value(SliceParameters(thickness=0.05), True)
    with steps.step("analysis with morphometry, 3 x 240 slices"):
        panel.work()
        until(lambda: panel._work is None and panel.obj is not None)
        until(lambda: dock.view.slice is not None)
    panel.reject()
    select()
    with steps.step("comparison of both"):
        run("Trabecula_Compare")
    with steps.step("comparison: passport"):
        dock.tabs.setCurrentIndex(dock.tabs.count() - 1)


def voxels(steps):
    """A voxel design of 10^6 voxels, its layers, its counts of trabeculae."""
    from freecad_trabecula.gui.voxel_dock import voxel_dock

    obj = voxels_made(steps)
    dock = voxel_dock()
    with steps.step("voxels: diagrams"):
        for number in range(dock.tabs.count()):
            dock.tabs.setCurrentIndex(number)
    with steps.step("voxels: seen from another side"):
        fit()
    analysed(steps, obj.Name, "the voxels")
    with steps.step("voxels: colours"):
        select(obj.Name)
        run("Trabecula_Colour_porosity_z")
    with steps.step("voxels: plain colours"):
        run("Trabecula_Colour_plain")
    with steps.step("voxels: undo"):
        FreeCAD.ActiveDocument.undo()
        wait(seconds=0.5)


def colours(steps):
    """A large scaffold: analysed, coloured by its slices."""
    built(steps, "case6", "scaffold").reject()
    analysed(steps, "Scaffold", "the scaffold")
    select("Scaffold")
    for step in ("Colour_porosity_z", "Colour_porosity_x", "Colour_plain", "Sight_glass"):
        with steps.step("scaffold: " + step):
            run("Trabecula_" + step)


def report(steps):
    """A report of rods, an analysis and voxels."""
    from freecad_trabecula.gui import report_writing

    built(steps, "case6", "scaffold").reject()
    analysed(steps, "Scaffold", "the scaffold")
    voxels_made(steps)
    opened = []
    QtGui.QDesktopServices.openUrl = lambda url: opened.append(url)
    path = os.path.join(tempfile.mkdtemp(), "report.html")
    with steps.step("report written"):
        report_writing.write(FreeCAD.ActiveDocument, path)
        until(lambda: os.path.exists(path))
        until(lambda: opened)


def seeds(steps):
    """Ten variants of rods and of voxels."""
    from freecad_trabecula.gui.variants_dialog import VariantsDialog

    def ten(words):
        with steps.step(words):
            run("Trabecula_Variants")
            windows = QtGui.QApplication.topLevelWidgets()
            dialog = next(one for one in windows if isinstance(one, VariantsDialog) and one.isVisible())
            until(lambda: dialog.variants is not None, 900)
        with steps.step(words + ": one taken"):
            dialog.table.selectRow(1)
            dialog.take()
            obj = dialog.obj()
            until(lambda: obj.ResultKey == obj.Proxy.key(obj))
        dialog.close()

    built(steps, "case6", "scaffold").reject()
    select("Wireframe")
    ten("10 other seeds of case 6")
    FreeCAD.newDocument("Voxels")
    obj = voxels_made(steps)
    select(obj.Name)
    ten("10 other seeds of voxels")


def preview(steps):
    """Values changed in the design panel, one by one and dragged."""
    from freecad_trabecula.gui import panels

    run("Trabecula_Preset_case6")
    panel = panels.current()
    until(lambda: panel._drawn is not None and "≈" in panel.outcome.headline.text())
    size = panel.fields.pores.fields["size"]
    with steps.step("case6: size changed"):
        panel.outcome.headline.setText("")
        size.high.set_value(0.55)
        until(lambda: "≈" in panel.outcome.headline.text())
    with steps.step("case6: size dragged for 3 s"):
        panel.outcome.headline.setText("")
        for k in range(60):
            size.high.set_value(0.5 + 0.002 * k)
            wait(seconds=0.05)
        until(lambda: "≈" in panel.outcome.headline.text())
    with steps.step("case6: coloured by coupling"):
        panel.outcome.colouring.set_value("coupling")


def documents(steps):
    """A document with rods, bodies, an analysis and voxels: saved, closed, opened, computed anew."""
    built(steps, "case6", "network", "scaffold").reject()
    analysed(steps, "Scaffold", "the scaffold")
    voxels_made(steps)
    document = FreeCAD.ActiveDocument
    path = os.path.join(tempfile.mkdtemp(), "all.FCStd")
    with steps.step("document of all saved"):
        document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    from freecad_trabecula.features import results

    results.clear()
    with steps.step("document of all opened"):
        document = FreeCAD.openDocument(path)
        wait(seconds=3.0)
    with steps.step("document of all: recomputed"):
        for obj in document.Objects:
            obj.touch()
        document.recompute()


def examples(steps):
    """The three example projects, opened with one click."""
    from freecad_trabecula.gui.example_projects import open_example

    for name in ("rods", "measure", "voxels"):
        opened = []
        with steps.step("example project: " + name):
            open_example(name, opened.append)
            until(lambda opened=opened: opened)


def main():
    """Do the work and end FreeCAD."""
    text = ""
    try:
        arrange()
        globals()[CHOICE["work"]](Steps())
    except BaseException:
        text = traceback.format_exc()
    print(text, file=sys.__stdout__, flush=True)
    os._exit(1 if text else 0)


QtCore.QTimer.singleShot(1500, main)
