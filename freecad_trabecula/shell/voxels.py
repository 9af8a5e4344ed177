# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m freecad_trabecula voxels``, under FreeCAD: a sample in, a voxel design and its report out."""

from __future__ import annotations

import time
from dataclasses import replace
from pathlib import Path
from typing import Any, Callable, Dict, List, Optional, Tuple

import numpy as np

from ..core.analysis.plots import save_figure
from ..core.analysis.workbook import require_openpyxl
from ..core.estimates import Work
from ..core.meshes import Mesh, printable
from ..core.progress import Progress, part
from ..core.stl import whole_file, write_stl
from ..core.voxels.blocks import block_mesh
from ..core.voxels.counting import counting_record
from ..core.voxels.design import VoxelDesign, estimate, make_design
from ..core.voxels.envelope_sources import targets_of_envelope
from ..core.voxels.image_stacks import write_stack
from ..core.voxels.parameters import BYTES_PER_VOXEL, VoxelParameters
from ..core.voxels.plots import design_figures
from ..core.voxels.report import KIND, design_record, record_json
from ..core.voxels.report_text import report_markdown, report_summary
from ..core.voxels.sources import layers_of_source, read_mask, read_targets, read_triangles, targets_record
from ..core.voxels.table_files import targets_of_tables, write_table_csv, write_tables_xlsx
from ..core.voxels.table_pairs import pair_rates
from ..core.voxels.targets import Targets
from ..core.voxels.volume_files import write_npy
from ..geometry.versions import versions
from .analyse import PACKAGES, plots_kind, progress_of, warn_of_old_files
from .folder import ResultFolder, require_own_folder
from .voxel_options import FIELDS

Report = Callable[..., None]

REPORT, PAGE = "report.json", "report.md"
DESIGN, TARGETS, MESH, WORKBOOK = "design.npy", "targets.json", "design.stl", "tables.xlsx"
_LAYERS = "layers"
_OURS = (MESH, WORKBOOK, f"{_LAYERS}/layer*.*", *(f"*.{kind}" for kind in ("png", "svg", "pdf")))
_CAPTIONS = {
    "layer_counts": "Sliced areas along the three axes: real, asked for, and the design's",
    "trabeculae": "Trabeculae per layer",
    "tables": "The tables alpha and beta",
    "layers": "Layers along Z",
}


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
        For wrong input, targets that no design meets, a search that gave up; nothing is then written.
    """
    parameters = parameters_of(options)
    if options["estimate"]:
        layers = layers_of_source(options["file"], parameters)
        report("text", text=estimate(layers, parameters.strategy).words)
        return 0
    if options["xlsx"]:
        require_openpyxl()
    require_own_folder(options["out"], KIND)
    kind = plots_kind(options["plots"], report)
    progress = progress_of(report)
    with ResultFolder(options["out"]) as folder:
        report("temporary", path=str(folder.aside))
        record = _write(options, parameters, kind, folder, progress, report)
        folder.keep(*record["files"], PAGE, REPORT)  # the report last: it tells of files that are there
        written = {name.rsplit("/", 1)[-1] for name in record["files"]}
        warn_of_old_files(folder, written, _OURS, report)
    for text in record["notes"]:
        report("warning", text=text)
    report("text", text=report_summary(record) + f"\nwritten to {folder.target}")
    return 0 if record["ok"] else 1


def parameters_of(options: Dict[str, Any]) -> VoxelParameters:
    """Return the choices that the options make.

    Raises
    ------
    ParameterError
        If one breaks a rule.
    """
    chosen = {name: options[name] for name in FIELDS if options[name] is not None}
    return VoxelParameters(**{k: tuple(v) if isinstance(v, list) else v for k, v in chosen.items()})


def _write(
    options: Dict[str, Any],
    parameters: VoxelParameters,
    kind: str,
    folder: ResultFolder,
    progress: Progress,
    report: Report,
) -> Dict[str, Any]:
    """Design, write all files aside, and return the report's record."""
    start = time.perf_counter()
    targets, mask = _asked(options, parameters, part(progress, 0.0, 0.25))
    work = estimate(targets.shape[::-1], parameters.strategy)
    if Work(work.seconds, BYTES_PER_VOXEL * work.cells).is_heavy:
        report("text", text=work.words)
    parameters = replace(parameters, size=targets.voxel)
    read = time.perf_counter()
    design = make_design(targets, parameters, mask, part(progress, 0.25, 0.8))
    made = time.perf_counter()
    mesh = None if options["no_mesh"] else printable(block_mesh(design.voxels, targets.voxel, targets.origin))
    names = _write_files(design, mesh, options, folder, part(progress, 0.8, 0.9))
    more = _studies(design, options, part(progress, 0.9, 0.95))
    pictures = _write_plots(design, kind, folder, part(progress, 0.95, 1.0)) if kind != "none" else []
    phases = {"targets": read - start, **design.seconds, "files and plots": time.perf_counter() - made}
    files = {name: folder.path(name).stat().st_size for name in [*names, *(name for name, _ in pictures)]}
    design = replace(design, seconds=phases)
    record = design_record(
        design, Path(options["file"]).name, time.perf_counter() - start, mesh, versions(*PACKAGES), files
    )
    record.update(more)
    for name, text in ((PAGE, report_markdown(record, pictures)), (REPORT, record_json(record))):
        with whole_file(folder.path(name)) as file:
            file.write(text.encode("utf-8"))
    return record


