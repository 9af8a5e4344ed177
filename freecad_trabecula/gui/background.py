# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work for documents that goes on without a panel: the status bar shows how far it is and can end it."""

from __future__ import annotations

from typing import Any, Callable, Dict, List

import FreeCAD

from ..errors import ParameterError, TrabeculaError
from .document_work import DocumentWork, Listener, ObjectWork, Order
from .notice import tell_of
from .recomputing import WorkBar, document_label
from .transactions import told

translate = FreeCAD.Qt.translate


class Background:
    """The works that go on without a panel, each with its bar; they end with their documents."""

    def __init__(self) -> None:
        self._bars: Dict[DocumentWork, WorkBar] = {}
        FreeCAD.addDocumentObserver(self)

    def take(self, work: DocumentWork, show: Callable[[Any], None], estimate: str = "") -> None:
        """Take a work over.

        Parameters
        ----------
        work : DocumentWork
        show : callable
            Shows the object that was made or changed, if its document is the active one by then.
        estimate : str
            What it will take.
        """
        bar = WorkBar(lambda: self.cancel(work), document_label(work.document))
        self._bars[work] = bar
        work.is_left = True
        work.listener = Listener(
            bar.show_progress, lambda obj: self._done(work, obj, show), lambda error: self._failed(work, error)
        )
        bar.show_start(estimate)

    def cancel(self, work: DocumentWork) -> None:
        """End a work; the document is as it was."""
        self.drop(work)
        work.cancel()

    def drop(self, work: DocumentWork) -> None:
        """Have nothing to do with a work any more."""
        self._bars.pop(work).close_bar()

    def works(self, document: str = "") -> List[DocumentWork]:
        """Return the works that go on, for one document or for all."""
        return [work for work in self._bars if document in ("", work.document)]

    def _done(self, work: DocumentWork, obj: Any, show: Callable[[Any], None]) -> None:
        self.drop(work)
        tell_of(work.document, obj.Name, True)
        if FreeCAD.ActiveDocument is not None and FreeCAD.ActiveDocument.Name == work.document:
            show(obj)

    def _failed(self, work: DocumentWork, error: TrabeculaError) -> None:
        self.drop(work)
        tell_of(work.document, "", False)
        with told():
            raise error

    # ------------------------------------------------------------------------------------------ FreeCAD's observer

    def slotDeletedDocument(self, document: Any) -> None:
        """End what belongs to a document that is closed (FreeCAD's observer protocol)."""
        for work in self.works(document.Name):
            self.cancel(work)


_background: List[Background] = []


def of_window() -> Background:
    """Return the window's one, made when it is first asked for."""
    if not _background:
        _background.append(Background())
    return _background[0]


def work_at_once(order: Order, show: Callable[[Any], None], estimate: str = "") -> None:
    """Do what was asked for with one click; the status bar shows what it will take, how far it is, and can end it.

    Raises
    ------
    TrabeculaError
        If the object that is to be changed is being computed, or the work cannot be started.
    """
    sentence = why_not(order.document, order.changed)
    if sentence:
        raise ParameterError(sentence)
    work = ObjectWork(order, Listener(lambda _: None, lambda _: None, lambda _: None))
    of_window().take(work, show, estimate)
    try:
        work.start()
    except TrabeculaError:
        of_window().drop(work)
        raise


def is_busy(document: str = "", kind: str = "") -> bool:
    """Return whether something goes on without a panel: in one document or in any, of one kind of result or of any."""
    return any(kind in ("", work.kind) for work in of_window().works(document))


def why_not(document: str, name: str) -> str:
    """Return why an object cannot be changed now, in a sentence; empty if it can."""
    if not name or all(work.changed != name for work in of_window().works(document)):
        return ""
    label = FreeCAD.getDocument(document).getObject(name).Label
    return translate("Trabecula", "{} is being computed: the status bar shows how far it is").format(label)
