# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a saved design, made in a real FreeCAD window on a display of its own.

``python3 tools/picture.py design.FCStd PICTURE.png [TYPE ...]`` shows the objects whose class is one of the types
(``Scaffold``, ``Network``, ``Wireframe``, ...; default Scaffold) from a corner, on white.
"""

import importlib.util
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
VARIABLE = "TRABECULA_PICTURE"
SIZE = (1200, 900)  # pixels
TIMEOUT = 180  # s


def take(document, pictures):
    """Open a document in a window and save pictures of its objects of some classes; return the exit code.

    ``pictures`` maps the name of a file to the classes that it shows.
    """
    run = _runner()
    with tempfile.TemporaryDirectory() as folder:
        facts = run.freecad_facts(Path(folder))
        home = run.make_home(facts)
        wanted = {str(Path(name).resolve()): list(shown) for name, shown in pictures.items()}
        call = {"document": str(Path(document).resolve()), "pictures": wanted}
        environment = dict(run.test_environment(facts, Path(folder)), FREECAD_USER_HOME=str(home))
        environment[VARIABLE] = json.dumps(call)
        command = ["xvfb-run", "-a", "-s", "-screen 0 1400x900x24", "freecad", str(Path(__file__).resolve())]
        try:
            done = subprocess.run(
                command, env=environment, timeout=TIMEOUT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
            )
        except subprocess.TimeoutExpired:
            return 1
        finally:
            shutil.rmtree(str(home), ignore_errors=True)
    if done.returncode or not all(Path(name).exists() for name in pictures):
        sys.stderr.write(done.stdout.decode("utf-8", "replace")[-3000:])
        return done.returncode or 1
    return 0


def _runner():
    """The test runner, which knows how to start a window with this checkout as its workbench."""
    specification = importlib.util.spec_from_file_location("run", str(ROOT / "tests" / "run.py"))
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


# ------------------------------------------------------------------------------------------------- inside the window


def _inside():
    from PySide import QtCore

    QtCore.QTimer.singleShot(1500, _guarded(_open))


def _guarded(step):
    def guarded():
        import traceback

        try:
            step()
        except BaseException:
            traceback.print_exc(file=sys.__stderr__)
            os._exit(1)

    return guarded


def _open():
    import FreeCAD
    import FreeCADGui
    from PySide import QtCore

    call = json.loads(os.environ[VARIABLE])
    document = FreeCAD.openDocument(call["document"])
    FreeCADGui.activeDocument().activeView().viewTrimetric()  # three faces in three tones; not all alike
    left = list(call["pictures"].items())

    def show():
        if not left:
            os._exit(0)
        for obj in document.Objects:
            obj.ViewObject.Visibility = type(getattr(obj, "Proxy", None)).__name__ in left[0][1]
        FreeCADGui.SendMsgToActiveView("ViewFit")
        QtCore.QTimer.singleShot(1500, _guarded(shoot))

    def shoot():
        FreeCADGui.SendMsgToActiveView("ViewFit")
        FreeCADGui.activeDocument().activeView().saveImage(left.pop(0)[0], *SIZE, "White")
        show()

    show()


if VARIABLE in os.environ and "FreeCADGui" in sys.modules:
    _inside()
elif __name__ == "__main__":
    sys.exit(take(sys.argv[1], {sys.argv[2]: sys.argv[3:] or ["Scaffold"]}) if len(sys.argv) > 2 else __doc__)
