# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trabecula's document tests for FreeCAD's own test runner: ``freecadcmd -t TestTrabecula``, or the Test workbench.

The module is at the top because FreeCAD imports it by name; the tests are in tests/geometry and tests/features.
"""

from __future__ import annotations

import importlib.util
import unittest
from pathlib import Path


def load_tests(loader: unittest.TestLoader, tests: unittest.TestSuite, pattern: str | None) -> unittest.TestSuite:
    """Return all document tests (the protocol of unittest)."""
    for folder in ("geometry", "features"):
        for path in sorted((Path(__file__).resolve().parent / "tests" / folder).glob("test_*.py")):
            specification = importlib.util.spec_from_file_location("trabecula_" + path.stem, str(path))
            module = importlib.util.module_from_spec(specification)
            specification.loader.exec_module(module)
            tests.addTests(loader.loadTestsFromModule(module))
    return tests
