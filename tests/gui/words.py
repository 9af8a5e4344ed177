# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tests in a window of another language share: texts of menus, labels, tooltips."""

import FreeCADGui
from PySide import QtGui


def menu_texts():
    """Return the texts of our menu's entries and of its submenus', without mnemonics."""
    bar = FreeCADGui.getMainWindow().menuBar()
    menus = [action.menu() for action in bar.actions() if action.text().replace("&", "") == "Trabecula"]
    entries = [entry for menu in menus for entry in menu.actions()]
    entries += [entry for one in entries if one.menu() for entry in one.menu().actions()]
    return [entry.text().replace("&", "") for entry in entries if entry.text()]


def label_texts(widget):
    """Return the texts of the labels, buttons and switches in a widget."""
    kinds = (QtGui.QLabel, QtGui.QAbstractButton)
    return [one.text() for kind in kinds for one in widget.findChildren(kind) if one.text()]


def choices_of(box):
    """Return the words that a combo box shows."""
    return [box.itemText(k) for k in range(box.count())]
