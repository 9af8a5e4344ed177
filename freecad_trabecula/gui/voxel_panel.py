# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a voxel design: its form, what it will take, and the work in another process."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Callable, NamedTuple, Optional, Sequence

import FreeCAD

from .. import make
from ..core.voxels.design import heeds_tables
from ..core.voxels.drawn_curves import DrawnCurves
from ..core.voxels.parameters import VoxelParameters
from ..errors import ParameterError, TrabeculaError
from ..features.base import read_parameters
from ..features.relations import type_of
from ..features.tasks import write_voxel_task
from ..features.voxel_design import VoxelDesign
from ..features.voxel_inputs import FlatTables, curves_of, flat_tables, inputs_of
from .analysis_form import is_sliceable, likely
from .background import work_at_once
from .document_work import Order, check_present, write_step
from .language import in_words
from .preferences import new_surface, new_voxels
from .voxel_dock import show_layers
from .voxel_form import ANALYSIS, VoxelForm
from .work_panel import WorkPanel

translate = FreeCAD.Qt.translate


class VoxelWish(NamedTuple):
    """What is to be designed; names of objects are empty where there is none."""

    document: str
    parameters: VoxelParameters
    source: str = ""
    file: str = ""
    envelope: str = ""
    surface: str = "blocks"
    design: str = ""
    curves: Optional[DrawnCurves] = None
    tables: Optional[FlatTables] = None

    def order(self) -> Order:
        """Return what is to be done for it.

        Raises
        ------
        TrabeculaError
            If there is no sample.
        """
        check_present(self.document, (self.source, self.envelope))
        document = FreeCAD.getDocument(self.document)
        sample = document.getObject(self.source) if self.source else self.curves or self.file
        envelope = document.getObject(self.envelope) if self.envelope else None
        inputs = inputs_of(sample, self.parameters, envelope, self.surface, self.tables)
        return Order(
            self.document, VoxelDesign.KIND, inputs.key, lambda folder: write_voxel_task(folder, inputs), self.write,
            self.order, (self.source, self.envelope), self.design,
        )  # fmt: skip

    def work(self, done: Callable[[Any], None]) -> None:
        """Do it with one click, seen in the status bar.

        Raises
        ------
        TrabeculaError
            If the work cannot be started.
        """
        work_at_once(self.order(), done)

    def write(self) -> Any:
        """Write the design, which is at hand, into the document in one step; return the object."""
        envelope = f"document.getObject({self.envelope!r})" if self.envelope else "None"
        more = f"parameters, envelope={envelope}, surface={self.surface!r}"
        if self.tables:
            more += f", tables={self.tables!r}"
        curves = repr(self.curves) if self.curves else ""
        lines = [f"from {DrawnCurves.__module__} import {DrawnCurves.__name__}"] if curves else []
        sample = f"document.getObject({self.source!r})" if self.source else curves or repr(self.file)
        if self.design:
            more += f", curves={curves}" if curves else ""
            lines.append(f"make.change_voxel_design(document.getObject({self.design!r}), {more})")
        else:
            lines.append(f"make.make_voxel_design(document, {sample}, {more})")
        if self.source and not self.design:  # both fill the same place
            lines.append(f"{sample}.Visibility = False")
        step = translate("Trabecula", "Design voxels")
        return write_step(self.document, step, self.parameters, lines, VoxelDesign.Type, self.design)


def design_with_tables(obj: Any, tables: Sequence[Any]) -> None:
    """Have the layers of a voxel design filled from given tables, in another process, as one step.

    Raises
    ------
    TrabeculaError
        If the work cannot be started.
    """
    VoxelWish(
        obj.Document.Name, read_parameters(obj, VoxelParameters), _name(obj.Source), obj.File, _name(obj.Envelope),
        obj.Surface, obj.Name, curves_of(obj), flat_tables(tables),
    ).work(show_layers)  # fmt: skip


def _name(obj: Any) -> str:
    return obj.Name if obj is not None else ""


