# SPDX-License-Identifier: LGPL-2.1-or-later
"""The three ways to work (doors), step by step: what each step says, what a click on it runs, and when it is done.

A step knows no history: it looks at what the document holds (``features/stages.py``) and at what the docks show.
"""

from __future__ import annotations

from typing import Any, Callable, List, NamedTuple, Optional, Tuple

import FreeCAD

from ..features.stages import DONE, NONE, STALE, Stages, state_of

translate = FreeCAD.Qt.translate
NEXT, OPEN, LATER = "next", "open", "later"


class Seen(NamedTuple):
    """What the docks show: names of the analyses whose plots are seen, and whether voxel layers are."""

    plots: Tuple[str, ...] = ()
    layers: bool = False


#: Name of a command, and what is selected for it; None: not yet.
Click = Optional[Tuple[str, List[Any]]]


class Step(NamedTuple):
    """One step: name, title, what to do, its state, what a click runs."""

    name: str
    title: str
    text: str
    state: Callable[[Stages, Seen], str]
    click: Callable[[Stages], Click]


class Door(NamedTuple):
    """One way to work; ``name`` is that of its example too."""

    name: str
    title: str
    line: str
    picture: str
    steps: Tuple[Step, ...]


class Marked(NamedTuple):
    """A step with its mark: ``DONE``, ``NEXT``, ``OPEN``, ``LATER``, ``STALE``, ``WORKING`` or ``FAILED``."""

    step: Step
    mark: str
    click: Click


def marked(door: Door, stages: Stages, seen: Seen) -> List[Marked]:
    """Return the steps of a door with their marks: the first that is not done is next, if it can be done."""
    found: List[Marked] = []
    is_next_open = True
    for step in door.steps:
        mark, click = step.state(stages, seen), step.click(stages)
        if mark == STALE:
            click = ("Trabecula_Renew", [])
        elif mark == NONE:
            mark = LATER if click is None else NEXT if is_next_open else OPEN
        is_next_open = is_next_open and mark == DONE
        found.append(Marked(step, mark, click))
    return found


def door_of(stages: Stages) -> Optional[str]:
    """Return the name of the door that a document went through; None if it holds nothing of ours."""
    if stages.voxels is not None:
        return "voxels"
    if stages.wireframe is not None:
        return "rods"
    return "measure" if stages.analyses else None


# -------------------------------------------------------------------------------------------- what the steps look at


def _if(condition: Any) -> str:
    return DONE if condition else NONE


def _of(obj: Any, command: str) -> Click:
    return (command, [obj]) if obj is not None else None


def _pair(first: Any, second: Any) -> Click:
    return ("Trabecula_Compare", [first, second]) if first is not None and second is not None else None


def _are_seen(seen: Seen, *analyses: Any) -> str:
    """The state of analyses whose plots are seen; none if one is not."""
    if any(one is None or one.Name not in seen.plots for one in analyses):
        return NONE
    return _worst(list(analyses), len(analyses))


def _worst(analyses: List[Any], least: int) -> str:
    """The state of all together; none if there are fewer than the least."""
    states = [state_of(one) for one in analyses]
    if len(states) < least:
        return NONE
    return next((state for state in states if state != DONE), DONE)


def _measure(stages: Stages, without: str = "Trabecula_MeasureFile") -> Click:
    """Measure the next body that is not measured yet; without one ask for a file by another command."""
    bones = stages.bones
    return ("Trabecula_AnalyseNow", bones[:1]) if bones else (without, [])


def _first_body(stages: Stages) -> List[Any]:
    made = [one for one in (stages.scaffold, stages.voxels) if one is not None]
    return (stages.chosen or stages.bodies or made)[:1]


def _targets(stages: Stages) -> Any:
    """The analysis that the voxels are to equal, or that of the bone which they are to equal."""
    source = stages.voxels.Source if stages.voxels is not None else None
    same = [one for one in stages.analyses if source is not None and source in (one, one.Source)]
    return next(iter(same), stages.of_bone)


