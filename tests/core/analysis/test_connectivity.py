# SPDX-License-Identifier: LGPL-2.1-or-later
"""Topology of voxels, on bodies whose parts, handles and cavities are known."""

import numpy as np
import pytest

from freecad_trabecula.core.analysis import connectivity as c
from freecad_trabecula.errors import Cancelled


def grid(n):
    return np.meshgrid(*(np.arange(n) - (n - 1) / 2,) * 3, indexing="ij")


def ball(n=24, radius=9.0, hollow=0.0):
    squared = sum(a**2 for a in grid(n))
    return (squared <= radius**2) & (squared >= hollow**2)


def torus(n=40, ring=12.0, tube=5.0):
    z, y, x = grid(n)
    return (np.hypot(x, y) - ring) ** 2 + z**2 <= tube**2


def directions(row):
    """A row of values laid along z, along y and along x."""
    return row[:, None, None], row[None, :, None], row[None, None, :]


def lattice(nodes, spacing=6, width=2):
    """A cubic lattice of struts between ``nodes`` nodes in each direction, a margin of void around it."""
    n = spacing * (nodes - 1) + width + 4
    on = np.zeros(n, bool)
    for k in range(nodes):
        on[2 + k * spacing : 2 + k * spacing + width] = True
    within = np.zeros(n, bool)
    within[2 : n - 2] = True
    z, y, x = directions(on)
    along_z, along_y, along_x = directions(within)
    return (z & y & along_x) | (z & along_y & x) | (along_z & y & x)


@pytest.mark.parametrize(
    "solid, euler, parts, cavities",
    [
        (np.zeros((4, 4, 4), bool), 0, 0, 0),
        (np.ones((3, 4, 5), bool), 1, 1, 0),
        (ball(), 1, 1, 0),
        (ball(hollow=5.0), 2, 1, 1),  # a hollow ball: one part, one cavity
        (torus(), 0, 1, 0),  # one handle
        (np.concatenate([torus(), torus()]), 0, 2, 0),
        (np.concatenate([ball(), ball(hollow=4.0)]), 3, 2, 1),
    ],
)
def test_euler_number_parts_and_cavities_of_known_bodies(solid, euler, parts, cavities):
    found = c.connectivity(solid)
    assert (found.euler, found.parts, found.cavities) == (euler, parts, cavities)


@pytest.mark.parametrize("nodes", [2, 3, 4])
def test_a_cubic_lattice_has_the_euler_number_of_its_graph(nodes):
    found = c.connectivity(lattice(nodes))
    struts = 3 * nodes**2 * (nodes - 1)
    assert found.euler == nodes**3 - struts
    assert found.connections == 1 - found.euler  # nothing of it is cut: no correction


def test_voxels_that_meet_in_a_corner_are_one_part_and_void_that_meets_in_a_corner_is_two():
    solid = np.zeros((2, 2, 2), bool)
    solid[0, 0, 0] = solid[1, 1, 1] = True
    assert c.connectivity(solid)[:3] == (1, 1, 0)
    shell = np.ones((4, 4, 4), bool)
    shell[1, 1, 1] = shell[2, 2, 2] = False
    assert c.connectivity(shell)[:3] == (3, 1, 2)  # 1 part, 2 cavities


@pytest.mark.parametrize("seed", range(4))
def test_euler_number_of_noise_is_that_of_all_its_cells_one_by_one(seed):
    solid = np.random.default_rng(seed).uniform(size=(5, 6, 19)) < 0.4
    cells = set()
    for z, y, x in np.argwhere(solid):
        for dz in (0, 1, 2):
            for dy in (0, 1, 2):
                cells.update((2 * z + dz, 2 * y + dy, 2 * x + dx) for dx in (0, 1, 2))
    # cells of the doubled grid: odd co-ordinates are directions that the cell reaches along
    expected = sum((-1) ** sum(k % 2 for k in cell) for cell in cells)
    assert c.euler_number(solid) == expected
    assert c.euler_number(solid.transpose(2, 0, 1)) == expected  # worked in other slabs


def test_planes_and_rows_have_euler_numbers_of_their_own():
    ring = np.ones((5, 5), bool)
    ring[2, 2] = False
    assert c.euler_number(ring) == 0
    assert c.euler_number(np.array([True, False, True, True, False])) == 2


def test_a_plate_and_a_rod_cut_by_the_box_add_nothing_to_the_endless_structure():
    plate, rod = np.zeros((12, 12, 12), bool), np.zeros((12, 12, 12), bool)
    plate[5:8] = True
    rod[5:8, 4:9] = True
    for solid in (plate, rod, np.ones((12, 12, 12), bool)):
        found = c.connectivity(solid)
        assert (found.euler, found.euler_in_bulk, found.connections) == (1, 0.0, 1.0)


@pytest.mark.parametrize("tiles", [1, 2, 3])
def test_connectivity_density_of_an_endless_lattice_does_not_depend_on_how_much_of_it_is_cut_out(tiles):
    # nodes at whole multiples of 6 voxels, three struts for each: Euler number 1 - 3 in each cell
    n = 6 * tiles
    on = np.isin(np.arange(n) % 6, (2, 3))
    z, y, x = directions(on)
    solid = (z & y) | (y & x) | (z & x)
    found = c.connectivity(np.broadcast_to(solid, (n, n, n)))
    assert found.euler_in_bulk == -2 * tiles**3


def test_bulk_numbers_of_the_pieces_of_a_body_add_up_to_its_euler_number():
    # cut where the voxels on both sides are alike, so that both pieces hold the same cut
    body = np.pad(np.random.default_rng(5).uniform(size=(6, 7, 8)) < 0.4, 1)
    for axis in range(3):
        body = body.repeat(2, axis)
    pieces = [body]
    for axis, cut in enumerate((5, 9, 11)):
        pieces = [half for piece in pieces for half in np.split(piece, [cut], axis)]
    assert len(pieces) == 8
    assert sum(c.euler_in_bulk(piece, c.euler_number(piece)) for piece in pieces) == c.euler_number(body)


def test_a_cavity_that_is_cut_open_by_the_box_is_none():
    shell = ball(24, 9.0, 5.0)
    assert c.connectivity(shell[:12])[:3] == (1, 1, 0)


def test_cancelling_stops_the_count():
    def cancel(done, total, what):
        raise Cancelled("stop")

    with pytest.raises(Cancelled):
        c.connectivity(ball(), cancel)
