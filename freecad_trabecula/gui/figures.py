# SPDX-License-Identifier: LGPL-2.1-or-later
"""The figures of a design as rows of a table, read from the properties of its objects."""

from __future__ import annotations

import re
from typing import Any, List, NamedTuple

import FreeCAD

from .. import make
from ..core.bodies import Check
from ..core.report import manual_seconds
from ..features.network import MOST_DIFFERENCE
from ..features.relations import products_of
from .language import choice, filled, in_words, local_number

translate = FreeCAD.Qt.translate
#: Bodies that checks and notes name, translated with what is said of them.
_BODIES = (FreeCAD.Qt.QT_TRANSLATE_NOOP("Core", "scaffold"), FreeCAD.Qt.QT_TRANSLATE_NOOP("Core", "channels"))
_POWER = re.compile(r"\bmm\^?([23])\b")


class Figure(NamedTuple):
    """A quantity and its value, the key of its explanation (none for what is no number); ``tip`` says more."""

    name: str
    value: str
    key: str = ""
    tip: str = ""


class Checked(NamedTuple):
    """Something that must hold: what, whether it does, what was found."""

    name: str
    ok: bool
    found: str


def headline(wireframe: Any) -> str:
    """Return the most important numbers of a design."""
    text = translate("Trabecula", "{} rods").format(wireframe.Rods)
    for one in products_of(wireframe):
        if volume_of(one, "ScaffoldVolume"):
            return text + filled(translate("Trabecula", ", porosity {:.2f} %"), one.Porosity)
    return text


def volume_of(obj: Any, name: str) -> float:
    """Return a volume that an object may have, mm³; 0 if it has none."""
    return float(getattr(getattr(obj, name, 0.0), "Value", 0.0))


def notes_of(wireframe: Any) -> List[str]:
    """Return what a user must know: warnings, bodies that are out of date or in error, notes of the engines."""
    notes = [in_words(note) for note in wireframe.Warnings]
    for one in products_of(wireframe):
        if not one.UpToDate or one.Status.startswith("error"):
            notes.append(f"{one.Label}: {in_words(one.Status)}")
        notes += [in_words(note) for note in getattr(one, "Notes", [])]
    return [with_powers(note) for note in notes]


def with_powers(text: str) -> str:
    """Return a text with its areas and volumes as a reader knows them.

    Examples
    --------
    >>> with_powers("0.5 mm3 of 2 mm^3 on 1 mm2")
    '0.5 mm³ of 2 mm³ on 1 mm²'
    """
    return _POWER.sub(lambda found: "mm" + {"2": "²", "3": "³"}[found[1]], text)


def figures_of(wireframe: Any) -> List[Figure]:
    """Return the figures of a design and of the bodies made of it."""
    rows = [Figure(translate("Trabecula", "Rods"), str(wireframe.Rods), "design.rods"), *manual_figures(wireframe)]
    for one in products_of(wireframe):
        if hasattr(one, "RodVolume"):
            rows.append(
                Figure(
                    translate("Trabecula", "Sum of the rods, mm³"),
                    local_number(one.RodVolume.Value, ".3f"),
                    "design.rod_volume",
                )
            )
        elif one.Proxy.KIND == "solid" and one.ScaffoldVolume.Value:
            rows += solid_figures(one)
        elif one.Proxy.KIND == "scaffold" and one.EngineUsed:
            rows += scaffold_figures(one, wireframe.Rods)
    return rows


def manual_figures(wireframe: Any) -> List[Figure]:
    """Return how long the design would take by hand; nothing while its wireframe is out of date."""
    if wireframe.ResultKey != wireframe.Proxy.key(wireframe):
        return []
    parameters, rods = wireframe.Proxy.parameters(wireframe), make.wireframe_of(wireframe)
    text = filled(translate("Trabecula", "{:.1f} h"), manual_seconds(parameters, rods) / 3600)
    tip = translate("Trabecula", "30 to 75 s a rod, by curvature and sections (thesis 2.3.3)")
    return [Figure(translate("Trabecula", "Rods by hand (thesis' estimate)"), text, "design.manual_time", tip)]


