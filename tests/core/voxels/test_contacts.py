# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contacts by an edge or a corner alone are removed, and stay away."""

import numpy as np
import pytest

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.connectivity import Solid, closed_cavities, corner_contacts, edge_contacts, parts
from freecad_trabecula.core.voxels.contacts import remove_contacts
from freecad_trabecula.core.voxels.exact_moves import ExactMoves
from freecad_trabecula.core.voxels.joining import one_part
from freecad_trabecula.core.voxels.plane_offsets import layer_sums
from freecad_trabecula.errors import ExactnessError


def rough(seed, share=0.45, size=18):
    solid = (Stream(seed, "rough").uniform(size**3) < share).reshape((size,) * 3)
    return one_part(solid, np.ones(solid.shape, bool))


def moves_of(solid):
    field = np.zeros(solid.shape, np.float32)
    return ExactMoves(Solid(solid), field, [np.zeros(n) for n in solid.shape], layer_sums(solid))


@pytest.mark.parametrize("seed", [1, 2, 3])
@pytest.mark.parametrize("corners", [False, True])
def test_no_contact_is_left_in_a_rough_solid(seed, corners):
    solid = rough(seed)
    assert edge_contacts(solid) > 100
    moves = moves_of(solid)
    found = remove_contacts(moves, corners)
    voxels = moves.solid.voxels
    assert found == (edge_contacts(solid), corner_contacts(solid) if corners else 0)
    assert edge_contacts(voxels) == 0
    assert not corners or corner_contacts(voxels) == 0
    assert len(parts(voxels)[1]) == 2
    assert len(closed_cavities(voxels)[1]) == 1


def test_exact_moves_afterwards_bring_no_contact_back():
    solid = rough(4, 0.3)
    moves = moves_of(solid)
    remove_contacts(moves, True)
    changed = moves.missing
    moves.spread()
    assert moves.missing < changed
    assert edge_contacts(moves.solid.voxels) == corner_contacts(moves.solid.voxels) == 0


def test_a_solid_without_contacts_is_left_alone():
    solid = np.zeros((8, 8, 8), bool)
    solid[2:6, 2:6, 2:6] = True
    moves = moves_of(solid)
    assert remove_contacts(moves, True) == (0, 0)
    assert moves.flips == 0


def test_contacts_that_the_mask_holds_in_place_are_refused_with_their_number():
    # two voxels joined by a bent bar, alone in their mask: each flip would split it or leave the mask
    mask = np.zeros((1, 2, 2), bool)
    mask[0, 0, 0] = mask[0, 1, 1] = True
    moves = ExactMoves(Solid(mask.copy(), mask), np.zeros(mask.shape, np.float32), [np.zeros(n) for n in mask.shape],
                       layer_sums(mask))  # fmt: skip
    with pytest.raises(ExactnessError, match="of 1 contacts 1 could not be removed"):
        remove_contacts(moves)
