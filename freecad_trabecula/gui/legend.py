# SPDX-License-Identifier: LGPL-2.1-or-later
"""Legends: what colours mean, painted in a panel and, by the same code, into the corner of a 3D view."""

from __future__ import annotations

from typing import Any, List, NamedTuple, Optional, Sequence, Tuple

import FreeCAD
import FreeCADGui
from pivy import coin
from PySide import QtCore, QtGui

from ..core.colours import SCALE, Legend
from .chart import nice_steps
from .language import local_number
from .qt import paper_and_ink

translate = FreeCAD.Qt.translate
_LINE, _MARGIN, _BOX, _BAR = 17, 8, 11, 12  # pixels
_WIDTH = 210  # pixels of a legend in the 3D view
_MOST_ENTRIES = 12
LEGEND_NODE = "TrabeculaLegend"
_AWAY = 0.03  # share of the view between the legend and its edges


def quantity_words(quantity: str) -> str:
    """Return what is coloured as a reader knows it."""
    words = {
        "size": translate("Trabecula", "size of the rods"),
        "coupling": translate("Trabecula", "coupling"),
        "recovery": translate("Trabecula", "recovery of the rods"),
        "kind": translate("Trabecula", "kind of the contours"),
        "porosity": translate("Trabecula", "porosity of the slices along {}"),
        "trabeculae": translate("Trabecula", "trabeculae in the layers along {}"),
    }
    name, _, axis = quantity.partition(" along ")
    return words.get(name, name).format(axis.upper())


def entry_words(name: str) -> str:
    """Return the name of a class as a reader knows it; names of faces are what they are."""
    words = {
        "as drawn": translate("Trabecula", "as drawn"),
        "mended": translate("Trabecula", "mended"),
        "leaves the envelope": translate("Trabecula", "leaves the envelope"),
        "failed, left out": translate("Trabecula", "failed, left out"),
        "rods": translate("Trabecula", "rods"),
        "plates": translate("Trabecula", "plates"),
    }
    return words.get(name, name)


class Titled(NamedTuple):
    """A legend and the name of what is coloured; empty: the quantity alone is its title."""

    legend: Legend
    name: str = ""

    @property
    def title(self) -> str:
        """Quantity, unit and name."""
        unit = f", {self.legend.unit}" if self.legend.unit else ""
        name = f"{self.name}: " if self.name else ""
        return f"{name}{quantity_words(self.legend.quantity)}{unit}"


def height_of(one: Titled) -> int:
    """Return how high a legend is, pixels."""
    lines = min(len(one.legend.entries), _MOST_ENTRIES + 1)
    return _LINE + (lines * _LINE if lines else _BAR + _LINE + 2)


def paint_legend(painter: Any, box: Any, one: Titled, ink: Any) -> None:
    """Paint a legend into a rectangle: its title, then the scale with round numbers, or the classes."""
    metrics = painter.fontMetrics()
    painter.setPen(ink)
    title = metrics.elidedText(one.title, QtCore.Qt.ElideRight, int(box.width()))
    painter.drawText(QtCore.QPointF(box.left(), box.top() + _LINE - 5), title)
    below = QtCore.QRectF(box.left(), box.top() + _LINE, box.width(), box.height() - _LINE)
    if one.legend.entries:
        _paint_entries(painter, below, one.legend, ink)
    else:
        _paint_scale(painter, below, one.legend, ink)


def _paint_scale(painter: Any, box: Any, legend: Legend, ink: Any) -> None:
    marks = scale_marks(legend.low, legend.high)
    widths = [painter.fontMetrics().boundingRect(text).width() for _, text in marks]
    room = max(widths) / 2 + 2.0  # half of a number stands out at both ends
    bar = QtCore.QRectF(box.left() + room, box.top(), box.width() - 2 * room, _BAR)
    gradient = QtGui.QLinearGradient(bar.left(), 0, bar.right(), 0)
    for k, colour in enumerate(SCALE):
        gradient.setColorAt(k / (len(SCALE) - 1), QtGui.QColor(*colour))
    painter.fillRect(bar, gradient)
    painter.setPen(ink)
    for share, text in marks:
        x = bar.left() + share * bar.width()
        painter.drawLine(QtCore.QPointF(x, bar.bottom()), QtCore.QPointF(x, bar.bottom() + 3))
        place = QtCore.QRectF(x - 40, bar.bottom() + 2, 80, _LINE)
        painter.drawText(place, QtCore.Qt.AlignCenter, text)


def scale_marks(low: float, high: float) -> List[Tuple[float, str]]:
    """Return shares and texts of the marks of a scale: both ends, and round numbers that do not touch them.

    Examples
    --------
    >>> scale_marks(0.0, 10.0)
    [(0.0, '0'), (0.5, '5'), (1.0, '10')]
    """
    if not high > low:
        return [(0.5, local_number(low, ".3g"))]
    inner = [(value - low) / (high - low) for value in nice_steps(low, high, 3)]
    shares = [0.0, *(share for share in inner if 0.28 < share < 0.72), 1.0]
    return [(share, local_number(low + share * (high - low), ".3g")) for share in shares]


