# SPDX-License-Identifier: LGPL-2.1-or-later
"""Looks at the installed workbench from inside FreeCAD's window or console; started by ``test_archive.py``.

Input is TRABECULA_INSTALLED: JSON with ``folder`` (where it was installed), ``missing`` (packages to be
taken for missing) and ``result`` (a file). Output is that file: JSON with what was found, or ``error``.
"""

import importlib.machinery
import json
import os
import sys
import traceback

import FreeCAD

CHOICE = json.loads(os.environ["TRABECULA_INSTALLED"])


class Hiding(importlib.machinery.PathFinder):
    """Finds all packages but those that are to be missing."""

    @classmethod
    def find_spec(cls, name, path=None, target=None):
        """Return where a module is; None if there is none."""
        return None if name.split(".")[0] in CHOICE["missing"] else super().find_spec(name, path, target)


sys.meta_path[:] = [Hiding if one is importlib.machinery.PathFinder else one for one in sys.meta_path]


def refusal(function, *arguments):
    """Return the class and the words of the error that a function raises."""
    try:
        function(*arguments)
    except Exception as error:
        return [type(error).__name__, str(error)]
    return ["", "no error"]


def look_in_the_console(found):
    """Design and slice with numpy alone; ask for what needs more."""
    import freecad_trabecula
    from freecad_trabecula import make
    from freecad_trabecula.core.analysis.parameters import SliceParameters
    from freecad_trabecula.core.parameters import ScaffoldParameters
    from freecad_trabecula.core.presets import preset
    from freecad_trabecula.core.voxels.parameters import VoxelParameters

    found["package"] = freecad_trabecula.__file__
    document = FreeCAD.newDocument("Installed")
    design = make.make_design(document, preset("case1"), parts=("network", "scaffold"))
    bodies = make.bodies_of(design.scaffold)
    found["rods"], found["engine"] = design.wireframe.Rods, bodies.engine
    found["facets"] = len(bodies.scaffold.triangles)
    found["porosity"] = 1 - bodies.parts.scaffold_volume / bodies.envelope_volume
    found["invalid"] = [obj.Name for obj in document.Objects if not obj.isValid()]
    box = make.make_box(document, 2, 2, 2)
    analysis = make.make_analysis(document, box, SliceParameters(thickness=0.5))
    found["area"] = float(make.analysis_of(analysis).profiles["z"].sliced_area.mean())
    found["refusals"] = {
        "manifold3d": refusal(make.make_scaffold, design.wireframe, ScaffoldParameters(engine="mesh")),
        "scipy": refusal(make.make_voxel_design, document, design.scaffold, VoxelParameters(size=(0.5, 0.5, 0.5))),
        "matplotlib": refusal(make.save_analysis, analysis, CHOICE["folder"] + "/saved"),
    }


def look_in_the_window(found):
    """Choose the workbench, see its commands, open and close a panel."""
    import FreeCADGui
    from PySide import QtGui

    found["workbench"] = bool(FreeCADGui.activateWorkbench("TrabeculaWorkbench"))
    import freecad_trabecula
    from freecad_trabecula.gui import panels

    found["package"] = freecad_trabecula.__file__
    found["commands"] = [name for name in FreeCADGui.listCommands() if name.startswith("Trabecula_")]
    found["texts"] = {name: FreeCADGui.Command.get(name).getInfo()["menuText"] for name in found["commands"]}
    found["toolbars"] = [
        bar.objectName() for bar in FreeCADGui.getMainWindow().findChildren(QtGui.QToolBar) if bar.isVisible()
    ]
    FreeCADGui.runCommand("Trabecula_Preset_case1")
    for _ in range(200):
        QtGui.QApplication.processEvents()
    found["panel"] = bool(FreeCADGui.Control.activeDialog())
    panels.current().reject()
    FreeCADGui.runCommand("Trabecula_Help")
    QtGui.QApplication.processEvents()
    found["report"] = [
        view.toPlainText()
        for view in FreeCADGui.getMainWindow().findChildren(QtGui.QTextEdit)
        if view.objectName() == "Report view"
    ]


def main(look):
    """Look, write what was found, and end FreeCAD."""
    found = {}
    try:
        look(found)
    except BaseException:
        found["error"] = traceback.format_exc()
    with open(CHOICE["result"], "w", encoding="utf-8") as file:
        json.dump(found, file)
    sys.stdout.flush()
    os._exit(0)


if FreeCAD.GuiUp:
    from PySide import QtCore

    QtCore.QTimer.singleShot(1500, lambda: main(look_in_the_window))
else:
    main(look_in_the_console)
