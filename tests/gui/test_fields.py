# SPDX-License-Identifier: LGPL-2.1-or-later
"""The form of the design panel alone: every value comes back as it was shown, typed ones as they were meant."""

import math
import unittest
from dataclasses import replace

from PySide import QtCore
from window import settle, type_into

from freecad_trabecula.core.laws import Law, constant, uniform
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
from freecad_trabecula.core.presets import PRESETS, preset
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.errors import ParameterError
from freecad_trabecula.gui.design_form import IN_DOCUMENT, Callbacks, DesignForm, Envelope
from freecad_trabecula.gui.faces_section import FacesSection
from freecad_trabecula.gui.fields import NumberField
from freecad_trabecula.gui.form import field_for
from freecad_trabecula.gui.law_field import LawField
from freecad_trabecula.gui.pore_drawing import PoreDrawing
from freecad_trabecula.gui.site_panel import components


def nothing(*_):
    """Do nothing."""


def form_with(job):
    """Return a form that shows a job, in a body of the document unless it is a prism."""
    form = DesignForm(Callbacks(nothing, nothing, nothing, nothing, nothing))
    form.set_envelopes([Envelope("", "new prism", True), Envelope("Body", "Body", False)], "" if job.prism else "Body")
    form.set_job(job)
    return form


class RoundTripTest(unittest.TestCase):
    def test_every_preset_comes_back_from_the_form_unchanged(self):
        for name in PRESETS:
            with self.subTest(preset=name):
                job = preset(name)
                self.assertEqual(form_with(job).job(), replace(job, envelope=job.envelope and IN_DOCUMENT))

    def test_a_job_far_from_the_defaults_comes_back_unchanged(self):
        path = PathParameters("tension", tension_first=uniform(2 / 7, 1 / 3), tension_second=constant(math.pi))
        job = replace(
            preset("case6"),
            name="own",
            prism=PrismParameters(31 / 3, 7.123456789, 9.5, 3, 4, 5, 0.123456, 0.5, 1 / 7),
            pores=PoreParameters("spline", Law("linear", 0.7, 0.3, (1.0, 2.0, 3.0)), 6, uniform(0.1, 0.9),
                                 constant(1 / 3), 0.05, 1),
            path=PathParameters("box", ((1.0, 2.0, 3.0), (4.0, 5.0, 1 / 3)), "nearest", (1.5, 2.5, 3.5)),
            couplings=(Coupling("Face1", "Face3", "same", True, 4, True, path), Coupling("Face2", "Face4", on=False)),
            rods=RodParameters(0.0123, 7, 0.5, 3),
            scaffold=ScaffoldParameters("field", 0.07, True, LayerParameters(("Face2",), 0.6, "outwards", False)),
            edits=(SiteEdit("Face1.2.3", "off"), SiteEdit("Face2.1.1", "pore", size=0.5)),
            seed=2**31 - 1,
        )  # fmt: skip
        self.assertEqual(form_with(job).job(), job)

    def test_every_kind_of_law_comes_back(self):
        for law in (
            constant(0.4), uniform(0.2, 0.8), Law("normal", 0.2, 0.8), Law("linear", 0.8, 0.2, (0.0, 1.0, 1.0)),
            Law("radial", 0.8, 0.2), Law("expression", 0.2, 0.9, expression="0.2 + 0.01 * z * u"),
        ):  # fmt: skip
            with self.subTest(law=law.kind):
                field = LawField("mm", 0.05, nothing)
                field.set_value(law)
                self.assertEqual(field.value(), law)

    def test_what_the_design_finds_by_itself_is_called_automatic_and_not_shown_as_a_number(self):
        for name, own in (("wavelength", (1.0, 2.0, 3.0)), ("rods", 0.7)):
            with self.subTest(field=name):
                changes = []
                field = field_for(VoxelParameters, name, lambda changes=changes: changes.append(1))
                automatic = getattr(VoxelParameters(), name)
                self.assertEqual(field.value(), automatic)
                self.assertTrue(field.field.widget.isHidden())
                field.switch.set_value(False)
                self.assertFalse(field.field.widget.isHidden())
                self.assertNotEqual(field.value(), automatic)
                VoxelParameters(**{name: field.value()})  # what an own value starts with is allowed
                self.assertTrue(changes)
                field.set_value(own)
                self.assertEqual((field.value(), field.switch.value()), (own, False))
                field.switch.set_value(True)
                self.assertEqual(field.value(), automatic)
        whole = field_for(Coupling, "limit", nothing)
        self.assertEqual((whole.widget.text(), whole.value()), ("automatic", 0))

    def test_a_third_of_a_millimetre_is_not_rounded_by_being_shown(self):
        field = NumberField("mm", 0.1, nothing)
        field.set_value(1 / 3)
        self.assertEqual(field.value(), 1 / 3)

    def test_typed_lengths_are_taken_to_the_last_digit(self):
        field = NumberField("mm", 0.1, nothing)
        field.set_value(1.0)
        type_into(field.widget, "0.75512")
        self.assertAlmostEqual(field.value(), 0.75512, places=12)

    def test_a_number_without_a_unit_is_one_of_millimetres_even_where_micrometres_are_shown(self):
        field = NumberField("mm", 0.1, nothing)
        # a unit that is typed counts
        for typed, wanted in (("0.08", 0.08), ("2", 2.0), ("0.001", 0.001), ("80 nm", 8e-5), ("30 um", 0.03)):
            field.set_value(0.05)
            self.assertIn("50", field.widget.text())
            self.assertFalse(field.widget.text().endswith("mm"), field.widget.text())
            type_into(field.widget, typed)
            self.assertAlmostEqual(field.value(), wanted, places=12, msg=typed)

    def test_a_comma_is_a_decimal_sign_where_the_locale_says_so(self):
        before = QtCore.QLocale()
        QtCore.QLocale.setDefault(QtCore.QLocale("de_DE"))
        try:
            field = NumberField("mm", 0.1, nothing)
            field.set_value(1.5)
            type_into(field.widget, "0,75")
            self.assertAlmostEqual(field.value(), 0.75, places=12)
        finally:
            QtCore.QLocale.setDefault(before)


