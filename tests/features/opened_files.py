# SPDX-License-Identifier: LGPL-2.1-or-later
"""The documents of earlier releases, and what a user sees of one: for the tests that open them."""

import re
from pathlib import Path

import FreeCAD

from freecad_trabecula.features.feature import is_a

#: FreeCAD before 1.0 cannot read the names of elements in files of FreeCAD 1.x.
_NEWEST = FreeCAD.Version()[0] != "0"
FILES = [
    path
    for path in sorted((Path(__file__).resolve().parents[1] / "data").glob("*.FCStd"))
    if _NEWEST or not path.stem.endswith("-freecad1")
]
#: Neither what a user sees nor the same in every run and release; how far two routes are apart is below their digits.
_PASSED_OVER = (
    "Checks Difference FaceMark Label2 LargestDifference MarkedFace Numbers Proxy Reason Rebuilt ResultKey RodKeys "
    "SchemaVersion Seconds Structure"
)
_NUMBER = re.compile(r"\d+(?:\.\d+)?")


def state(document):
    """Return what a user sees of our objects, by object's and property's names: numbers, texts, sizes of shapes."""
    found = {}
    for obj in document.Objects:
        for name in obj.PropertiesList if is_a(obj) else ():
            value = getattr(obj, name)
            value = getattr(value, "Value", value)
            shown = name not in _PASSED_OVER.split() and not name.startswith("_")
            if shown and isinstance(value, (bool, int, float, str, list, tuple)):
                found[obj.Name, name] = [str(one) for one in value] if _is_texts(value) else value
        mesh, shape = getattr(obj, "Mesh", None), getattr(obj, "Shape", None)
        if mesh is not None:
            found[obj.Name, "Mesh"] = [mesh.CountFacets, float(mesh.Volume)]
        if shape is not None and not shape.isNull():
            found[obj.Name, "Shape"] = [len(shape.Faces), len(shape.Edges), len(shape.Vertexes), shape.Volume]
    return found


def _is_texts(value):
    return isinstance(value, (list, tuple)) and not all(isinstance(one, (int, float)) for one in value)


def assert_same(test, found, expected):
    """Assert that two states are the same: numbers to a ten-thousandth, texts exactly, notes in their numbers."""
    test.assertEqual(set(found), set(expected))
    for key, value in expected.items():
        with test.subTest(object=key[0], property=key[1]):
            if key[1] == "Notes":  # a later version may put them in better words
                _assert_near(test, list(map(_NUMBER.findall, found[key])), list(map(_NUMBER.findall, value)))
            else:
                _assert_near(test, found[key], value)


def _assert_near(test, found, expected):
    if isinstance(expected, (list, tuple)):
        test.assertEqual(len(found), len(expected))
        for one, other in zip(found, expected):
            _assert_near(test, one, other)
    elif isinstance(expected, float):
        test.assertAlmostEqual(found, expected, delta=1e-4 * max(1.0, abs(expected)))
    else:
        test.assertEqual(found, expected)
