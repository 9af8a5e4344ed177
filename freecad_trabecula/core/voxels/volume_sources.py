# SPDX-License-Identifier: LGPL-2.1-or-later
"""Targets from voxels that were scanned or designed before: NPY, NRRD, image stacks, thresholded."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Optional, Union

import numpy as np

from ...errors import ExportError, ParameterError
from ..progress import Progress, silent
from ..triples import triple
from .image_stacks import read_stack
from .parameters import VoxelParameters
from .targets import Targets, targets_of_voxels
from .thresholds import material
from .trabeculae import trabecula_counts
from .volume_files import Volume, read_npy, read_nrrd

#: Suffixes of volumes in one file.
VOLUMES = (".npy", ".nrrd", ".tif", ".tiff")


def targets_of_volume(
    path: Union[str, Path],
    parameters: VoxelParameters,
    threshold: Optional[float] = None,
    progress: Progress = silent,
) -> Targets:
    """Return the targets of a volume; the voxel size is the file's own, of NPY that of the parameters.

    Parameters
    ----------
    path : str or Path
        One of ``VOLUMES``, or a folder of images.
    parameters : VoxelParameters
    threshold : float, optional
        Values above it are material; None: Otsu's.
    progress : callable

    Raises
    ------
    ParameterError
        If the file is damaged, images are of unequal sizes, or nothing or everything is material.
    DependencyError
        If Pillow is needed and missing.
    """
    volume = _read(Path(path), parameters, progress)
    solid = material(volume.values, threshold)
    targets = targets_of_voxels(solid, volume.voxel)
    asked = trabecula_counts(solid) if parameters.trabeculae != "off" else None
    return replace(
        targets, origin=triple(volume.origin), trabeculae=asked, thickness=block_thickness(solid, volume.voxel)
    )


def _read(path: Path, parameters: VoxelParameters, progress: Progress) -> Volume:
    try:
        if path.suffix.lower() == ".npy":
            return Volume(read_npy(path), parameters.size, (0.0, 0.0, 0.0))
        return read_nrrd(path) if path.suffix.lower() == ".nrrd" else read_stack(path, progress=progress)
    except ExportError as error:
        raise ParameterError(str(error)) from error


def block_thickness(voxels: np.ndarray, voxel: tuple) -> float:
    """Return the mean thickness 2 V / S of voxels, mm; their stairs have 3/2 of a smooth surface's area in the mean.

    Parameters
    ----------
    voxels : ndarray of shape (P, M, N), bool
    voxel : tuple
        Edges dx, dy, dz, mm.

    Examples
    --------
    A plate of 2 voxels, whose faces are no stairs, seems 3/2 as thick as it is:

    >>> plate = np.zeros((400, 400, 4), bool)
    >>> plate[:, :, 1:3] = True
    >>> round(block_thickness(plate, (1.0, 1.0, 1.0)), 1)
    3.0
    """
    cell = math.prod(voxel)
    surface = 0.0
    for axis, edge in zip((2, 1, 0), voxel):  # what touches the box's border is cut there, not surface
        surface += np.count_nonzero(np.diff(voxels, axis=axis)) * cell / edge
    return float(2 * np.count_nonzero(voxels) * cell / (surface / 1.5)) if surface else math.nan
