# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is known of a previewed design: rods, porosity, warnings, the scale of colours; below the form of the panel."""

from __future__ import annotations

from html import escape
from typing import Callable, Optional

import FreeCAD
from PySide import QtGui

from .fields import ChoiceField, row_widget
from .language import filled, in_words, local_number
from .legend import LegendWidget
from .preview import COLOURINGS
from .preview_worker import Estimate, Outline
from .qt import word_colour

translate = FreeCAD.Qt.translate
#: Readable on light and on dark themes.
RED, ORANGE, GREEN = "#d64545", "#c77700", "#2e9e5b"


class Outcome(QtGui.QWidget):
    """A few lines about the preview, and what of it is shown.

    Parameters
    ----------
    show_parts : callable
        Called when the user changes what is shown.
    """

    def __init__(self, show_parts: Callable[[], None]) -> None:
        super().__init__()
        self.headline, self.details, self.message = QtGui.QLabel(), QtGui.QLabel(), QtGui.QLabel()
        self.message.setWordWrap(True)
        self.details.setWordWrap(True)
        self._outline: Optional[Outline] = None
        self.legend = LegendWidget()
        self.colouring = ChoiceField(COLOURINGS, show_parts, translate("Trabecula", "What the rods' colours mean"))
        self.parts = {}
        shown = row_widget()
        shown.layout().addWidget(QtGui.QLabel(translate("Trabecula", "Colour")))
        shown.layout().addWidget(self.colouring.widget)
        for name, text, on in (
            ("rods", translate("Trabecula", "Rods"), True),
            ("sites", translate("Trabecula", "Sites"), True),
            ("pairs", translate("Trabecula", "Pairs"), False),
        ):
            box = QtGui.QCheckBox(text)
            box.setChecked(on)
            box.toggled.connect(lambda *_: show_parts())
            self.parts[name] = box
            shown.layout().addWidget(box)
        shown.layout().addStretch(1)
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(3)
        for widget in (shown, self.legend, self.headline, self.details, self.message):
            column.addWidget(widget)
        self.show_busy()

    def shown(self) -> dict:
        """Return which parts of the preview are to be shown."""
        return {name: box.isChecked() for name, box in self.parts.items()}

    def show_legend(self) -> None:
        """Show what the colours mean."""
        rods = self._outline.rods if self._outline is not None else 0
        self.legend.show_legend(self._outline.drawing.legends[self.colouring.value()] if rods else None)

    def show_busy(self, text: str = "") -> None:
        """Say that a preview is on its way, or what else goes on before it."""
        self.message.hide()
        if text:
            self._outline = None
            self.details.setText("")
        if self._outline is None:
            self.headline.setText(f"<b>{text or translate('Trabecula', 'Preview …')}</b>")

    def show_outline(self, outline: Outline) -> None:
        """Show the number of rods; the porosity follows."""
        self._outline = outline
        rods = translate("Trabecula", "{} rods").format(outline.rods)
        self.headline.setText(f"<b>{rods}</b>, {translate('Trabecula', 'porosity …')}")
        self.details.setText(mended_text(outline))
        self.details.show()
        self.show_legend()
        self.message.hide()

    def show_estimate(self, estimate: Estimate) -> None:
        """Show the porosity and the warnings."""
        rods = translate("Trabecula", "{} rods").format(self._outline.rods if self._outline else 0)
        porosity = translate("Trabecula", "porosity ≈ {} %").format(porosity_text(estimate))
        self.headline.setText(f"<b>{rods}, {porosity}</b>")
        plain = filled(translate("Trabecula", "sum of the rods {:.1f} %"), 100 * estimate.plain_sum)
        mended = mended_text(self._outline) if self._outline else ""
        if not estimate.is_mended:
            mended = translate("Trabecula", "faulty rods are being mended …")
        self.details.setText(f"{plain}, {mended}" if mended else plain)
        self._say("\n".join(in_words(warning) for warning in estimate.warnings), ORANGE)

    def show_error(self, text: str) -> None:
        """Say why there is no preview."""
        self.headline.setText(f"<b>{translate('Trabecula', 'No preview')}</b>")
        self.details.hide()
        self._outline = None
        self._say(in_words(text), RED)

    def _say(self, text: str, colour: str) -> None:
        lines = escape(text).replace("\n", "<br>")
        self.message.setText(f'<span style="color:{word_colour(colour)}">{lines}</span>')
        self.message.setVisible(bool(text))


def porosity_text(estimate: Estimate) -> str:
    """Return a porosity in percent with as many digits as its error leaves.

    Examples
    --------
    >>> porosity_text(Estimate(0.3612, 0.0004, 0.5, ()))
    '36.12 ± 0.04'
    """
    digits = 2 if estimate.error < 1e-3 else 1
    form, error = f".{digits}f", max(100 * estimate.error, 10**-digits)
    return f"{local_number(100 * estimate.porosity, form)} ± {local_number(error, form)}"


def mended_text(outline: Outline) -> str:
    """Return what happened to faulty rods, in a few words; empty if there were none."""
    parts = (
        (outline.mended, translate("Trabecula", "{} mended")),
        (outline.failed, translate("Trabecula", "{} left out")),
        (outline.outside, translate("Trabecula", "{} leave the envelope")),
    )
    return ", ".join(text.format(count) for count, text in parts if count)
