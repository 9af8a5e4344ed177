# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tests in a window of another language share: texts of menus, labels, tooltips."""

import FreeCADGui
from PySide import QtGui


def command_texts(name):
    """Return text and tooltip of one of our commands as menu and toolbar show them."""
    action = FreeCADGui.Command.get(name).getAction()[0]
    return action.text().replace("&", ""), action.toolTip()


def label_texts(widget):
    """Return the texts of the labels, buttons and switches in a widget."""
    kinds = (QtGui.QLabel, QtGui.QAbstractButton)
    return [one.text() for kind in kinds for one in widget.findChildren(kind) if one.text()]


def choices_of(box):
    """Return the words that a combo box shows."""
    return [box.itemText(k) for k in range(box.count())]
