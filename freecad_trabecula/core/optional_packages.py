# SPDX-License-Identifier: LGPL-2.1-or-later
"""Packages that may be missing: imported where they are used, else the error says how each is installed."""

from __future__ import annotations

import importlib
from typing import Any

from ..errors import DependencyError

#: The command that installs a package, by the name under which it is imported.
INSTALL = {
    "scipy": "python3 -m pip install scipy (Debian: apt install python3-scipy)",
    "matplotlib": "python3 -m pip install matplotlib (Debian: apt install python3-matplotlib)",
    "openpyxl": "python3 -m pip install openpyxl (Debian: apt install python3-openpyxl)",
    "PIL": "python3 -m pip install pillow (Debian: apt install python3-pil)",
    "manifold3d": "python3 -m pip install --no-deps --target <FreeCAD's additional packages folder> manifold3d==3.5.4",
}


def optional_module(name: str, purpose: str, *needed: str) -> Any:
    """Return a module of a package that may be missing.

    Parameters
    ----------
    name : str
        E.g. ``scipy.ndimage``; its package is one of ``INSTALL``.
    purpose : str
        What needs it, as a sentence without its stop: "plots need matplotlib".
    *needed : str
        What the module must hold: an older version may not.

    Raises
    ------
    DependencyError
        If it is missing or too old; the message is the purpose and the command that installs the package.
    """
    try:
        module = importlib.import_module(name)
    except ImportError as error:
        raise _missing(name, purpose) from error
    if not all(hasattr(module, one) for one in needed):
        raise _missing(name, purpose)
    return module


def _missing(name: str, purpose: str) -> DependencyError:
    return DependencyError(f"{purpose}; install it with: {INSTALL[name.partition('.')[0]]}")
