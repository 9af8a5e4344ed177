# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dock of the section plane: along which axis, at which height, which side, how the cut is filled."""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Tuple

import FreeCAD
import FreeCADGui
import numpy as np
from PySide import QtCore, QtGui

from ..core.analysis.parameters import AXES, axis_name
from ..core.analysis.triangles import Soup
from ..errors import TrabeculaError
from ..features.analysis_source import object_source, soup_of_source
from ..features.containers import seen_at
from ..features.relations import type_of
from .analysis_form import is_sliceable
from .colouring import show_also
from .fields import ChoiceField, NumberField
from .legend import Titled
from .looks import LOOKS, look_of
from .qt import help_buttons, icon, invoke_later
from .section import FILLS, Body, Section
from .transactions import say

translate = FreeCAD.Qt.translate
_NAME = "TrabeculaSectionDock"
_STEPS = 1000  # of the slider
_MOST = 1_500_000  # triangles of a body whose cut is filled
_CLEAR = 50  # % of transparency from which on a body's cut is not filled: what lies in it is looked at
_LOOK = 250  # ms between two looks at what is seen
_OTHERS = (0.75, 0.75, 0.78)  # the cut of what is not ours


class SectionDock(QtGui.QDockWidget):
    """Cuts the views of the active document open while it is seen; the document knows nothing of it."""

    def __init__(self) -> None:
        super().__init__(translate("Trabecula", "Section plane"), FreeCADGui.getMainWindow())
        self.setObjectName(_NAME)
        self.setWindowIcon(icon("Trabecula_section"))
        self.section: Optional[Section] = None
        self._document, self._free, self._moving = "", "", False
        self._soups: Dict[str, Soup] = {}
        self._observing = False
        self._wait = QtCore.QTimer(self)
        self._wait.setSingleShot(True)
        self._wait.timeout.connect(self._load)
        # an observer of all views would see them while they are being made: FreeCAD 1.1 then takes a solid's for one
        # without colours of faces, for good
        self._looks, self._seen = QtCore.QTimer(self), ()
        self._looks.setInterval(_LOOK)
        self._looks.timeout.connect(self._look)
        self.setWidget(self._page())
        self.visibilityChanged.connect(self._observe)

    def _page(self) -> Any:
        page = QtGui.QWidget()
        row = QtGui.QHBoxLayout(page)
        row.setContentsMargins(6, 2, 6, 2)
        self.axes = {axis: QtGui.QRadioButton(axis.upper()) for axis in AXES}
        self.axes["free"] = QtGui.QRadioButton(translate("Trabecula", "As seen"))
        self.axes["free"].setToolTip(translate("Trabecula", "Across the direction in which you look now"))
        for axis, button in self.axes.items():
            button.setChecked(axis == "z")
            button.clicked.connect(lambda *_, axis=axis: self.take_axis(axis))
            row.addWidget(button)
        self.slider = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.slider.setRange(0, _STEPS)
        self.slider.setValue(_STEPS // 2)
        self.slider.valueChanged.connect(lambda *_: self._slide())
        row.addWidget(self.slider, 1)
        self.height_field = NumberField("mm", 0.1, self._type, translate("Trabecula", "Where the plane is, mm"))
        row.addWidget(self.height_field.widget)
        self.other_side = QtGui.QCheckBox(translate("Trabecula", "Other side"))
        self.other_side.toggled.connect(lambda *_: self.show_section())
        row.addWidget(self.other_side)
        row.addWidget(QtGui.QLabel(translate("Trabecula", "Cut")))
        self.fill = ChoiceField(FILLS, self.show_section, translate("Trabecula", "How the cut is filled"))
        row.addWidget(self.fill.widget)
        row.addWidget(help_buttons("commands/Section.md"))
        return page

    # ----------------------------------------------------------------------------------------------------- what it does

    @property
    def axis(self) -> str:
        """The axis across which the plane lies."""
        chosen = next(axis for axis, button in self.axes.items() if button.isChecked())
        return self._free if chosen == "free" else chosen

    def take_axis(self, axis: str) -> None:
        """Cut across another axis, in the middle of what is seen; ``free`` is that of the present view."""
        if axis == "free":
            view = FreeCADGui.getDocument(self._document).mdiViewsOfType("Gui::View3DInventor")[0]
            direction = view.getViewDirection()
            self._free = axis_name([round(-one, 4) for one in direction])
        self.axes[axis].setChecked(True)
        self._moving = True
        self.slider.setValue(_STEPS // 2)
        self._moving = False
        self._slide()

    def place(self, height: float) -> None:
        """Move the plane to a height, mm."""
        self.height_field.set_value(height)
        self._type()

    def _slide(self) -> None:
        if self.section is None or self._moving:
            return
        low, high = self.section.range(self.axis)
        self._moving = True
        self.height_field.set_value(round(low + (high - low) * self.slider.value() / _STEPS, 3))
        self._moving = False
        self.show_section()

    def _type(self) -> None:
        if self.section is None or self._moving:
            return
        low, high = self.section.range(self.axis)
        self._moving = True
        self.slider.setValue(int(round(_STEPS * (self.height_field.value() - low) / max(high - low, 1e-9))))
        self._moving = False
        self.show_section()

    def show_section(self) -> None:
        """Cut where the widgets say."""
        if self.section is not None:
            place = self.axis, self.height_field.value(), self.other_side.isChecked(), self.fill.value()
            self.section.show(*place)
            legend = self.section.legend
            show_also(self._document, Titled(legend, translate("Trabecula", "Section")) if legend else None)

    def open(self) -> None:
        """Show the dock, and cut the active document open."""
        window = FreeCADGui.getMainWindow()
        if window.dockWidgetArea(self) == QtCore.Qt.NoDockWidgetArea and not self.isFloating():
            window.addDockWidget(QtCore.Qt.TopDockWidgetArea, self)
        self.show()
        self._begin()

    def _begin(self) -> None:
        self._end()
        if FreeCAD.ActiveDocument is None:
            return
        self._document = FreeCAD.ActiveDocument.Name
        self.section = Section(self._document)
        self.section.set_bodies((), _box_of(self._objects()))
        self._slide()
        self._wait.start(0)

    def _end(self) -> None:
        if self.section is not None:
            self.section.close()
            self.section = None
            show_also(self._document, None)

    # ------------------------------------------------------------------------------------------------ what is cut

    def _objects(self) -> List[Any]:
        """What is seen and has a body."""
        if self._document not in FreeCAD.listDocuments():
            return []
        every = FreeCAD.getDocument(self._document).Objects
        return [one for one in every if one.ViewObject.Visibility and is_sliceable(one)]

    def _load(self) -> None:
        """Take the triangles of what is seen, one body after the other, so that the window answers between."""
        if self.section is None:
            return
        found: List[Body] = []
        for obj in self._objects():
            if type_of(obj) == "Trabecula::Wireframe" or obj.ViewObject.Transparency > _CLEAR:
                continue
            try:
                source = object_source(obj)
                if source.key not in self._soups:
                    if source.kind == "mesh" and source.body.CountFacets > _MOST:
                        say(translate("Trabecula", "{} has too many triangles to be filled").format(obj.Label))
                        continue
                    self._soups[source.key] = soup_of_source(source, "auto", 0.0)
                    self._wait.start(0)  # on with the others
                    return
            except TrabeculaError as error:
                FreeCAD.Console.PrintLog(f"{error}\n")
                continue
            triangles = seen_at(self._soups[source.key].triangles, obj)
            found.append(Body(obj.Name, triangles, _colour_of(obj)))
        self.section.set_bodies(found, _box_of(self._objects()))
        self.show_section()

    # ------------------------------------------------------------------------------------------ FreeCAD's observer

    def _observe(self, visible: bool) -> None:
        """Follow the document only while the dock is seen."""
        if visible and not self._observing:
            FreeCAD.addDocumentObserver(self)
            self._looks.start()
        elif not visible and self._observing:
            FreeCAD.removeDocumentObserver(self)
            self._looks.stop()
            self._end()
            self._soups = {}
        self._observing = visible

    def _look(self) -> None:
        """Cut what is shown now, if that changed."""
        if self._document in FreeCAD.listDocuments():
            views = [obj.ViewObject for obj in FreeCAD.getDocument(self._document).Objects]
            seen = tuple((view.Object.Name, view.Visibility, getattr(view, "Transparency", 0)) for view in views)
            if seen != self._seen:
                self._seen = seen
                self.later(self._document)

    def later(self, document: str) -> None:
        """Take what is seen of a document anew, once many changes are done."""
        if document == self._document:
            self._wait.start(50)

    def slotRecomputedDocument(self, document: Any) -> None:
        """Cut the new shapes (FreeCAD's observer protocol)."""
        self.later(document.Name)

    def slotActivateDocument(self, document: Any) -> None:
        """Cut the document that one turns to (FreeCAD's observer protocol)."""
        if document.Name != self._document and self.section is not None:
            invoke_later(self._begin)

    def slotDeletedDocument(self, document: Any) -> None:
        """Leave a document that is closed (FreeCAD's observer protocol)."""
        if document.Name == self._document:
            self.section, self._document = None, ""  # its scenes go with it
            self.hide()


def _box_of(objects: List[Any]) -> np.ndarray:
    """The box (2, 3) of objects, mm; of nothing a cube."""
    if not objects:
        return np.array([[0.0, 0, 0], [1, 1, 1]])
    boxes = [(obj, (getattr(obj, "Mesh", None) or obj.Shape).BoundBox) for obj in objects]
    corners = [seen_at(np.array([tuple(box.getPoint(k)) for k in range(8)]), obj) for obj, box in boxes]
    return np.stack([np.min(corners, axis=(0, 1)), np.max(corners, axis=(0, 1))])


def _colour_of(obj: Any) -> Tuple[float, float, float]:
    """A darker shade of how the object looks: the cut stands out from the surface."""
    plain = look_of(obj).colour if type_of(obj) in (*LOOKS, "Trabecula::Body") else _OTHERS
    return tuple(0.8 * one for one in plain)


_docks: List[SectionDock] = []


def section_dock() -> SectionDock:
    """Return the window's dock, made when it is first asked for."""
    if not _docks:
        _docks.append(SectionDock())
        _docks[0].hide()
    return _docks[0]
