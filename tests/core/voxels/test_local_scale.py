# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields of varying wavelength."""

import numpy as np
import pytest

from freecad_trabecula.core.voxels.local_scale import VaryingField, locally_fitted
from freecad_trabecula.core.voxels.plane_offsets import layer_sums, newton_offsets, solid_of
from freecad_trabecula.core.voxels.texture import QUANTUM, Texture, trabecular_field
from freecad_trabecula.core.voxels.trabeculae import trabecula_counts
from freecad_trabecula.errors import Cancelled

SHAPE = (40, 40, 40)
TEXTURE = Texture((12.0,) * 3)


def counted(solid):
    return list(trabecula_counts(solid))[::-1]


def solid_with(counts):
    return lambda field: solid_of(field, newton_offsets(field, counts, narrowest=2.0**-5))


def test_a_field_of_one_wavelength_is_the_plain_one():
    varying = VaryingField(TEXTURE, SHAPE, 3).field([np.zeros(n) for n in SHAPE])
    assert varying == pytest.approx(trabecular_field(TEXTURE, SHAPE, 3), abs=2 * QUANTUM)


def test_longer_waves_in_half_the_layers_make_fewer_trabeculae_there():
    logs = [np.where(np.arange(40) < 20, -0.4, 0.5), np.zeros(40), np.zeros(40)]
    field = VaryingField(TEXTURE, SHAPE, 1).field(logs)
    counts = counted(field > np.quantile(field, 0.75))[0]
    assert counts[:15].mean() > 1.8 * counts[25:].mean()


def test_the_fit_comes_nearer_to_numbers_that_vary_from_layer_to_layer():
    logs = [np.linspace(0.5, -0.2, 40), np.zeros(40), np.zeros(40)]
    sample = VaryingField(TEXTURE, SHAPE, 9).field(logs)
    sample = sample > np.quantile(sample, 0.75)
    wanted, solidify = counted(sample), solid_with(layer_sums(sample))
    plain = counted(solidify(trabecular_field(TEXTURE, SHAPE, 2)))
    fitted = counted(solidify(locally_fitted(TEXTURE, SHAPE, 2, (), [wanted[0], None, None], solidify, counted)))
    assert np.abs(fitted[0] - wanted[0]).sum() < 0.8 * np.abs(plain[0] - wanted[0]).sum()


def test_the_fit_can_be_cancelled():
    def stop(done, total, what):
        raise Cancelled("stopped")

    counts = [np.full(40, 400)] * 3
    with pytest.raises(Cancelled):
        locally_fitted(TEXTURE, SHAPE, 1, (), counts, solid_with(counts), counted, stop)
