# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples in the docstrings of the modules that run in plain Python are true."""

import ast
import builtins
import doctest
import importlib
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parent.parent
PLAIN = [
    "freecad_trabecula.errors",
    *(".".join(p.relative_to(ROOT).with_suffix("").parts) for p in ROOT.glob("freecad_trabecula/core/**/*.py")),
]
#: Those of the command line that need no FreeCAD.
PLAIN += ["freecad_trabecula.gui.help_pages"]
PLAIN += ["freecad_trabecula.shell." + name for name in ("arguments", "folder", "launch")]


def has_examples(name):
    """Return whether a module's source holds a docstring with an example."""
    path = ROOT.joinpath(*name.split(".")).with_suffix(".py")
    if path.stem == "__init__" or not path.exists():
        return False
    nodes = ast.walk(ast.parse(path.read_text(encoding="utf-8")))
    documented = (ast.Module, ast.ClassDef, ast.FunctionDef)
    return any(isinstance(node, documented) and ">>> " in (ast.get_docstring(node) or "") for node in nodes)


def numpy_scalars(value):
    """Return numpy's scalars in a value, or in a tuple, list, set or dictionary: numpy 2 prints ``np.float64(1.0)``."""
    if isinstance(value, dict):
        return numpy_scalars([*value, *value.values()])
    if isinstance(value, (tuple, list, set, frozenset)):
        return [scalar for item in value for scalar in numpy_scalars(item)]
    return [value] if isinstance(value, np.generic) else []


def show_as_both(value):
    """Print a value as Python does; refuse one that numpy 1 (FreeCAD 0.20.2) and 2 (1.1) print differently."""
    if numpy_scalars(value):
        raise TypeError(f"numpy 1 and 2 print {value!r} differently: make it a bool, int or float")
    if value is not None:
        builtins._ = value
        print(repr(value))


def test_an_example_that_only_one_numpy_prints_so_is_refused():
    for value in (np.bool_(True), (1, np.float64(2)), {"a": [np.int64(3)]}):
        with pytest.raises(TypeError, match="numpy 1 and 2"):
            show_as_both(value)


@pytest.mark.parametrize("name", sorted(filter(has_examples, PLAIN)))
def test_the_examples_of_a_module_are_true(name, monkeypatch):
    monkeypatch.setattr(sys, "__displayhook__", show_as_both)
    result = doctest.testmod(importlib.import_module(name), optionflags=doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS)
    assert result.attempted > 0
    assert result.failed == 0
