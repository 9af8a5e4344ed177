# SPDX-License-Identifier: LGPL-2.1-or-later
"""Targets from volumes: what was written is asked for again; damaged ones are refused."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.image_stacks import write_stack
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.voxels.sources import read_targets
from freecad_trabecula.core.voxels.targets import targets_of_voxels
from freecad_trabecula.core.voxels.volume_files import write_npy, write_nrrd
from freecad_trabecula.core.voxels.volume_sources import block_thickness
from freecad_trabecula.errors import ParameterError

CHOICE = VoxelParameters(strategy="sequential", size=0.1)
VOXELS = Stream(4, "volume").many(5 * 6 * 7).reshape(5, 6, 7) < 0.4


def counts_of(targets):
    return [c.tolist() for c in targets.counts]


ASKED = counts_of(targets_of_voxels(VOXELS))


def test_a_design_written_is_asked_for_again(tmp_path):
    write_npy(tmp_path / "a.npy", VOXELS)
    write_nrrd(tmp_path / "a.nrrd", VOXELS, (0.2, 0.2, 0.3), (1.0, 2.0, 3.0))
    assert counts_of(read_targets(tmp_path / "a.npy", CHOICE)) == ASKED
    targets = read_targets(tmp_path / "a.nrrd", CHOICE)
    assert counts_of(targets) == ASKED
    assert targets.voxel == pytest.approx((0.2, 0.2, 0.3)) and targets.origin == pytest.approx((1, 2, 3))
    assert (targets.sample == VOXELS).all()


def test_a_folder_of_images_is_a_sample(tmp_path):
    pytest.importorskip("PIL", reason="Pillow IS NOT INSTALLED: image stacks are NOT tested")
    write_stack(tmp_path, VOXELS, (0.05, 0.05, 0.05))
    targets = read_targets(tmp_path, CHOICE)
    assert counts_of(targets) == ASKED and targets.voxel[0] == pytest.approx(0.05, rel=1e-3)


def test_a_threshold_is_otsu_s_or_a_value(tmp_path):
    grey = np.where(VOXELS, 180, 20).astype(np.uint8)
    grey[0, 0, 0] = 100
    np.save(tmp_path / "grey.npy", grey)
    above = VOXELS.copy()
    above[0, 0, 0] = True
    assert counts_of(read_targets(tmp_path / "grey.npy", CHOICE, threshold=60)) == counts_of(targets_of_voxels(above))
    above[0, 0, 0] = False
    assert counts_of(read_targets(tmp_path / "grey.npy", CHOICE, threshold=150)) == counts_of(targets_of_voxels(above))


def test_the_thickness_of_a_ball_of_voxels_is_nearly_that_of_the_ball():
    z, y, x = np.ogrid[-30:31, -30:31, -30:31]
    ball = x * x + y * y + z * z <= 25**2
    # 2 V / S of a ball is 2 r / 3
    assert block_thickness(ball, (0.1, 0.1, 0.1)) == pytest.approx(2 * 2.5 / 3, rel=0.02)


def test_trabeculae_are_counted_when_asked_for(tmp_path):
    write_npy(tmp_path / "a.npy", VOXELS)
    chosen = VoxelParameters(strategy="sequential", trabeculae="z")
    assert [len(t) for t in read_targets(tmp_path / "a.npy", chosen).trabeculae] == [7, 6, 5]


@pytest.mark.parametrize("name", ["a.npy", "a.nrrd"])
def test_a_damaged_volume_is_refused(tmp_path, name):
    write_npy(tmp_path / "a.npy", VOXELS)
    write_nrrd(tmp_path / "a.nrrd", VOXELS, (0.1, 0.1, 0.1), (0.0, 0.0, 0.0))
    whole = (tmp_path / name).read_bytes()
    (tmp_path / name).write_bytes(whole[: len(whole) * 2 // 3])
    with pytest.raises(ParameterError, match=name):
        read_targets(tmp_path / name, CHOICE)


def test_images_of_unequal_sizes_and_an_empty_folder_are_refused(tmp_path):
    pytest.importorskip("PIL", reason="Pillow IS NOT INSTALLED: image stacks are NOT tested")
    with pytest.raises(ParameterError, match="must hold images"):
        read_targets(tmp_path, CHOICE)
    write_stack(tmp_path, VOXELS, (0.1, 0.1, 0.1))
    (tmp_path / "other").mkdir()
    other = write_stack(tmp_path / "other", VOXELS[:1, :3], (0.1, 0.1, 0.1))[0]
    other.rename(tmp_path / "layer_0003.png")
    with pytest.raises(ParameterError, match="size"):
        read_targets(tmp_path, CHOICE)


def test_an_empty_or_full_volume_is_refused(tmp_path):
    for value in (False, True):
        np.save(tmp_path / "a.npy", np.full((3, 3, 3), value))
        with pytest.raises(ParameterError, match="must have material and voids"):
            read_targets(tmp_path / "a.npy", CHOICE)
