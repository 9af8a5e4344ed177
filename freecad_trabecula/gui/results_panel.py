# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of a design: porosity, volumes by two routes, counts, recoveries, couplings, sizes, checks."""

from __future__ import annotations

from typing import Any, List, NamedTuple, Optional, Sequence

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from ..core.couplings import CouplingRow
from ..core.wireframe import Recovery
from ..features.base import records_of
from .accordion import Accordion
from .histogram import Histogram
from .outcome import GREEN, ORANGE, RED
from .qt import Buttons, flags_of, icon, invoke_later, widen_dock
from .view_providers import products_of

translate = FreeCAD.Qt.translate
WIDTH = 385  # pixels that the form needs


class Figure(NamedTuple):
    """One row: name, value, value by a second route, difference; ``ok`` is None where nothing is checked."""

    name: str
    value: str
    second: str = ""
    difference: str = ""
    ok: Optional[bool] = None


class ResultsPanel:
    """A task panel on one wireframe and the bodies made of it."""

    def __init__(self, wireframe: Any) -> None:
        self.wireframe, self._open = wireframe, True
        self._document = wireframe.Document.Name
        self.headline, self.warnings = QtGui.QLabel(), QtGui.QLabel()
        self.warnings.setWordWrap(True)
        self.figures, self.couplings, self.recoveries = table(4), table(4), table(4)
        self.histogram = Histogram(translate("Trabecula", "Size of the end sections, mm"))
        self.form = self._make_form()
        FreeCAD.addDocumentObserver(self)
        self.show()
        invoke_later(lambda: widen_dock(self.form, WIDTH))

    def _make_form(self) -> Any:
        form = QtGui.QWidget()
        form.setWindowTitle(translate("Trabecula", "Results"))
        form.setWindowIcon(icon("Trabecula_results"))
        self.sections = Accordion()
        for title, picture, page in (
            (translate("Trabecula", "Figures and checks"), "results", self.figures),
            (translate("Trabecula", "Pore sizes"), "pore", self.histogram),
            (translate("Trabecula", "Couplings"), "coupling", self.couplings),
            (translate("Trabecula", "Recoveries"), "path", self.recoveries),
        ):
            self.sections.add(title, icon("Trabecula_" + picture), page)
        column = QtGui.QVBoxLayout(form)
        column.setContentsMargins(6, 6, 6, 6)
        for widget in (self.headline, self.warnings, self.sections):
            column.addWidget(widget)
        return form

    def show(self) -> None:
        """Show what the objects hold."""
        obj = self.wireframe
        self.headline.setText(f"<b>{headline(obj)}</b>")
        notes = [*obj.Warnings, *outdated(obj)]
        self.warnings.setText(f'<span style="color:{ORANGE}">' + "<br>".join(notes) + "</span>")
        self.warnings.setVisible(bool(notes))
        names = (translate("Trabecula", "Quantity"), translate("Trabecula", "Value"),
                 translate("Trabecula", "Second route"), translate("Trabecula", "Apart"))  # fmt: skip
        fill(self.figures, names, figures(obj))
        rows = records_of(obj.CouplingTable, CouplingRow, "row")
        fill(self.couplings, (translate("Trabecula", "Faces"), translate("Trabecula", "Available"),
             translate("Trabecula", "Rods"), translate("Trabecula", "Left")), [Figure(
                f"{r.first} – {r.second}", f"{r.available_first} · {r.available_second}", str(r.rods),
                f"{r.left_first} · {r.left_second}") for r in rows])  # fmt: skip
        mended = records_of(obj.Recoveries, Recovery, "recovery")
        fill(self.recoveries, (translate("Trabecula", "Rod"), translate("Trabecula", "Fault"),
             translate("Trabecula", "Remedy"), translate("Trabecula", "Attempts")),
             [Figure(r.rod, r.fault, r.remedy, str(r.attempts)) for r in mended])  # fmt: skip
        self.sections.set_summary(2, str(len(rows)))
        self.sections.set_summary(3, str(len(mended)) if mended else translate("Trabecula", "none"))
        self.histogram.set_values(obj.PoreSizes)

    def getStandardButtons(self) -> Any:
        """Return the buttons above the form."""
        return flags_of(Buttons.Close)

    def reject(self) -> bool:
        """Close the panel."""
        self._leave()
        FreeCADGui.Control.closeDialog()
        return True

    def slotDeletedDocument(self, document: Any) -> None:
        """Close the panel when its document is closed (FreeCAD's observer protocol)."""
        if self._open and document.Name == self._document:
            self._leave()
            invoke_later(FreeCADGui.Control.closeDialog)

    def slotRecomputedObject(self, obj: Any) -> None:
        """Show the figures anew when an object has been computed again (FreeCAD's observer protocol)."""
        if self._open and obj.Document.Name == self._document and obj in (self.wireframe, *products_of(self.wireframe)):
            self.show()

    def _leave(self) -> None:
        if self._open:
            self._open = False
            FreeCAD.removeDocumentObserver(self)


