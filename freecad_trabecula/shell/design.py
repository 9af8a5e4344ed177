# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m freecad_trabecula design``, under FreeCAD: job in, folder of results out (docs/job.md)."""

from __future__ import annotations

import time
from dataclasses import replace
from typing import Any, Callable, Dict, List, Mapping, NamedTuple, Tuple

import FreeCAD

from .. import make
from ..core.bodies import Bodies, Check
from ..core.estimates import Work
from ..core.job import Job, job_to_json
from ..core.presets import PRESETS, THESIS
from ..core.progress import part
from ..core.report import NETWORK_STEPS, Outcome, body_figures, report_json, report_record
from ..core.report_text import report_markdown, report_summary
from ..core.stl import whole_file
from ..core.wireframe import Wireframe
from ..errors import ExportError, ParameterError
from ..geometry.files import MESH_FORMATS, SHAPE_FORMATS
from ..geometry.versions import versions
from .analyse import teller
from .folder import ResultFolder, require_own_folder
from .job_options import job_of_options
from .products import products, stl_checks, write_products

Report = Callable[..., None]

REPORT, PAGE = "report.json", "report.md"
PACKAGES = ("scipy", "manifold3d")  # beside numpy, whose versions are told
_ROD_TOLERANCE = 2e-3  # of the rods' volume, solids against meshes: tessellation


class Made(NamedTuple):
    """A design that has been made: its document, the objects in it, its wireframe and bodies."""

    document: FreeCAD.Document
    objects: make.Design
    wireframe: Wireframe
    bodies: Bodies


class Stopwatch:
    """Times the steps of a job, and reports its progress."""

    def __init__(self, report: Report) -> None:
        self.seconds: Dict[str, float] = {}
        self._report = report
        self._last = time.perf_counter()
        self.cpu_start = time.process_time()

    def progress(self, done: float, total: float, what: str) -> None:
        """Report progress."""
        self._report("progress", share=done / max(total, 1e-12), what=what)

    def lap(self, step: str) -> None:
        """Book the time since the last lap as that of a step."""
        now = time.perf_counter()
        self.seconds[step] = self.seconds.get(step, 0.0) + now - self._last
        self._last = now


def run(options: Dict[str, Any], report: Report) -> int:
    """Design what the options say; return the exit code.

    Parameters
    ----------
    options : dict
        As ``arguments.read_arguments`` returns them.
    report : callable
        Takes messages (``launch.Child``).

    Raises
    ------
    TrabeculaError
        For wrong input and whatever else goes wrong; nothing is then written.
    """
    if options["preset"] == "list":
        report("text", text=preset_list())
        return 0
    job = job_of_options(options)
    if options["save_job"]:
        save_job(job, options["save_job"])
    if not options["out"]:
        return 0
    require_own_folder(options["out"])
    with ResultFolder(options["out"]) as folder:
        report("temporary", path=str(folder.aside))
        record = write_design(job, folder, options["also"], Stopwatch(report), teller(job.name, report))
        _warn_of_old_files(folder, record, report)
    for text in record["warnings"]:
        report("warning", text=text)
    report("text", text=report_summary(record) + f"\nwritten to {folder.target}")
    return 0 if record["ok"] else 1


def save_job(job: Job, path: str) -> None:
    """Write a job file.

    Raises
    ------
    ParameterError
        If it cannot be written.
    """
    try:
        with whole_file(path) as file:
            file.write(job_to_json(job).encode("utf-8"))
    except ExportError as error:
        raise ParameterError(str(error)) from error


def preset_list() -> str:
    """Return the presets with what the thesis gives for them, one a line."""
    lines = []
    for name in PRESETS:
        figures = THESIS[name]
        porosity = f", porosity {figures.porosity:g} %" if figures.porosity else ""
        lines.append(f"{name:10} in the thesis {figures.rods} rods{porosity}")
    return "\n".join(lines)


