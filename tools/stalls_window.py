# SPDX-License-Identifier: LGPL-2.1-or-later
"""Does long work in a FreeCAD window and measures for how long it does not answer; started by ``stalls.py``."""

import json
import os
import sys
import tempfile
import traceback
from pathlib import Path

import FreeCAD
import FreeCADGui
import Mesh
import numpy as np
from PySide import QtCore, QtGui

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "tests" / "gui"), str(ROOT / "tools")]

from stall_steps import Steps, until  # noqa: E402  the folders come first
from window import wait  # noqa: E402


def arrange():
    """Give the window its size."""
    FreeCADGui.activateWorkbench("TrabeculaWorkbench")
    FreeCADGui.getMainWindow().setGeometry(0, 0, 1280, 800)
    wait(seconds=1.0)


def run(command):
    """Run a command as a click on its button does."""
    FreeCADGui.runCommand(command)


def opened(command):
    """Run a command that opens a panel; return the panel, which comes a little later if there was no document."""
    from freecad_trabecula.gui import panels

    run(command)
    until(FreeCADGui.Control.activeDialog, 30)
    return panels.current()


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
        panel = opened("Trabecula_Preset_" + preset)
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


def curves():
    """Return the sample of the voxels: 30 % in each layer of a cube of 10 mm."""
    from freecad_trabecula.core.voxels.drawn_curves import DrawnCurves

    share = ((0.5, 0.3),)
    return DrawnCurves((10.0, 10.0, 10.0), share, share, share)


def voxels_made(steps):
    """Design 100^3 voxels of drawn curves in the panel."""
    panel = opened("Trabecula_Voxels")
    panel.fields.take_curves(curves())
    for edge in panel.fields.edges:
        edge.set_value(0.1)
    with steps.step("100^3 voxels, designed and shown"):
        panel.work()
        until(lambda: panel._work is None and panel.obj is not None)
        until(lambda: panel.obj.ViewObject.Proxy.blocks.is_whole)
    obj = panel.obj
    print(f"{obj.Voxels} voxels, {obj.Mesh.CountFacets} triangles", file=sys.__stdout__)
    panel.reject()
    return obj


# --------------------------------------------------------------------------------------------------------- the works


def bodies_of_ours():
    """Return meshes and shapes of what ``documents`` makes: case 6 with its rods and scaffold, 100^3 voxels."""
    from freecad_trabecula import make
    from freecad_trabecula.core.presets import preset
    from freecad_trabecula.core.voxels.parameters import VoxelParameters

    document = FreeCAD.newDocument("Ours")
    wireframe = make.make_design(document, preset("case6")).wireframe
    make.make_network(wireframe)
    make.make_scaffold(wireframe)
    make.make_voxel_design(document, curves(), VoxelParameters(size=(0.1, 0.1, 0.1)))
    meshes = [obj.Mesh.copy() for obj in document.Objects if hasattr(obj, "Mesh")]
    shapes = [obj.Shape.copy() for obj in document.Objects if hasattr(obj, "Shape")]
    FreeCAD.closeDocument(document.Name)
    return sorted(meshes, key=lambda mesh: mesh.CountFacets), shapes


class EmptyPanel:
    """A task panel with a word in it."""

    def __init__(self):
        self.form = QtGui.QLabel("Nothing")


def alone(steps):
    """FreeCAD without us: a document, a task panel, bodies like ours as plain objects, shown, saved and opened."""
    meshes, shapes = bodies_of_ours()
    with steps.step("FreeCAD alone: a new document"):
        document = FreeCAD.newDocument("Plain")
    with steps.step("FreeCAD alone: a task panel with one word"):
        FreeCADGui.Control.showDialog(EmptyPanel())
    FreeCADGui.Control.closeDialog()
    fit()
    with steps.step(f"FreeCAD alone: mesh of {meshes[-1].CountFacets} triangles taken and drawn"):
        document.addObject("Mesh::Feature", "Mesh").Mesh = meshes[-1]
        fit()
    with steps.step("FreeCAD alone: the same drawn again"):
        FreeCADGui.activeDocument().activeView().redraw()
    file = os.path.join(tempfile.mkdtemp(), "mesh.bms")
    with steps.step("FreeCAD alone: the same written into a binary file"):
        meshes[-1].write(file)
    with steps.step("FreeCAD alone: the same read from it"):
        Mesh.Mesh().read(file)
    with steps.step("FreeCAD alone: the same selected, its edges counted for the property editor"):
        select("Mesh")
    for mesh in meshes[:-1]:
        document.addObject("Mesh::Feature", "Mesh").Mesh = mesh
    for shape in shapes:
        document.addObject("Part::Feature", "Shape").Shape = shape
    wait(seconds=3.0)
    path = os.path.join(tempfile.mkdtemp(), "plain.FCStd")
    with steps.step("FreeCAD alone: document of bodies like ours saved"):
        document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    with steps.step("FreeCAD alone: the same opened"):
        FreeCAD.openDocument(path)


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
    panel = opened("Trabecula_Analysis")
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
    panel = opened("Trabecula_Preset_case6")
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
        choice = json.loads(os.environ["TRABECULA_STALLS"])
        globals()[choice["work"]](Steps(choice["work"], choice["result"], choice["pictures"]))
    except BaseException:
        text = traceback.format_exc()
    print(text, file=sys.__stdout__, flush=True)
    os._exit(1 if text else 0)


QtCore.QTimer.singleShot(1500, main)
