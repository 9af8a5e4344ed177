# SPDX-License-Identifier: LGPL-2.1-or-later
"""Versions of the programs that take part in a work, for its report."""

from __future__ import annotations

import importlib.metadata
import platform
from typing import Dict

import FreeCAD
import numpy as np


def versions(*packages: str) -> Dict[str, str]:
    """Return the versions of FreeCAD, Python, numpy, and of those of some packages that are there."""
    found = {"FreeCAD": ".".join(FreeCAD.Version()[:3]), "Python": platform.python_version(), "numpy": np.__version__}
    for name in packages:
        try:
            found[name] = importlib.metadata.version(name)
        except importlib.metadata.PackageNotFoundError:
            continue
    return found
