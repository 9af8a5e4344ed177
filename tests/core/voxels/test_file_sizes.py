# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sizes told before are those of the files."""

import importlib.util

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.file_sizes import estimated_size
from freecad_trabecula.core.voxels.image_stacks import write_stack
from freecad_trabecula.core.voxels.volume_files import write_npy, write_nrrd, write_vti
from freecad_trabecula.errors import ParameterError

VOXEL, ORIGIN = (0.1, 0.1, 0.1), (0.0, 0.0, 0.0)
needs_pillow = pytest.mark.skipif(importlib.util.find_spec("PIL") is None, reason="Pillow is not installed")


@pytest.fixture(scope="module")
def voxels():
    noise = Stream(3, "sizes").uniform(60 * 50 * 45).reshape(60, 50, 45)
    blurred = sum(np.roll(noise, (i, j, k), (0, 1, 2)) for i in range(3) for j in range(3) for k in range(3))
    return blurred > np.median(blurred)


@pytest.mark.parametrize("kind", ["npy", "nrrd", "vti"])
def test_a_volume_file_is_as_large_as_it_was_said(tmp_path, voxels, kind):
    path = tmp_path / f"design.{kind}"
    if kind == "npy":
        write_npy(path, voxels)
    else:
        {"nrrd": write_nrrd, "vti": write_vti}[kind](path, voxels, VOXEL, ORIGIN)
    assert estimated_size(kind, voxels) == pytest.approx(path.stat().st_size, rel=0.1)


@pytest.mark.parametrize(
    "kind", ["png", pytest.param("bmp", marks=needs_pillow), pytest.param("tiff", marks=needs_pillow)]
)
def test_a_stack_is_as_large_as_it_was_said(tmp_path, voxels, kind):
    files = write_stack(tmp_path, voxels, VOXEL, kind)
    assert estimated_size(kind, voxels) == pytest.approx(sum(path.stat().st_size for path in files), rel=0.2)


def test_another_kind_is_refused(voxels):
    with pytest.raises(ParameterError, match="must be one of npy, nrrd, vti, png, bmp, tiff, got 'gif'"):
        estimated_size("gif", voxels)
