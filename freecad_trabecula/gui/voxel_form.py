# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of a voxel design: sample, voxel size, strategy and its own choices, targets, envelope, surface."""

from __future__ import annotations

from typing import Any, Callable, List, Optional, Sequence

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ..core.voxels.drawn_curves import DrawnCurves
from ..core.voxels.parameters import VoxelParameters
from ..core.voxels.registry import find_strategy, strategy_names
from ..features.relations import type_of
from ..features.voxel_design import SURFACES
from .accordion import Accordion
from .curve_dialog import ask_for_curves
from .fields import ChoiceField, NumberField, row_widget
from .form import Form
from .language import choice, description, in_words
from .object_choice import ObjectChoice
from .qt import small_button

translate = FreeCAD.Qt.translate
ANALYSIS = "Trabecula::Analysis"
_FILES = "(*.stl *.obj *.ply *.3mf *.csv *.json *.npy *.nrrd *.tif *.tiff)"
_SEED = (("seed", translate("Trabecula", "Seed"), 1),)
_OPTIONS = (
    ("wavelength", translate("Trabecula", "Wavelengths"), 0.1),
    ("rods", translate("Trabecula", "Sheets 0 … rods 1"), 0.1),
    ("contacts", translate("Trabecula", "Contacts avoided"), 1),
    ("thickness", translate("Trabecula", "Least thickness"), 1),
    ("void", translate("Trabecula", "Least void"), 1),
    ("trabeculae", translate("Trabecula", "Trabeculae counted"), 1),
    ("cap_alpha", translate("Trabecula", "Most in a line (x, z)"), 1),
    ("cap_beta", translate("Trabecula", "Most in a line (y, z)"), 1),
    ("solver", translate("Trabecula", "Rows of tables"), 1),
    ("pairing", translate("Trabecula", "Pairs of tables"), 1),
    ("tries", translate("Trabecula", "Tries"), 1),
    ("direction", translate("Trabecula", "Lines solved"), 1),
    ("field", translate("Trabecula", "Field"), 1),
)
_TARGETS = (
    ("areas", translate("Trabecula", "Areas"), 1),
    ("correction", translate("Trabecula", "To one total by"), 1),
    ("total", translate("Trabecula", "Total of"), 1),
)
_BOUNDARY = (("boundary", translate("Trabecula", "Cells at its border"), 1),)