class VoxelPanel(WorkPanel):
    """A task panel on one document.

    Parameters
    ----------
    document : App.Document
    obj : document object or None
        The design that is to be changed; None means a new one.
    source : document object or None
        The sample of a new one at first.
    """

    def __init__(self, document: Any, obj: Any = None, source: Any = None) -> None:
        words = (
            *(translate("Trabecula", "Voxel design"), translate("Trabecula", "Build")),
            *("Trabecula_voxels", "commands/Voxels.md"),
        )
        super().__init__(document, obj, source, VoxelForm(self._changed), words, lambda one: show_layers(one))

    def fill(self, source: Any) -> None:
        """Show the values of the design, or those that a new one of a source has by default."""
        obj, samples = self.obj, samples_of(self.document)
        bodies = [one for one in samples if type_of(one) != ANALYSIS]
        if obj is not None:
            self.fields.offer(samples, bodies, obj.Source, obj.Envelope)
            self.fields.set_value(read_parameters(obj, VoxelParameters), obj.Surface)
            curves = curves_of(obj)
            if obj.Source is None and obj.File:
                self.fields.source.set_file(obj.File)
            elif curves is not None:
                self.fields.take_curves(curves)
            self.lock_source(True)
        else:
            source = source if source is not None else likely(samples)
            self.fields.offer(samples, bodies, source, None)
            self.fields.set_value(first_parameters(source), new_surface())
        self._changed()

    def lock_source(self, locked: bool) -> None:
        """Forbid to choose another sample while there is a design; drawn curves can be bent."""
        self.fields.source.setEnabled(not locked)
        self.fields.draw.setEnabled(not locked or self.fields.curves() is not None)

    def _changed(self) -> None:
        """Say what the design will take, or what is wrong."""
        try:
            self.message.setText(self._estimate())
            self.build_bar.build_button.setEnabled(True)
        except TrabeculaError as error:
            self.refuse(error)
            self.build_bar.build_button.setEnabled(False)

    def _sample(self) -> Any:
        name = self.fields.source.object_name()
        sample = self.document.getObject(name) if name else self.fields.curves() or self.fields.file()
        if not sample:
            raise ParameterError("a voxel design needs a sample, got none: choose an object or a file, or draw it")
        return sample

    def _estimate(self) -> str:
        parameters = self.fields.value()
        return in_words(make.estimate_voxel_design(self._sample(), parameters).words)

    def order(self) -> Order:
        """Return what is to be designed.

        Raises
        ------
        TrabeculaError
            If there is no sample, a rule is broken, or the design would be too large.
        """
        self._estimate()
        return VoxelWish(
            self.document.Name, self.fields.value(), self.fields.source.object_name(), self.fields.file(),
            self.fields.envelope_name(), self.fields.surface.value(), self.obj.Name if self.obj else "",
            self.fields.curves(), self._kept_tables(),
        ).order()  # fmt: skip

    def _kept_tables(self) -> Optional[FlatTables]:
        """Given tables of the design, where they still go: the same voxels and layers, a strategy that heeds tables."""
        if self.obj is None or not self.obj.Alpha:
            return None
        parameters, before = self.fields.value(), read_parameters(self.obj, VoxelParameters)
        same = parameters.size == before.size and self.fields.curves() == curves_of(self.obj)
        goes = same and heeds_tables(parameters.strategy)
        return flat_tables((self.obj.Alpha, self.obj.Beta)) if goes else None


def samples_of(document: Any) -> list:
    """Return the objects of a document of which voxels can be designed: bodies, and analyses of layers."""
    return [obj for obj in document.Objects if is_sample(obj)]


def is_sample(obj: Any) -> bool:
    """Return whether voxels can be designed of an object."""
    return type_of(obj) == ANALYSIS or (is_sliceable(obj) and type_of(obj) != "Trabecula::Wireframe")


def first_parameters(sample: Any) -> VoxelParameters:
    """Return what a new design of a sample begins with: voxels as thick as the layers of an analysis, or of its own."""
    measured = [] if sample is None else [one for one in (sample, *sample.InList) if type_of(one) == ANALYSIS]
    if not measured:
        return new_voxels()
    return replace(new_voxels(), size=(float(measured[-1].SliceThickness.Value),) * 3)
