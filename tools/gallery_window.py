# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drives a FreeCAD window and takes its pictures; started by ``gallery.py``."""

import json
import os
import sys
import time
import traceback
from pathlib import Path

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

ROOT = Path(__file__).resolve().parent.parent
CHOICE = json.loads(os.environ["TRABECULA_GALLERY"])
FOLDER = Path(CHOICE["folder"])
#: Docks of FreeCAD's default layout that show nothing of ours.
OTHER_DOCKS = ("Python console", "Report view", "Selection view", "DAG View")


def wait(condition=lambda: False, seconds=1.0):
    """Run the event loop until a condition holds or the time is over."""
    end = time.monotonic() + seconds
    while time.monotonic() < end and not condition():
        QtGui.QApplication.processEvents()
        time.sleep(0.01)


def shoot(name):
    """Picture the screen: ``QWidget.grab`` would leave the 3D view blank."""
    wait(seconds=0.6)
    QtGui.QGuiApplication.primaryScreen().grabWindow(0).save(str(FOLDER / (name + ".png")))


def arrange():
    """Give the window its size and clear it of what is not ours."""
    window = FreeCADGui.getMainWindow()
    FreeCADGui.activateWorkbench("TrabeculaWorkbench")
    for dock in window.findChildren(QtGui.QDockWidget):
        if dock.objectName() in OTHER_DOCKS:
            dock.hide()
    window.setGeometry(0, 0, 1280, 800)
    wait(seconds=0.5)


def open_preset(name):
    """Open the design panel with a preset and wait for the mended preview and its porosity."""
    from freecad_trabecula.gui import panels

    FreeCADGui.runCommand("Trabecula_Preset_" + name)
    wait(FreeCADGui.Control.activeDialog, 30)
    panel = panels.current()
    wait(lambda: panel._drawn is not None and "≈" in panel.outcome.headline.text(), 300)
    wait(seconds=1.0)
    return panel


def view():
    """Return the 3D view of the active document."""
    return FreeCADGui.activeDocument().activeView()


def build(panel, *kinds):
    """Build bodies and wait until the results are open; return their panel."""
    from freecad_trabecula.gui import panels

    for kind, box in panel.build_bar.boxes.items():
        box.setChecked(kind in kinds)
    panel.build()
    wait(lambda: panel.build_bar.bar.value() > 100 or not panel.is_open, 120)
    if panel.is_open:
        shoot(CHOICE["part"] + "-building")
    wait(lambda: not panel.is_open, 800)
    wait(lambda: panels.current() is not panel, 10)
    wait(seconds=1.0)
    if panels.current() is panel:
        sys.exit("nothing was built")
    return panels.current()


def take_design(name):
    """Picture one design: its preview, its scaffold and channels, its results."""
    panel = open_preset(name)
    shoot(name + "-preview")
    report = build(panel, "scaffold")
    view().viewIsometric()
    view().fitAll()
    shoot(name + "-results")
    picture = FOLDER / (name + "-scaffold.png")
    view().saveImage(str(picture), 900, 700, "White")
    report.reject()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.runCommand("Trabecula_Switch")
    wait(seconds=0.5)
    view().saveImage(str(FOLDER / (name + "-channels.png")), 900, 700, "White")


def take_panels():
    """Picture every panel and dialog."""
    panel = open_preset("case6")
    for number, name in enumerate(("sites", "pores", "paths", "couplings", "rods", "scaffold")):
        panel.fields.sections.open(number)
        shoot("design-" + name)
    panel.outcome.colouring.set_value("coupling")
    panel.outcome.parts["pairs"].setChecked(True)
    shoot("design-by-coupling")
    take_path_dialog(panel)
    panel.fields.pores.fields["size"].low.set_value(0.9)
    panel.fields.sections.open(1)
    wait(lambda: "low &lt;= high" in panel.outcome.message.text(), 5)
    shoot("design-refused")
    panel.fields.pores.fields["size"].low.set_value(0.2)
    wait(lambda: "≈" in panel.outcome.headline.text(), 30)
    report = build(panel, "network", "scaffold")
    view().viewIsometric()
    view().fitAll()
    for number, name in enumerate(("figures", "checks", "sizes", "couplings", "recoveries")):
        report.sections.open(number)
        shoot("results-" + name)
    take_loose(report)
    report.reject()
    take_export()
    take_site_panel()
    take_rod_dock()
    take_installer()
    take_recomputing()


def take_dialog(name, dialog):
    """Picture a dialog that is shown beside the window."""
    dialog.show()
    dialog.move(640, 300)
    shoot(name)
    dialog.close()


def take_path_dialog(panel):
    """Picture the dialog for the paths of one coupling."""
    from freecad_trabecula.gui.couplings_section import PathDialog

    dialog = PathDialog(panel.form, panel.fields.couplings.value()[0], panel.fields.paths.value())
    dialog.own.setChecked(True)
    take_dialog("design-own-path", dialog)


