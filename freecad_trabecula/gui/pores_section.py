# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part of the design panel for pores (thesis 2.4.1, 2.4.2)."""

from __future__ import annotations

import FreeCAD

from ..core.laws import Law
from ..core.parameters import PoreParameters
from .fields import Changed
from .form import Form
from .language import choice, local_number

translate = FreeCAD.Qt.translate


class PoresSection(Form):
    """Layout, size and shape of the pores."""

    def __init__(self, changed: Changed) -> None:
        rows = (
            ("layout", translate("Trabecula", "Layout"), 1.0),
            ("size", translate("Trabecula", "Size"), 0.05),
            ("sections", translate("Trabecula", "Sections"), 1.0),
            ("corners", translate("Trabecula", "Corners"), 1.0),
            ("turn", translate("Trabecula", "Tangents"), 0.1),
            ("pull", translate("Trabecula", "Pull"), 0.1),
            ("scatter", translate("Trabecula", "Scatter"), 0.05),
        )
        super().__init__(PoreParameters, rows, changed)
        self.fields["layout"].widget.currentIndexChanged.connect(lambda *_: self._show_rows())

    def _show_rows(self) -> None:
        spline = self.fields["layout"].value() == "spline"
        for name in ("corners", "turn", "pull", "scatter"):
            self.show_row(name, spline)

    def set_value(self, parameters: PoreParameters) -> None:
        """Show the parameters."""
        super().set_value(parameters)
        self._show_rows()


def pores_summary(pores: PoreParameters) -> str:
    """Return one line about pores."""
    sections = translate("Trabecula", "1 section") if pores.sections == 1 else translate("Trabecula", "2 sections")
    return f"{choice(pores.layout)}, {law_text(pores.size)} mm, {sections}"


def law_text(law: Law) -> str:
    """Return a law in a few characters."""
    if law.kind == "constant":
        return local_number(law.low)
    if law.kind == "expression":
        return law.expression
    kind = "" if law.kind == "uniform" else choice(law.kind) + " "
    return f"{kind}{local_number(law.low)}–{local_number(law.high)}"