def write_design(
    job: Job, folder: ResultFolder, also: List[str], watch: Stopwatch, tell: Callable[[Work], None]
) -> Dict[str, Any]:
    """Make a design, write all its files into the folder, and return its report."""
    document = FreeCAD.newDocument(_document_name(job))
    try:
        made = make_job(document, job, watch, tell)
        meshes = {"scaffold": made.bodies.scaffold, "channels": made.bodies.channels}
        files = write_products(products(meshes, made.objects, also), folder, part(watch.progress, 0.85, 0.95))
        watch.lap("files")
        watch.progress(0.95, 1.0, "reading the meshes again")
        again = [check for n, m in meshes.items() for check in stl_checks(folder.path(f"{n}.stl"), m, made.bodies)]
        checks = (*design_checks(made), *again)
        watch.lap("check of the files")
        told = warnings(made)
    finally:
        FreeCAD.closeDocument(document.Name)
    figures = body_figures(made.bodies)
    if made.objects.solid_scaffold:
        figures = replace(figures, engine="brep")
    outcome = Outcome(
        job,
        made.wireframe,
        figures,
        checks,
        watch.seconds,
        time.process_time() - watch.cpu_start,
        {name: folder.path(name).stat().st_size for name in files},
        versions(*PACKAGES),
        told,
    )
    record = report_record(outcome)
    for name, text in ((PAGE, report_markdown(record)), (REPORT, report_json(record))):
        with whole_file(folder.path(name)) as file:
            file.write(text.encode("utf-8"))
    folder.keep(*files, PAGE, REPORT)  # the report last: it tells of files that are there
    return record


# -------------------------------------------------------------------------------------------------------- the design


def _document_name(job: Job) -> str:
    return "".join(c if c.isascii() and c.isalnum() else "_" for c in job.name) or "design"


def make_job(document: FreeCAD.Document, job: Job, watch: Stopwatch, tell: Callable[[Work], None]) -> Made:
    """Make envelope, sites, wireframe, network and scaffold of a job in a document, step by step."""
    progress = watch.progress
    try:
        progress(0.0, 1.0, "envelope")
        envelope = make.make_job_envelope(document, job)
        tell(make.estimate_design(job, envelope.Shape))
        objects = make.make_design(document, job, envelope=envelope, progress=part(progress, 0.0, 0.1))
    except ExportError as error:  # an envelope that cannot be read is wrong input
        raise ParameterError(str(error)) from error
    watch.lap(NETWORK_STEPS[0])
    objects = objects._replace(network=make.make_network(objects.wireframe, part(progress, 0.1, 0.25)))
    watch.lap(NETWORK_STEPS[1])
    scaffold = make.make_scaffold(objects.wireframe, job.scaffold, part(progress, 0.25, 0.6))
    watch.lap("scaffold")
    solid = None
    if job.scaffold.engine == "brep":
        solid = make.make_solid_scaffold(objects.wireframe, job.scaffold, part(progress, 0.6, 0.85))
        watch.lap("scaffold as a solid")
    objects = objects._replace(scaffold=scaffold, solid_scaffold=solid)
    return Made(document, objects, make.wireframe_of(objects.wireframe), make.bodies_of(scaffold))


def design_checks(made: Made) -> Tuple[Check, ...]:
    """Return what must hold of a design: of its rods, and what its scaffold worked out twice."""
    wireframe, network = made.wireframe, made.objects.network
    wanted = len(wireframe) + len(wireframe.failed)
    solids, meshes = network.RodVolume.Value, network.MeshVolume.Value
    return (
        Check("rods made, of those that were coupled", len(wireframe), wanted, len(wireframe.failed), 0),
        Check(
            "volume of the rods, solids against meshes, mm3",
            solids,
            meshes,
            abs(solids - meshes) / max(meshes, 1e-300),
            _ROD_TOLERANCE,
        ),
        *made.bodies.checks,
        *_solid_checks(made.objects.solid_scaffold),
    )


def _solid_checks(solid: Any) -> Tuple[Check, ...]:
    """Return what must hold of the scaffold as a solid, if there is one."""
    if solid is None:
        return ()
    volume, other = solid.SolidVolume.Value, solid.MeshVolume.Value
    name = "volume of the scaffold, solid against mesh, mm3"
    return (Check(name, volume, other, abs(volume / other - 1), _ROD_TOLERANCE),)


def warnings(made: Made) -> Tuple[str, ...]:
    """Return what the user should know: of the envelope, of pores, of rods that leave it."""
    outside = made.wireframe.outside
    found = [*getattr(made.objects.envelope, "Notes", ()), *made.objects.wireframe.Warnings]
    if outside:
        found.append(f"{len(outside)} rods leave the envelope between their ends: {', '.join(outside)}")
    return tuple(found)


def _warn_of_old_files(folder: ResultFolder, record: Mapping[str, Any], report: Report) -> None:
    """Point out result files of an earlier run: they do not belong to this report."""
    ours = {
        f"{stem}.{kind}" for stem in ("scaffold", "channels", "network") for kind in (*MESH_FORMATS, *SHAPE_FORMATS)
    }
    old = sorted(name for name in ours - set(record["files"]) if (folder.target / name).exists())
    if old:
        report("warning", text=f"{', '.join(old)} in {folder.target} belong to an earlier run")