def take_loose(report):
    """Picture what the channels cut off, alone."""
    from freecad_trabecula.features.relations import parts_of

    parts = parts_of(report.wireframe)
    for one in parts:
        one.ViewObject.Visibility = getattr(one, "Role", "") in ("loose", "voids")
    report.show()
    report.sections.open(0)
    shoot("results-loose-pieces")
    for one in parts:
        one.ViewObject.Visibility = one.Name == "Scaffold"


def take_export():
    """Picture the export dialog."""
    from freecad_trabecula.features.relations import parts_of, wireframe_of
    from freecad_trabecula.gui.export_dialog import ExportDialog, exists

    wireframe = wireframe_of(FreeCAD.ActiveDocument.getObject("Network"))
    bodies = [one for one in parts_of(wireframe) if exists(one)]
    take_dialog("export", ExportDialog(FreeCADGui.getMainWindow(), bodies))


def take_site_panel():
    """Picture the panel for single sites and pores."""
    from freecad_trabecula.gui import panels

    FreeCADGui.runCommand("Trabecula_EditSite")
    wait(seconds=0.5)
    FreeCADGui.Selection.addSelection(FreeCAD.ActiveDocument.Name, "Sites", "Vertex60", 0, 0, 0)
    wait(seconds=0.5)
    panel = panels.current()
    panel.size.set_value(0.9)
    shoot("edit-site")
    panel.reject()


def take_rod_dock():
    """Picture the dock that tells of a rod."""
    network = FreeCAD.ActiveDocument.getObject("Network")
    for obj in FreeCAD.ActiveDocument.Objects:
        obj.ViewObject.Visibility = obj is network or obj.Name == network.Name
    FreeCADGui.runCommand("Trabecula_RodInfo")
    wait(seconds=0.5)
    FreeCADGui.Selection.addSelection(FreeCAD.ActiveDocument.Name, network.Name, "Face301", 0, 0, 0)
    view().fitAll()
    shoot("rod")
    FreeCADGui.runCommand("Trabecula_RodInfo")


def take_recomputing():
    """Picture a property that was changed, its result on the way in another process."""
    from freecad_trabecula.features.relations import wireframe_of
    from freecad_trabecula.gui.recomputing import of_window

    wireframe = wireframe_of(FreeCAD.ActiveDocument.getObject("Network"))
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.Selection.addSelection(FreeCAD.ActiveDocument.Name, wireframe.Name)
    wireframe.Seed = 7
    FreeCAD.ActiveDocument.recompute()
    wait(lambda: any(one.bar.value() > 300 for one in of_window().bars()), 60)
    shoot("recomputing")
    of_window().cancel()


def take_installer():
    """Picture the offer to install what is missing."""
    from freecad_trabecula.gui.install import InstallDialog

    text = "the mesh engine needs the package manifold3d: pip install manifold3d"
    take_dialog("install", InstallDialog(FreeCADGui.getMainWindow(), text))


def take_analysis():
    """Picture slice analyses: of bone, if there is some, else of a scaffold; of a design's rods; both compared."""
    from freecad_trabecula.gui import panels
    from freecad_trabecula.gui.analysis_dock import dock_of_window
    from freecad_trabecula.gui.analysis_plots import KINDS

    panel = open_preset("case6")
    build(panel, "network").reject()
    bone = Path(os.environ.get("TRABECULA_DATA", "")) / "trab_ior_10mm_13MB.stl"
    view().viewIsometric()
    view().fitAll()
    FreeCADGui.runCommand("Trabecula_Analysis")
    panel = panels.current()
    if bone.is_file():
        panel.fields.set_file(str(bone))
    panel.work()
    wait(lambda: panel.build_bar.bar.value() > 100 or panel._work is None, 60)
    shoot("analysis-working")
    wait(lambda: panel._work is None, 300)
    wait(seconds=1.0)
    panel.fields.sections.open(2)
    shoot("analysis-panel")
    panel.reject()
    FreeCADGui.Selection.addSelection(FreeCAD.ActiveDocument.Name, "Network")
    FreeCADGui.runCommand("Trabecula_AnalyseNow")
    dock = dock_of_window()
    wait(lambda: len(dock.objects()) > 1 and len(dock.ticked()) == 1, 300)
    wait(lambda: dock.view.slice is not None, 60)
    for number, (kind, _) in enumerate(KINDS):
        dock.tabs.setCurrentIndex(number)
        dock.show_plane(20 + 10 * number)
        shoot("analysis-" + kind)
    dock.tabs.setCurrentIndex(len(KINDS))
    shoot("analysis-numbers")
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.runCommand("Trabecula_Compare")
    wait(lambda: dock.view.slice is not None, 60)
    for number, name in ((0, "compared"), (4, "difference"), (len(KINDS), "passport")):
        dock.tabs.setCurrentIndex(number)
        shoot("analysis-" + name)


