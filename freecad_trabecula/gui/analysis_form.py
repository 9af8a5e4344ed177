# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of a slice analysis: body, planes, mending, measures."""

from __future__ import annotations

import math
from typing import Any, Callable, List, Sequence, Tuple

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ..core.analysis.parameters import AXES, SliceParameters
from ..core.analysis.triangles import UNITS
from ..errors import ParameterError
from ..features.bodies import has_solid, is_mesh
from ..features.relations import type_of
from .accordion import Accordion
from .fields import NumberField, row_widget
from .form import Form
from .language import choice, decimal_point, local_number
from .object_choice import ObjectChoice
from .qt import small_button

translate = FreeCAD.Qt.translate
_FILES = "(*.stl *.obj *.ply *.3mf)"
_LAYERS = (("thickness", translate("Trabecula", "Thickness"), 0.05), ("at", translate("Trabecula", "Planes"), 1))
_MENDING = (
    ("gap", translate("Trabecula", "Gap fill"), 0.01),
    ("iterations", translate("Trabecula", "Rounds"), 1),
    ("filter_open,filter_closed", translate("Trabecula", "Filter open, closed"), 0.01),
    ("smoothing", translate("Trabecula", "Smoothing"), 1),
    ("compensation", translate("Trabecula", "Compensation"), 0.01),
)
_MEASURES = (("fill", translate("Trabecula", "Overlaps"), 1), ("rod_ratio", translate("Trabecula", "Rods from"), 0.05))


class AnalysisForm(QtGui.QWidget):
    """What is sliced and how.

    Parameters
    ----------
    changed : callable
        Called after every change by the user.
    """

    def __init__(self, changed: Callable[[], None]) -> None:
        super().__init__()
        self._changed, self._least_area, self._showing = changed, 1e-6, False
        self.source, self.envelope, self.unit = ObjectChoice(), ObjectChoice(), QtGui.QComboBox()
        for unit in ("auto", *UNITS):
            self.unit.addItem(choice(unit) if unit == "auto" else unit, unit)
        self.layers, self.mending = Form(SliceParameters, _LAYERS, changed), Form(SliceParameters, _MENDING, changed)
        self.measures = Form(SliceParameters, _MEASURES, changed)
        self.axes = {axis: QtGui.QCheckBox(axis.upper()) for axis in AXES}
        self.direction, self.heights = QtGui.QLineEdit(), QtGui.QLineEdit()
        self.range = QtGui.QCheckBox(translate("Trabecula", "Only from, to"))
        self.low, self.high = NumberField("mm", 1.0, changed), NumberField("mm", 1.0, changed)
        self.morphometry = QtGui.QCheckBox(translate("Trabecula", "Tb.Th, Tb.Sp, Conn.D, DA … on voxels (slow)"))
        self._lay_out()
        for box in (self.source, self.envelope, self.unit):
            box.currentIndexChanged.connect(self._report)
        for box in (*self.axes.values(), self.range, self.morphometry):
            box.toggled.connect(self._report)
        for line in (self.direction, self.heights):
            line.textChanged.connect(self._report)

    def _lay_out(self) -> None:
        top = QtGui.QFormLayout()
        top.setContentsMargins(0, 0, 0, 0)
        top.setSpacing(4)
        top.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        body, axes, limits = row_widget(), row_widget(), row_widget()
        self.source.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Fixed)
        body.layout().addWidget(self.source, 1)
        body.layout().addWidget(self.unit)
        body.layout().addWidget(
            small_button("document-open", translate("Trabecula", "Slice an STL, OBJ, PLY or 3MF file"), self._ask_file)
        )
        for box in self.axes.values():
            axes.layout().addWidget(box)
        axes.layout().addWidget(self.direction, 1)
        self.direction.setPlaceholderText(translate("Trabecula", "direction: 0.6,0.8,0"))
        self.direction.setToolTip(translate("Trabecula", "A further direction: as if the part were turned"))
        for widget in (self.range, self.low.widget, self.high.widget):
            limits.layout().addWidget(widget)
        for words, widget in (
            (translate("Trabecula", "Body"), body),
            (translate("Trabecula", "Porosity in"), self.envelope),
            (translate("Trabecula", "Axes"), axes),
        ):
            top.addRow(words, widget)
        self.envelope.setToolTip(translate("Trabecula", "To whose slices the porosity refers"))
        planes = QtGui.QWidget()
        column = QtGui.QVBoxLayout(planes)
        column.setContentsMargins(0, 0, 0, 0)
        self.heights.setPlaceholderText(translate("Trabecula", "heights: 0.5 1.0 2.5"))
        self.heights.setToolTip(translate("Trabecula", "Co-ordinates of the planes, mm, for planes at heights"))
        column.addWidget(limits)
        column.addWidget(self.heights)
        what = QtGui.QWidget()
        column = QtGui.QVBoxLayout(what)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.measures)
        column.addWidget(self.morphometry)
        self.sections = Accordion(
            (translate("Trabecula", "Measures"), "results", what),
            (translate("Trabecula", "Range and heights"), "analysis", planes),
            (translate("Trabecula", "Mending"), "edit_pore", self.mending),
        )
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(4)
        column.addLayout(top)
        column.addWidget(self.layers)
        column.addWidget(self.sections)

    def _report(self, *_: Any) -> None:
        self.unit.setEnabled(bool(self.file()))
        if not self._showing:
            self._changed()

    def _ask_file(self, *_: Any) -> None:
        path = ask_mesh_file()
        if path:
            self.set_file(path)

    # ---------------------------------------------------------------------------------------------------- the body

    def offer(self, objects: Sequence[Any], source: Any, envelope: Any) -> None:
        """Offer objects to be sliced and to refer to, and choose one of each."""
        self._showing = True
        self.source.offer(objects)
        self.envelope.offer(objects, translate("Trabecula", "box of the body"))
        self.choose(source, envelope)
        self._showing = False
        self._report()

    def choose(self, source: Any, envelope: Any) -> None:
        """Choose what is sliced and to what it refers; None for the file and the box."""
        if source is not None:
            self.source.choose(source)
        self.envelope.choose(envelope)

    def set_file(self, path: str) -> None:
        """Choose a file to be sliced."""
        self.source.set_file(path)
        self._report()

    def source_name(self) -> str:
        """Return the name of the object that is sliced; empty for a file."""
        return self.source.object_name()

    def envelope_name(self) -> str:
        """Return the name of the object to which porosity refers; empty for the body's box."""
        return self.envelope.object_name()

    def file(self) -> str:
        """Return the path of the file that is sliced; empty for an object."""
        return self.source.file()

    # ------------------------------------------------------------------------------------------------ the parameters

    def set_value(self, parameters: SliceParameters, morphometry: bool = False) -> None:
        """Show parameters."""
        self._showing = True
        for form in (self.layers, self.mending, self.measures):
            form.set_value(parameters)
        for axis, box in self.axes.items():
            box.setChecked(axis in parameters.axes)
        self.direction.setText("; ".join(axis for axis in parameters.axes if axis not in AXES))
        self.heights.setText(" ".join(local_number(height) for height in parameters.heights))
        given = not (math.isnan(parameters.low) and math.isnan(parameters.high))
        self.range.setChecked(given)
        self.low.set_value(0.0 if math.isnan(parameters.low) else parameters.low)
        self.high.set_value(0.0 if math.isnan(parameters.high) else parameters.high)
        self.morphometry.setChecked(morphometry)
        self._least_area = parameters.least_area
        self._showing = False

    def value(self) -> SliceParameters:
        """Return the parameters.

        Raises
        ------
        ParameterError
            If a rule is broken.
        """
        axes = [axis for axis, box in self.axes.items() if box.isChecked()]
        axes += [part.strip() for part in self.direction.text().split(";") if part.strip()]
        is_range, values = self.range.isChecked(), {}
        for form in (self.layers, self.mending, self.measures):
            values.update(form.values())
        return SliceParameters(
            axes=tuple(axes),
            heights=tuple(_numbers(self.heights.text())) if values["at"] == "heights" else (),
            low=self.low.value() if is_range else math.nan,
            high=self.high.value() if is_range else math.nan,
            least_area=self._least_area,
            **values,
        )


