# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the checkout, and the packages that FreeCAD keeps for itself, importable in plain Python."""

import glob
import os
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def packages_folders():
    """Return FreeCAD's folders of additional packages: the one the runner names, or those of this user."""
    named = os.environ.get("TRABECULA_PACKAGES")
    if named:
        return [named]
    version = "py%d%d" % sys.version_info[:2]
    user_data = os.path.expanduser("~/.local/share/FreeCAD")
    folders = glob.glob(os.path.join(user_data, "**", "AdditionalPythonPackages", version), recursive=True)
    return [*sorted(folders), os.path.join(user_data, "AdditionalPythonPackages")]


sys.path.insert(0, str(ROOT))
# At the end, as FreeCAD does: what the distribution has is never replaced.
sys.path.extend(folder for folder in packages_folders() if os.path.isdir(folder))