def take_voxels():
    """Picture a voxel design: of bone, if there is some, else of a scaffold; panel, work, layers, diagrams, dialogs."""
    from freecad_trabecula.gui import panels
    from freecad_trabecula.gui.layer_dialog import LayerDialog
    from freecad_trabecula.gui.voxel_dock import KIND, voxel_dock
    from freecad_trabecula.gui.voxel_export import VoxelExportDialog

    bone = Path(os.environ.get("TRABECULA_DATA", "")) / "trab_ior_10mm_13MB.stl"
    if bone.is_file():
        FreeCAD.newDocument("Bone")
    else:
        build(open_preset("case6"), "scaffold").reject()
    FreeCADGui.runCommand("Trabecula_Voxels")
    panel = panels.current()
    if bone.is_file():
        panel.fields.source.set_file(str(bone))
    panel.work()
    wait(lambda: panel.build_bar.bar.value() > 300 or panel._work is None, 120)
    shoot("voxels-working")
    wait(lambda: panel._work is None, 600)
    voxel_dock().hide()
    (made,) = [obj for obj in FreeCAD.ActiveDocument.Objects if obj.Name.startswith("VoxelDesign")]
    wait(lambda: made.ViewObject.Proxy.blocks.is_whole, 60)
    view().viewIsometric()
    view().fitAll()
    wait(seconds=1.5)  # blocks are coarse while the camera moves
    shoot("voxels-panel")
    panel.fields.strategy.setCurrentText("minimum-zeros")
    shoot("voxels-strategy")
    panel.fields.edges[0].set_value(0.001)
    shoot("voxels-refused")
    panel.reject()
    FreeCADGui.runCommand("Trabecula_VoxelLayers")
    dock = voxel_dock()
    for number, name in enumerate(("layers", "areas", "trabeculae")):
        dock.take_axis(2 - number)
        dock.tabs.setCurrentIndex(number)
        dock.slider.setValue(40 + 10 * number)
        shoot("voxels-" + name)
    obj = next(one for one in FreeCAD.ActiveDocument.Objects if getattr(one.Proxy, "Type", "") == KIND)
    take_tables(obj)
    take_dialog("voxels-shapes", LayerDialog(FreeCADGui.getMainWindow(), obj))
    take_dialog("voxels-export", VoxelExportDialog(FreeCADGui.getMainWindow(), [obj]))


def take_curves(obj):
    """Picture curves taken from the profiles of a voxel design's sample and bent along X."""
    from freecad_trabecula import make
    from freecad_trabecula.core.voxels.drawn_curves import DrawnCurves, curves_of_areas
    from freecad_trabecula.gui.curve_dialog import CurveDialog

    targets = make.voxel_design_of(obj).targets
    own = curves_of_areas(targets.areas, targets.voxel[0])
    bent = DrawnCurves(own.edges, [(t, min(1.0, s * (1.5 - t))) for t, s in own.x], own.y, own.z)
    dialog = CurveDialog(FreeCADGui.getMainWindow(), own)
    profiles = [areas / layer for areas, layer in zip(targets.areas, layer_areas(targets))]
    dialog.show_curves(bent, profiles)
    dialog.show()
    dialog.move(300, 40)
    shoot("voxels-curves")
    dialog.close()


def layer_areas(targets):
    """Return the areas of whole layers along X, Y, Z, mm2."""
    dx, dy, dz = targets.voxel
    return [cells * face for cells, face in zip(targets.layer_sizes, (dy * dz, dx * dz, dx * dy))]


def take_tables(obj):
    """Picture the tables of a voxel design with a wrong cell, and a small layer that is being filled."""
    from freecad_trabecula.gui.propagation_dialog import watch_layer
    from freecad_trabecula.gui.table_dialog import TableDialog

    dialog = TableDialog(FreeCADGui.getMainWindow(), obj)
    model = dialog.models[0]
    model.setData(model.index(6, 5), str(int(model.cells[4, -6]) + 1))
    dialog.show()
    dialog.move(200, 120)
    shoot("voxels-tables")
    dialog.close()
    take_curves(obj)
    dialog = watch_layer(None)
    dialog.go(4)
    dialog.move(360, 60)
    shoot("voxels-watch")
    dialog.close()


