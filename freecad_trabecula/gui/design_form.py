# SPDX-License-Identifier: LGPL-2.1-or-later
"""The form of the design panel: preset, envelope and seed above, the sections of a job below. It knows no document."""

from __future__ import annotations

from typing import Callable, Dict, NamedTuple, Optional, Sequence

import FreeCAD
from PySide import QtGui

from ..core.couplings import CouplingRow
from ..core.job import Job
from ..core.parameters import LARGEST_SEED, PrismParameters
from ..core.presets import PRESETS, THESIS
from ..core.sites import PRISM_FACES
from ..errors import ParameterError
from .accordion import Accordion
from .couplings_section import CouplingsSection, couplings_summary
from .edits_list import EditsList
from .faces_section import FacesSection, faces_summary
from .fields import ChoiceField, WholeField, row_widget
from .language import local_number
from .paths_section import PathsSection, paths_summary
from .pores_section import PoresSection, pores_summary
from .prism_section import PrismSection, prism_summary
from .qt import icon, small_button
from .scaffold_section import ScaffoldSection, SurfaceSection, scaffold_summary, surface_summary

translate = FreeCAD.Qt.translate
#: Stands in a job for an envelope that is an object of the document.
IN_DOCUMENT = "envelope.bin"
ON_PRISM, ON_FACES = "prism", "picked faces"


class Envelope(NamedTuple):
    """A body that can be chosen: its name in the document ("" for a new prism), its label, whether it is a box."""

    name: str
    label: str
    is_box: bool


class Callbacks(NamedTuple):
    """What the form asks of its panel."""

    changed: Callable[[], None]
    preset_chosen: Callable[[str], None]
    envelope_chosen: Callable[[str], None]
    pick_faces: Callable[[bool], None]
    pick_origin: Callable[[], None]


