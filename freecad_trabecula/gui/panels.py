# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opens task panels: one at a time, each on a document and an object that are there."""

from __future__ import annotations

from typing import Any, Optional, Sequence

import FreeCAD

from ..core.job import Job, read_job
from ..features.jobs import job_of
from ..features.relations import products_of, type_of, wireframe_of
from .background import why_not
from .preferences import new_job
from .results_panel import open_results
from .task_panels import current, is_free, show_panel
from .transactions import say, told

translate = FreeCAD.Qt.translate


def open_for(document: str, name: str) -> None:
    """Open the panel of an object: results of bodies, the design of all else."""
    if document not in FreeCAD.listDocuments() or not is_free():
        return
    obj = FreeCAD.getDocument(document).getObject(name)
    if obj is None:
        return
    wireframe = wireframe_of(obj)
    if type_of(obj) == "Trabecula::Analysis":
        open_analysis(obj.Document, obj)
    elif type_of(obj) == "Trabecula::VoxelDesign":
        open_voxels(obj.Document, obj)
    elif wireframe is None:
        say(translate("Trabecula", "{} belongs to no design yet").format(obj.Label))
    elif obj in products_of(wireframe):
        open_results(document, wireframe)
    else:
        open_change(wireframe)


def is_free_for(obj: Any) -> bool:
    """Return whether no task panel is open, and an object is not being computed; else say so in the status bar."""
    sentence = why_not(obj.Document.Name, obj.Name) if obj is not None else ""
    if sentence:
        say(sentence)
    return not sentence and is_free()


def open_new(document: Any, job: Optional[Job] = None, envelope: Any = None) -> None:
    """Open the design panel for a new design."""
    from .design_panel import DesignPanel

    if is_free():
        with told():
            show_panel(DesignPanel(document, job or new_job(), envelope))


def open_change(wireframe: Any) -> bool:
    """Open the design panel with the values of a design that is there; return whether it is open."""
    from .design_form import IN_DOCUMENT
    from .design_panel import DesignPanel

    if is_free_for(wireframe):
        with told():
            scaffold = next((one for one in products_of(wireframe) if type_of(one).endswith("Scaffold")), None)
            job = job_of(wireframe, scaffold, IN_DOCUMENT)
            show_panel(DesignPanel(wireframe.Document, job, wireframe.Envelope, wireframe))
            return True
    return False


def open_on_faces(document: Any, envelope: Any, faces: Sequence[str]) -> None:
    """Open the design panel for a new design with sites on faces of a solid."""
    if is_free():
        open_new(document, envelope=envelope)
        panel = current()
        for face in faces:
            panel.fields.faces.toggle(face)
        if not faces:
            panel.fields.faces.pick_button.setChecked(True)


def open_and_build(wireframe: Any, kind: str) -> None:
    """Open the design panel of a design and build one kind of body at once."""
    if wireframe is not None and open_change(wireframe):
        panel = current()
        for name, box in panel.build_bar.boxes.items():
            box.setChecked(box.isChecked() or name == kind)
        panel.build()


def open_job(document: Any, path: str) -> None:
    """Open the design panel with the values of a job file.

    Raises
    ------
    TrabeculaError
        If the file cannot be read, or is no job.
    """
    open_new(document, read_job(path))


def open_analysis(document: Any, obj: Any = None, source: Any = None) -> None:
    """Open the panel of slice analyses: for one that is there, or for a new one of a source."""
    from .analysis_panel import AnalysisPanel

    if is_free_for(obj):
        with told():
            show_panel(AnalysisPanel(document, obj, source))


def open_analysis_of_file(document: Any, path: str) -> None:
    """Open the panel of slice analyses for a new one of a file."""
    if is_free():
        open_analysis(document)
        current().fields.set_file(path)


def open_voxels(document: Any, obj: Any = None, source: Any = None) -> None:
    """Open the panel of voxel designs: for one that is there, or for a new one of a source."""
    from .voxel_panel import VoxelPanel

    if is_free_for(obj):
        with told():
            show_panel(VoxelPanel(document, obj, source))