def _numbers(text: str) -> List[float]:
    """Return the numbers in a text, between blanks or semicolons.

    Raises
    ------
    ParameterError
        If a word is none.
    """
    found = []
    for word in text.replace(";", " ").split():
        try:
            found.append(float(word.replace(decimal_point(), ".")))
        except ValueError:
            raise ParameterError(f"heights must be numbers between blanks, mm, got {word!r}") from None
    return found


def ask_mesh_file() -> str:
    """Ask for a file that can be sliced; empty if there was none chosen."""
    words = translate("Trabecula", "Body to be sliced")
    kinds = translate("Trabecula", "Meshes") + " " + _FILES
    path, _ = QtGui.QFileDialog.getOpenFileName(FreeCADGui.getMainWindow(), words, "", kinds)
    return path


def sliceable(document: Any) -> Tuple[Any, ...]:
    """Return the objects of a document that can be sliced: a cheap look, no check of them."""
    return tuple(obj for obj in document.Objects if is_sliceable(obj))


def likely(offered: Sequence[Any]) -> Any:
    """Return what is likely meant if nothing is selected: the latest, channels and loose pieces last; None of none."""
    parts = ("Trabecula::Body", "Trabecula::Wireframe")
    whole = [obj for obj in offered if type_of(obj) not in parts]
    return next(iter([*whole[::-1], *offered[::-1]]), None)


def is_sliceable(obj: Any) -> bool:
    """Return whether an object has triangles or a solid."""
    if type_of(obj) == "Trabecula::Wireframe":
        return obj.Rods > 0
    is_sites = type_of(obj) in ("Trabecula::PrismSites", "Trabecula::FaceSites")
    return is_mesh(obj) or (not is_sites and has_solid(obj))
