# SPDX-License-Identifier: LGPL-2.1-or-later
"""The strategies that there are: the modules of ``strategies``, found by looking.

A strategy is a module of that package with ``NAME`` (the module's own, hyphens for underscores), ``SUMMARY``,
``OPTIONS`` (the fields of VoxelParameters that it heeds; ``boundary``: it takes a mask) and
``design(targets, parameters, mask, progress) -> voxels``, bool of shape (P, M, N): exact, or an ``InfeasibleError`` or
``ExactnessError``. A new one is one more module: nothing in the core names it.
"""

from __future__ import annotations

import importlib
import pkgutil
from types import ModuleType
from typing import Tuple

from ..parameters import require
from . import strategies


def strategy_names() -> Tuple[str, ...]:
    """Return the names of all strategies, sorted."""
    return tuple(sorted(module.name.replace("_", "-") for module in pkgutil.iter_modules(strategies.__path__)))


def find_strategy(name: str) -> ModuleType:
    """Return the module of a strategy.

    Raises
    ------
    ParameterError
        If there is none of that name.
    """
    names = strategy_names()
    require(name in names, f"the strategy must be one of {', '.join(names)}", repr(name))
    return importlib.import_module(f"{strategies.__name__}.{name.replace('-', '_')}")
