# SPDX-License-Identifier: LGPL-2.1-or-later
"""Offsets that give a field its layer counts."""

import numpy as np
import pytest

from freecad_trabecula.core.voxels.plane_offsets import (
    FORBIDDEN,
    layer_sums,
    newton_offsets,
    on_field,
    polished,
    solid_of,
)  # fmt: skip
from freecad_trabecula.core.voxels.texture import QUANTUM, Texture, trabecular_field
from freecad_trabecula.errors import ParameterError

SHAPE = (24, 20, 28)


def field_and_counts(seed=1):
    field = trabecular_field(Texture((9.0,) * 3), SHAPE, seed)
    z, y, x = (np.linspace(-0.3, 0.3, n).astype(np.float32) for n in SHAPE)
    other = trabecular_field(Texture((9.0,) * 3), SHAPE, seed + 50) + (z[:, None, None] + y[:, None] ** 2 - x)
    return field, layer_sums(other > np.quantile(other, 0.7))


def missing(field, counts, offsets):
    return [int(np.abs(c - s).sum()) for c, s in zip(counts, layer_sums(solid_of(field, offsets)))]


def test_layer_sums_are_those_of_numpy():
    solid = np.arange(60).reshape(3, 4, 5) % 3 == 0
    for axis, sums in enumerate(layer_sums(solid)):
        assert sums.tolist() == solid.sum(tuple(a for a in range(3) if a != axis)).tolist()


def test_newton_comes_near_all_counts_and_polishing_nearer():
    field, counts = field_and_counts()
    offsets = newton_offsets(field, counts)
    before, after = missing(field, counts, offsets), missing(field, counts, polished(field, counts, offsets, 3))
    assert sum(before) < 0.05 * 3 * counts[0].sum()
    assert sum(after) < sum(before)
    assert after[2] <= 3  # the last axis is exact but for ties


def test_no_other_solid_with_the_same_counts_sums_higher_over_the_field():
    field, counts = field_and_counts(2)
    offsets = polished(field, counts, newton_offsets(field, counts))
    best = solid_of(field, offsets)
    # exchanges of four voxels on a rectangle keep all counts
    generator = np.random.RandomState(1)
    for _ in range(3000):
        z, y, (x1, x2), (y2,) = (generator.randint(0, n, k) for n, k in zip((24, 20, 28, 20), (1, 1, 2, 1)))
        z, y = int(z[0]), int(y[0])
        if best[z, y, x1] and not best[z, y, x2] and best[z, y2, x2] and not best[z, y2, x1]:
            change = field[z, y, x2] + field[z, y2, x1] - field[z, y, x1] - field[z, y2, x2]
            assert change <= 1e-6


def test_offsets_are_multiples_of_the_quantum():
    field, counts = field_and_counts(3)
    for offsets in newton_offsets(field, counts):
        assert np.array_equal(offsets, np.rint(offsets / QUANTUM) * QUANTUM)


def test_nothing_becomes_solid_where_it_may_not():
    field, _ = field_and_counts(4)
    mask = np.indices(SHAPE).sum(0) % 7 > 1
    field[~mask] = FORBIDDEN
    counts = [c // 3 for c in layer_sums(mask)]
    offsets = polished(field, counts, newton_offsets(field, counts))
    assert not (solid_of(field, offsets) & ~mask).any()
    assert sum(missing(field, counts, offsets)) < 0.1 * 3 * counts[0].sum()


def test_the_field_with_offsets_is_exact_in_single_precision():
    field, counts = field_and_counts(5)
    offsets = newton_offsets(field, counts)
    exact = field.astype(np.float64) + (offsets[0][:, None, None] + (offsets[1][:, None] + offsets[2]))
    assert np.array_equal(on_field(field, offsets).astype(np.float64), exact)


def test_targets_of_another_shape_are_refused():
    field, counts = field_and_counts()
    with pytest.raises(ParameterError, match="do not fit"):
        newton_offsets(field, counts[::-1])