def _sample(stages: Stages) -> Any:
    """What the voxels are made of: the bone itself, of which each layer can be seen; without it what is known of it."""
    targets = _targets(stages)
    body = targets.Source if targets is not None else next(iter(stages.chosen or stages.bodies), None)
    return targets if body is None else body


# ------------------------------------------------------------------------------------------------------- the steps


def _rods() -> Tuple[Step, ...]:
    return (
        Step(
            "body",
            translate("Trabecula", "Pick a body"),
            translate("Trabecula", "Select the solid or the closed mesh to be filled. A click here brings one in from "
                      "a file; without one a box is filled."),
            lambda on, seen: _if(on.solids or on.chosen or on.wireframe is not None),
            lambda on: ("Trabecula_Body", []),
        ),
        Step(
            "design",
            translate("Trabecula", "Design the rods"),
            translate("Trabecula", "Sites, pores, paths and couplings; the preview and its porosity follow every "
                      "change. OK keeps the design."),
            lambda on, seen: state_of(on.wireframe),
            lambda on: ("Trabecula_Design", [on.wireframe] if on.wireframe is not None
                        else (on.chosen or on.solids[-1:])[:1]),
        ),
        Step(
            "build",
            translate("Trabecula", "Build the scaffold"),
            translate("Trabecula", "The channels are cut out of the body. Volumes, parts and loose pieces are "
                      "checked."),
            lambda on, seen: state_of(on.scaffold),
            lambda on: _of(on.wireframe, "Trabecula_Scaffold"),
        ),
        Step(
            "analyse",
            translate("Trabecula", "Analyse the scaffold"),
            translate("Trabecula", "Every slice along X, Y and Z is measured: areas, porosity, contours."),
            lambda on, seen: state_of(on.of_scaffold),
            lambda on: _of(on.scaffold, "Trabecula_AnalyseNow"),
        ),
        Step(
            "bone",
            translate("Trabecula", "Measure a bone"),
            translate("Trabecula", "What the scaffold is to be like: a file, or a mesh of the document."),
            lambda on, seen: state_of(on.of_bone),
            _measure,
        ),
        _compare(lambda on: (on.of_bone, on.of_scaffold)),
        _change(lambda on: on.wireframe, "Trabecula_Design"),
        _export(lambda on: _of(on.wireframe if on.scaffold is not None else None, "Trabecula_Export")),
    )  # fmt: skip


def _compare(pair: Callable[[Stages], Tuple[Any, Any]]) -> Step:
    return Step(
        "compare",
        translate("Trabecula", "Compare"),
        translate("Trabecula", "Both on shared axes, with their differences and a passport of how near they are."),
        lambda on, seen: _are_seen(seen, *pair(on)),
        lambda on: _pair(*pair(on)),
    )


def _change(design: Callable[[Stages], Any], command: str) -> Step:
    return Step(
        "change",
        translate("Trabecula", "Change the design"),
        translate("Trabecula", "Change a value and build again: analysis and comparison follow in the plots."),
        lambda on, seen: NONE,
        lambda on: _of(design(on), command),
    )


def _export(click: Callable[[Stages], Click]) -> Step:
    return Step(
        "export",
        translate("Trabecula", "Export"),
        translate("Trabecula", "Write files for a printer, a CAD system or a table; sizes are shown first."),
        lambda on, seen: NONE,
        click,
    )


