# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rods that failed and were left out, in a 3D view: broken lines between their pores' centres, not picked."""

from __future__ import annotations

import numpy as np
from pivy import coin

from ..core.rod_colours import FAILED, OUTCOMES

_WIDTH, _BROKEN = 3.0, 0xF8F8  # pixels; pattern of 16 bits


class LostRods:
    """A node for a scene; what it shows can be changed."""

    def __init__(self) -> None:
        self.node = coin.SoSwitch()
        unpickable, light, colour, style = (
            coin.SoPickStyle(),
            coin.SoLightModel(),
            coin.SoBaseColor(),
            coin.SoDrawStyle(),
        )
        unpickable.style = coin.SoPickStyle.UNPICKABLE
        light.model = coin.SoLightModel.BASE_COLOR
        colour.rgb = tuple(one / 255.0 for one in OUTCOMES[FAILED])
        style.lineWidth, style.linePattern = _WIDTH, _BROKEN
        self._ends, self._lines = coin.SoCoordinate3(), coin.SoLineSet()
        whole = coin.SoSeparator()
        for child in (unpickable, light, colour, style, self._ends, self._lines):
            whole.addChild(child)
        self.node.addChild(whole)

    def take(self, lines: np.ndarray) -> None:
        """Take lines (F, 2, 3), mm, in place of those before."""
        self._ends.point.setNum(2 * len(lines))
        self._lines.numVertices.setNum(len(lines))
        if len(lines):
            self._ends.point.setValues(0, 2 * len(lines), np.reshape(lines, (-1, 3)).tolist())
            self._lines.numVertices.setValues(0, len(lines), [2] * len(lines))

    def set_visible(self, visible: bool) -> None:
        """Show or hide them, if there are any."""
        shown = visible and self._lines.numVertices.getNum() > 0
        self.node.whichChild = coin.SO_SWITCH_ALL if shown else coin.SO_SWITCH_NONE
