# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that changes one site or one pore by hand: pick a site in the 3D view, change it, see it at once."""

from __future__ import annotations

from typing import Any, List, Optional, Sequence, Tuple

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtGui

from ..core.wireframe import Wireframe
from ..features.relations import type_of, wireframe_of
from .edits_list import EditsList
from .fields import ChoiceField, NumberField, PointField
from .language import in_words
from .panels import is_free_for
from .pore_drawing import PoreDrawing
from .qt import PanelForm
from .rod_dock import computed_wireframe
from .task_panels import DocumentPanel, show_panel, while_open
from .transactions import record, say, told, transaction

translate = FreeCAD.Qt.translate
WIDTH = 340  # pixels that the form needs


class SiteGate:
    """Lets sites of one design be selected, nothing else."""

    def __init__(self, wireframe: Any) -> None:
        self._names = {one.Name for one in wireframe.Sites}
        self._document = wireframe.Document.Name

    def allow(self, document: Any, obj: Any, sub: str) -> bool:
        """Return whether something may be selected."""
        ok = document.Name == self._document and obj.Name in self._names and "Vertex" in sub
        if not ok:
            self.notAllowedReason = translate("Trabecula", "Pick a site")
        return ok


class SitePanel(DocumentPanel):
    """A task panel on one wireframe; every press of a button is one step to undo."""

    def __init__(self, wireframe: Any) -> None:
        super().__init__(wireframe.Document, WIDTH)
        self.obj = wireframe
        self.site = ChoiceField((), self._show_site, translate("Trabecula", "Site; or click one in the 3D view"))
        self.size = NumberField("mm", 0.05, self._draw, translate("Trabecula", "Size of the pore"))
        self.turns: List[NumberField] = []
        self.drawing = PoreDrawing()
        self.point = PointField("mm", 0.1, lambda: None, translate("Trabecula", "Place of the site"))
        self.edits = EditsList(self._take_back)
        self.form = self._make_form()
        self._sites = list(wireframe.Sites)
        self._visible = [(one, one.ViewObject.Visibility) for one in self._sites]
        for one in self._sites:
            one.ViewObject.Visibility = True
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelectionGate(SiteGate(wireframe))
        FreeCADGui.Selection.addObserver(self)
        self.begin()
        self._fill()

    def _make_form(self) -> Any:
        form = PanelForm(translate("Trabecula", "Edit site and pore"), "Trabecula_edit_pore", "commands/EditSite.md")
        grid = QtGui.QFormLayout(form)
        grid.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        grid.addRow(translate("Trabecula", "Site"), self.site.widget)
        grid.addRow(self.drawing)
        grid.addRow(translate("Trabecula", "Size"), self.size.widget)
        self._turns_row = QtGui.QWidget()
        QtGui.QHBoxLayout(self._turns_row).setContentsMargins(0, 0, 0, 0)
        grid.addRow(translate("Trabecula", "Tangents"), self._turns_row)
        grid.addRow(self._button(translate("Trabecula", "Set pore"), self._set_pore))
        grid.addRow(translate("Trabecula", "Place"), self.point.widget)
        grid.addRow(self._button(translate("Trabecula", "Move site"), self._move))
        grid.addRow(self._button(translate("Trabecula", "Switch site off"), self._switch_off))
        grid.addRow(self.edits)
        return form

    @staticmethod
    def _button(text: str, pressed: Any) -> Any:
        button = QtGui.QPushButton(text)
        button.clicked.connect(lambda *_: pressed())
        return button

    # ------------------------------------------------------------------------------------------------- what it shows

    def _wireframe(self) -> Optional[Wireframe]:
        return computed_wireframe(self.obj)

    def _fill(self) -> None:
        """Show the sites that there are."""
        wireframe, chosen = self._wireframe(), self.site.value()
        names = [name for one in wireframe.sites.values() for name in one.names] if wireframe else []
        self.site.set_choices(names)
        if names:
            self.site.set_value(chosen if chosen in names else names[0])
        self.edits.set_value(self.obj.Proxy.parameters(self.obj).edits)
        self._show_site()

    def _place(self) -> Optional[Tuple[Wireframe, str, int]]:
        wireframe, name = self._wireframe(), self.site.value()
        if wireframe is None or not name:
            return None
        face = name.split(".")[0]
        return wireframe, face, wireframe.sites[face].names.index(name)

    def _show_site(self) -> None:
        place = self._place()
        if place is None:
            return
        wireframe, face, number = place
        pore = wireframe.pores[face].take(np.array([number]))
        self.size.set_value(float(pore.size[0]))
        self.point.set_value(tuple(float(c) for c in wireframe.sites[face].points[number]))
        parameters = self.obj.Proxy.parameters(self.obj).pores
        self._show_turns(components(pore.angles[0]) if parameters.layout == "spline" else [])
        self._draw()

    def _show_turns(self, turns: List[float]) -> None:
        while len(self.turns) > len(turns):
            self.turns.pop().widget.deleteLater()
        while len(self.turns) < len(turns):
            field = NumberField("", 0.05, self._draw, translate("Trabecula", "Component of the unit tangent, 0 to 1"))
            field.widget.setButtonSymbols(QtGui.QAbstractSpinBox.NoButtons)
            self._turns_row.layout().addWidget(field.widget)
            self.turns.append(field)
        for field, value in zip(self.turns, turns):
            field.set_value(value)
        self._turns_row.setEnabled(bool(turns))

    def _draw(self) -> None:
        place = self._place()
        if place is not None:
            turns = [field.value() for field in self.turns]
            self.drawing.set_pore(self.obj.Proxy.parameters(self.obj).pores, self.size.value(), turns)

    # ---------------------------------------------------------------------------------------------------- changes

    def _do(self, title: str, call: str) -> None:
        document = self.obj.Document
        with told(), transaction(document, title):
            record("import FreeCAD")
            record("from freecad_trabecula import make")
            record(f"wireframe = FreeCAD.getDocument({document.Name!r}).getObject({self.obj.Name!r})")
            record(f"make.{call}")
        self._fill()
        say(in_words(self.obj.Status))

    def _set_pore(self) -> None:
        turns = tuple(field.value() for field in self.turns)
        more = f", turns={turns!r}" if turns else ""
        self._do(
            translate("Trabecula", "Set pore"),
            f"set_pore(wireframe, {self.site.value()!r}, size={self.size.value()!r}{more})",
        )

    def _move(self) -> None:
        self._do(
            translate("Trabecula", "Move site"), f"move_site(wireframe, {self.site.value()!r}, {self.point.value()!r})"
        )

    def _switch_off(self) -> None:
        self._do(translate("Trabecula", "Switch site off"), f"switch_off_site(wireframe, {self.site.value()!r})")

    def _take_back(self) -> None:
        kept = {edit.site for edit in self.edits.value()}
        gone = [edit.site for edit in self.obj.Proxy.parameters(self.obj).edits if edit.site not in kept]
        for site in gone[:1]:
            self._do(translate("Trabecula", "Take back"), f"take_back_edits(wireframe, {site!r})")

    # --------------------------------------------------------------------------------------- observers, task panel

    @while_open
    def addSelection(self, document: str, name: str, sub: str, point: Any) -> None:
        """Take the site that was clicked (FreeCAD's observer protocol)."""
        element = sub.split(".")[-1]
        if (document, name) not in [(self.document_name, one.Name) for one in self._sites] or "Vertex" not in element:
            return
        with told():
            obj = FreeCAD.getDocument(document).getObject(name)
            names = [one for face in obj.Proxy.faces(obj).values() for one in face.sites.names]
            self.site.set_value(names[int(element[6:]) - 1])

    def objects(self) -> Sequence[Any]:
        """Return the design."""
        return (self.obj,)

    def let_go(self, has_document: bool) -> None:
        """Listen to clicks no more, and hide the sites that were hidden."""
        FreeCADGui.Selection.removeObserver(self)
        FreeCADGui.Selection.removeSelectionGate()
        for one, visible in self._visible if has_document else ():
            if one in self.document.Objects:
                one.ViewObject.Visibility = visible


def components(angles: np.ndarray) -> List[float]:
    """Return the tangent components in 0..1 that give angles (M,) of a pore: the inverse of ``pores.make_pores``."""
    count = len(angles)
    quarter = (angles - (-np.pi / 2 + 2 * np.pi / count * np.arange(count))) * count / 4
    even = np.arange(count) % 2 == 0
    return np.clip(np.where(even, np.sin(quarter), np.cos(quarter)), 0.0, 1.0).tolist()


def open_site_panel(obj: Any) -> None:
    """Open the panel for the design to which an object belongs."""
    wireframe = wireframe_of(obj) if type_of(obj) else None
    if wireframe is None:
        say(translate("Trabecula", "Select a wireframe or its sites first"))
    elif is_free_for(wireframe):
        show_panel(SitePanel(wireframe))
