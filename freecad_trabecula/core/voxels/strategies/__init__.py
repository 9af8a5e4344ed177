# SPDX-License-Identifier: LGPL-2.1-or-later
"""How layers are filled: one module a strategy.

A strategy is a module of this package with ``NAME`` (the module's own, hyphens for underscores), ``SUMMARY`` and
``design(targets, parameters, mask, progress) -> voxels``, bool of shape (P, M, N): exact, or an ``InfeasibleError`` or
``ExactnessError``. A new one is one more module: nothing else names it.
"""

from __future__ import annotations

import importlib
import pkgutil
from types import ModuleType
from typing import Tuple

from ...parameters import require


def strategy_names() -> Tuple[str, ...]:
    """Return the names of all strategies, sorted."""
    return tuple(sorted(module.name.replace("_", "-") for module in pkgutil.iter_modules(__path__)))


def find_strategy(name: str) -> ModuleType:
    """Return the module of a strategy.

    Raises
    ------
    ParameterError
        If there is none of that name.
    """
    names = strategy_names()
    require(name in names, f"the strategy must be one of {', '.join(names)}", repr(name))
    return importlib.import_module(f"{__name__}.{name.replace('-', '_')}")