class FieldTest(unittest.TestCase):
    def test_fields_have_the_tooltips_of_the_parameter_classes(self):
        field = field_for(PoreParameters, "scatter", nothing)
        self.assertIn("Random displacement", field.widget.toolTip())

    def test_showing_values_reports_no_change_and_typing_does(self):
        changes = []
        form = DesignForm(Callbacks(lambda: changes.append(1), nothing, nothing, nothing, nothing))
        form.set_envelopes([Envelope("", "new prism", True)], "")
        form.set_job(preset("case3"))
        self.assertEqual(changes, [])
        type_into(form.prism.fields["l"].widget, "12")
        self.assertTrue(changes)

    def test_a_bad_formula_is_refused_with_its_text(self):
        field = LawField("mm", 0.05, nothing)
        field.set_value(Law("expression", 0.2, 0.9, expression="z"))
        field.expression.widget.setText("import os")
        with self.assertRaisesRegex(ParameterError, "import os"):
            field.value()

    def test_faces_get_letters_and_a_second_pick_takes_one_away(self):
        section = FacesSection(nothing, nothing, nothing)
        for face in ("Face3", "Face7", "Face3", "Face9"):
            section.toggle(face)
        self.assertEqual([(one.name, one.face) for one in section.value()], [("B", "Face7"), ("A", "Face9")])

    def test_a_spacing_of_zero_is_refused_until_it_is_mended(self):
        section = FacesSection(nothing, nothing, nothing)
        section.toggle("Face1")
        spacing = section.form.fields["c_u"]
        type_into(spacing.widget, "0")
        with self.assertRaisesRegex(ParameterError, "c_u must be greater than 0"):
            section.value()
        type_into(spacing.widget, "2")
        self.assertEqual(section.value()[0], FaceParameters("Face1", "A", c_u=2.0))

    def test_spacings_go_to_all_faces(self):
        section = FacesSection(nothing, nothing, nothing)
        section.set_value([FaceParameters("Face1", "A", c_u=2.5, b_v=0.1), FaceParameters("Face2", "B")])
        section.all_button.click()
        self.assertEqual([(one.face, one.c_u, one.b_v) for one in section.value()],
                         [("Face1", 2.5, 0.1), ("Face2", 2.5, 0.1)])  # fmt: skip

    def test_couplings_are_ordered_removed_and_switched_off(self):
        form = form_with(preset("case3"))
        section = form.couplings
        section.table.selectRow(0)
        section._move(1)
        self.assertEqual([(c.first, c.second) for c in section.value()],
                         [("Face3", "Face4"), ("Face1", "Face2"), ("Face5", "Face6")])  # fmt: skip
        section.table.item(2, 0).setCheckState(QtCore.Qt.Unchecked)
        self.assertFalse(section.value()[2].on)
        section.table.selectRow(0)
        section._remove()
        self.assertEqual(len(section.value()), 2)
        section.opposite_button.click()
        self.assertEqual(section.value(), preset("case3").couplings)

    def test_tangent_components_are_those_of_which_the_pore_was_made(self):
        import numpy as np

        from freecad_trabecula.core.pores import make_pores

        turns = np.array([[0.1, 0.5, 0.9, 0.3]])
        pore = make_pores(PoreParameters(), np.array([0.5]), turns, np.ones((1, 4)), np.zeros((1, 4, 2)))
        self.assertTrue(np.allclose(components(pore.angles[0]), turns[0]))

    def test_a_pore_that_cannot_be_is_not_drawn(self):
        drawing = PoreDrawing()
        drawing.set_pore(PoreParameters(), 0.5, (0.1, 0.2, 0.3, 0.4))
        before = drawing._curve
        for size, turns in ((-1.0, (0.1,) * 4), (0.5, (2.0,) * 4), (0.5, ()), (float("nan"), (0.1,) * 4)):
            drawing.set_pore(PoreParameters(), size, turns)
            self.assertIs(drawing._curve, before)


class TypedTest(unittest.TestCase):
    def test_a_comma_is_a_point_in_an_english_window(self):
        for unit in ("mm", ""):
            field = NumberField(unit, 0.1, nothing)
            for text, value in (("0,5", 0.5), ("0.5", 0.5), ("1,125", 1.125)):
                field.set_value(0.3)
                type_into(field.widget, text)
                self.assertAlmostEqual(field.value(), value, places=9, msg=(unit, text))

    def test_a_new_field_answers_though_somebody_holds_those_of_closed_panels(self):
        held = [NumberField("mm", 0.1, nothing) for _ in range(40)]
        for one in held:
            one.widget.deleteLater()
        settle(0.2)
        heard = []
        for number in range(40):
            field = NumberField("mm", 0.1, lambda number=number: heard.append(number))
            field.set_value(0.5 + number)
            held.append(field)
        self.assertEqual(sorted(set(heard)), list(range(40)))
