# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dock of slice analyses: diagrams, the slice under the cursor as filled contours, numbers, comparisons."""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Sequence

import FreeCAD
import numpy as np
from PySide import QtCore, QtGui

from .. import make
from ..core.analysis.analysis import Analysis
from ..core.analysis.comparison import Comparison
from ..errors import TrabeculaError
from ..features.analysis import contours_at_hand
from . import analysis_plots as plots
from .analysis_plots import KINDS, number_text, title
from .analysis_saving import ask_and_save
from .chart import Chart, Diagram
from .fields import row_widget
from .language import filled, in_words
from .object_dock import ObjectDock
from .qt import Tabs, help_buttons, icon
from .slice_view import Slice, SliceView, plane_box, plane_corners
from .tables import fill, let_grow, table
from .transactions import told
from .why import WhyButton, WhyTable

translate = FreeCAD.Qt.translate
_NAME = "TrabeculaAnalysisDock"
KIND = "Trabecula::Analysis"
_LIST, _WORDS = 150, 250  # pixels: widths of the list and of the table's first column


class AnalysisDock(ObjectDock):
    """Shows the analyses of the active document that are ticked; two or more on shared axes."""

    def __init__(self) -> None:
        super().__init__(KIND, _NAME, translate("Trabecula", "Slice analysis"), "Trabecula_analysis")
        self.axis, self.plane = "", 0
        self._comparison: Optional[Comparison] = None
        self._shown: Dict[str, Analysis] = {}
        self.list = QtGui.QListWidget()
        self.list.setIconSize(QtCore.QSize(16, 16))
        self.list.setMinimumWidth(90)
        self.list.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.list.setTextElideMode(QtCore.Qt.ElideRight)
        self.list.itemChanged.connect(lambda *_: self.refresh())
        self.axes = row_widget()
        self.charts = {kind: Chart() for kind, _ in KINDS}
        self.figures = table(4)
        self.why, self.why_plot = WhyTable(self.figures, self._found), WhyButton(self._keys, self._found)
        self.figures.horizontalHeader().setSectionResizeMode(QtGui.QHeaderView.ResizeToContents)
        self.view, self.number = SliceView(), QtGui.QSpinBox()
        self.setWidget(self._make_page())

    def _make_page(self) -> Any:
        self.tabs = Tabs()
        for kind, words in KINDS:
            self.charts[kind].pointed.connect(self._point)
            self.tabs.addTab(self.charts[kind], words)
        self.tabs.addTab(self.figures, translate("Trabecula", "Numbers"))
        self.tabs.setCornerWidget(help_buttons("commands/Plots.md", self.why_plot))
        self.tabs.currentChanged.connect(lambda *_: self._show_page())
        self.number.setPrefix(translate("Trabecula", "slice "))
        self.number.valueChanged.connect(lambda value: self.show_plane(int(value)))
        left = QtGui.QWidget()
        column = QtGui.QVBoxLayout(left)
        column.setContentsMargins(0, 0, 0, 0)
        save = QtGui.QPushButton(translate("Trabecula", "Save …"))
        save.setToolTip(translate("Trabecula", "Tables, report and plots of what is ticked, in a folder"))
        save.clicked.connect(lambda *_: self._save())
        for widget in (self.list, self.axes, self.number, save):
            column.addWidget(widget)
        left.setMaximumWidth(_LIST)
        split = QtGui.QSplitter()
        for widget, stretch in ((left, 0), (self.tabs, 3), (self.view, 2)):
            split.addWidget(widget)
            split.setStretchFactor(split.count() - 1, stretch)
        split.setSizes([_LIST, 700, 330])
        return split

    # ---------------------------------------------------------------------------------------------- what there is

    def ticked(self) -> List[Any]:
        """Return the analyses that are to be shown."""
        items = [self.list.item(k) for k in range(self.list.count())]
        names = [item.data(QtCore.Qt.UserRole) for item in items if item.checkState() == QtCore.Qt.Checked]
        return [obj for obj in self.objects() if obj.Name in names]

    def show_objects(self, chosen: Sequence[Any] = ()) -> None:
        """List the analyses anew, and tick the chosen ones; without any those that were ticked, or the last."""
        every = self.objects()
        names = [obj.Name for obj in chosen] or [obj.Name for obj in self.ticked()] or [obj.Name for obj in every[-1:]]
        self.list.blockSignals(True)
        self.list.clear()
        for obj in every:
            item = QtGui.QListWidgetItem(icon("Trabecula_analysis"), obj.Label)
            item.setData(QtCore.Qt.UserRole, obj.Name)
            item.setToolTip(f"{obj.Label}: {in_words(obj.Status)}")
            item.setCheckState(QtCore.Qt.Checked if obj.Name in names else QtCore.Qt.Unchecked)
            self.list.addItem(item)
        self.list.blockSignals(False)
        self.refresh()

    def refresh(self) -> None:
        """Show what is ticked."""
        self._shown, self._comparison, notice = {}, None, ""
        try:
            found = {obj.Name: make.analysis_of(obj) for obj in self.ticked()}
            if len(found) > 1:
                self._comparison = plots.comparison_of(list(found.values()))
            self._shown = found
        except TrabeculaError as error:
            notice = in_words(str(error))
        axes = list(self._comparison.axes if self._comparison else next(iter(self._shown.values())).profiles) \
            if self._shown else []  # fmt: skip
        self._offer_axes(axes)
        if self.axis not in axes:
            self.axis = axes[-1] if axes else ""
        self._notice = notice or translate("Trabecula", "Analyse a mesh, a solid or a design to see its slices")
        self._name_tabs()
        self._show_page()
        self._offer_slices()

    def _name_tabs(self) -> None:
        heat = [kind for kind, _ in KINDS].index("heat")
        words = translate("Trabecula", "Difference") if self._comparison else dict(KINDS)["heat"]
        self.tabs.setTabText(heat, words)
        last = translate("Trabecula", "Passport") if self._comparison else translate("Trabecula", "Numbers")
        self.tabs.setTabText(self.tabs.count() - 1, last)

    def _offer_axes(self, axes: Sequence[str]) -> None:
        row = self.axes.layout()
        while row.count():
            row.takeAt(0).widget().deleteLater()
        for axis in axes:
            button = QtGui.QRadioButton(title(axis))
            button.setChecked(axis == (self.axis if self.axis in axes else axes[-1]))
            button.toggled.connect(lambda on, axis=axis: self.take_axis(axis) if on else None)
            row.addWidget(button)

    def take_axis(self, axis: str) -> None:
        """Show another axis."""
        self.axis = axis
        self._show_page()
        self._offer_slices()

    # ------------------------------------------------------------------------------------------------- what is seen

    def first(self) -> Optional[Analysis]:
        """Return the analysis whose slices are seen: the first of those that are ticked."""
        return next(iter(self._shown.values()), None)

    def _show_page(self) -> None:
        """Fill the page that is open; tables take the room of the slice."""
        number = self.tabs.currentIndex()
        self.view.setVisible(number < len(KINDS))
        if number < len(KINDS):
            kind = KINDS[number][0]
            self.charts[kind].show_diagram(self._diagram(kind))
            self._move_cursor()
            return
        head, rows = [translate("Trabecula", "Quantity")], []
        if self._comparison is not None:
            head, rows = plots.passport_of(self._comparison, list(self._shown.values()))
        elif self._shown:
            head, rows = plots.figures_of(self.first())
        self.figures.setColumnCount(len(head) + 1)
        fill(self.figures, [*head, ""], [[row.words, *row.values] for row in rows])
        self.why.set_keys([row.key for row in rows])
        for line, row in enumerate(rows):
            self.figures.item(line, 0).setToolTip(row.tip or row.words)
        self.figures.horizontalHeader().setSectionResizeMode(0, QtGui.QHeaderView.Interactive)
        self.figures.setColumnWidth(0, _WORDS)
        let_grow(self.figures)

    def _keys(self) -> Sequence[str]:
        """Which numbers the open diagram shows; the table has signs of its own."""
        number = self.tabs.currentIndex()
        if number >= len(KINDS) or not self._shown:
            return ()
        return (plots.COMPARED_KEYS if self._comparison is not None else plots.KEYS)[KINDS[number][0]]

    def _found(self, key: str) -> Sequence[str]:
        return [text for obj in self.ticked() for text in make.found_routes(obj, key)]

    def _diagram(self, kind: str) -> Diagram:
        if not self._shown:
            return Diagram("", "")
        if self._comparison is not None:
            return plots.compared_diagram(self._comparison, list(self._shown.values()), kind, self.axis)
        return plots.diagram_of(self.first(), kind, self.axis)

    def _origin(self) -> float:
        """Where the diagram's co-ordinate begins in that of the first analysis."""
        return self._comparison.axes[self.axis].origins[0] if self._comparison is not None else 0.0

    def _offer_slices(self) -> None:
        analysis = self.first()
        count = len(analysis.profiles[self.axis]) if analysis is not None and self.axis else 0
        self.number.blockSignals(True)
        self.number.setRange(0, max(count - 1, 0))
        self.number.setEnabled(count > 0)
        self.number.blockSignals(False)
        self.show_plane(min(self.plane, count - 1) if 0 < self.plane < count else count // 2)

    def _point(self, x: float) -> None:
        """Take the slice that is nearest to the cursor."""
        analysis = self.first()
        if analysis is not None and self.axis:
            where = analysis.profiles[self.axis].coordinate
            self.show_plane(int(np.argmin(np.abs(where - self._origin() - x))))

    def show_plane(self, plane: int) -> None:
        """Show one slice: cursor, contours, plane in the 3D view."""
        self.plane = plane
        self.number.blockSignals(True)
        self.number.setValue(plane)
        self.number.blockSignals(False)
        self._move_cursor()
        analysis = self.first()
        if analysis is None or not self.axis or not len(analysis.profiles[self.axis]):
            self.view.show_slice(None, self._notice)
            self.drop_plane()
            return
        obj = self.ticked()[0]
        contours = contours_at_hand(obj, self.axis)
        if contours is None:
            self.view.show_slice(None, translate("Trabecula", "The contours are being worked out …"))
            self._fetch(obj)
        else:
            self.view.show_slice(slice_of(analysis, contours, self.axis, plane))
        height = float(analysis.profiles[self.axis].coordinate[plane])
        self.move_plane(plane_corners(self.axis, height, analysis.box), obj)

    def _fetch(self, obj: Any) -> None:
        """Have the contours computed in another process; the dock is told by the object's recompute."""
        from .recomputing import of_window

        if obj.UpToDate and not of_window().take(obj, obj.ResultKey):
            self.view.show_slice(None, in_words(obj.Status))

    def _move_cursor(self) -> None:
        analysis = self.first()
        if analysis is None or not self.axis:
            return
        where = analysis.profiles[self.axis].coordinate
        at = float(where[self.plane]) - self._origin() if self.plane < len(where) else None
        for chart in self.charts.values():
            chart.set_cursor(at)

    def _save(self) -> None:
        with told():
            if self.ticked():
                ask_and_save(self.ticked())


def slice_of(analysis: Analysis, contours: Any, axis: str, plane: int) -> Slice:
    """Return what is seen of one slice of an analysis."""
    measures, profile = analysis.measures[axis], analysis.profiles[axis]
    first, last = np.searchsorted(contours.plane, [plane, plane + 1])
    low, high = plane_box(axis, analysis.box)
    words = translate("Trabecula", "{} = {:.3f} mm, {} contours")
    where = filled(words, title(axis), float(profile.coordinate[plane]), int(profile.contours[plane]))
    numbers = translate("Trabecula", "{} mm², porosity {} %").format(
        number_text(profile.sliced_area[plane]), number_text(100 * profile.porosity[plane])
    )
    rows = slice(first, last)
    return Slice(
        list(contours.of_plane(plane)), measures.area[rows], measures.is_rod[rows], low, high, (where, numbers)
    )


_docks: List[AnalysisDock] = []


def dock_of_window() -> AnalysisDock:
    """Return the window's dock, made when it is first asked for."""
    if not _docks:
        _docks.append(AnalysisDock())
        _docks[0].hide()
    return _docks[0]


def show_analyses(chosen: Sequence[Any] = ()) -> AnalysisDock:
    """Open the dock on some analyses; without any on those that were seen last."""
    dock = dock_of_window()
    dock.open()
    dock.show_objects(chosen)
    return dock
