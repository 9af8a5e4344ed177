# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preview in a 3D view: one Coin node that is filled with arrays; the document knows nothing of it."""

from __future__ import annotations

from typing import Any, Optional

import FreeCAD
import numpy as np
from pivy import coin

from ..core.rod_colours import RECOVERY, ROD_COLOURINGS
from .drawing import Drawing
from .lost_rods import LostRods

COLOURINGS = tuple(ROD_COLOURINGS)
_SITE, _IDLE_SITE, _PAIR, _EDGE = (0.1, 0.1, 0.1), (0.85, 0.25, 0.2), (0.25, 0.35, 0.55), (0.35, 0.35, 0.35)
_CORNERS = np.array([[i & 1, i >> 1 & 1, i >> 2 & 1] for i in range(8)], float)
_BOX_EDGES = np.array([(a, b) for a in range(8) for b in range(a + 1, 8) if bin(a ^ b).count("1") == 1])


class Preview:
    """Sites, pairs and rods in a view, until ``close``."""

    def __init__(self, view: Any) -> None:
        self.colouring = COLOURINGS[0]
        self._drawing: Optional[Drawing] = None
        self._strips: Optional[np.ndarray] = None
        self.node = coin.SoSeparator()
        # neither picked nor boxed: selecting and "fit all" see the document only
        unpickable = coin.SoPickStyle()
        unpickable.style = coin.SoPickStyle.UNPICKABLE
        self.node.addChild(unpickable)
        self._frame = coin.SoMatrixTransform()
        self.node.addChild(self._frame)
        self._rods, self._rods_switch = self._add_rods()
        self.lost, self._rods_shown = LostRods(), True
        self.node.addChild(self.lost.node)
        self._sites, self._sites_switch = self._add_points(_SITE, 5.0)
        self._idle, _ = self._add_points(_IDLE_SITE, 4.0, self._sites_switch)
        self._pairs, self._pairs_switch = self._add_lines(_PAIR, 1.0)
        self._edges, self._edges_switch = self._add_lines(_EDGE, 1.5)
        # the scene, not the view: FreeCAD crashes when a view is asked whose document was closed
        self._scene = view.getSceneGraph()
        self._scene.addChild(self.node)

    # -------------------------------------------------------------------------------------------------- the nodes

    def _switch(self) -> Any:
        switch = coin.SoSwitch()
        switch.whichChild = coin.SO_SWITCH_ALL
        self.node.addChild(switch)
        return switch

    def _add_rods(self) -> Any:
        switch = self._switch()
        hints = coin.SoShapeHints()
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        hints.shapeType = coin.SoShapeHints.SOLID
        material = coin.SoMaterial()
        material.specularColor = (0.15, 0.15, 0.15)
        rods, vertices = coin.SoIndexedTriangleStripSet(), coin.SoVertexProperty()
        vertices.normalBinding = vertices.materialBinding = coin.SoVertexProperty.PER_VERTEX_INDEXED
        rods.vertexProperty = vertices
        for child in (hints, material, rods):
            switch.addChild(child)
        return rods, switch

    def _add_points(self, colour: tuple, size: float, switch: Any = None) -> Any:
        switch = switch or self._switch()
        style, points = coin.SoDrawStyle(), coin.SoPointSet()
        style.pointSize = size
        points.vertexProperty = self._plain(switch, colour)
        for child in (style, points):
            switch.addChild(child)
        return points, switch

    def _add_lines(self, colour: tuple, width: float) -> Any:
        switch = self._switch()
        style, lines = coin.SoDrawStyle(), coin.SoLineSet()
        style.lineWidth = width
        lines.vertexProperty = self._plain(switch, colour)
        for child in (style, lines):
            switch.addChild(child)
        return lines, switch

    @staticmethod
    def _plain(switch: Any, colour: tuple) -> Any:
        light, material = coin.SoLightModel(), coin.SoBaseColor()
        light.model = coin.SoLightModel.BASE_COLOR
        material.rgb = colour
        switch.addChild(light)
        switch.addChild(material)
        return coin.SoVertexProperty()

    # ----------------------------------------------------------------------------------------------- what they show

    def place(self, frame: FreeCAD.Placement) -> None:
        """Show all of it in the co-ordinates of the ``App::Part`` in which the envelope lies."""
        matrix = np.array(frame.toMatrix().A).reshape(4, 4).T  # Coin's rows are columns
        self._frame.matrix = coin.SbMatrix(*matrix.ravel().tolist())

    def show(self, drawing: Drawing) -> None:
        """Show a drawing in place of the one before."""
        self._drawing = drawing
        vertices = self._rods.vertexProperty.getValue()
        _fill(vertices.vertex, drawing.vertices)
        _fill(vertices.normal, drawing.normals)
        self._colour()
        if self._strips is None or not np.array_equal(self._strips, drawing.strips):
            _fill(self._rods.coordIndex, drawing.strips)
            self._strips = drawing.strips
        for shape, points in ((self._sites, drawing.sites), (self._idle, drawing.idle_sites)):
            _fill(shape.vertexProperty.getValue().vertex, points)
        self._show_lines(self._pairs, drawing.pairs)
        self.lost.take(drawing.lost)
        low, high = np.array(drawing.low), np.array(drawing.high)
        self._show_lines(self._edges, (low + _CORNERS * (high - low))[_BOX_EDGES.ravel()])

    @staticmethod
    def _show_lines(lines: Any, ends: np.ndarray) -> None:
        _fill(lines.vertexProperty.getValue().vertex, ends)
        _fill(lines.numVertices, np.full(len(ends) // 2, 2, np.int32))

    def _colour(self) -> None:
        _fill(self._rods.vertexProperty.getValue().orderedRGBA, self._drawing.colours[self.colouring])
        self._show_lost()

    def _show_lost(self) -> None:
        self.lost.set_visible(self._rods_shown and self.colouring == RECOVERY)

    def set_colouring(self, colouring: str) -> None:
        """Colour rods by one of ``COLOURINGS``."""
        self.colouring = colouring
        if self._drawing is not None:
            self._colour()

    def set_visible(self, rods: bool = True, sites: bool = True, pairs: bool = False, box: bool = True) -> None:
        """Show or hide the parts."""
        for switch, visible in (
            (self._rods_switch, rods),
            (self._sites_switch, sites),
            (self._pairs_switch, pairs),
            (self._edges_switch, box),
        ):
            switch.whichChild = coin.SO_SWITCH_ALL if visible else coin.SO_SWITCH_NONE
        self._rods_shown = rods
        self._show_lost()

    def close(self) -> None:
        """Take the node out of the view."""
        if self._scene.findChild(self.node) >= 0:
            self._scene.removeChild(self.node)


def _fill(field: Any, values: np.ndarray) -> None:
    """Put an array into a multiple-value field, its length included, with one notification."""
    field.enableNotify(False)
    field.setNum(len(values))
    if len(values):
        # unsigned and whole numbers are taken from lists only
        field.setValues(0, len(values), values if values.ndim == 2 else values.tolist())
    field.enableNotify(True)
    field.touch()
