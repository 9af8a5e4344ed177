# SPDX-License-Identifier: LGPL-2.1-or-later
"""How fast a voxel design of a million voxels turns in the 3D view: ``python3 tools/turning_speed.py``.

A window of its own under Xvfb draws it merged (coarser while it turns) and as its mesh, without a graphics card.
The figures stand in docs/voxels.md.
"""

import os
import shutil
import sys
import time
import traceback
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
OUT = "TRABECULA_TURNING"  # environment variable: the file into which the window writes
TURNS = {"Merged blocks": 20, "Shaded": 3}
TIMEOUT = 600  # s


def measure():
    """Return lines of figures; runs in the window."""
    import FreeCAD
    import FreeCADGui
    from pivy import coin
    from PySide import QtGui

    from freecad_trabecula import make
    from freecad_trabecula.core.voxels.drawn_curves import DrawnCurves
    from freecad_trabecula.core.voxels.parameters import VoxelParameters

    share = ((0.5, 0.3),)  # of every layer
    chosen = VoxelParameters(size=(0.1, 0.1, 0.1), wavelength=(1.4, 1.4, 1.4))
    curves = DrawnCurves((15.0, 15.0, 15.0), share, share, share)
    obj = make.make_voxel_design(FreeCAD.newDocument(), curves, chosen)
    view = FreeCADGui.activeDocument().activeView()
    view.viewIsometric()
    view.fitAll()
    blocks = obj.ViewObject.Proxy.blocks
    while not blocks.is_whole:
        QtGui.QApplication.processEvents()
    lines = ["%d voxels, mesh of %d triangles" % (obj.Voxels, obj.Mesh.CountFacets)]
    for name, part in (("merged", blocks.fine), ("while it turns", blocks.coarse)):
        count = sum(len(part.getChild(k).numVertices) for k in range(part.getNumChildren()))
        lines.append("%s: %d rectangles" % (name, count))
    for mode, turns in TURNS.items():
        obj.ViewObject.DisplayMode = mode
        camera = view.getCameraNode()
        started = time.time()
        for _ in range(turns):
            camera.orientation.setValue(camera.orientation.getValue() * coin.SbRotation(coin.SbVec3f(0, 0, 1), 0.1))
            view.redraw()
            QtGui.QApplication.processEvents()
        lines.append("%s: %.2f pictures a second" % (mode, turns / (time.time() - started)))
    return lines


def in_window():
    """Measure once the window has opened, write the figures and leave."""
    try:
        text = "\n".join(measure())
    except BaseException:
        text = traceback.format_exc()
    Path(os.environ[OUT]).write_text(text + "\n", encoding="utf-8")
    os._exit(0)


def main():
    """Open the window and print what it measured; return the exit code."""
    sys.path.insert(0, str(ROOT / "tests"))
    import run as tests

    folder = ROOT / "build" / "turning"
    folder.mkdir(parents=True, exist_ok=True)
    facts = tests.freecad_facts(folder)
    home, found = tests.make_home(facts), folder / "figures.txt"
    command = ["xvfb-run", "-a", "-s", "-screen 0 1280x800x24 -dpi 96", "freecad", __file__]
    environment = dict(tests.test_environment(facts, folder), FREECAD_USER_HOME=str(home), **{OUT: str(found)})
    found.write_text("")
    try:
        tests.run_process(command, environment, folder / "log.txt", TIMEOUT)
    finally:
        shutil.rmtree(str(home), ignore_errors=True)
    text = found.read_text(encoding="utf-8")
    print("FreeCAD %s\n%s" % (facts["freecad"], text or tests.tail(folder / "log.txt", 20)))
    return 0 if "pictures a second" in text else 1


if OUT in os.environ:
    from PySide import QtCore

    QtCore.QTimer.singleShot(3000, in_window)
elif __name__ == "__main__":
    os.chdir(str(ROOT))
    sys.exit(main())
