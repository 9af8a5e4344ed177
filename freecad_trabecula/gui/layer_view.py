# SPDX-License-Identifier: LGPL-2.1-or-later
"""One layer of voxels as a picture: solid in a colour, void in the window's own, cells outside an envelope between."""

from __future__ import annotations

from typing import Any, Optional, Tuple

import numpy as np
from PySide import QtCore, QtGui

from .preferences import preferred_colour
from .qt import paper_and_ink

_MARGIN, _TEXT = 6, 18  # pixels


class LayerView(QtGui.QWidget):
    """Paints a layer; every voxel has the shape of its edges.

    Parameters
    ----------
    preferred : str
        The preference that the colour of solid voxels comes from.
    """

    def __init__(self, preferred: str) -> None:
        super().__init__()
        self._preferred, self.words, self.image = preferred, "", None
        self._pixel = (1.0, 1.0)
        self.setMinimumSize(150, 150)
        self.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Expanding)

    def show_layer(
        self,
        layer: Optional[np.ndarray],
        words: str,
        pixel: Tuple[float, float] = (1.0, 1.0),
        inside: Optional[np.ndarray] = None,
    ) -> None:
        """Show a layer, or only words in its place.

        Parameters
        ----------
        layer : ndarray of shape (rows, columns), bool, or None
            Row 0 is the lowest.
        words : str
        pixel : (float, float), mm
            Width and height of a voxel.
        inside : ndarray of the same shape, bool, optional
            Cells that may be solid.
        """
        paper, ink = paper_and_ink()
        self.words, self._pixel = words, pixel
        colour = QtGui.QColor(preferred_colour(self._preferred))
        self.image = None if layer is None else layer_picture(layer, colour, paper, ink, inside)
        self.update()

    def place(self) -> Any:
        """Return the rectangle of the picture, pixels."""
        width, height = (size * edge for size, edge in zip((self.image.width(), self.image.height()), self._pixel))
        room = self.width() - 2 * _MARGIN, self.height() - _MARGIN - _TEXT
        scale = max(min(room[0] / width, room[1] / height), 1e-9)
        size = scale * width, scale * height
        return QtCore.QRectF((self.width() - size[0]) / 2, _TEXT + (room[1] - size[1]) / 2, *size)

    def paintEvent(self, event: Any) -> None:
        """Paint words and picture."""
        paper, ink = paper_and_ink()
        painter = QtGui.QPainter(self)
        painter.fillRect(self.rect(), paper)
        painter.setPen(ink)
        if self.image is None:
            room = self.rect().adjusted(_MARGIN, 0, -_MARGIN, 0)
            painter.drawText(room, QtCore.Qt.AlignCenter | QtCore.Qt.TextWordWrap, self.words)
        else:
            room = self.width() - 2 * _MARGIN
            words = painter.fontMetrics().elidedText(self.words, QtCore.Qt.ElideRight, room)
            painter.drawText(QtCore.QPointF(_MARGIN, 13), words)
            place = self.place()
            # finer than the screen: mean of the voxels; coarser: their borders stay sharp
            fine = self.image.width() > place.width()
            painter.setRenderHint(QtGui.QPainter.SmoothPixmapTransform, fine)
            painter.drawImage(place, self.image)
            painter.setPen(QtGui.QPen(ink, 0.8, QtCore.Qt.DotLine))
            painter.drawRect(place)
        painter.end()


def layer_picture(layer: np.ndarray, colour: Any, paper: Any, ink: Any, inside: Optional[np.ndarray] = None) -> Any:
    """Return a layer (rows, columns) as a QImage, one pixel a voxel, row 0 at the bottom."""
    red, green, blue = ((7 * p + i) // 8 for p, i in zip(paper.getRgb()[:3], ink.getRgb()[:3]))
    outside = QtGui.QColor(red, green, blue)
    colours = np.array([paper.rgb(), colour.rgb(), outside.rgb()], np.uint32)
    numbers = layer.astype(np.uint8)
    if inside is not None:
        numbers[~inside & ~layer] = 2
    pixels = np.ascontiguousarray(colours[numbers[::-1]])
    rows, columns = pixels.shape
    # the picture keeps no hold of the array: a copy of its own
    return QtGui.QImage(pixels.tobytes(), columns, rows, 4 * columns, QtGui.QImage.Format_RGB32).copy()
