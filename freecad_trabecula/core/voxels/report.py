# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a voxel design as one record of plain values (report.json); ``report_text`` makes pages of it."""

from __future__ import annotations

import json
import math
from typing import Any, Dict, Mapping, Optional, Sequence

import numpy as np

from ..meshes import Mesh, is_closed, mesh_volume
from ..records import to_record
from .connectivity import closed_cavities, corner_contacts, edge_contacts, parts
from .design import VoxelDesign
from .feasibility import smallest_cap
from .sources import targets_record
from .targets import AXES
from .trabeculae import mean_deviation, trabecula_counts
from .verification import layer_errors

SCHEMA, KIND = 1, "voxel design"
#: CPU seconds of the thesis on the 103 x 94 x 103 voxels of its sample (6.3.1, 6.3.2): alpha, beta, layers.
THESIS_SECONDS = {"minimum-zeros": (94, 90, 1198), "sequential": (115, 108, 1217)}


def design_record(
    design: VoxelDesign,
    name: str,
    seconds: float,
    mesh: Optional[Mesh] = None,
    versions: Optional[Mapping[str, str]] = None,
    files: Optional[Mapping[str, int]] = None,
    more_notes: Sequence[str] = (),
) -> Dict[str, Any]:
    """Return what is known of a design.

    Parameters
    ----------
    design : VoxelDesign
    name : str
        Where the targets came from.
    seconds : float
        Time of the whole run.
    mesh : Mesh, optional
        The design's mesh, to be checked.
    versions, files : dict, optional
        Programs that took part; bytes of each file.
    more_notes : sequence of str
        What the user should know besides.

    Raises
    ------
    ExactnessError
        If the design has other layers than its targets.
    """
    errors = layer_errors(design.voxels, design.targets)
    record = {
        "kind": KIND,
        "schema": SCHEMA,
        "name": name,
        "seed": design.parameters.seed,
        "strategy": design.parameters.strategy,
        "exact": not errors,
        "wrong_layers": [list(e) for e in errors],
        "layers": dict(zip(("N", "M", "P"), design.targets.layers)),
        "voxels": int(design.voxels.sum()),
        "voxel_mm": list(design.targets.voxel),
        "volume_mm3": design.targets.volume,
        "bone_fraction": int(design.voxels.sum()) / _cells(design),
        **connection_record(design.voxels, design.mask),
        "trabeculae": trabeculae_record(design),
        "tables": {
            "alpha_max": int(design.alpha.max()),
            "beta_max": int(design.beta.max()),
            "alpha_zeros": int((design.alpha == 0).sum()),
            "beta_zeros": int((design.beta == 0).sum()),
            "alpha_smallest_cap": smallest_cap(design.targets.c, design.targets.d),
            "beta_smallest_cap": smallest_cap(design.targets.c, design.targets.e),
        },
        "deltas": dict(zip(("delta_X", "delta_Y", "delta_Z"), design.targets.deltas)),
        "mean_thickness_voxels": _finite(design.targets.thickness / max(design.targets.voxel)),
        "notes": [*design.notes, *more_notes],
        "mesh": None if mesh is None else _mesh_record(mesh, design),
        "seconds": seconds,
        "phases": dict(design.seconds),
        "parameters": to_record(design.parameters, everything=True),
        "targets": targets_record(design.targets),
        "files": dict(files or {}),
        "versions": dict(versions or {}),
    }
    record["ok"] = bool(record["exact"]) and (mesh is None or record["mesh"]["watertight"])
    return record


def _cells(design: VoxelDesign) -> int:
    return design.voxels.size if design.mask is None else int(design.mask.sum())


def _finite(value: float) -> Optional[float]:
    return float(value) if math.isfinite(value) else None


def connection_record(voxels: np.ndarray, mask: Optional[np.ndarray] = None) -> Dict[str, Any]:
    """Return how the solid hangs together.

    Parameters
    ----------
    voxels : ndarray of shape (P, M, N), bool
    mask : ndarray of the same shape, bool, optional

    Returns
    -------
    dict
        ``components`` of 6-neighbours, ``largest_fraction`` of the voxels in the largest, ``floating_voxels`` outside
        of it, ``single_voxels`` that touch no other by a face, ``closed_cavities``, ``edge_contacts``,
        ``corner_contacts``.
    """
    sizes = parts(voxels)[1][1:]
    total = int(sizes.sum())
    largest = int(sizes.max()) if len(sizes) else 0
    return {
        "components": len(sizes),
        "largest_fraction": largest / total if total else 0.0,
        "floating_voxels": total - largest,
        "single_voxels": int((sizes == 1).sum()),
        "closed_cavities": len(closed_cavities(voxels, mask)[1]) - 1,
        "edge_contacts": edge_contacts(voxels),
        "corner_contacts": corner_contacts(voxels),
    }


def trabeculae_record(design: VoxelDesign) -> Dict[str, Any]:
    """Return the numbers of trabeculae (4-connected) per layer, and how far they are from those asked for."""
    record = {}
    wanted = design.targets.trabeculae
    for k, (axis, counts) in enumerate(zip(AXES, trabecula_counts(design.voxels))):
        record[axis] = {"mean": float(counts.mean()), "per_layer": counts.tolist()}
        if wanted is not None:
            record[axis]["target_mean"] = float(np.mean(wanted[k]))
            record[axis]["mean_deviation"] = mean_deviation(counts, np.asarray(wanted[k]))
    return record


def _mesh_record(mesh: Mesh, design: VoxelDesign) -> Dict[str, Any]:
    volume = mesh_volume(mesh)
    return {
        "triangles": len(mesh.triangles),
        "volume_mm3": volume,
        "volume_error": volume / design.targets.volume - 1,
        "watertight": is_closed(mesh),
    }


def record_json(record: Mapping[str, Any]) -> str:
    """Return a record as the text of a JSON file.

    Raises
    ------
    ValueError
        If a value is not finite: that would be no JSON.
    """
    return json.dumps(record, indent=1, allow_nan=False) + "\n"
