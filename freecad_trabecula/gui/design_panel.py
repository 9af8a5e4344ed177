# SPDX-License-Identifier: LGPL-2.1-or-later
"""The design panel: its form, the live preview, picking, and what is made of it in the end."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Tuple, Union

import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from .. import make
from ..core.job import Job
from ..core.presets import preset
from ..errors import TrabeculaError
from ..features.containers import frame_of
from ..features.relations import products_of
from . import background
from .build_bar import BuildBar
from .building import MAKERS, Building, Target, Writing
from .design_envelope import DesignEnvelope
from .design_form import IN_DOCUMENT, Callbacks, DesignForm
from .document_work import Listener
from .notice import tell_of
from .outcome import Outcome
from .picking import FacePicker
from .preview import Preview
from .preview_worker import Estimate, Outline, PreviewWorker, Request
from .qt import Buttons, PanelForm, invoke_later
from .results_panel import open_results
from .task_panels import DocumentPanel, while_open
from .transactions import told
from .transparency import ClearView

translate = FreeCAD.Qt.translate
WIDTH = 400  # pixels that the form needs
DRAG_PAUSE = 30  # ms from a change to its preview: a burst of signals is one change


class DesignPanel(DocumentPanel):
    """A task panel on one document.

    Parameters
    ----------
    document : App.Document
    job : Job
    envelope : document object or None
        None means a new prism.
    wireframe : document object or None
        The design that is to be changed; None means a new one.
    """

    BUTTONS = (Buttons.Ok, Buttons.Cancel)

    def __init__(self, document: Any, job: Job, envelope: Any = None, wireframe: Any = None) -> None:
        super().__init__(document, WIDTH)
        self.wireframe = wireframe
        self.body = DesignEnvelope(document, envelope, wireframe is not None, self._envelope_ready, self._refuse)
        self._is_kept = False
        self._building: Union[Building, Writing, None] = None
        self._wanted: Optional[Job] = None
        self._drawn: Optional[Job] = None
        self._seen = False
        self.picker, self._clear_view = FacePicker(self._picked), ClearView()
        self._origin_wanted = False
        self.fields = DesignForm(
            Callbacks(self._changed, self._take_preset, self._take_envelope, self._pick_faces, self._pick_origin)
        )
        self.outcome = Outcome(self._show_parts)
        self.build_bar = BuildBar(self._kinds(), self.build, self.cancel, leave=self.leave)
        self.form = self._make_form()
        self.preview = Preview(view_of(document))
        self.worker = PreviewWorker()
        self.worker.drawn.connect(self._show_outline)
        self.worker.estimated.connect(self._show_estimate)
        self.worker.refused.connect(self._refuse)
        self._pause = QtCore.QTimer()
        self._pause.setSingleShot(True)
        self._pause.setInterval(DRAG_PAUSE)
        self._pause.timeout.connect(self._request)
        self.begin()
        self.fields.set_envelopes(self.body.offered(), envelope.Name if envelope else "", self.body.is_fixed)
        if envelope is None:
            self.set_job(job)
        else:
            self.fields.set_job(job)
            self.body.begin()

    def _make_form(self) -> Any:
        form = PanelForm(translate("Trabecula", "Design rods"), "Trabecula_design", "commands/Design.md")
        column = QtGui.QVBoxLayout(form)
        column.setContentsMargins(6, 4, 6, 4)
        column.setSpacing(4)
        for widget in (self.fields.head, self.outcome, self.build_bar, self.fields.sections):
            column.addWidget(widget)
        return form

    def _kinds(self) -> Sequence[Tuple[str, str, bool]]:
        """Bodies that can be built, those chosen that the design has already."""
        there = {one.Proxy.KIND for one in products_of(self.wireframe)} if self.wireframe else {"scaffold"}
        texts = {
            "network": translate("Trabecula", "Rods"),
            "scaffold": translate("Trabecula", "Scaffold"),
            "solid": translate("Trabecula", "STEP scaffold"),
        }
        return [(kind, text, kind in there) for kind, text in texts.items() if hasattr(make, MAKERS[kind])]

    # ------------------------------------------------------------------------------------------------- the envelope

    @property
    def envelope(self) -> Any:
        """The object to be filled; None for a new prism."""
        return self.body.obj

    @while_open
    def _take_envelope(self, name: str) -> None:
        self.picker.stop()
        self.outcome.show_busy(translate("Trabecula", "Checking the envelope …"))
        with told():
            self.body.choose(name)

    @while_open
    def _envelope_ready(self) -> None:
        self.fields.set_envelopes(self.body.offered(), self.envelope.Name if self.envelope else "", self.body.is_fixed)
        if self.wireframe is None:
            self._take_edges()
        self.fields.prism.allow_edges(self.envelope is None or self.wireframe is not None)
        self._clear_view.apply(self.envelope, self._hidden())
        self.preview.place(frame_of(self.envelope))
        self._show_parts()
        self._seen = False
        self._changed()
        self._invite()

    def _take_edges(self) -> None:
        if self.envelope is not None and self.envelope.TypeId == "Part::Box":
            edges = (self.envelope.Length.Value, self.envelope.Width.Value, self.envelope.Height.Value)
            self.fields.prism.set_edges(edges)

    def _invite(self) -> None:
        """Let faces of a new design's envelope be picked at once: without them there is nothing to be seen."""
        is_bare = self.wireframe is None and self.envelope is not None and not self.fields.labels()
        if is_bare and not self.fields.faces.pick_button.isChecked():
            self.fields.faces.pick_button.setChecked(True)

    @while_open
    def _refuse(self, text: str) -> None:
        self.outcome.show_error(text)

    def _hidden(self) -> Sequence[Any]:
        """What the preview stands for: the design's own objects."""
        return [self.wireframe, *self.wireframe.Sites, *products_of(self.wireframe)] if self.wireframe else []

    def _take_preset(self, name: str) -> None:
        with told():
            self.set_job(preset(name))

    def set_job(self, job: Job) -> None:
        """Show a job; if it has a file, that becomes the envelope.

        Raises
        ------
        DependencyError
            If the file cannot be read because FreeCAD's console program is not found.
        """
        self.fields.set_job(job)
        if job.envelope and job.envelope != IN_DOCUMENT and not self.body.is_fixed:
            self.outcome.show_busy(translate("Trabecula", "Reading the envelope …"))
            self.body.load(job.envelope, job.solid)
        elif job.prism is not None and not self.body.is_fixed:
            self._take_envelope("")
        else:
            self.body.begin()

    # -------------------------------------------------------------------------------------------------- the preview

    def _changed(self) -> None:
        if not self._pause.isActive():  # started anew by each change it would never end while a value is dragged
            self._pause.start()

    @while_open
    def _request(self) -> None:
        if not self.body.is_ready:
            return
        try:
            job = self.fields.job()
        except TrabeculaError as error:
            self.outcome.show_error(str(error))
            return
        self._wanted = job
        self.fields.show_summaries(job)
        self.outcome.show_busy()
        self.worker.request(Request(job, self.body.solid(job)))

    @while_open
    def _show_outline(self, outline: Outline) -> None:
        if not self._seen:
            self._first_look()
        self._drawn = outline.job
        self.preview.show(outline.drawing)
        self.fields.show_counts(outline.rows, outline.counts)
        self.outcome.show_outline(outline)

    def _first_look(self) -> None:
        """Turn the view of an empty document to the preview."""
        self._seen = True
        view = view_of(self.document)
        if len(self.document.Objects) <= 1:
            view.viewIsometric()
        invoke_later(lambda: self._fit(view))  # once the drawing is in the scene

    @while_open
    def _fit(self, view: Any) -> None:
        view.fitAll()

    @while_open
    def _show_estimate(self, estimate: Estimate) -> None:
        self.outcome.show_estimate(estimate)
        self.build_bar.show_estimate(estimate.work)

    @while_open
    def _show_parts(self) -> None:
        if hasattr(self, "preview"):
            self.preview.set_visible(box=self.envelope is None, **self.outcome.shown())
            self.preview.set_colouring(self.outcome.colouring.value())
            self.outcome.show_legend()

    # ---------------------------------------------------------------------------------------------------- picking

    def _pick_faces(self, start: bool) -> None:
        self._origin_wanted = False
        if start and self.envelope is not None:
            self.picker.start(self.envelope)
        else:
            self.picker.stop()

    def _pick_origin(self) -> None:
        if self.envelope is not None:
            self._origin_wanted = True
            self.picker.start(self.envelope)

    def _picked(self, face: str, point: Tuple[float, float, float]) -> None:
        if self._origin_wanted:
            self.fields.faces.set_origin(face, point)
            self._origin_wanted = False
            if not self.fields.faces.pick_button.isChecked():
                invoke_later(self.picker.stop)
        else:
            self.fields.faces.toggle(face)
        # the same face can be clicked again only when it is not selected any more; not inside its own notification
        invoke_later(FreeCADGui.Selection.clearSelection)

    # ----------------------------------------------------------------------------------------------- task panel

    def accept(self) -> bool:
        """Keep the design; bodies that it has already are brought up to date in another process first.

        While it is built the panel closes and the status bar takes over.
        """
        if self._building is not None:
            self.leave()
            return False
        kinds = [one.Proxy.KIND for one in products_of(self.wireframe)] if self.wireframe else []
        with told():
            self.body.check_ready()
            job = self.fields.job()
            if kinds or job != self._drawn:
                self._start(job, kinds)
                return False
            # found at hand: the preview has computed it
            listener = Listener(lambda _: None, self._keep, self._not_built, self._clear_view.restore)
            self._building = Writing(self._target(), job, (), listener)
            self._building.start()
        return False

    def _keep(self, _: Any = None) -> None:
        self._is_kept = True
        self.close()

    def objects(self) -> Sequence[Any]:
        """Return the design that is changed, and what it fills."""
        return [self.wireframe, self.envelope] if self.wireframe is not None else []

    @while_open
    def slotDeletedObject(self, obj: Any) -> None:
        """Let go of an envelope that is deleted; a design needs its own (FreeCAD's observer protocol)."""
        super().slotDeletedObject(obj)
        if self.is_open and obj == self.envelope:
            self.cancel()
            self._clear_view.forget()
            self.body.forget()
            invoke_later(lambda: self._take_envelope(""))

    @while_open
    def slotRecomputedObject(self, obj: Any) -> None:
        """Look at the envelope anew when somebody else has changed it (FreeCAD's observer protocol)."""
        if self.envelope is not None and obj == self.envelope and self._building is None:
            invoke_later(self._look_again)

    @while_open
    def _look_again(self) -> None:
        self._take_edges()
        with told():
            self.body.begin()

    def let_go(self, has_document: bool) -> None:
        """Leave the document as it was, unless the design is kept."""
        self._pause.stop()
        self.worker.close()
        self.picker.stop()
        self.preview.close()
        if not has_document:
            self._clear_view.forget()
        self.cancel()
        self._clear_view.restore()
        self.body.cancel(self._is_kept or not has_document)

    # ---------------------------------------------------------------------------------------------------- building

    def _target(self) -> Target:
        return Target(
            self.document.Name,
            self.envelope.Name if self.envelope is not None else "",
            self.wireframe.Name if self.wireframe is not None else "",
        )

    def build(self) -> None:
        """Build what is ticked, in another process."""
        with told():
            self.body.check_ready()
            self._start(self.fields.job(), self.build_bar.chosen())

    def _start(self, job: Job, kinds: Sequence[str]) -> None:
        if self._building is not None:
            return
        self.picker.stop()
        heard = (self.build_bar.show_progress, self._built, self._not_built, self._clear_view.restore)
        building = Building(self._target(), job, kinds, lambda: self.body.solid(job), Listener(*heard))
        building.start()
        self._building = building
        self._set_working(True)

    def leave(self) -> None:
        """Close the panel while the build goes on in the status bar."""
        if isinstance(self._building, Building) and self._building.is_computed:
            background.of_window().take(self._building, lambda _: None)
            self._building = None
            self._keep()

    def cancel(self) -> None:
        """Stop building; the document is as it was."""
        if self._building is not None:
            self._building.cancel()
            self._building = None
            self._show_idle()

    @while_open
    def _show_idle(self) -> None:
        self._set_working(False)
        self._clear_view.apply(self.envelope, self._hidden())

    def _set_working(self, working: bool) -> None:
        (self.build_bar.show_working if working else self.build_bar.show_idle)()
        for widget in (self.fields.head, self.fields.sections):
            widget.setEnabled(not working)

    def _built(self, wireframe: Any) -> None:
        self._building = None
        name = self.document.Name  # not the document: it may be closed by then
        tell_of(name, wireframe.Name, True)
        self._keep()
        invoke_later(lambda: open_results(name))

    @while_open
    def _not_built(self, error: TrabeculaError) -> None:
        self._building = None
        tell_of(self.document.Name, "", False)
        self._show_idle()
        self.outcome.show_error(str(error))
        with told():
            raise error


def view_of(document: Any) -> Any:
    """Return a 3D view of a document."""
    views = FreeCADGui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor")
    return views[0]
