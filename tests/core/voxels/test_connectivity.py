# SPDX-License-Identifier: LGPL-2.1-or-later
"""What hangs together, held against scipy's labels on all or many neighbourhoods."""

import numpy as np
import pytest
from scipy import ndimage

from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels import connectivity
from freecad_trabecula.core.voxels.connectivity import EDGES, FACES, STEPS, Solid


def random_solid(shape, share, seed=1):
    return (Stream(seed, "test").uniform(int(np.prod(shape))) < share).reshape(shape)


def groups_by_labels(code, steps, faces):
    """Return how many labelled parts of the neighbours of a code hold one of the faces."""
    block = np.zeros((3, 3, 3), bool)
    for bit, step in enumerate(STEPS[:18]):
        if (code >> bit) & 1 and tuple(step) in steps:
            block[tuple(step + 1)] = True
    labels = ndimage.label(block)[0]
    return len({int(labels[tuple(np.add(f, 1))]) for f in faces} - {0})


def test_groups_of_faces_are_those_that_labels_find():
    codes = Stream(3, "codes").integers(400) % np.uint64(1 << 18)
    for code in codes.astype(int):
        steps = {*FACES, *EDGES}
        assert connectivity.face_groups()[code] == groups_by_labels(code, steps, FACES)


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_groups_in_a_plane_are_those_that_labels_find(axis):
    faces = [f for f in FACES if f[axis] == 0]
    steps = {s for s in (*FACES, *EDGES) if s[axis] == 0}
    for code in (Stream(4, "codes", axis).integers(200) % np.uint64(1 << 18)).astype(int):
        assert connectivity.planar_groups()[axis, code] == groups_by_labels(code, steps, faces)


def test_contacts_change_by_what_counting_before_and_after_gives():
    voxels = random_solid((7, 7, 7), 0.5)
    solid = Solid(voxels)
    index = solid.index_of(*(a.ravel() for a in np.indices(voxels.shape)))
    edges, corners = solid.contact_changes(index)
    padded = np.pad(voxels, 1)
    for place, edge, corner in zip(np.ndindex(voxels.shape), edges, corners):
        flipped = padded.copy()
        flipped[tuple(np.add(place, 1))] ^= True
        assert edge == connectivity.edge_contacts(flipped) - connectivity.edge_contacts(padded)
        assert corner == connectivity.corner_contacts(flipped) - connectivity.corner_contacts(padded)


def test_a_flip_that_is_allowed_neither_splits_the_solid_nor_closes_a_cavity():
    voxels = random_solid((6, 6, 6), 0.55, 2)
    voxels = connectivity.parts(voxels)[0] == np.argmax(connectivity.parts(voxels)[1])
    solid = Solid(voxels)
    index = solid.index_of(*(a.ravel() for a in np.indices(voxels.shape)))
    allowed = solid.flippable(index)
    cavities = len(connectivity.closed_cavities(voxels)[1])
    assert 10 < allowed.sum() < len(index)
    for place in np.argwhere(allowed.reshape(voxels.shape)):
        flipped = voxels.copy()
        flipped[tuple(place)] ^= True
        assert len(connectivity.parts(flipped)[1]) == 2
        assert len(connectivity.closed_cavities(flipped)[1]) <= cavities


def test_flips_that_are_apart_may_be_made_at_once():
    voxels = np.zeros((12, 12, 12), bool)
    voxels[3:9, 3:9, 3:9] = True
    solid = Solid(voxels, no_edges=True)
    index = solid.index_of(*(a.ravel() for a in np.indices(voxels.shape)))
    index = index[solid.flippable(index)]
    chosen = index[solid.apart(index)]
    places = np.stack(solid.places_of(chosen), 1)
    distances = np.abs(places[:, None] - places[None]).max(2) + 9 * np.eye(len(places), dtype=int)
    assert distances.min() >= 2
    solid.flip(chosen)
    assert len(connectivity.parts(solid.voxels)[1]) == 2
    assert connectivity.edge_contacts(np.pad(solid.voxels, 1)) == 0


def test_a_hollow_cube_has_one_cavity_and_a_hole_to_the_outside_opens_it():
    cube = np.ones((5, 5, 5), bool)
    cube[2, 2, 2] = False
    assert connectivity.closed_cavities(cube)[1].tolist() == [0, 1]
    cube[2, 2, 3:] = False
    assert connectivity.closed_cavities(cube)[1].tolist() == [0]


def test_void_outside_a_mask_is_open():
    cube, mask = np.ones((5, 5, 5), bool), np.ones((5, 5, 5), bool)
    cube[2, 2, 2] = mask[2, 2, 2] = False
    assert len(connectivity.closed_cavities(cube)[1]) == 2
    assert len(connectivity.closed_cavities(cube, mask)[1]) == 1


def test_voxels_outside_the_mask_or_the_box_are_not_addable():
    voxels = np.zeros((3, 3, 3), bool)
    voxels[1, 1, 1] = True
    mask = voxels.copy()
    mask[1, 1, 2] = True
    solid = Solid(voxels, mask)
    assert solid.addable(solid.index_of(np.array([1, 1]), np.array([1, 1]), np.array([2, 0]))).tolist() == [True, False]
    full = Solid(np.ones((3, 3, 3), bool))
    assert not full.addable(full.index_of(np.array([1]), np.array([1]), np.array([3])))[0]