def _measures() -> Tuple[Step, ...]:
    return (
        Step(
            "file",
            translate("Trabecula", "Take a bone or a design"),
            translate("Trabecula", "A click brings in a mesh or a solid from a file; one of the document will do as "
                      "well."),
            lambda on, seen: _if(on.analyses or _first_body(on)),
            lambda on: ("Trabecula_Body", []),
        ),
        Step(
            "analyse",
            translate("Trabecula", "Analyse it"),
            translate("Trabecula", "Thickness of the layers, axes, mending; Tb.Th, Tb.Sp, Conn.D and DA if they are "
                      "ticked."),
            lambda on, seen: _worst(on.analyses, 1),
            lambda on: ("Trabecula_Analysis", on.analyses[-1:] or _first_body(on)),
        ),
        Step(
            "plots",
            translate("Trabecula", "Look at the plots"),
            translate("Trabecula", "Point at a diagram: the slice there is drawn beside it and shown in the 3D view."),
            lambda on, seen: _if(seen.plots),
            lambda on: _of(on.analyses[-1] if on.analyses else None, "Trabecula_Plots"),
        ),
        Step(
            "second",
            translate("Trabecula", "Measure another"),
            translate("Trabecula", "Another bone, or a design: a click brings it in, the next one measures it."),
            lambda on, seen: _worst(on.analyses, 2),
            lambda on: _measure(on, "Trabecula_Body") if on.analyses else None,
        ),
        _compare(lambda on: tuple(on.analyses[:2]) if len(on.analyses) > 1 else (None, None)),
        _export(lambda on: ("Trabecula_SaveAnalyses", on.analyses) if on.analyses else None),
    )  # fmt: skip


def _voxel_steps() -> Tuple[Step, ...]:
    return (
        Step(
            "sample",
            translate("Trabecula", "Take a sample"),
            translate("Trabecula", "The bone that the voxels are to match: a click brings in a mesh or a solid."),
            lambda on, seen: _if(on.bodies or on.analyses or on.voxels is not None),
            lambda on: ("Trabecula_Body", []),
        ),
        Step(
            "targets",
            translate("Trabecula", "Measure the targets"),
            translate("Trabecula", "Slice the sample in layers as thick as the voxels are to be: each is a target."),
            lambda on, seen: state_of(_targets(on)) if _targets(on) is not None else _if(on.voxels is not None),
            lambda on: _of(next(iter(on.chosen or on.bodies), None), "Trabecula_Analysis"),
        ),
        Step(
            "voxels",
            translate("Trabecula", "Design the voxels"),
            translate("Trabecula", "As many voxels in every layer along X, Y and Z as the targets ask, in one piece."),
            lambda on, seen: state_of(on.voxels),
            lambda on: ("Trabecula_Voxels", [one for one in (_sample(on),) if one is not None]),
        ),
        Step(
            "layers",
            translate("Trabecula", "Look at the layers"),
            translate("Trabecula", "Sample and design side by side, layer by layer, with the counts of both."),
            lambda on, seen: _if(seen.layers and on.voxels is not None),
            lambda on: _of(on.voxels, "Trabecula_VoxelLayers"),
        ),
        Step(
            "analyse",
            translate("Trabecula", "Analyse the voxels"),
            translate("Trabecula", "The design is sliced as the sample was: the second route to its areas."),
            lambda on, seen: state_of(on.of_voxels),
            lambda on: _of(on.voxels, "Trabecula_AnalyseNow"),
        ),
        _compare(lambda on: (_targets(on), on.of_voxels)),
        _change(lambda on: on.voxels, "Trabecula_Voxels"),
        _export(lambda on: _of(on.voxels, "Trabecula_VoxelExport")),
    )  # fmt: skip


DOORS: Tuple[Door, ...] = (
    Door(
        "rods",
        translate("Trabecula", "Design a scaffold in this body"),
        translate("Trabecula", "Rods through a box, an implant or any solid; channels, porosity, files for a printer."),
        "Trabecula_scaffold",
        _rods(),
    ),
    Door(
        "measure",
        translate("Trabecula", "Measure a bone or a design"),
        translate("Trabecula", "Slices, porosity, thickness of trabeculae; two bodies side by side."),
        "Trabecula_compare",
        _measures(),
    ),
    Door(
        "voxels",
        translate("Trabecula", "Design voxels that match a bone"),
        translate("Trabecula", "Voxels in one piece with the bone's sliced areas in every layer along X, Y and Z."),
        "Trabecula_voxels",
        _voxel_steps(),
    ),
)