def take_study():
    """Picture why a porosity is what it is, and variants of a design by other seeds."""
    from freecad_trabecula.gui.variants_dialog import VariantsDialog
    from freecad_trabecula.gui.why import WhyPopup

    report = build(open_preset("case6"), "network", "scaffold")
    view().viewIsometric()
    view().fitAll()
    report.why[0].tell(3)
    shoot("why-results")
    windows = QtGui.QApplication.topLevelWidgets()
    for one in [one for one in windows if isinstance(one, WhyPopup)]:
        one.close()
    report.reject()
    FreeCADGui.runCommand("Trabecula_Variants")
    dialog = next(one for one in QtGui.QApplication.topLevelWidgets() if isinstance(one, VariantsDialog))
    dialog.move(180, 30)
    wait(lambda: dialog.variants is not None, 300)
    dialog.table.selectRow(1)
    shoot("variants")


def take_seeing():
    """Picture colours with their legend, ways to look through, the section plane, a notice."""
    from freecad_trabecula.gui.notice import notices
    from freecad_trabecula.gui.section_dock import section_dock

    build(open_preset("case6"), "network", "scaffold").reject()
    document = FreeCAD.ActiveDocument
    scaffold, network = document.getObject("Scaffold"), document.getObject("Network")
    view().viewIsometric()
    view().fitAll()
    scaffold.ViewObject.Visibility, network.ViewObject.Visibility = False, True
    for by in ("size", "coupling", "recovery"):
        FreeCADGui.runCommand("Trabecula_Colour_" + by)
        shoot("seeing-colours" if by == "size" else "seeing-" + by)
    FreeCADGui.runCommand("Trabecula_Sight_glass")
    shoot("seeing-glass")
    FreeCADGui.runCommand("Trabecula_Sight_solid")
    scaffold.ViewObject.Visibility, network.ViewObject.Visibility = True, False
    FreeCADGui.runCommand("Trabecula_Section")
    dock = section_dock()
    wait(lambda: dock.section._bodies, 30)
    dock.place(3.0)
    dock.fill.set_value("rods and plates")
    shoot("seeing-section")
    FreeCADGui.runCommand("Trabecula_Section")
    notices().tell(document.Name, "case6: Scaffold is done", True, lambda: None)
    shoot("seeing-notice")


def take_report():
    """Write the report of the first example and of voxels that match its bone; ``gallery.py`` has a browser show it."""
    from unittest import mock

    from freecad_trabecula import make
    from freecad_trabecula.gui import report_writing

    document = FreeCAD.newDocument("Example")
    make.make_example(document, "rods")
    make.make_voxel_design(document, document.getObject("Bone"))
    path = FOLDER / "report.html"
    path.unlink(missing_ok=True)
    with mock.patch.object(QtGui.QDesktopServices, "openUrl", lambda *_: True):
        report_writing.write(document, str(path))
        wait(path.exists, 300)
        wait(seconds=1.0)
    if not path.exists():
        sys.exit("no report was written")


def take_dark():
    """Picture some panels with a dark theme of FreeCAD's own."""
    from freecad_trabecula import make
    from freecad_trabecula.gui.analysis_dock import show_analyses

    panel = open_preset("case6")
    shoot("dark-design")
    report = build(panel, "network")
    report.sections.open(2)
    shoot("dark-results")
    report.sections.open(1)
    shoot("dark-checks")
    report.reject()
    document = FreeCAD.ActiveDocument
    obj = make.make_analysis(document, document.getObject("Network"))
    for axis in "xyz":
        make.contours_of(obj, axis)
    dock = show_analyses([obj])
    wait(seconds=0.5)
    shoot("dark-analysis")
    dock.tabs.setCurrentIndex(4)
    shoot("dark-heat")


def choose_dark_theme():
    """Have FreeCAD start with a dark theme of its own the next time."""
    settings = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/MainWindow")
    settings.SetString("StyleSheet", "FreeCAD.qss" if FreeCAD.Version()[0] != "0" else "Behave-dark.qss")
    settings.SetString("Theme", "FreeCAD Dark")
    FreeCAD.saveParameter()


def main():
    """Take the pictures and end FreeCAD."""
    output = open(1, "w", encoding="utf-8", errors="replace", buffering=1, closefd=False)  # noqa: SIM115
    status = 1
    try:
        if CHOICE["part"] != "theme":
            arrange()
        others = {"panels": take_panels, "analysis": take_analysis, "voxels": take_voxels}
        others.update(dark=take_dark, report=take_report, study=take_study, seeing=take_seeing, theme=choose_dark_theme)
        if CHOICE["part"].startswith("tour-"):
            import tour_window

            door = CHOICE["part"][len("tour-") :]
            others[CHOICE["part"]] = lambda: tour_window.walk_door(door, FOLDER, wait, shoot)
        others.get(CHOICE["part"], lambda: take_design(CHOICE["part"]))()
        status = 0
    except SystemExit as stop:
        print(stop, file=output)
    except BaseException:
        traceback.print_exc(file=output)
    output.flush()
    os._exit(status)


sys.path[:0] = [str(ROOT), str(ROOT / "tools")]
QtCore.QTimer.singleShot(1500, main)
