# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parameter classes as properties and back; records as lines."""

import dataclasses
import sys
import unittest
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent))
from document_case import DocumentCase, small_job

from freecad_trabecula.core.laws import Law
from freecad_trabecula.core.parameters import (
    Coupling,
    FaceParameters,
    LayerParameters,
    PathParameters,
    PoreParameters,
    PrismParameters,
    RodParameters,
    ScaffoldParameters,
    SiteEdit,
)
from freecad_trabecula.errors import ParameterError
from freecad_trabecula.features import base

#: One object of each class with no field at its default.
UNUSUAL = (
    PoreParameters(
        "circle",
        Law("linear", 0.9, 0.3, (1.0, 2.0, 0.0)),
        6,
        Law("expression", 0.1, 0.9, expression="u * x / 20"),
        Law("radial", 0.5, 2.0),
        0.2,
        1,
    ),
    PathParameters(
        "tension",
        ((1.0, 2.0, 3.0), (-1.0, 0.0, 4.5)),
        "nearest",
        (1.0, 0.0, 2.5),
        Law("normal", 1.0, 2.0),
        Law("uniform", 0.5, 0.75),
    ),
    RodParameters(deflection=0.02, stations=9, redraws=3),
    PrismParameters(10.0, 10.0, 10.0, 2, 3, 4, 0.5, 0.25, 0.125),
    FaceParameters("Face2", "B", (0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.5), 1.25, 2.5, 0.25, 0.0),
    ScaffoldParameters("field", 0.05, True, LayerParameters(("Face1", "B"), 0.5, "outwards", False), 60.0, 2.0),
)
FIXED = {PrismParameters: {"l": 10.0, "w": 10.0, "h": 10.0}, FaceParameters: {"face": "Face2"}}


class ParametersTest(DocumentCase):
    def blank(self):
        return self.document.addObject("App::FeaturePython", "Blank")

    def test_every_length_is_a_property_with_the_unit_of_a_length(self):
        seen = 0
        for cls in base.BINDINGS:
            obj = self.blank()
            base.add_parameters(obj, cls)
            for field in dataclasses.fields(cls):
                name = base.property_name(cls, field.name)
                for one in (name, name + "Low", name + "High"):
                    if field.metadata.get("unit") == "mm" and one in obj.PropertiesList:
                        kinds = ("App::PropertyLength", "App::PropertyVectorDistance", "App::PropertyVectorList")
                        self.assertIn(obj.getTypeIdOfProperty(one), kinds, one)
                        seen += 1
        self.assertGreater(seen, 20)

    def test_every_field_survives_the_way_into_properties_and_back(self):
        for parameters in UNUSUAL:
            with self.subTest(cls=type(parameters).__name__):
                obj = self.blank()
                base.add_parameters(obj, type(parameters))
                base.write_parameters(obj, parameters)
                fixed = FIXED.get(type(parameters), {})
                self.assertEqual(base.read_parameters(obj, type(parameters), **fixed), parameters)

    def test_new_properties_hold_the_defaults_of_their_class(self):
        for parameters in UNUSUAL:
            cls = type(parameters)
            obj = self.blank()
            base.add_parameters(obj, cls)
            self.assertEqual(base.read_parameters(obj, cls, **FIXED.get(cls, {})), cls(**FIXED.get(cls, {})))

    def test_every_field_has_a_property_with_a_tooltip_in_a_group(self):
        for cls in base.BINDINGS:
            obj = self.blank()
            before = set(obj.PropertiesList)
            base.add_parameters(obj, cls)
            fields = [f.name for f in dataclasses.fields(cls) if f.name not in base.BINDINGS[cls].without]
            added = set(obj.PropertiesList) - before
            self.assertGreaterEqual(len(added), len(fields))
            for name in added:
                self.assertGreater(len(obj.getDocumentationOfProperty(name)), 10, name)
                self.assertTrue(obj.getGroupOfProperty(name))

    def test_lengths_have_units_so_that_expressions_and_texts_work(self):
        obj = self.blank()
        base.add_parameters(obj, PoreParameters)
        obj.PoreSizeHigh = "0.06 cm"
        self.assertAlmostEqual(base.read_parameters(obj, PoreParameters).size.high, 0.6)
        obj.setExpression("PoreSizeLow", "PoreSizeHigh / 2")
        self.document.recompute()
        self.assertAlmostEqual(base.read_parameters(obj, PoreParameters).size.low, 0.3)

    def test_limits_hold_after_the_file_was_opened_again(self):
        wireframe = self.make(small_job()).wireframe
        self.assertEqual(wireframe.State, ["Up-to-date"])
        wireframe = self.reopened().getObject("Wireframe")
        self.assertEqual(wireframe.State, ["Up-to-date"])
        wireframe.PoreCorners = 99
        self.assertEqual(wireframe.PoreCorners, 12)
        wireframe.Seed = -1
        self.assertEqual(wireframe.Seed, 0)

    def test_a_refused_value_is_named_with_its_property_and_unit(self):
        obj = self.blank()
        base.add_parameters(obj, PoreParameters)
        obj.PoreSizeHigh = 0.1
        with self.assertRaisesRegex(ParameterError, r"PoreSize \(mm\).*low <= high, got 0.2 and 0.1"):
            base.read_parameters(obj, PoreParameters)

    def test_no_number_is_refused_as_a_size(self):
        obj = self.blank()
        base.add_parameters(obj, PoreParameters)
        obj.PoreSizeLow = float("nan")
        with self.assertRaisesRegex(ParameterError, "finite"):
            base.read_parameters(obj, PoreParameters)


class RecordsTest(unittest.TestCase):
    def test_couplings_and_edits_survive_as_readable_lines(self):
        couplings = (Coupling("A", "B", "same", True, 5, False, PathParameters("centre")), Coupling("B", "C"))
        edits = (
            SiteEdit("A.1.2", "pore", size=0.3, turns=(0.1, 0.2, 0.3, 1.0)),
            SiteEdit("A.x", "add", (1.0, 2.0, 3.0)),
        )
        self.assertEqual(base.records_of(base.lines_of(couplings), Coupling, "coupling"), couplings)
        self.assertEqual(base.records_of(base.lines_of(edits), SiteEdit, "edit"), edits)
        self.assertEqual(base.lines_of([Coupling("A", "B")]), ['{"first": "A", "second": "B"}'])

    def test_empty_lines_are_passed_over_but_counted(self):
        with self.assertRaisesRegex(ParameterError, "coupling 3 must be one JSON object, got 'A - B'"):
            base.records_of(['{"first": "A", "second": "B"}', "", "A - B"], Coupling, "coupling")

    def test_an_unknown_key_is_refused_with_those_that_are_known(self):
        with self.assertRaisesRegex(ParameterError, "coupling 1 has no key 'frist'; known are first, second"):
            base.records_of(['{"frist": "A", "second": "B"}'], Coupling, "coupling")