class DesignForm:
    """All fields of a job: ``head`` (preset, envelope, seed) and ``sections`` are widgets for the panel to place."""

    def __init__(self, callbacks: Callbacks) -> None:
        self._callbacks = callbacks
        self._showing = False
        self._name = "design"
        self._envelopes: Sequence[Envelope] = ()
        self.sections = Accordion()
        self._make_head()
        self._make_sections()

    # ------------------------------------------------------------------------------------------------- its parts

    def _make_head(self) -> None:
        self.preset = QtGui.QComboBox()
        self.preset.addItem(translate("Trabecula", "choose a design …"), "")
        for name in PRESETS:
            self.preset.addItem(preset_text(name), name)
        self.preset.setToolTip(translate("Trabecula", "The thesis' designs, to start from"))
        self.preset.activated.connect(self._preset_chosen)
        self.envelope = QtGui.QComboBox()
        self.envelope.setToolTip(translate("Trabecula", "The body to be filled"))
        self.envelope.activated.connect(self._envelope_chosen)
        self.seed = WholeField(0, LARGEST_SEED, self._report, translate("Trabecula", "One number reproduces all draws"))
        seeds = row_widget()
        seeds.layout().addWidget(self.seed.widget, 1)
        tip = translate("Trabecula", "The next seed: other draws, other pairs")
        self.next_seed = small_button("view-refresh", tip, lambda *_: self.seed.set_value(self.seed.value() + 1))
        seeds.layout().addWidget(self.next_seed)
        self.head = QtGui.QWidget()
        grid = QtGui.QFormLayout(self.head)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setSpacing(4)
        grid.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        for label, widget in (
            (translate("Trabecula", "Preset"), self.preset),
            (translate("Trabecula", "Envelope"), self.envelope),
            (translate("Trabecula", "Seed"), seeds),
        ):
            widget.setSizePolicy(QtGui.QSizePolicy.Expanding, QtGui.QSizePolicy.Fixed)
            grid.addRow(label, widget)
        for box in (self.preset, self.envelope):
            box.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
            box.setMinimumContentsLength(12)

    def _make_sections(self) -> None:
        changed = self._report
        self.kind = ChoiceField((ON_PRISM, ON_FACES), self._kind_changed, translate("Trabecula", "How sites are set"))
        self.prism = PrismSection(changed)
        self.faces = FacesSection(self._faces_changed, self._callbacks.pick_faces, self._callbacks.pick_origin)
        self.edits = EditsList(changed)
        self.pores = PoresSection(changed)
        self.paths = PathsSection(changed)
        self.couplings = CouplingsSection(changed, self.paths.value)
        self.surface = SurfaceSection(changed)
        self.scaffold = ScaffoldSection(changed)
        sites = QtGui.QWidget()
        column = QtGui.QVBoxLayout(sites)
        column.setContentsMargins(0, 0, 0, 0)
        kind = row_widget()
        kind.layout().addWidget(QtGui.QLabel(translate("Trabecula", "Sites on")))
        kind.layout().addWidget(self.kind.widget, 1)
        for widget in (kind, self.prism, self.faces, self.edits):
            column.addWidget(widget)
        self._titles = (
            translate("Trabecula", "Sites"),
            translate("Trabecula", "Pores"),
            translate("Trabecula", "Paths"),
            translate("Trabecula", "Couplings"),
            translate("Trabecula", "Rods"),
            translate("Trabecula", "Scaffold"),
        )
        pictures = ("site", "pore", "path", "coupling", "network", "scaffold")
        widgets = (sites, self.pores, self.paths, self.couplings, self.surface, self.scaffold)
        for widget, title, picture in zip(widgets, self._titles, pictures):
            self.sections.add(title, icon("Trabecula_" + picture), widget)

    # -------------------------------------------------------------------------------------------------- the value

    def job(self) -> Job:
        """Return the job.

        Raises
        ------
        ParameterError
            If a value breaks a rule.
        """
        on_faces, couplings = self.kind.value() == ON_FACES, self.couplings.value()
        if on_faces and not self.faces.value():
            raise ParameterError(
                "rods begin on faces with sites, got none: press Pick faces and click them in the view"
            )
        if not couplings:
            raise ParameterError("rods join a pair of faces, got no pair: add one in the section Couplings")
        return Job(
            name=self._name,
            envelope="" if self._is_box() else IN_DOCUMENT,
            prism=self._prism(on_faces),
            faces=self.faces.value() if on_faces else (),
            pores=self.pores.value(),
            path=self.paths.value(),
            couplings=couplings,
            rods=self.surface.value(),
            scaffold=self.scaffold.value(),
            edits=self.edits.value(),
            seed=self.seed.value(),
        )

    def _prism(self, on_faces: bool) -> Optional[PrismParameters]:
        if not self._is_box():
            return None
        return self.prism.bare_value() if on_faces else self.prism.value()

    def set_job(self, job: Job) -> None:
        """Show a job; the envelope is set by ``set_envelopes``."""
        self._showing = True
        try:
            self._name = job.name
            self.preset.setCurrentIndex(max(self.preset.findData(job.name), 0))
            self.seed.set_value(job.seed)
            self.kind.set_value(ON_PRISM if job.prism is not None and not job.faces else ON_FACES)
            self.prism.set_value(job.prism or PrismParameters())
            self.faces.set_value(job.faces)
            self.edits.set_value(job.edits)
            self.pores.set_value(job.pores)
            self.paths.set_value(job.path)
            self.couplings.set_value(job.couplings, self.labels())
            self.surface.set_value(job.rods)
            self.scaffold.set_value(job.scaffold)
            self.scaffold.set_faces(self.labels())
            self._show_kind()
        finally:
            self._showing = False
        self.show_summaries(job)

    def labels(self) -> Sequence[str]:
        """Return the names of the faces that have sites."""
        if self.kind.value() == ON_PRISM:
            return PRISM_FACES
        try:
            return tuple(face.label for face in self.faces.value())
        except ParameterError:
            return ()

    def set_envelopes(self, envelopes: Sequence[Envelope], chosen: str, fixed: bool = False) -> None:
        """Offer envelopes, of which the one named ``chosen`` is taken; ``fixed``: no other can be chosen."""
        self._envelopes = tuple(envelopes)
        self.envelope.clear()
        for one in envelopes:
            self.envelope.addItem(one.label, one.name)
        names = [one.name for one in envelopes]
        self.envelope.setCurrentIndex(names.index(chosen) if chosen in names else 0)
        self.envelope.setEnabled(not fixed)
        self._show_kind()

    def envelope_name(self) -> str:
        """Return the name of the chosen envelope, "" for a new prism."""
        return self._envelopes[self.envelope.currentIndex()].name if self._envelopes else ""

    def _is_box(self) -> bool:
        return not self._envelopes or self._envelopes[self.envelope.currentIndex()].is_box

    # ------------------------------------------------------------------------------------------------ what it shows

    def show_summaries(self, job: Optional[Job]) -> None:
        """Show each section's values in a few words beside its title."""
        texts: Dict[int, str] = {}
        if job is not None:
            sites = prism_summary(job.prism) if job.prism is not None and not job.faces else faces_summary(job.faces)
            texts = dict(enumerate((
                sites, pores_summary(job.pores), paths_summary(job.path), couplings_summary(job.couplings),
                surface_summary(job.rods), scaffold_summary(job.scaffold),
            )))  # fmt: skip
        for k in range(len(self._titles)):
            self.sections.set_summary(k, texts.get(k, ""))

    def show_counts(self, rows: Sequence[CouplingRow], counts: Dict[str, int]) -> None:
        """Show what each coupling gave and how many sites each face has."""
        self.couplings.set_rows(rows)
        self.faces.set_counts(counts)

    def _show_kind(self) -> None:
        on_faces = self.kind.value() == ON_FACES
        if not self._is_box() and not on_faces:
            self.kind.set_value(ON_FACES)
            on_faces = True
        self.kind.widget.setEnabled(self._is_box())
        self.prism.setVisible(self._is_box())
        self.prism.show_sites(not on_faces)
        self.faces.setVisible(on_faces)
        if on_faces and not self.labels():
            self.sections.set_summary(0, faces_summary(()))

    # ---------------------------------------------------------------------------------------------------- changes

    def _report(self) -> None:
        if not self._showing:
            self._callbacks.changed()

    def _kind_changed(self) -> None:
        self._show_kind()
        self._faces_changed()

    def _faces_changed(self) -> None:
        if self._showing:
            return
        self.couplings.set_faces(self.labels())
        self.scaffold.set_faces(self.labels())
        self._report()

    def _preset_chosen(self, index: int) -> None:
        name = self.preset.itemData(index)
        if name:
            self._callbacks.preset_chosen(str(name))

    def _envelope_chosen(self, index: int) -> None:
        self._show_kind()
        self._faces_changed()
        self._callbacks.envelope_chosen(self.envelope_name())


def preset_text(name: str) -> str:
    """Return a preset's name with what the thesis says of it."""
    thesis = THESIS[name]
    words = {"prism420": translate("Trabecula", "prism"), "cranial": translate("Trabecula", "craniofacial implant"),
             "femur": translate("Trabecula", "humerus implant")}  # fmt: skip
    title = words.get(name, name.replace("case", translate("Trabecula", "case ")))
    porosity = f", {local_number(thesis.porosity)} %" if thesis.porosity else ""
    return translate("Trabecula", "{} ({} rods{})").format(title, thesis.rods, porosity)
