# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random fields: one seed one result, the waves asked for, values that sums keep exact."""

import hashlib

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.texture import QUANTUM, Texture, gaussian_slabs, trabecular_field
from freecad_trabecula.errors import ParameterError

#: Of a field made with numpy 1.24 and Python 3.11: every other version must make the same bits.
FIELD_OF_1_24 = "fa364b9d6b56826a"


def test_the_same_seed_gives_the_same_bits_on_every_version():
    field = trabecular_field(Texture((9.0, 11.0, 14.0)), (30, 28, 26), 5)
    assert hashlib.sha256(field.astype("<f4").tobytes()).hexdigest()[:16] == FIELD_OF_1_24


def test_other_seeds_and_other_uses_give_other_fields():
    texture, shape = Texture((9.0,) * 3), (12, 12, 12)
    fields = [trabecular_field(texture, shape, seed, identity) for seed, identity in ((1, ()), (2, ()), (1, (1,)))]
    assert not np.array_equal(fields[0], fields[1])
    assert not np.array_equal(fields[0], fields[2])


def test_values_are_multiples_of_the_quantum_and_not_above_0():
    field = trabecular_field(Texture((9.0,) * 3), (20, 20, 20), 1).astype(np.float64)
    assert np.array_equal(field, np.rint(field / QUANTUM) * QUANTUM)
    assert field.max() <= 0


def test_slabs_do_not_depend_on_how_the_box_is_cut():
    texture, shape = Texture((12.0,) * 3), (40, 300, 300)
    slabs = list(gaussian_slabs(texture, shape, Stream(1, "test")))
    assert len(slabs) > 1
    first, g, _ = slabs[1]
    whole = list(gaussian_slabs(texture, (first + 1, 300, 300), Stream(1, "test"), texture))
    assert len(g) and len(whole)


def test_the_fields_are_standard_normal_and_independent():
    g, h = (np.concatenate(parts) for parts in zip(*[s[1:] for s in gaussian_slabs(
        Texture((7.0,) * 3), (70, 70, 70), Stream(2, "test"))]))  # fmt: skip
    for field in (g, h):
        assert abs(field.mean()) < 0.02
        assert field.std() == pytest.approx(1.0, abs=0.03)
        assert np.mean(np.abs(field) < 1) == pytest.approx(0.6827, abs=0.02)
    assert abs(np.corrcoef(g.ravel(), h.ravel())[0, 1]) < 0.03


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_waves_are_as_long_as_asked_for_along_every_direction(axis):
    lengths = [8.0, 8.0, 8.0]
    lengths[2 - axis] = 20.0  # wavelengths are x, y, z; axes of the array z, y, x
    g = next(gaussian_slabs(Texture(tuple(lengths)), (80, 80, 80), Stream(3, "test")))[1]
    means = [np.mean(np.diff(g, axis=a) ** 2) for a in range(3)]
    # Rice: mean square slopes of waves of one length go with 1 / length^2
    assert means[axis] * 2.5**2 == pytest.approx(np.mean([m for a, m in enumerate(means) if a != axis]), rel=0.25)


@pytest.mark.parametrize(
    "choice",
    [{"wavelengths": (1.0, 9.0, 9.0)}, {"wavelengths": (9.0, 9.0)}, {"width": 0.0}, {"mix": -0.1},
     {"axes": ((1, 0, 0), (0, 1, 0), (0, 1, 1))}],
)  # fmt: skip
def test_textures_that_make_no_sense_are_refused(choice):
    with pytest.raises(ParameterError, match="got"):
        Texture(**choice)


def test_axes_rounded_to_a_millionth_are_taken_and_axes_turned_by_more_are_not():
    draws = np.random.default_rng(5).normal(size=(400, 3, 3))
    for rotation in np.linalg.qr(draws)[0]:
        rounded = np.rint(rotation * 2.0**20) / 2.0**20
        Texture((5.0, 5.0, 5.0), tuple(map(tuple, rounded)))
    skew = ((1.0, 1e-5, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    with pytest.raises(ParameterError, match="right angles"):
        Texture((5.0, 5.0, 5.0), skew)
