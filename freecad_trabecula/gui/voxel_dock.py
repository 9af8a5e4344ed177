# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dock of voxel designs: the sample's layer and the design's side by side along three axes, target and design."""

from __future__ import annotations

from pathlib import Path
from typing import Any, List, Optional, Sequence, Set, Tuple

import FreeCAD
import numpy as np
from PySide import QtCore, QtGui

from .. import make
from ..core.voxels.sources import MESHES
from ..core.voxels.targets import AXES
from ..core.voxels.volume_sources import VOLUMES
from ..errors import TrabeculaError
from ..features.relations import type_of
from ..features.voxel_design import design_at_hand
from .aside import compute_aside
from .chart import Chart, Diagram
from .fields import row_widget
from .language import in_words
from .layer_view import LayerView
from .object_choice import ObjectChoice
from .object_dock import ObjectDock
from .qt import Tabs, help_buttons
from .recomputing import of_window
from .slice_view import plane_corners
from .tables import fill, let_grow, table
from .voxel_figures import figures_of
from .voxel_layers import DESIGN, KEYS, KINDS, SAMPLE, Layers, layer_of, pixel_of
from .why import WhyButton, WhyTable

translate = FreeCAD.Qt.translate
KIND = "Trabecula::VoxelDesign"


class VoxelDock(ObjectDock):
    """Shows one voxel design of the active document, layer by layer."""

    def __init__(self) -> None:
        super().__init__(KIND, "TrabeculaVoxelDock", translate("Trabecula", "Voxel layers"), "Trabecula_layers")
        self.axis, self.layer = 2, 0
        self.layers: Optional[Layers] = None
        self._shown: Optional[Tuple[str, bool]] = None  # key of the design, and whether its sample is at hand
        self._notice = ""
        self._fetched: Set[str] = set()
        self.choice, self.number = ObjectChoice(), QtGui.QSpinBox()
        self.slider = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.sample, self.design = LayerView(SAMPLE), LayerView(DESIGN)
        self.charts = {kind: Chart() for kind, _ in KINDS}
        self.figures = table(3)
        self.why, self.why_plot = WhyTable(self.figures, self._found), WhyButton(self._keys, self._found)
        self.tabs = Tabs()
        self.axes = [QtGui.QRadioButton(axis.upper()) for axis in AXES]
        self.axes[self.axis].setChecked(True)
        self.setWidget(self._make_page())
        self.choice.currentIndexChanged.connect(lambda *_: self.refresh())
        for axis, button in enumerate(self.axes):
            button.toggled.connect(lambda on, axis=axis: self.take_axis(axis) if on else None)
        self.slider.valueChanged.connect(lambda value: self.show_layer(int(value)))
        self.number.valueChanged.connect(lambda value: self.show_layer(int(value)))
        self.tabs.currentChanged.connect(lambda *_: self._show_chart())

    def _make_page(self) -> Any:
        self.number.setPrefix(translate("Trabecula", "layer "))
        for kind, words in KINDS:
            self.charts[kind].pointed.connect(self._point)
            self.tabs.addTab(self.charts[kind], words)
        self.tabs.addTab(self.figures, translate("Trabecula", "Numbers"))
        self.tabs.setCornerWidget(help_buttons("commands/VoxelLayers.md", self.why_plot))
        pictures, bar, left = QtGui.QSplitter(), row_widget(), QtGui.QWidget()
        for view in (self.sample, self.design):
            pictures.addWidget(view)
        for widget in (self.choice, *self.axes, self.slider, self.number):
            bar.layout().addWidget(widget, 1 if widget is self.slider else 0)
        self.choice.setMinimumWidth(110)
        column = QtGui.QVBoxLayout(left)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        column.addWidget(bar)
        column.addWidget(pictures, 1)
        split = QtGui.QSplitter()
        split.addWidget(left)
        split.addWidget(self.tabs)
        split.setSizes([700, 420])
        return split

    # -------------------------------------------------------------------------------------------------- what is shown

    def chosen(self) -> Any:
        """Return the design that is shown; None if there is none."""
        name = self.choice.object_name()
        return next((obj for obj in self.objects() if obj.Name == name), None)

    def show_objects(self, obj: Any = None) -> None:
        """List the designs anew, and show one; without any the one that was shown, or the last."""
        every = self.objects()
        names = [one.Name for one in every]
        wanted = obj.Name if obj is not None else self.choice.object_name()
        self.choice.blockSignals(True)
        self.choice.offer(every)
        if every:
            self.choice.choose(every[names.index(wanted) if wanted in names else -1])
        self.choice.blockSignals(False)
        self.refresh()

    def refresh(self) -> None:
        """Show the chosen design."""
        obj = self.chosen()
        self._notice = translate("Trabecula", "Design voxels of a body or an analysis to see their layers")
        mark = (obj.ResultKey, design_at_hand(obj) is not None) if obj is not None else None
        try:
            if mark is None or mark != self._shown:  # counted once
                self.layers = Layers(make.voxel_design_of(obj)) if obj is not None else None
        except TrabeculaError as error:
            self.layers, self._notice = None, in_words(str(error))
        self._shown = mark
        self._offer_layers()
        self._show_chart()
        if self.layers is not None:
            self._fetch_sample(obj)

    def _fetch_sample(self, obj: Any) -> None:
        """Have a design whose sample is not at hand made again elsewhere; the object tells when it is there."""
        if _has_sample(obj) and design_at_hand(obj) is None and obj.UpToDate and obj.ResultKey not in self._fetched:
            self._fetched.add(obj.ResultKey)  # once: what is not there then has none
            of_window().take(obj, obj.ResultKey)

    def take_axis(self, axis: int) -> None:
        """Show the layers along X, Y or Z: 0, 1, 2."""
        self.axis = axis
        self.axes[axis].setChecked(True)
        self._offer_layers()
        self._show_chart()

    def _offer_layers(self) -> None:
        count = self.layers.design.targets.layers[self.axis] if self.layers is not None else 0
        for widget in (self.slider, self.number):
            widget.blockSignals(True)
            widget.setRange(0, max(count - 1, 0))
            widget.setEnabled(count > 0)
            widget.blockSignals(False)
        self.show_layer(self.layer if 0 < self.layer < count else count // 2)

    def show_layer(self, number: int) -> None:
        """Show one layer: both pictures, their counts, the cursor, the plane in the 3D view."""
        self.layer = number
        for widget in (self.slider, self.number):
            widget.blockSignals(True)
            widget.setValue(number)
            widget.blockSignals(False)
        if self.layers is None:
            for view in (self.sample, self.design):
                view.show_layer(None, self._notice)
            self.drop_plane()
            return
        design, targets = self.layers.design, self.layers.design.targets
        pixel, words = pixel_of(targets.voxel, self.axis), self.layers.words(self.axis, number)
        inside = None if design.mask is None else layer_of(design.mask, self.axis, number)
        self.design.show_layer(layer_of(design.voxels, self.axis, number), words[1], pixel, inside)
        if targets.sample is None:
            self.sample.show_layer(None, f"{words[0]}\n\n{self._no_sample()}")
        else:
            self.sample.show_layer(layer_of(targets.sample, self.axis, number), words[0], pixel)
        height = float(self.layers.middles(self.axis)[number])
        for chart in self.charts.values():
            chart.set_cursor(height)
        low = np.array(targets.origin)
        box = np.stack([low, low + np.array(targets.layers) * targets.voxel])
        self.move_plane(plane_corners(AXES[self.axis], height, box), self.chosen())

    def _no_sample(self) -> str:
        obj = self.chosen()
        if obj is not None and _has_sample(obj) and design_at_hand(obj) is None:
            return translate("Trabecula", "The sample is being worked out …")
        return translate("Trabecula", "Profiles have no picture")

    def _keys(self) -> Sequence[str]:
        """Which numbers the open diagram shows; the table has signs of its own."""
        number = self.tabs.currentIndex()
        return KEYS[KINDS[number][0]] if number < len(KINDS) and self.layers is not None else ()

    def _found(self, key: str) -> Sequence[str]:
        return make.found_routes(self.chosen(), key) if self.chosen() is not None else ()

    def _show_chart(self) -> None:
        if self.tabs.currentIndex() == len(KINDS):
            rows = figures_of(self.chosen()) if self.chosen() is not None else []
            names = (translate("Trabecula", "Quantity"), translate("Trabecula", "Value"), "")
            fill(self.figures, names, [row[:2] for row in rows])
            let_grow(self.figures)
            self.why.set_keys([row.key for row in rows])
            return
        kind, layers, diagram = KINDS[self.tabs.currentIndex()][0], self.layers, Diagram("", "")
        if layers is not None and layers.has(kind):
            diagram = layers.diagram(kind, self.axis)
        elif layers is not None:
            compute_aside(layers.count_trabeculae, lambda _: self._counted(layers))
        self.charts[kind].show_diagram(diagram)

    def _counted(self, layers: Layers) -> None:
        """Show what has been counted, if it is still wanted."""
        if layers is self.layers:
            self._show_chart()

    def _point(self, x: float) -> None:
        """Take the layer that is nearest to the mouse."""
        if self.layers is not None:
            self.show_layer(int(np.abs(self.layers.middles(self.axis) - x).argmin()))


def _has_sample(obj: Any) -> bool:
    """Whether a design's sample is a body, of which voxels are known, not profiles."""
    if obj.Source is None:
        return Path(obj.File).suffix.lower() in (*MESHES, *VOLUMES)
    return type_of(obj.Source) != "Trabecula::Analysis"


_docks: List[VoxelDock] = []


def voxel_dock() -> VoxelDock:
    """Return the window's dock, made when it is first asked for."""
    if not _docks:
        _docks.append(VoxelDock())
        _docks[0].hide()
    return _docks[0]


def show_layers(obj: Any = None) -> VoxelDock:
    """Open the dock on a voxel design; without any on the one that was seen last."""
    dock = voxel_dock()
    dock.open()
    dock.show_objects(obj)
    return dock
