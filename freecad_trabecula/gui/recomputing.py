# SPDX-License-Identifier: LGPL-2.1-or-later
"""What would keep the window waiting during a recompute is computed in another process and shown when it is there.

The objects say "being computed" meanwhile and keep what they had; the status bar shows how far it is and can end it.
"""

from __future__ import annotations

from contextlib import nullcontext
from typing import Any, Dict, List, Optional, Tuple

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .. import make
from ..errors import TrabeculaError
from ..features.analysis import Analysis
from ..features.estimates import work_of
from ..features.feature import is_a
from ..features.jobs import job_of
from ..features.on_demand import COMPUTING, OUT_OF_DATE, Keyed
from ..features.relations import wireframe_of
from ..features.voxel_design import VoxelDesign
from .child_work import ChildWork, Progress, progress_text, start_task
from .notice import tell_of
from .qt import invoke_later
from .transactions import transaction
from .work_text import work_text

translate = FreeCAD.Qt.translate
_TURN = 50  # ms until a result that waits looks whether it is its turn
Owner = Tuple[str, str]  # names of document and wireframe, or analysis, or voxel design


class Recomputing(QtCore.QObject):
    """Takes over objects; those of one design are computed together, and anew when its inputs change."""

    def __init__(self) -> None:
        super().__init__()
        self._wanted: Dict[Owner, Dict[str, str]] = {}
        self._works: Dict[Owner, ChildWork] = {}
        self._failed: Dict[Tuple[str, str], Tuple[str, str]] = {}  # key and sentence, by names of document and object
        self._bars: Dict[Owner, WorkBar] = {}
        self._steps: Dict[Owner, str] = {}  # names of the steps to undo that results become, where they are asked for
        FreeCAD.addDocumentObserver(self)

    def take(self, obj: Any, key: str, step: str = "") -> bool:
        """Have an object computed elsewhere.

        Parameters
        ----------
        obj : document object
        key : str
            Of its inputs.
        step : str
            Name of the step to undo that the result becomes; none: it belongs to the step that changed the inputs.

        Returns
        -------
        bool
            False if it cannot be handed over.

        Raises
        ------
        TrabeculaError
            What another process said of the same inputs; the next time it is tried again.
        """
        failed_key, text = self._failed.pop((obj.Document.Name, obj.Name), ("", ""))
        if failed_key == key:
            raise TrabeculaError(text)
        try:
            alone = is_a(obj, Analysis, VoxelDesign)
            if not alone:
                job_of(wireframe_of(obj), envelope="envelope")
            owner = (obj.Document.Name, (obj if alone else wireframe_of(obj)).Name)
        except (TrabeculaError, AttributeError):  # of no design, or of one that no job can hold
            return False
        if step:
            self._steps[owner] = step
        names = self._wanted.setdefault(owner, {})
        if names.get(obj.Name) != key:
            names[obj.Name] = key
            self._end(owner)
            invoke_later(lambda: self._start(owner))
        return True

    # -------------------------------------------------------------------------------------------------- the work

    def _start(self, owner: Owner) -> None:
        objects = self._objects(owner)
        if owner in self._works or not objects:
            return
        bar = WorkBar(lambda: self.cancel(owner), document_label(owner[0]))
        try:
            work = start_task(
                lambda folder: make.write_task(folder, objects),
                bar.show_progress,
                lambda folder: self._take(owner, folder),
                lambda text: self._fail(owner, text),
            )
        except TrabeculaError as error:
            bar.close_bar()
            self._fail(owner, str(error))
            return
        self._works[owner], self._bars[owner] = work, bar
        bar.show_start(_estimate(objects))

    def _objects(self, owner: Owner) -> List[Any]:
        """Those that wait: one alone, or a wireframe, which stands for its sites, and bodies made of it."""
        if owner[0] not in FreeCAD.listDocuments():
            return []
        document = FreeCAD.getDocument(owner[0])
        found = [document.getObject(name) for name in self._wanted.get(owner, ())]
        wireframe = document.getObject(owner[1])
        bodies = [one for one in found if one is not None and getattr(one, "Wireframe", None) == wireframe]
        return [wireframe, *bodies] if found and wireframe is not None else []

    def _take(self, owner: Owner, folder: str) -> None:
        try:
            make.take_results(folder)
        except TrabeculaError as error:
            self._fail(owner, str(error))
            return
        invoke_later(lambda: self._recompute(owner))  # between reading and showing the window has its turn

    def _fail(self, owner: Owner, text: str) -> None:
        for name, key in self._wanted.get(owner, {}).items():
            self._failed[owner[0], name] = key, text
        self._recompute(owner)

    def _recompute(self, owner: Owner) -> None:
        if owner in self._steps and FreeCAD.getActiveTransaction() is not None:  # one more would cut it in two
            invoke_later(lambda: self._recompute(owner), _TURN)
            return
        names, step = self._wanted.pop(owner, {}), self._steps.pop(owner, "")
        self._end(owner)
        if owner[0] in FreeCAD.listDocuments():
            document = FreeCAD.getDocument(owner[0])
            with transaction(document, step) if step else nullcontext():
                for obj in filter(None, map(document.getObject, names)):
                    obj.touch()
                document.recompute()
            done = [obj for obj in map(document.getObject, names) if obj is not None]
            if done:
                tell_of(owner[0], done[0].Name, all(obj.isValid() for obj in done))

    def _end(self, owner: Owner) -> None:
        work = self._works.pop(owner, None)
        if work is not None:
            work.cancel()
            self._bars.pop(owner).close_bar()

    def _forget(self, owner: Owner) -> None:
        del self._wanted[owner]
        self._steps.pop(owner, None)
        self._end(owner)

    def bars(self) -> List[WorkBar]:
        """Return the bars of the works that go on, one for each design."""
        return list(self._bars.values())

    def cancel(self, only: Optional[Owner] = None) -> None:
        """End the work of one design, or all; the objects keep what they had and are out of date."""
        for owner, names in list(self._wanted.items()):
            if only not in (None, owner):
                continue
            self._forget(owner)
            if owner[0] in FreeCAD.listDocuments():
                document = FreeCAD.getDocument(owner[0])
                for obj in filter(None, map(document.getObject, names)):
                    obj.Status = obj.Status.replace(COMPUTING, OUT_OF_DATE)

    # ------------------------------------------------------------------------------------------ FreeCAD's observer

    def slotDeletedDocument(self, document: Any) -> None:
        """End what belongs to a document that is closed (FreeCAD's observer protocol)."""
        for owner in [one for one in self._wanted if one[0] == document.Name]:
            self._forget(owner)

    def slotUndoDocument(self, document: Any) -> None:
        """Show what belongs to the inputs that have come back (FreeCAD's observer protocol)."""
        name = document.Name
        invoke_later(lambda: _show_present(name))

    def slotRedoDocument(self, document: Any) -> None:
        """Do the same for a step done again (FreeCAD's observer protocol)."""
        self.slotUndoDocument(document)


