# SPDX-License-Identifier: LGPL-2.1-or-later
"""A dock that says of a rod selected in the 3D view which sites and sections it has."""

from __future__ import annotations

from typing import Any, List, Optional, Tuple

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from ..core.wireframe import Wireframe, rows_of_rods
from ..errors import TrabeculaError
from ..features.relations import type_of, wireframe_of
from .language import in_words, local_number, place_text
from .qt import help_buttons, icon

translate = FreeCAD.Qt.translate
_NAME = "TrabeculaRodDock"


class RodDock(QtGui.QDockWidget):
    """The dock; it observes the selection while it is visible."""

    def __init__(self) -> None:
        super().__init__(translate("Trabecula", "Rod"), FreeCADGui.getMainWindow())
        self.setObjectName(_NAME)
        self.setWindowIcon(icon("Trabecula_network"))
        self.table = QtGui.QTableWidget(0, 2)
        self.table.horizontalHeader().hide()
        self.table.verticalHeader().hide()
        self.table.verticalHeader().setDefaultSectionSize(22)
        self.table.horizontalHeader().setSectionResizeMode(0, QtGui.QHeaderView.ResizeToContents)
        self.table.horizontalHeader().setStretchLastSection(True)
        self.table.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        self.table.setMinimumWidth(260)
        page = QtGui.QWidget()
        column = QtGui.QVBoxLayout(page)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(help_buttons("commands/RodInfo.md"), 0, QtCore.Qt.AlignRight)
        column.addWidget(self.table)
        self.setWidget(page)
        self._faces: Tuple[int, np.ndarray] = (0, np.zeros(0, int))
        self._observing = False
        self.visibilityChanged.connect(self._observe)
        self.show_rows([(translate("Trabecula", "Click a rod in the 3D view"), "")])

    def _observe(self, visible: bool) -> None:
        if visible and not self._observing:
            FreeCADGui.Selection.addObserver(self)
        elif not visible and self._observing:
            FreeCADGui.Selection.removeObserver(self)
        self._observing = visible

    # ------------------------------------------------------------------------------------------ FreeCAD's observer

    def addSelection(self, document: str, name: str, sub: str, point: Any) -> None:
        """Show the rod that was clicked (FreeCAD's observer protocol)."""
        obj = FreeCAD.getDocument(document).getObject(name)
        number = self.rod_number(obj, sub.split(".")[-1])
        if number is None:
            return
        wireframe = computed_wireframe(wireframe_of(obj))
        if wireframe is not None and number < len(wireframe):
            self.show_rows(rod_facts(wireframe, number))

    def clearSelection(self, document: str) -> None:
        """Keep what is shown (FreeCAD's observer protocol)."""

    def rod_number(self, obj: Any, sub: str) -> Optional[int]:
        """Return which rod an element of a network or a wireframe belongs to; None for anything else."""
        kind = type_of(obj)
        if kind == "Trabecula::Wireframe" and sub.startswith("Edge"):
            return (int(sub[4:]) - 1) // 2  # a path has two pieces
        if kind == "Trabecula::Network" and sub.startswith("Face"):
            if self._faces[0] != obj.Shape.hashCode():
                counts = np.cumsum([len(solid.Faces) for solid in obj.Shape.Solids])
                self._faces = obj.Shape.hashCode(), counts
            return int(np.searchsorted(self._faces[1], int(sub[4:]) - 1, side="right"))
        return None

    def show_rows(self, rows: List[Tuple[str, str]]) -> None:
        """Show pairs of words."""
        self.table.setRowCount(len(rows))
        for row, texts in enumerate(rows):
            for column, text in enumerate(texts):
                self.table.setItem(row, column, QtGui.QTableWidgetItem(text))


def computed_wireframe(obj: Any) -> Optional[Wireframe]:
    """Return the wireframe of a document object, computed if it is not at hand; None if it has an error."""
    if obj is None:
        return None
    try:
        return obj.Proxy.wireframe(obj)
    except TrabeculaError as error:
        FreeCAD.Console.PrintWarning(in_words(str(error)) + "\n")
        return None


def rod_facts(wireframe: Wireframe, number: int) -> List[Tuple[str, str]]:
    """Return what there is to know of one rod, as pairs of words."""
    rows = [(translate("Trabecula", "Rod"), wireframe.names[number])]
    row = int(rows_of_rods(wireframe)[number])
    coupling = wireframe.rows[row] if row >= 0 else None
    ends = (wireframe.ends.first, wireframe.ends.second if wireframe.ends.rolls else wireframe.ends.first)
    faces = (coupling.first, coupling.second) if coupling else ("", "")
    words = (translate("Trabecula", "First site"), translate("Trabecula", "Second site"))
    for word, face, site, pores in zip(words, faces, wireframe.site_numbers[number], ends):
        point = wireframe.sites[face].points[site] if face in wireframe.sites else None
        if point is not None:
            rows.append((word, wireframe.sites[face].names[site]))
            rows.append((translate("Trabecula", "  at"), place_text(point, ".3f")))
        one = pores.take(np.array([number]))
        rows.append((translate("Trabecula", "  size"), f"{local_number(one.size[0], '.4f')} mm"))
        rows.append((translate("Trabecula", "  area"), f"{local_number(one.areas[0], '.4f')} mm²"))
    length = local_number(_length(wireframe.paths[number]), ".3f")
    rows.append((translate("Trabecula", "Length"), f"{length} mm"))
    for one in wireframe.recoveries:
        if one.rod == wireframe.names[number]:
            rows.append(
                (translate("Trabecula", "Mended"), f"{in_words(one.fault)}: {in_words(one.remedy)} ({one.attempts})")
            )
    if wireframe.names[number] in wireframe.outside:
        rows.append((translate("Trabecula", "Outside"), translate("Trabecula", "leaves the envelope")))
    return rows


def _length(path: np.ndarray) -> float:
    from ..core.paths import stations

    return float(stations(path[None], 3).lengths[0])


_docks: List[RodDock] = []


def dock_of_window() -> RodDock:
    """Return the window's dock, made when it is first asked for."""
    if not _docks:
        _docks.append(RodDock())
        FreeCADGui.getMainWindow().addDockWidget(QtCore.Qt.RightDockWidgetArea, _docks[0])
        _docks[0].hide()
    return _docks[0]


def toggle_dock() -> None:
    """Show the dock, or hide it."""
    dock = dock_of_window()
    dock.setVisible(not dock.isVisible())