def _paint_entries(painter: Any, box: Any, legend: Legend, ink: Any) -> None:
    shown, more = legend.entries[:_MOST_ENTRIES], legend.entries[_MOST_ENTRIES:]
    for line, entry in enumerate(shown):
        y = box.top() + line * _LINE
        painter.fillRect(QtCore.QRectF(box.left(), y + 2, _BOX, _BOX), QtGui.QColor(*entry.colour))
        painter.setPen(ink)
        text = f"{entry_words(entry.name)} ({entry.count})"
        text = painter.fontMetrics().elidedText(text, QtCore.Qt.ElideRight, int(box.width()) - _BOX - 6)
        painter.drawText(QtCore.QPointF(box.left() + _BOX + 6, y + _LINE - 5), text)
    if more:
        text = translate("Trabecula", "and {} more").format(len(more))
        painter.drawText(QtCore.QPointF(box.left(), box.top() + (_MOST_ENTRIES + 1) * _LINE - 5), text)


class LegendWidget(QtGui.QWidget):
    """A legend in a panel."""

    def __init__(self) -> None:
        super().__init__()
        self.legend: Optional[Legend] = None
        self.show_legend(None)

    def show_legend(self, legend: Optional[Legend]) -> None:
        """Show a legend; None hides it."""
        self.legend = legend
        self.setVisible(legend is not None)
        if legend is not None:
            self.setFixedHeight(height_of(Titled(legend)))
            self.setToolTip("\n".join(f"{entry_words(one.name)} ({one.count})" for one in legend.entries))
        self.update()

    def paintEvent(self, event: Any) -> None:
        """Paint it."""
        if self.legend is not None:
            painter = QtGui.QPainter(self)
            paint_legend(painter, QtCore.QRectF(self.rect()), Titled(self.legend), paper_and_ink()[1])
            painter.end()


def legend_image(legends: Sequence[Titled]) -> Any:
    """Return legends one below the other as a picture, on a ground of their own: they are read before anything."""
    font = QtGui.QApplication.font()
    metrics = QtGui.QFontMetrics(font)
    widest = max(metrics.boundingRect(one.title).width() for one in legends)
    width = min(max(_WIDTH, widest + 4), 2 * _WIDTH)
    height = sum(height_of(one) for one in legends) + _MARGIN * (len(legends) - 1)
    image = QtGui.QImage(width + 2 * _MARGIN, height + 2 * _MARGIN, QtGui.QImage.Format_RGBA8888)
    paper, ink = paper_and_ink()
    image.fill(paper)
    painter = QtGui.QPainter(image)
    painter.setFont(font)
    painter.setPen(ink)
    painter.drawRect(0, 0, image.width() - 1, image.height() - 1)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    y = _MARGIN
    for one in legends:
        paint_legend(painter, QtCore.QRectF(_MARGIN, y, width, height_of(one)), one, ink)
        y += height_of(one) + _MARGIN
    painter.end()
    return image


class LegendOverlay:
    """Legends in the lower left corner of the 3D views of a document; neither picked nor boxed."""

    def __init__(self) -> None:
        self.legends: Tuple[Titled, ...] = ()
        self._image = coin.SoImage()
        self._image.horAlignment = coin.SoImage.LEFT
        self._image.vertAlignment = coin.SoImage.BOTTOM
        self.node = _corner(self._image)
        # scenes, not views: FreeCAD crashes when a view is asked whose document was closed
        self._scenes: List[Any] = []

    def show(self, document: str, legends: Sequence[Titled]) -> None:
        """Show legends in all views of a document, in place of those before; none takes the node out."""
        self.legends = tuple(legends)
        if not legends:
            self.close()
            return
        image = legend_image(legends).mirrored()
        pixels = bytes(image.constBits())
        self._image.image.setValue(coin.SbVec2s(image.width(), image.height()), 4, pixels)
        for view in FreeCADGui.getDocument(document).mdiViewsOfType("Gui::View3DInventor"):
            scene = view.getSceneGraph()
            if scene.findChild(self.node) < 0:
                # before all else: a section plane cuts what comes after it
                scene.insertChild(self.node, 0)
                self._scenes.append(scene)

    def close(self) -> None:
        """Take the node out of the views."""
        for scene in self._scenes:
            if scene.findChild(self.node) >= 0:
                scene.removeChild(self.node)
        self._scenes = []


def _corner(image: Any) -> Any:
    """A node that shows an image in the lower left corner of whatever view it is in."""
    skip = coin.SoType.fromName("SoSkipBoundingGroup").createInstance()  # FreeCAD's own: "fit all" passes it over
    front, unpickable, camera = coin.SoAnnotation(), coin.SoPickStyle(), coin.SoOrthographicCamera()
    unpickable.style = coin.SoPickStyle.UNPICKABLE
    camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
    camera.position, camera.height = (0, 0, 1), 2.0
    camera.nearDistance, camera.farDistance = 0.5, 2.0
    place = coin.SoTranslation()
    place.translation = (2 * _AWAY - 1, 2 * _AWAY - 1, 0)
    for child in (unpickable, camera, place, image):
        front.addChild(child)
    skip.addChild(front)
    whole = (
        coin.SoGroup()
    )  # made by its constructor, it is Python's as well as the scene's: it outlives being taken out
    whole.addChild(skip)
    whole.setName(LEGEND_NODE)
    return whole