class VoxelForm(QtGui.QWidget):
    """What is designed and how.

    Parameters
    ----------
    changed : callable
        Called after every change by the user.
    """

    def __init__(self, changed: Callable[[], None]) -> None:
        super().__init__()
        self._changed, self._showing = changed, False
        self._drawn: Optional[DrawnCurves] = None
        self._analyses: Sequence[Any] = ()
        self.source, self.envelope, self.strategy = ObjectChoice(), ObjectChoice(), QtGui.QComboBox()
        self.edges = [NumberField("mm", 0.01, self._report, f"{axis}: {_doc('size')}") for axis in "XYZ"]
        self.is_cube = QtGui.QCheckBox(translate("Trabecula", "cube"))
        self.is_cube.setToolTip(translate("Trabecula", "Off: three edges along X, Y, Z"))
        self.seed, self.options = (
            Form(VoxelParameters, _SEED, self._report),
            Form(VoxelParameters, _OPTIONS, self._report),
        )
        self.targets = Form(VoxelParameters, _TARGETS, self._report)
        self.boundary = Form(VoxelParameters, _BOUNDARY, self._report)
        self.surface = ChoiceField(SURFACES, self._report, translate(
            "Trabecula", "Blocks keep volume and areas exactly; smooth keeps the volume"))  # fmt: skip
        for number, name in enumerate(strategy_names()):
            self.strategy.addItem(choice(name), name)
            self.strategy.setItemData(number, in_words(find_strategy(name).SUMMARY), QtCore.Qt.ToolTipRole)
        self._lay_out()
        for box in (self.source, self.envelope, self.strategy):
            box.currentIndexChanged.connect(lambda *_: self._report())
        self.is_cube.toggled.connect(lambda *_: self._report())

    def _lay_out(self) -> None:
        body, size = row_widget(), row_widget()
        body.layout().addWidget(self.source, 1)
        body.layout().addWidget(
            small_button("document-open", translate(
                "Trabecula", "A mesh, an analysis' CSV, targets or voxels from a file"), self._ask_file)
        )  # fmt: skip
        tip = translate("Trabecula", "Draw the sliced areas along X, Y and Z, anew or from those of an analysis")
        self.draw = small_button("Trabecula_draw_curves", tip, self._ask_curves)
        body.layout().addWidget(self.draw)
        for field in self.edges:
            field.widget.setMinimumWidth(60)
            size.layout().addWidget(field.widget, 1)
        size.layout().addWidget(self.is_cube)
        top = QtGui.QFormLayout()
        top.setSpacing(4)
        top.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        self.envelope.setToolTip(translate("Trabecula", "Body within which voxels may lie"))
        for words, widget in (
            (translate("Trabecula", "Sample"), body),
            (translate("Trabecula", "Voxel size"), size),
            (translate("Trabecula", "Strategy"), self.strategy),
        ):
            top.addRow(words, widget)
        around = QtGui.QWidget()
        rows = QtGui.QFormLayout(around)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.setSpacing(4)
        rows.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        rows.addRow(translate("Trabecula", "Voxels within"), self.envelope)
        rows.addRow(self.boundary)
        rows.addRow(translate("Trabecula", "Surface"), self.surface.widget)
        self.sections = Accordion(
            (translate("Trabecula", "Strategy's own choices"), "voxels", self.options),
            (translate("Trabecula", "Envelope and surface"), "envelope", around),
            (translate("Trabecula", "Targets"), "plots", self.targets),
        )
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(4)
        column.addLayout(top)
        column.addWidget(self.seed)
        column.addWidget(self.sections)

    def _report(self) -> None:
        if not self._showing:
            self._show_what_matters()
            self._changed()

    def _show_what_matters(self) -> None:
        """Show the choices that the strategy heeds, and one edge of a cube."""
        module = find_strategy(self.strategy.currentData())
        for name in self.options.fields:
            self.options.show_row(name, name in module.OPTIONS)
        takes_mask = "boundary" in module.OPTIONS
        self.envelope.setEnabled(takes_mask)
        self.boundary.setEnabled(takes_mask and bool(self.envelope_name()))
        self.strategy.setToolTip(in_words(module.SUMMARY))
        for field in self.edges[1:]:
            field.widget.setVisible(not self.is_cube.isChecked())

    def _ask_file(self, *_: Any) -> None:
        path, _ = QtGui.QFileDialog.getOpenFileName(
            FreeCADGui.getMainWindow(),
            translate("Trabecula", "Sample of a voxel design"),
            "",
            translate("Trabecula", "Samples") + " " + _FILES,
        )
        if path:
            self.source.set_file(path)
            self._report()

    def _ask_curves(self, *_: Any) -> None:
        curves = ask_for_curves(self._drawn, self._analyses)
        if curves is not None:
            self.take_curves(curves)

    def take_curves(self, curves: DrawnCurves) -> None:
        """Take drawn curves as the sample."""
        self._drawn = curves
        self.source.set_file(_drawn_words())
        self._report()

    def curves(self) -> Optional[DrawnCurves]:
        """Return the curves that are the sample; None if another one is chosen."""
        return self._drawn if self.source.file() == _drawn_words() else None

    def file(self) -> str:
        """Return the path of the file that is the sample; empty for objects and curves."""
        return "" if self.curves() is not None else self.source.file()

    def offer(self, samples: Sequence[Any], bodies: Sequence[Any], source: Any, envelope: Any) -> None:
        """Offer objects as samples and as envelopes, and choose one of each."""
        self._showing = True
        self._analyses = [one for one in samples if type_of(one) == ANALYSIS]
        self.source.offer(samples)
        self.envelope.offer(bodies, translate("Trabecula", "box of the sample"))
        if source is not None:
            self.source.choose(source)
        self.envelope.choose(envelope)
        self._showing = False
        self._report()

    def envelope_name(self) -> str:
        """Return the name of the body within which voxels may lie; empty for the sample's box."""
        return self.envelope.object_name() if self.envelope.isEnabled() else ""

    # ------------------------------------------------------------------------------------------------ the parameters

    def _forms(self) -> List[Form]:
        return [self.seed, self.options, self.targets, self.boundary]

    def set_value(self, parameters: VoxelParameters, surface: str = "blocks") -> None:
        """Show parameters."""
        self._showing = True
        for form in self._forms():
            form.set_value(parameters)
        for field, edge in zip(self.edges, parameters.size):
            field.set_value(edge)
        self.is_cube.setChecked(len(set(parameters.size)) == 1)
        self.strategy.setCurrentIndex(self.strategy.findData(parameters.strategy))
        self.surface.set_value(surface)
        self._showing = False
        self._report()

    def size(self) -> tuple:
        """Return the edges dx, dy, dz of a voxel, mm."""
        edges = [field.value() for field in self.edges]
        return tuple(edges[:1] * 3 if self.is_cube.isChecked() else edges)

    def value(self) -> VoxelParameters:
        """Return the parameters.

        Raises
        ------
        ParameterError
            If a rule is broken.
        """
        values = {}
        for form in self._forms():
            values.update(form.values())
        return VoxelParameters(size=self.size(), strategy=self.strategy.currentData(), **values)


def _drawn_words() -> str:
    return translate("Trabecula", "drawn curves")


def _doc(name: str) -> str:
    return description(VoxelParameters.__dataclass_fields__[name].metadata["doc"])
