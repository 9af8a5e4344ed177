# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples in the docstrings of the modules that run in plain Python are true."""

import ast
import doctest
import importlib
from pathlib import Path

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


@pytest.mark.parametrize("name", sorted(filter(has_examples, PLAIN)))
def test_the_examples_of_a_module_are_true(name):
    result = doctest.testmod(importlib.import_module(name), optionflags=doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS)
    assert result.attempted > 0
    assert result.failed == 0
