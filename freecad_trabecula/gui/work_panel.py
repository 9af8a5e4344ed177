# SPDX-License-Identifier: LGPL-2.1-or-later
"""A task panel whose work another process does, and which stays open for more."""

from __future__ import annotations

from html import escape
from typing import Any, Callable, Optional, Tuple

from PySide import QtGui

from ..errors import TrabeculaError
from . import background
from .build_bar import BuildBar
from .document_work import Listener, ObjectWork, Order
from .language import in_words
from .notice import tell_of
from .outcome import RED
from .qt import Buttons, PanelForm, word_colour
from .task_panels import DocumentPanel, while_open
from .transactions import told

WIDTH = 400  # pixels that the form needs


class WorkPanel(DocumentPanel):
    """Base of panels that make or change one object: fields, what is to be said, a button, a bar.

    Parameters
    ----------
    document : App.Document
    obj : document object or None
        What is to be changed; None means a new one.
    source : document object or None
        What a new one is made of at first.
    fields : QWidget
    words : tuple of str
        Title, text of the button, icon, page of the help.
    show : callable
        Shows what was made or changed.
    """

    BUTTONS = (Buttons.Ok, Buttons.Cancel)

    def __init__(
        self,
        document: Any,
        obj: Any,
        source: Any,
        fields: Any,
        words: Tuple[str, str, str, str],
        show: Callable[[Any], None],
    ) -> None:
        super().__init__(document, WIDTH)
        self.obj, self.fields, self._show, self._closes = obj, fields, show, False
        self._work: Optional[ObjectWork] = None
        self.message = QtGui.QLabel()
        self.message.setWordWrap(True)
        title, button, picture, page = words
        self.build_bar = BuildBar((), self.work, self.cancel, button, picture, self.leave)
        self.form = PanelForm(title, picture, page)
        column = QtGui.QVBoxLayout(self.form)
        column.setContentsMargins(6, 4, 6, 4)
        column.setSpacing(4)
        for widget in (self.fields, self.message, self.build_bar):
            column.addWidget(widget)
        self.fill(source)
        self.begin()

    def fill(self, source: Any) -> None:
        """Show the values of the object, or those of a new one of a source."""
        raise NotImplementedError

    def order(self) -> Order:
        """Return what is to be done.

        Raises
        ------
        TrabeculaError
            If a rule is broken.
        """
        raise NotImplementedError

    def lock_source(self, locked: bool) -> None:
        """Forbid to choose another source while there is an object."""

    def refuse(self, error: TrabeculaError) -> None:
        """Show what is wrong."""
        self.message.setText(f'<span style="color:{word_colour(RED)}">{escape(in_words(str(error)))}</span>')

    # ------------------------------------------------------------------------------------------------------ the work

    def work(self) -> None:
        """Have it done in another process; the panel stays open."""
        with told():
            self._start(False)

    def _start(self, closes: bool) -> None:
        if self._work is not None:
            return
        self._closes = closes
        work = ObjectWork(self.order(), Listener(self.build_bar.show_progress, self._done, self._refused))
        self._work = work
        self._set_working(True)
        try:
            work.start()
        except TrabeculaError:
            self._end_work()
            raise

    def leave(self) -> None:
        """Close the panel while the work goes on in the status bar."""
        if self._work is not None:
            background.of_window().take(self._work, self._show)
            self._work = None
            self.close()

    def cancel(self) -> None:
        """Stop the work; the document is as it was."""
        if self._work is not None:
            self._work.cancel()
            self._end_work()

    def _end_work(self) -> None:
        self._work = None
        if self.is_open:
            self._set_working(False)

    def _set_working(self, working: bool) -> None:
        (self.build_bar.show_working if working else self.build_bar.show_idle)()
        self.fields.setEnabled(not working)

    def _done(self, obj: Any) -> None:
        self._end_work()
        self.obj = obj
        if self.is_open:
            self.lock_source(True)
            self.message.setText(in_words(obj.Status))
        tell_of(self.document_name, obj.Name, True)
        self._show(obj)
        if self._closes and self.is_open:
            self.close()

    def _refused(self, error: TrabeculaError) -> None:
        self._end_work()
        tell_of(self.document_name, "", False)
        if self.is_open:
            self.refuse(error)
        with told():
            raise error

    # ---------------------------------------------------------------------------------------------------- task panel

    def accept(self) -> bool:
        """Do the work, then close; while it is done the panel closes and the status bar takes over."""
        if self._work is not None:
            self.leave()
            return False
        with told():
            self._start(True)
        return False

    def let_go(self, has_document: bool) -> None:
        """Stop the work; what was made stays."""
        self.cancel()

    @while_open
    def slotDeletedObject(self, obj: Any) -> None:
        """Begin anew when the object goes, by undo for instance (FreeCAD's observer protocol)."""
        if self.obj is not None and obj == self.obj:
            self.cancel()
            self.obj = None
            self.lock_source(False)
