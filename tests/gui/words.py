# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tests in a window of another language share: texts of menus, labels, tooltips."""

import re

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


#: Small words of English that no other language of the window has.
_ENGLISH = re.compile(
    r"\b(the|of|by|and|that|with|over|their|its|which|is|are|from|less|not|than|them|when|has|have|must|all|one|two)\b"
)
_AUTHORS = re.compile(r"[A-Z]\w+ and [A-Z]\w+(?= \d{4})")


def english_in(text):
    """Return the first small word of English in a text, nothing if there is none; authors may be joined by one."""
    found = _ENGLISH.search(_AUTHORS.sub("", text))
    return found[0] if found else ""