# ------------------------------------------------------------------------------------------------------ the figures


def headline(wireframe: Any) -> str:
    """Return the most important numbers of a design."""
    porosity = [one.Porosity for one in products_of(wireframe) if hasattr(one, "Porosity")]
    text = translate("Trabecula", "{} rods").format(wireframe.Rods)
    return text + (translate("Trabecula", ", porosity {:.2f} %").format(porosity[0]) if porosity else "")


def outdated(wireframe: Any) -> List[str]:
    """Return a sentence for each body that belongs to older inputs or has an error."""
    return [f"{one.Label}: {one.Status}" for one in products_of(wireframe) if not one.UpToDate]


def figures(wireframe: Any) -> List[Figure]:
    """Return the figures of a design and of the bodies made of it."""
    rows = [Figure(translate("Trabecula", "Rods"), str(wireframe.Rods), "", "", None if wireframe.Rods else False)]
    for name, values in (
        (translate("Trabecula", "Rods left out"), wireframe.Failed),
        (translate("Trabecula", "Rods outside"), wireframe.Outside),
    ):
        rows.append(Figure(name, str(len(values)), "", "", not values))
    for one in products_of(wireframe):
        if one.Proxy.KIND == "network":
            rows += network_figures(one)
    return rows


def network_figures(network: Any) -> List[Figure]:
    """Return the figures of a network of solids."""
    volume = Figure(
        translate("Trabecula", "Sum of the rods"),
        f"{network.RodVolume.Value:.4f} mm³",
        f"{network.MeshVolume.Value:.4f} mm³",
        f"{network.Difference:.4f} %",
        bool(network.UpToDate),
    )
    worst = f"{network.LargestDifference:.4f} %"
    return [volume, Figure(translate("Trabecula", "Worst rod"), "", "", worst, bool(network.UpToDate))]


# ------------------------------------------------------------------------------------------------------- the tables


def table(columns: int) -> Any:
    """Return a table to be read."""
    widget = QtGui.QTableWidget(0, columns)
    widget.verticalHeader().hide()
    widget.verticalHeader().setDefaultSectionSize(22)
    widget.horizontalHeader().setSectionResizeMode(QtGui.QHeaderView.ResizeToContents)
    widget.horizontalHeader().setStretchLastSection(True)
    widget.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
    widget.setSelectionMode(QtGui.QAbstractItemView.NoSelection)
    widget.setMinimumHeight(220)
    return widget


def fill(widget: Any, names: Sequence[str], rows: Sequence[Figure]) -> None:
    """Show figures in a table, those that were checked in green or red."""
    widget.setHorizontalHeaderLabels(list(names))
    widget.setRowCount(len(rows))
    for number, row in enumerate(rows):
        for column, text in enumerate(row[:4]):
            item = QtGui.QTableWidgetItem(text)
            if column:
                item.setTextAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
            elif row.ok is not None:
                item.setText(("✓ " if row.ok else "✗ ") + text)
                item.setForeground(QtGui.QBrush(QtGui.QColor(GREEN if row.ok else RED)))
            widget.setItem(number, column, item)
