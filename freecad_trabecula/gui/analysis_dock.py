# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dock of slice analyses: diagrams, the slice under the cursor as filled contours, numbers, comparisons."""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Sequence

import FreeCAD
import FreeCADGui
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
from .qt import icon
from .results_panel import fill, table
from .slice_view import Slice, SlicePlane, SliceView, plane_box, plane_corners
from .transactions import told
from .view_providers import type_of

translate = FreeCAD.Qt.translate
_NAME = "TrabeculaAnalysisDock"
KIND = "Trabecula::Analysis"
_HEIGHT, _LIST, _WORDS = 330, 150, 250  # pixels: of the dock, of its list's and its table's first column's width


class AnalysisDock(QtGui.QDockWidget):
    """Shows the analyses of the active document that are ticked; two or more on shared axes."""

    def __init__(self) -> None:
        super().__init__(translate("Trabecula", "Slice analysis"), FreeCADGui.getMainWindow())
        self.setObjectName(_NAME)
        self.setWindowIcon(icon("Trabecula_analysis"))
        self.axis, self.plane, self._document = "", 0, ""
        self._comparison: Optional[Comparison] = None
        self._shown: Dict[str, Analysis] = {}
        self._slice_plane: Optional[SlicePlane] = None
        self._observing = False
        self.list = QtGui.QListWidget()
        self.list.setIconSize(QtCore.QSize(16, 16))
        self.list.setMinimumWidth(90)
        self.list.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.list.setTextElideMode(QtCore.Qt.ElideRight)
        self.list.itemChanged.connect(lambda *_: self.refresh())
        self.axes = row_widget()
        self.charts = {kind: Chart() for kind, _ in KINDS}
        self.figures = table(4)
        self.figures.horizontalHeader().setSectionResizeMode(QtGui.QHeaderView.ResizeToContents)
        self.view, self.number = SliceView(), QtGui.QSpinBox()
        self._wait = QtCore.QTimer(self)
        self._wait.setSingleShot(True)
        self._wait.timeout.connect(self.show_objects)
        self.setWidget(self._make_page())
        self.visibilityChanged.connect(self._observe)

    def _make_page(self) -> Any:
        self.tabs = QtGui.QTabWidget()
        for kind, words in KINDS:
            self.charts[kind].pointed.connect(self._point)
            self.tabs.addTab(self.charts[kind], words)
        self.tabs.addTab(self.figures, translate("Trabecula", "Numbers"))
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

    def sizeHint(self) -> Any:
        """Ask for a height at which diagrams can be read."""
        return QtCore.QSize(900, _HEIGHT)

    # ---------------------------------------------------------------------------------------------- what there is

    def objects(self) -> List[Any]:
        """Return the analyses of the active document."""
        document = FreeCAD.ActiveDocument
        return [obj for obj in document.Objects if type_of(obj) == KIND] if document is not None else []

    def ticked(self) -> List[Any]:
        """Return the analyses that are to be shown."""
        items = [self.list.item(k) for k in range(self.list.count())]
        names = [item.data(QtCore.Qt.UserRole) for item in items if item.checkState() == QtCore.Qt.Checked]
        return [obj for obj in self.objects() if obj.Name in names]

    def show_objects(self, chosen: Sequence[Any] = ()) -> None:
        """List the analyses anew, and tick the chosen ones; without any those that were ticked, or the last."""
        every = self.objects()
        names = [obj.Name for obj in chosen] or [obj.Name for obj in self.ticked()] or [obj.Name for obj in every[-1:]]
        self._document = FreeCAD.ActiveDocument.Name if FreeCAD.ActiveDocument is not None else ""
        self.list.blockSignals(True)
        self.list.clear()
        for obj in every:
            item = QtGui.QListWidgetItem(icon("Trabecula_analysis"), obj.Label)
            item.setData(QtCore.Qt.UserRole, obj.Name)
            item.setToolTip(f"{obj.Label}: {obj.Status}")
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
            notice = str(error)
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
        self.figures.setColumnCount(len(head))
        fill(self.figures, head, [[row.words, *row.values] for row in rows])
        for line, row in enumerate(rows):
            self.figures.item(line, 0).setToolTip(row.tip or row.words)
        self.figures.horizontalHeader().setSectionResizeMode(0, QtGui.QHeaderView.Interactive)
        self.figures.setColumnWidth(0, _WORDS)
        self.figures.setMinimumHeight(0)
        self.figures.setMaximumHeight(16777215)  # the dock's own height, not that of all rows

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
            self._drop_plane()
            return
        obj = self.ticked()[0]
        contours = contours_at_hand(obj, self.axis)
        if contours is None:
            self.view.show_slice(None, translate("Trabecula", "The contours are being worked out …"))
            self._fetch(obj)
        else:
            self.view.show_slice(slice_of(analysis, contours, self.axis, plane))
        self._move_plane(analysis, plane)

    def _fetch(self, obj: Any) -> None:
        """Have the contours computed in another process; the dock is told by the object's recompute."""
        from .recomputing import of_window

        if obj.UpToDate and not of_window().take(obj, obj.ResultKey):
            self.view.show_slice(None, obj.Status)

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

    # ------------------------------------------------------------------------------------------------- the 3D view

    def _move_plane(self, analysis: Analysis, plane: int) -> None:
        if self._slice_plane is None and self.isVisible() and self._document in FreeCAD.listDocuments():
            views = FreeCADGui.getDocument(self._document).mdiViewsOfType("Gui::View3DInventor")
            self._slice_plane = SlicePlane(views[0]) if views else None
        if self._slice_plane is not None:
            height = float(analysis.profiles[self.axis].coordinate[plane])
            self._slice_plane.show(plane_corners(self.axis, height, analysis.box))

    def _drop_plane(self) -> None:
        if self._slice_plane is not None:
            self._slice_plane.close()
            self._slice_plane = None

    # ------------------------------------------------------------------------------------------ FreeCAD's observer

    def _observe(self, visible: bool) -> None:
        """Follow the documents only while the dock is seen."""
        if visible and not self._observing:
            FreeCAD.addDocumentObserver(self)
            self._wait.start(0)
        elif not visible and self._observing:
            FreeCAD.removeDocumentObserver(self)
            self._drop_plane()
        self._observing = visible

    def _later(self) -> None:
        self._wait.start(50)  # many signals, one change

    def slotRecomputedObject(self, obj: Any) -> None:
        """Show an analysis anew that has been computed (FreeCAD's observer protocol)."""
        if type_of(obj) == KIND:
            self._later()

    def slotChangedObject(self, obj: Any, name: str) -> None:
        """Follow labels (FreeCAD's observer protocol)."""
        if name == "Label" and type_of(obj) == KIND:
            self._later()

    def slotDeletedObject(self, obj: Any) -> None:
        """Take an analysis from the list (FreeCAD's observer protocol)."""
        if type_of(obj) == KIND:
            self._later()

    def slotActivateDocument(self, document: Any) -> None:
        """Show another document's analyses (FreeCAD's observer protocol)."""
        if document.Name != self._document:
            self._drop_plane()
            self._later()

    def slotDeletedDocument(self, document: Any) -> None:
        """Let go of a document that is closed (FreeCAD's observer protocol)."""
        if document.Name == self._document:
            self._slice_plane = None  # its scene goes with it
            self._later()


def slice_of(analysis: Analysis, contours: Any, axis: str, plane: int) -> Slice:
    """Return what is seen of one slice of an analysis."""
    measures, profile = analysis.measures[axis], analysis.profiles[axis]
    first, last = np.searchsorted(contours.plane, [plane, plane + 1])
    low, high = plane_box(axis, analysis.box)
    where = translate("Trabecula", "{} = {:.3f} mm, {} contours").format(
        title(axis), profile.coordinate[plane], int(profile.contours[plane])
    )
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
        window = FreeCADGui.getMainWindow()
        window.setCorner(QtCore.Qt.BottomLeftCorner, QtCore.Qt.LeftDockWidgetArea)  # task panels keep their height
        window.addDockWidget(QtCore.Qt.BottomDockWidgetArea, _docks[0])
        _docks[0].hide()
    return _docks[0]


def show_analyses(chosen: Sequence[Any] = ()) -> AnalysisDock:
    """Open the dock on some analyses; without any on those that were seen last."""
    dock = dock_of_window()
    dock.show()
    dock.raise_()
    FreeCADGui.getMainWindow().resizeDocks([dock], [_HEIGHT], QtCore.Qt.Vertical)
    dock.show_objects(chosen)
    return dock
