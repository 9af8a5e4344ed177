# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small boxes: designed where fields and moves find no way, refused with rule, layer and what to relax."""

import numpy as np
import pytest

from freecad_trabecula.core.progress import silent
from freecad_trabecula.core.voxels import small_boxes
from freecad_trabecula.core.voxels.connectivity import closed_cavities, edge_contacts, parts
from freecad_trabecula.core.voxels.exact_rules import Verdict
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.voxels.plane_offsets import layer_sums
from freecad_trabecula.core.voxels.small_boxes import SmallBox, is_small_box
from freecad_trabecula.core.voxels.strategies.trabecular import design
from freecad_trabecula.core.voxels.targets import Targets, targets_of_voxels
from freecad_trabecula.core.voxels.verification import layer_errors
from freecad_trabecula.errors import Cancelled, ExactnessError, InfeasibleError

DIAGONAL = [np.ones(2, int), np.ones(2, int), np.full(1, 2)]  # two voxels of a square, across


def of_box(counts, contacts="edge", progress=silent):
    shape = tuple(len(count) for count in counts)
    return SmallBox(counts, None, contacts, 1).design(np.zeros(shape, bool), np.zeros(shape), progress)


def assert_keeps_rules(voxels, targets):
    assert layer_errors(voxels, targets) == []
    assert len(parts(voxels)[1]) == 2 and len(closed_cavities(voxels)[1]) == 1 and edge_contacts(voxels) == 0


@pytest.mark.parametrize("arm", [1, 2, 3])
@pytest.mark.parametrize("seed", [1, 2])
def test_beams_with_full_layers_are_designed(arm, seed):
    y, x = np.mgrid[:8, :8]
    targets = targets_of_voxels(np.broadcast_to((x < arm) | (y < arm), (8, 8, 8)).copy())
    assert_keeps_rules(design(targets, VoxelParameters(seed=seed)), targets)


def test_stairs_whose_only_design_is_the_sample_are_found():
    z, _, x = np.mgrid[:12, :12, :12]
    sample = x <= z + 1
    targets = targets_of_voxels(sample)
    # full layers and, what is left of them taken off, full ones again: Gale's condition is tight all along
    assert np.array_equal(design(targets, VoxelParameters()), sample)


def test_counts_of_voxels_that_break_every_rule_are_designed_within_the_rules():
    sample = np.random.default_rng(5).random((6, 7, 6)) < 0.5
    assert len(parts(sample)[1]) > 2 and edge_contacts(sample) > 10
    targets = targets_of_voxels(sample)
    bare = Targets(targets.d, targets.e, targets.c)
    assert_keeps_rules(design(bare, VoxelParameters(seed=3)), bare)


def test_a_sample_that_lacks_one_voxel_of_its_box_is_designed():
    sample = np.ones((6, 6, 6), bool)
    sample[5, 5, 5] = False
    assert np.array_equal(design(targets_of_voxels(sample), VoxelParameters()), sample)


def test_a_refusal_names_the_rule_the_layer_and_what_to_relax():
    with pytest.raises(
        InfeasibleError, match="no contact by an edge alone; the nearest .* in layer .*; only a strategy"
    ):
        of_box(DIAGONAL)
    with pytest.raises(InfeasibleError, match="exists that has one part; the nearest one found has"):
        of_box(DIAGONAL, "any")


def test_where_contacts_are_all_that_is_in_the_way_the_refusal_says_so():
    # full but for two cells of a layer that touch by an edge alone
    solid = np.ones((1, 3, 3), bool)
    solid[0, 0, 0] = solid[0, 1, 1] = False
    solid[0, 0, 2] = solid[0, 2, 0] = True
    counts = layer_sums(solid)
    found = of_box(counts, "any")
    assert all(np.array_equal(a, b) for a, b in zip(layer_sums(found), counts))
    with pytest.raises(InfeasibleError, match="with contacts 'any' there is one"):
        of_box(counts)


def test_what_is_not_decided_is_said_to_be_not_found(monkeypatch):
    monkeypatch.setattr(small_boxes, "decided", lambda *_: Verdict(None, (), False))
    with pytest.raises(ExactnessError, match="none was found; the nearest one found has .*; another seed"):
        of_box(DIAGONAL)


def test_what_a_program_finds_is_told_and_not_taken_for_one_seed_must_give_one_design(monkeypatch):
    answer = np.array([[[True], [False]], [[False], [True]]])
    monkeypatch.setattr(small_boxes, "decided", lambda *_: Verdict(answer, (), True))
    with pytest.raises(ExactnessError, match="exists, but was not found; another seed may do"):
        of_box(DIAGONAL)


def test_the_search_can_be_cancelled():
    def stop(done, total, what):
        raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        of_box(DIAGONAL, progress=stop)


def test_boxes_up_to_eight_thousand_cells_are_small():
    assert is_small_box((20, 20, 20)) and not is_small_box((20, 20, 21))