def _estimate(objects: List[Any]) -> str:
    """What the computing of objects will take; empty where it is little, or not known."""
    try:
        return work_text(work_of(objects))
    except TrabeculaError:  # it will say itself what is missing
        return ""


def _show_present(name: str) -> None:
    """Recompute the objects of a document whose results came after the step that was undone."""
    if name not in FreeCAD.listDocuments():
        return
    document, late = FreeCAD.getDocument(name), []
    for obj in document.Objects:
        proxy = getattr(obj, "Proxy", None)
        try:
            if isinstance(proxy, Keyed) and obj.ResultKey and obj.ResultKey != proxy.key(obj):
                if OUT_OF_DATE in obj.Status:
                    obj.purgeTouched()  # so it was before the step, and stays until it is updated
                else:
                    late.append(obj)
        except (TrabeculaError, AttributeError):
            continue  # without envelope or design
    for obj in late:
        obj.touch()
    if late:
        document.recompute()


class WorkBar(QtGui.QWidget):
    """What is being done, a bar, and a button that ends it, in the status bar.

    Parameters
    ----------
    cancel : callable
        Called by the button.
    name : str
        Of the document; it is said while several are open.
    """

    def __init__(self, cancel: Any, name: str = "") -> None:
        super().__init__()
        self._name, self._estimate = name, ""
        self.what, self.bar, self.button = QtGui.QLabel(), QtGui.QProgressBar(), QtGui.QToolButton()
        self.bar.setRange(0, 1000)
        self.bar.setTextVisible(False)
        self.bar.setFixedSize(120, 14)
        self.button.setText(translate("Trabecula", "Cancel"))
        self.button.clicked.connect(lambda *_: cancel())
        row = QtGui.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        for widget in (self.what, self.bar, self.button):
            row.addWidget(widget)
        FreeCADGui.getMainWindow().statusBar().addPermanentWidget(self)
        self.hide()

    def show_start(self, estimate: str = "") -> None:
        """Show that work has begun, and what it will take, until the time left is known."""
        self._estimate = f" ({estimate})" if estimate else ""
        self.bar.setValue(0)
        self.what.setText(translate("Trabecula", "being computed") + self._estimate)
        self.show()

    def show_progress(self, progress: Progress) -> None:
        """Show how far it is."""
        self.bar.setValue(int(1000 * progress.share))
        text = progress_text(progress) + (self._estimate if progress.left is None else "")
        several = self._name and len(FreeCAD.listDocuments()) > 1
        self.what.setText(f"{self._name}: {text}" if several else text)

    def close_bar(self) -> None:
        """Take it out of the status bar."""
        self.hide()
        FreeCADGui.getMainWindow().statusBar().removeWidget(self)
        self.deleteLater()


def document_label(name: str) -> str:
    """Return what a document is called in the window; empty if it is not open any more."""
    return FreeCAD.getDocument(name).Label if name in FreeCAD.listDocuments() else ""


_recomputing: List[Recomputing] = []


def of_window() -> Recomputing:
    """Return the window's one, made when it is first asked for."""
    if not _recomputing:
        _recomputing.append(Recomputing())
    return _recomputing[0]