def _asked(
    options: Dict[str, Any], parameters: VoxelParameters, progress: Progress
) -> Tuple[Targets, Optional[np.ndarray]]:
    """Targets, and the mask if there is one."""
    if options["density"] is not None:
        return targets_of_envelope(read_triangles(options["file"]), options["density"], parameters, progress)
    if options["tables"]:
        targets = targets_of_tables(options["tables"], parameters.size)
    else:
        targets = read_targets(options["file"], parameters, part(progress, 0.0, 0.8), options["threshold"])
    if not options["mask"]:
        return targets, None
    return targets, read_mask(options["mask"], targets, parameters.boundary, part(progress, 0.8, 1.0))


def _write_files(
    design: VoxelDesign, mesh: Optional[Mesh], options: Dict[str, Any], folder: ResultFolder, progress: Progress
) -> List[str]:
    """Write voxels, targets, tables, mesh and images; return the files' names."""
    progress(0.0, 1.0, "writing files")
    names = [DESIGN, TARGETS, "alpha.csv", "beta.csv"]
    write_npy(folder.path(DESIGN), design.voxels)
    with whole_file(folder.path(TARGETS)) as file:
        file.write(record_json(targets_record(design.targets)).encode("utf-8"))
    write_table_csv(folder.path("alpha.csv"), design.alpha)
    write_table_csv(folder.path("beta.csv"), design.beta)
    if options["xlsx"]:
        write_tables_xlsx(folder.path(WORKBOOK), design.alpha, design.beta)
        names.append(WORKBOOK)
    if mesh is not None:
        progress(0.3, 1.0, "writing the mesh")
        write_stl(folder.path(MESH), mesh)
        names.append(MESH)
    if options["images"] != "none":
        folder.path(_LAYERS).mkdir()
        step = part(progress, 0.5, 1.0)
        files = write_stack(folder.path(_LAYERS), design.voxels, design.targets.voxel, options["images"], step)
        names += [f"{_LAYERS}/{path.name}" for path in files]
    return names


def _studies(design: VoxelDesign, options: Dict[str, Any], progress: Progress) -> Dict[str, Any]:
    """What was asked besides the design: how many there are, how often tables fit."""
    found: Dict[str, Any] = {}
    if options["count"]:
        found["counting"] = counting_record(design, part(progress, 0.0, 0.8))
    if options["rates"]:
        rates = pair_rates(design.targets, design.parameters, options["rates"], part(progress, 0.8, 1.0))
        found["rates"] = rates._asdict()
    return found


def _write_plots(design: VoxelDesign, kind: str, folder: ResultFolder, progress: Progress) -> List[tuple]:
    """Write the plots; return (file, caption) of each."""
    pictures = []
    for number, (name, figure) in enumerate(design_figures(design).items()):
        progress(number, len(_CAPTIONS), "plots")
        save_figure(figure, folder.path(f"{name}.{kind}"), kind)
        pictures.append((f"{name}.{kind}", _CAPTIONS[name]))
    return pictures