def scaffold_figures(scaffold: Any, rods: int) -> List[Figure]:
    """Return the figures of a scaffold: porosity, volumes, counts, times."""
    counted = translate("Trabecula", "{} ({:.3g} mm³)")
    loose, voids = scaffold.LooseVolume.Value, scaffold.VoidVolume.Value
    return [
        Figure(
            translate("Trabecula", "Porosity of the scaffold (Eq. 2.2)"),
            number_with_unit(scaffold.Porosity, ".3f", "%"),
            "design.porosity",
        ),
        Figure(
            translate("Trabecula", "Union of the rods in the envelope"),
            number_with_unit(scaffold.UnionPorosity, ".3f", "%"),
            "design.union_porosity",
        ),
        Figure(
            translate("Trabecula", "Plain sum of the rods"),
            number_with_unit(scaffold.SumPorosity, ".3f", "%"),
            "design.sum_porosity",
        ),
        Figure(
            translate("Trabecula", "Envelope"),
            number_with_unit(scaffold.EnvelopeVolume.Value, ".3f", "mm³"),
            "design.envelope_volume",
        ),
        Figure(
            translate("Trabecula", "Scaffold"),
            number_with_unit(scaffold.ScaffoldVolume.Value, ".3f", "mm³"),
            "design.scaffold_volume",
        ),
        Figure(
            translate("Trabecula", "Channels"),
            number_with_unit(scaffold.ChannelVolume.Value, ".3f", "mm³"),
            "design.channel_volume",
        ),
        Figure(translate("Trabecula", "Loose pieces"), filled(counted, scaffold.LoosePieces, loose), "design.loose"),
        Figure(
            translate("Trabecula", "Voids that no opening reaches"),
            filled(counted, scaffold.Voids, voids),
            "design.voids",
        ),
        Figure(translate("Trabecula", "Connected pieces of the scaffold"), str(scaffold.Pieces), "design.pieces"),
        Figure(translate("Trabecula", "Connected channels"), str(scaffold.Openings), "design.openings"),
        Figure(translate("Trabecula", "Engine"), choice(scaffold.EngineUsed), tip=in_words(scaffold.Reason)),
        Figure(translate("Trabecula", "Time"), number_with_unit(scaffold.Seconds, ".1f", "s"), "design.seconds"),
        Figure(
            translate("Trabecula", "Time for a rod"),
            number_with_unit(scaffold.Seconds / max(rods, 1), ".3f", "s"),
            "design.seconds_per_rod",
        ),
    ]


def number_with_unit(value: float, form: str, unit: str) -> str:
    """Return a number with the decimal sign of the window, and its unit."""
    return f"{local_number(value, form)} {unit}"


def solid_figures(solid: Any) -> List[Figure]:
    """Return the figures of a scaffold as a solid."""
    return [
        Figure(
            translate("Trabecula", "STEP scaffold: porosity"),
            number_with_unit(solid.Porosity, ".3f", "%"),
            "design.solid_porosity",
        ),
        Figure(
            translate("Trabecula", "STEP scaffold: volume"),
            number_with_unit(solid.ScaffoldVolume.Value, ".3f", "mm³"),
            "design.solid_volume",
        ),
        Figure(
            translate("Trabecula", "STEP scaffold: rods cut"),
            f"{solid.RodsCut} / {solid.RodsWanted}",
            "design.solid_rods",
            in_words(solid.Reason),
        ),
        Figure(
            translate("Trabecula", "STEP scaffold: time"), number_with_unit(solid.Seconds, ".1f", "s"), "design.seconds"
        ),
    ]


def checks_of(wireframe: Any) -> List[Checked]:
    """Return all that must hold of a design and its bodies."""
    rows = []
    for name, rods in (
        (translate("Trabecula", "No rod is left out"), wireframe.Failed),
        (translate("Trabecula", "No rod leaves the envelope"), wireframe.Outside),
    ):
        rows.append(Checked(name, not rods, ", ".join(rods[:20]) or translate("Trabecula", "none")))
    for one in products_of(wireframe):
        name = translate("Trabecula", "{} is up to date and without error").format(one.Label)
        good = bool(one.UpToDate) and not one.Status.startswith("error")
        rows.append(Checked(name, good, with_powers(in_words(one.Status))))
        if volume_of(one, "RodVolume"):
            name = translate("Trabecula", "Rods as solids and as meshes, mm³")
            rows.append(two_routes(name, one.RodVolume.Value, one.MeshVolume.Value, one.LargestDifference))
        elif volume_of(one, "SolidVolume"):
            name = translate("Trabecula", "Scaffold as solid and as mesh, mm³")
            rows.append(two_routes(name, one.SolidVolume.Value, one.MeshVolume.Value, one.Difference))
        rows += [checked(text) for text in getattr(one, "Checks", [])]
    return rows


def two_routes(name: str, solid: float, mesh: float, worst: float) -> Checked:
    """Return the check of a volume by the kernel against that of the mesh; ``worst`` is the largest difference, %."""
    most = 100 * MOST_DIFFERENCE
    found = translate("Trabecula", "{:.3f} against {:.3f}, at most {:.3g} % apart (allowed: {:g} %)")
    return Checked(name, worst <= most, filled(found, solid, mesh, worst, most))


def checked(text: str) -> Checked:
    """Return a check from the text that an object keeps of it.

    Examples
    --------
    >>> checked("a and b, mm3: 3 against 3.1, 0.03 apart (at most 0.1)")
    Checked(name='a and b, mm³', ok=True, found='3 against 3.1, 0.03 apart (at most 0.1)')
    """
    found = Check.from_text(text)
    if found is None:
        return Checked(with_powers(in_words(text)), False, "")
    words = translate("Trabecula", "{:.9g} against {:.9g}, {:.2g} apart (at most {:.2g})")
    return Checked(with_powers(in_words(found.name)), found.ok, filled(words, *found[1:]))
