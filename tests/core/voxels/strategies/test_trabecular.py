# SPDX-License-Identifier: LGPL-2.1-or-later
"""Trabecular designs: exact, one part, no cavity, no contact by an edge; with what else is asked for."""

import hashlib
from pathlib import Path

import numpy as np
import pytest

from freecad_trabecula.core.voxels.connectivity import closed_cavities, corner_contacts, edge_contacts, parts
from freecad_trabecula.core.voxels.masks import targets_within
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.voxels.sources import read_targets
from freecad_trabecula.core.voxels.strategies.trabecular import DEFAULT_WAVELENGTH, chosen_texture, design
from freecad_trabecula.core.voxels.targets import Targets, targets_of_voxels
from freecad_trabecula.core.voxels.texture import Texture, trabecular_field
from freecad_trabecula.core.voxels.thinnest import thin_voxels
from freecad_trabecula.core.voxels.trabeculae import mean_deviation, trabecula_counts
from freecad_trabecula.core.voxels.verification import layer_errors
from freecad_trabecula.errors import Cancelled, InfeasibleError, ParameterError

#: Made with numpy 1.24, scipy 1.10, Python 3.11: every other version must make the same voxels.
DESIGN_OF_1_24 = "c4cc1faea2c1718c"


def sample_of(seed=21, shape=(36, 34, 38), wavelength=11.0, share=0.75):
    field = trabecular_field(Texture((wavelength,) * 3, mix=0.2), shape, seed)
    field += np.linspace(-0.2, 0.2, shape[0], dtype=np.float32)[:, None, None]
    return field > np.quantile(field, share)


TARGETS = targets_of_voxels(sample_of())


def assert_one_exact_part(voxels, targets, mask=None):
    assert layer_errors(voxels, targets) == []
    assert len(parts(voxels)[1]) == 2
    assert len(closed_cavities(voxels, mask)[1]) == 1


@pytest.mark.parametrize("seed", [1, 2, 3])
@pytest.mark.parametrize("contacts", ["any", "edge", "corner"])
def test_designs_are_exact_in_one_part_without_the_contacts_that_are_avoided(seed, contacts):
    voxels = design(TARGETS, VoxelParameters(seed=seed, contacts=contacts))
    assert_one_exact_part(voxels, TARGETS)
    assert contacts == "any" or edge_contacts(voxels) == 0
    assert contacts != "corner" or corner_contacts(voxels) == 0


def test_the_same_seed_gives_the_same_design_on_every_version():
    voxels = design(TARGETS, VoxelParameters(seed=4))
    assert hashlib.sha256(np.packbits(voxels).tobytes()).hexdigest()[:16] == DESIGN_OF_1_24


def test_other_seeds_give_other_designs():
    first, second = (design(TARGETS, VoxelParameters(seed=seed)) for seed in (1, 2))
    assert 2 * (first & second).sum() / (first.sum() + second.sum()) < 0.6


@pytest.mark.parametrize("density", [0.06, 0.3, 0.85])
def test_sparse_and_dense_designs_in_a_ball_are_exact_and_stay_in_it(density):
    z, y, x = np.ogrid[:32, :32, :32]
    mask = (z - 15.5) ** 2 + (y - 15.5) ** 2 + (x - 15.5) ** 2 <= 256
    targets = targets_within(mask, (density,) * 3)
    voxels = design(targets, VoxelParameters(), mask)
    assert_one_exact_part(voxels, targets, mask)
    assert not (voxels & ~mask).any()


def test_the_least_thickness_is_kept_and_counts_stay_exact():
    voxels = design(TARGETS, VoxelParameters(seed=2, thickness=2, wavelength=1.6, rods=0.3))
    assert_one_exact_part(voxels, TARGETS)
    assert thin_voxels(voxels, 2) == (0, 0)


def test_numbers_of_trabeculae_come_near_the_samples():
    voxels = design(TARGETS, VoxelParameters(trabeculae="xyz"))
    assert_one_exact_part(voxels, TARGETS)
    pairs = list(zip(trabecula_counts(voxels), trabecula_counts(TARGETS.sample)))
    assert np.mean([mean_deviation(counts, goal) for counts, goal in pairs]) < 0.15


def test_empty_layers_at_the_ends_stay_empty():
    sample = np.zeros((30, 30, 30), bool)
    sample[4:27, 3:28, 5:26] = sample_of(3, (23, 25, 21), 9.0)
    targets = targets_of_voxels(sample)
    assert_one_exact_part(design(targets, VoxelParameters()), targets)


def test_the_texture_is_the_users_where_it_is_given_and_in_voxels():
    targets = targets_of_voxels(sample_of(), (0.1, 0.1, 0.2))
    texture = chosen_texture(targets, VoxelParameters(size=(0.1, 0.1, 0.2), wavelength=(1.0, 1.2, 1.4), rods=0.5))
    assert texture.wavelengths == pytest.approx((10.0, 12.0, 7.0))
    assert texture.mix == 0.5


def test_without_a_sample_the_texture_is_the_usual_one():
    bare = Targets(TARGETS.d, TARGETS.e, TARGETS.c)
    assert chosen_texture(bare, VoxelParameters()).wavelengths == (DEFAULT_WAVELENGTH,) * 3


def test_an_empty_layer_between_others_is_refused_by_name():
    counts = np.full(8, 6)
    hollow = counts.copy()
    hollow[[2, 5]] = 12, 0
    with pytest.raises(InfeasibleError, match="along X layers 4 and 6"):
        design(Targets(hollow, counts, counts), VoxelParameters())


def test_a_mask_in_two_parts_is_refused():
    mask = np.ones(TARGETS.shape, bool)
    mask[16:18] = False
    with pytest.raises(ParameterError, match="in one part"):
        design(TARGETS, VoxelParameters(), mask)


def test_a_design_can_be_cancelled():
    def stop(done, total, what):
        raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        design(TARGETS, VoxelParameters(), None, stop)


def test_numbers_of_trabeculae_without_a_sample_are_refused():
    with pytest.raises(ParameterError, match="need a sample"):
        design(Targets(TARGETS.d, TARGETS.e, TARGETS.c), VoxelParameters(trabeculae="z"))


@pytest.mark.parametrize("name", ["a", "b"])
@pytest.mark.parametrize("seed", [1, 2])
def test_specimens_that_hold_about_one_wave_are_designed(name, seed):
    path = Path(__file__).parents[4] / "resources" / "examples" / ("shrew_bone_%s.ply" % name)
    chosen = VoxelParameters(size=(0.1, 0.1, 0.1), seed=seed)
    targets = read_targets(path, chosen)
    made = design(targets, chosen)
    assert_one_exact_part(made, targets)
    assert max(chosen_texture(targets, chosen).wavelengths) <= 4 * max(made.shape)  # texture_fit says why
