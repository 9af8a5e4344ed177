# SPDX-License-Identifier: LGPL-2.1-or-later
"""A task panel whose work another process does, and which stays open for more."""

from __future__ import annotations

from html import escape
from typing import Any, Callable, Optional, Tuple

import FreeCAD
import FreeCADGui
from PySide import QtGui

from ..errors import TrabeculaError
from .build_bar import BuildBar
from .document_work import DocumentWork, Order
from .language import in_words
from .notice import tell_of
from .outcome import RED
from .qt import Buttons, PanelForm, flags_of, invoke_later, widen_dock
from .transactions import told

WIDTH = 400  # pixels that the form needs


class WorkPanel:
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

    def __init__(
        self,
        document: Any,
        obj: Any,
        source: Any,
        fields: Any,
        words: Tuple[str, str, str, str],
        show: Callable[[Any], None],
    ) -> None:
        self.document, self.obj, self.fields, self._show = document, obj, fields, show
        self._name, self._open, self._closes = document.Name, True, False
        self._work: Optional[DocumentWork] = None
        self.message = QtGui.QLabel()
        self.message.setWordWrap(True)
        title, button, picture, page = words
        self.build_bar = BuildBar((), self.work, self.cancel, button, picture)
        self.form = PanelForm(title, picture, page)
        column = QtGui.QVBoxLayout(self.form)
        column.setContentsMargins(6, 4, 6, 4)
        column.setSpacing(4)
        for widget in (self.fields, self.message, self.build_bar):
            column.addWidget(widget)
        self.fill(source)
        FreeCAD.addDocumentObserver(self)
        invoke_later(lambda: widen_dock(self.form, WIDTH))

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
        self.message.setText(f'<span style="color:{RED}">{escape(in_words(str(error)))}</span>')

    # ------------------------------------------------------------------------------------------------------ the work

    def work(self) -> None:
        """Have it done in another process; the panel stays open."""
        with told():
            self._start(False)

    def _start(self, closes: bool) -> None:
        if self._work is not None:
            return
        self._closes = closes
        work = DocumentWork(self.order(), self.build_bar.show_progress, self._done, self._refused)
        self._work = work
        self._set_working(True)
        try:
            work.start()
        except TrabeculaError:
            self._end_work()
            raise

    def cancel(self) -> None:
        """Stop the work; the document is as it was."""
        if self._work is not None:
            self._work.cancel()
            self._end_work()

    def _end_work(self) -> None:
        self._work = None
        if self._open:
            self._set_working(False)

    def _set_working(self, working: bool) -> None:
        (self.build_bar.show_working if working else self.build_bar.show_idle)()
        self.fields.setEnabled(not working)

    def _done(self, obj: Any) -> None:
        self._end_work()
        self.obj = obj
        if self._open:
            self.lock_source(True)
            self.message.setText(in_words(obj.Status))
        tell_of(self._name, obj.Name, True)
        self._show(obj)
        if self._closes and self._open:
            self._leave()
            FreeCADGui.Control.closeDialog()

    def _refused(self, error: TrabeculaError) -> None:
        self._end_work()
        tell_of(self._name, "", False)
        if self._open:
            self.refuse(error)
        with told():
            raise error

    # ---------------------------------------------------------------------------------------------------- task panel

    def getStandardButtons(self) -> Any:
        """Return the buttons above the form."""
        return flags_of(Buttons.Ok, Buttons.Cancel)

    def accept(self) -> bool:
        """Do the work, then close."""
        with told():
            self._start(True)
        return False

    def reject(self) -> bool:
        """Close the panel; what was made stays."""
        self.cancel()
        self._leave()
        FreeCADGui.Control.closeDialog()
        return True

    def slotDeletedDocument(self, document: Any) -> None:
        """Close the panel when its document is closed (FreeCAD's observer protocol)."""
        if self._open and document.Name == self._name:
            self._leave()
            self.cancel()
            invoke_later(FreeCADGui.Control.closeDialog)

    def slotDeletedObject(self, obj: Any) -> None:
        """Begin anew when the object goes, by undo for instance (FreeCAD's observer protocol)."""
        if self._open and self.obj is not None and obj == self.obj:
            self.obj = None
            self.lock_source(False)

    def _leave(self) -> None:
        if self._open:
            self._open = False
            FreeCAD.removeDocumentObserver(self)
