# SPDX-License-Identifier: LGPL-2.1-or-later
"""Packages that may be missing: each has a command that installs it, and a refusal that names it."""

import re
import sys
from types import ModuleType

import pytest

from freecad_trabecula.core.optional_packages import INSTALL, optional_module
from freecad_trabecula.errors import DependencyError


@pytest.mark.parametrize("package", sorted(INSTALL))
def test_without_a_package_the_error_says_what_for_and_how_to_install_it(monkeypatch, package):
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(DependencyError) as caught:
        optional_module(package, "this needs it")
    sentence, _, command = str(caught.value).partition("; install it with: ")
    assert sentence == "this needs it"
    assert re.match(r"python3 -m pip install [^\n]*(scipy|matplotlib|openpyxl|pillow|manifold3d)", command)


def test_a_version_that_lacks_what_is_needed_is_refused_in_the_same_words(monkeypatch):
    monkeypatch.setitem(sys.modules, "scipy.optimize", ModuleType("scipy.optimize"))
    with pytest.raises(DependencyError, match="this needs milp; install it with: .* install scipy"):
        optional_module("scipy.optimize", "this needs milp", "milp")


def test_a_module_that_is_there_is_returned(monkeypatch):
    older = ModuleType("scipy.optimize")
    older.milp = print
    monkeypatch.setitem(sys.modules, "scipy.optimize", older)
    assert optional_module("scipy.optimize", "this needs milp", "milp") is older
