# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tests in a window of another language share: texts of menus, labels, tooltips."""

import FreeCADGui
from PySide import QtGui


def menu_texts():
    """Return the texts of our menu's entries, without mnemonics."""
    bar = FreeCADGui.getMainWindow().menuBar()
    menus = [action for action in bar.actions() if action.text().replace("&", "") == "Trabecula"]
    return [entry.text().replace("&", "") for action in menus for entry in action.menu().actions() if entry.text()]


def label_texts(widget):
    """Return the texts of the labels, buttons and switches in a widget."""
    kinds = (QtGui.QLabel, QtGui.QAbstractButton)
    return [one.text() for kind in kinds for one in widget.findChildren(kind) if one.text()]


def choices_of(box):
    """Return the words that a combo box shows."""
    return [box.itemText(k) for k in range(box.count())]
