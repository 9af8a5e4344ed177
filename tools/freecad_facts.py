# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes what the FreeCAD that runs this file knows of itself, as JSON, into the file named by TRABECULA_FACTS.

Run it as ``TRABECULA_FACTS=facts.json freecadcmd tools/freecad_facts.py`` (standard output carries FreeCAD's banner).
"""

import importlib
import json
import os
import sys

import FreeCAD


def packages_folder():
    """Return the folder into which FreeCAD's own Addon Manager installs Python packages, and in which it looks.

    0.20 looks in ``AdditionalPythonPackages`` alone; later versions keep one folder per Python below it, which they
    search first.
    """
    folder = os.path.join(FreeCAD.getUserAppDataDir(), "AdditionalPythonPackages")
    if tuple(int(part) for part in FreeCAD.Version()[:2]) >= (0, 21):
        folder = os.path.join(folder, "py%d%d" % sys.version_info[:2])
    return folder


def version_of(name):
    """Return a package's version, "unknown" if it states none, None if it cannot be imported."""
    try:
        module = importlib.import_module(name)
    except ImportError:
        return None
    return str(getattr(module, "__version__", "unknown"))


def write_facts(path):
    """Write the facts to `path`."""
    sys.path.append(packages_folder())
    facts = {
        "freecad": ".".join(FreeCAD.Version()[:3]),
        "python": "%d.%d.%d" % sys.version_info[:3],
        "user_data": FreeCAD.getUserAppDataDir(),
        "packages": packages_folder(),
        "modules": {name: version_of(name) for name in ("numpy", "scipy", "manifold3d")},
    }
    with open(path, "w", encoding="utf-8") as file:
        json.dump(facts, file, indent=1)


# FreeCAD gives exit code 0 to a script that raises, and runs it a second time: hence the exit of our own.
status = 1
try:
    write_facts(os.environ["TRABECULA_FACTS"])
    status = 0
finally:
    sys.stdout.flush()
    os._exit(status)
