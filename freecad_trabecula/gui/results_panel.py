# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of a design: porosity, volumes by two routes, counts, recoveries, couplings, sizes, checks."""

from __future__ import annotations

from html import escape
from typing import Any, Sequence

import FreeCAD
from PySide import QtCore, QtGui

from .. import make
from ..core.couplings import CouplingRow
from ..core.wireframe import Recovery
from ..features.base import records_of
from ..features.relations import parts_of, products_of
from .accordion import Accordion
from .export_dialog import export_design
from .figures import Checked, checks_of, figures_of, headline, notes_of
from .histogram import Histogram
from .language import in_words, local_number
from .looks import look_of
from .outcome import GREEN, ORANGE, RED
from .qt import PanelForm, icon, word_colour
from .tables import fill, table
from .task_panels import DocumentPanel, is_free, show_panel, while_open, wireframes
from .transactions import told
from .why import WhyButton, WhyTable

translate = FreeCAD.Qt.translate
WIDTH = 420  # pixels that the form needs


class ResultsPanel(DocumentPanel):
    """A task panel on one wireframe and the bodies made of it."""

    def __init__(self, wireframe: Any) -> None:
        super().__init__(wireframe.Document, WIDTH)
        self.wireframe = wireframe
        self.headline, self.notes = QtGui.QLabel(), QtGui.QLabel()
        self.notes.setWordWrap(True)
        self.figures, self.couplings, self.recoveries = table(3), table(5), table(5)
        self.why = [WhyTable(one, self._found) for one in (self.figures, self.couplings, self.recoveries)]
        self.checks = QtGui.QTextBrowser()
        self.checks.setMinimumHeight(330)
        self.histogram = Histogram(translate("Trabecula", "Size of the end sections, mm"))
        self.shown = QtGui.QWidget()
        self.form = self._make_form()
        self.begin()
        self.show()

    def _make_form(self) -> Any:
        form = PanelForm(translate("Trabecula", "Results"), "Trabecula_results", "commands/Results.md")
        self.sections = Accordion()
        for title, picture, page in (
            (translate("Trabecula", "Figures"), "results", self.figures),
            (translate("Trabecula", "Checks"), "scaffold", self.checks),
            (translate("Trabecula", "Pore sizes"), "pore", self._sizes_page()),
            (translate("Trabecula", "Couplings"), "coupling", self.couplings),
            (translate("Trabecula", "Recoveries"), "path", self.recoveries),
        ):
            self.sections.add(title, icon("Trabecula_" + picture), page)
        export = QtGui.QPushButton(translate("Trabecula", "Export …"))
        export.setIcon(icon("Trabecula_export"))
        export.clicked.connect(lambda *_: self._export())
        self._boxes = QtGui.QGridLayout(self.shown)
        self._boxes.setContentsMargins(0, 0, 0, 0)
        column = QtGui.QVBoxLayout(form)
        column.setContentsMargins(6, 4, 6, 4)
        column.setSpacing(4)
        for widget in (self.headline, self.shown, self.notes, self.sections, export):
            column.addWidget(widget)
        return form

    def _sizes_page(self) -> Any:
        page = QtGui.QWidget()
        column = QtGui.QVBoxLayout(page)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.histogram)
        column.addWidget(WhyButton(lambda: ["design.pore_size", "design.pore_area"]), 0, QtCore.Qt.AlignRight)
        return page

    def _found(self, key: str) -> Sequence[str]:
        return make.found_routes(self.wireframe, key)

    def _export(self) -> None:
        with told():
            export_design(self.wireframe)

    # ----------------------------------------------------------------------------------------------- what it shows

    def show(self) -> None:
        """Show what the objects hold."""
        obj = self.wireframe
        self.headline.setText(f"<b>{headline(obj)}</b>")
        notes = notes_of(obj)
        self.notes.setText(f'<span style="color:{word_colour(ORANGE)}">' + "<br>".join(map(escape, notes)) + "</span>")
        self.notes.setVisible(bool(notes))
        self._offer_bodies()
        names = (translate("Trabecula", "Quantity"), translate("Trabecula", "Value"), "")
        figures = figures_of(obj)
        fill(self.figures, names, [row[:2] for row in figures])
        self.why[0].set_keys([row.key for row in figures])
        rows = checks_of(obj)
        self.checks.setHtml("".join(check_text(row) for row in rows))
        good = sum(row.ok for row in rows)
        self.sections.set_summary(1, translate("Trabecula", "{} of {} hold").format(good, len(rows)))
        self._show_couplings(records_of(obj.CouplingTable, CouplingRow, "row"))
        self._show_recoveries(records_of(obj.Recoveries, Recovery, "recovery"))
        self.histogram.set_values(obj.PoreSizes)
        sizes = list(obj.PoreSizes) or [0.0]
        self.sections.set_summary(2, f"{local_number(min(sizes), '.2f')}–{local_number(max(sizes), '.2f')} mm")

    def _show_couplings(self, rows: Sequence[CouplingRow]) -> None:
        titles = (translate("Trabecula", "Faces"), translate("Trabecula", "Available"),
                  translate("Trabecula", "Rods"), translate("Trabecula", "Left"), "")  # fmt: skip
        fill(self.couplings, titles, [(
            f"{r.first} – {r.second}", f"{r.available_first} · {r.available_second}", str(r.rods),
            f"{r.left_first} · {r.left_second}") for r in rows])  # fmt: skip
        self.why[1].set_keys(["design.available design.rods design.left"] * len(rows))
        self.sections.set_summary(3, str(len(rows)))

    def _show_recoveries(self, mended: Sequence[Recovery]) -> None:
        titles = (translate("Trabecula", "Rod"), translate("Trabecula", "Fault"),
                  translate("Trabecula", "Remedy"), translate("Trabecula", "Attempts"), "")  # fmt: skip
        fill(self.recoveries, titles, [(r.rod, in_words(r.fault), in_words(r.remedy), str(r.attempts)) for r in mended])
        self.why[2].set_keys(["design.attempts"] * len(mended))
        self.sections.set_summary(4, str(len(mended)) if mended else translate("Trabecula", "none"))

    def _offer_bodies(self) -> None:
        """Offer a switch for each body: whether it is seen."""
        while self._boxes.count():
            self._boxes.takeAt(0).widget().deleteLater()
        for number, obj in enumerate([self.wireframe, *parts_of(self.wireframe)]):
            box = QtGui.QCheckBox(obj.Label)
            box.setIcon(icon(look_of(obj).icon))
            box.setChecked(bool(obj.ViewObject.Visibility))
            box.toggled.connect(lambda on, view=obj.ViewObject: setattr(view, "Visibility", bool(on)))
            box.setEnabled(getattr(obj, "Facets", 1) > 0)  # loose pieces and voids of which there are none
            self._boxes.addWidget(box, number // 3, number % 3)

    # ------------------------------------------------------------------------------------------------- task panel

    def objects(self) -> Sequence[Any]:
        """Return the design."""
        return (self.wireframe,)

    @while_open
    def slotRecomputedObject(self, obj: Any) -> None:
        """Show the figures anew when an object has been computed again (FreeCAD's observer protocol)."""
        if obj.Document == self.document and obj in (self.wireframe, *products_of(self.wireframe)):
            self.show()


def check_text(row: Checked) -> str:
    """Return a check as HTML: green if it holds, red if not."""
    sign, colour = ("✓", word_colour(GREEN)) if row.ok else ("✗", word_colour(RED))
    return f'<p style="margin:3px"><b style="color:{colour}">{sign} {escape(row.name)}</b><br>{escape(row.found)}</p>'


def open_results(document: str, wireframe: Any = None) -> None:
    """Open the results of a design: that of the selection, or the last one of the document."""
    if document in FreeCAD.listDocuments() and is_free():
        found = wireframe or wireframes(FreeCAD.getDocument(document))[-1]
        show_panel(ResultsPanel(found))
