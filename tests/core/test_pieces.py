# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces of cut bodies, on boxes in boxes; no Boolean is needed."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_trabecula.core.meshes import Mesh, join, mesh_volume
from freecad_trabecula.core.pieces import SLIVER, inner_point, pieces, separate
from freecad_trabecula.errors import MeshError

BOX_TRIANGLES = np.array(
    [[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4], [2, 6, 3], [3, 6, 7], [0, 4, 2], [2, 4, 6],
     [1, 3, 5], [3, 7, 5]]
)  # fmt: skip
NOTHING = Mesh(np.zeros((0, 3)), np.zeros((0, 3), int))


def box(low, high):
    cube = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
    return Mesh(np.array(low) + cube * (np.array(high, float) - np.array(low)), BOX_TRIANGLES)


def cube(low, size):
    return box(np.full(3, float(low)), np.full(3, float(low + size)))


def turned(mesh):
    """The same surface, its triangles the other way round: a cavity."""
    return Mesh(mesh.vertices, mesh.triangles[:, ::-1])


def tube(low, high, wall):
    """A square tube along z with an open hole: eight walls of one closed surface."""
    square = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    outer = low + square * (high - low)
    inner = low + wall + square * (high - low - 2 * wall)
    rings = [np.column_stack([ring, np.full(4, z)]) for z in (low, high) for ring in (outer, inner)]
    triangles = []
    for k in range(4):
        n = (k + 1) % 4
        for a, b, c, d in ((k, n, 8 + n, 8 + k), (12 + k, 12 + n, 4 + n, 4 + k)):  # outer wall, inner wall
            triangles += [[a, b, c], [a, c, d]]
        for a, b, c, d in ((4 + k, 4 + n, n, k), (8 + k, 8 + n, 12 + n, 12 + k)):  # bottom, top
            triangles += [[a, b, c], [a, c, d]]
    return Mesh(np.concatenate(rings), np.array(triangles))


# --------------------------------------------------------------------------------------------------------- pieces


def test_a_box_with_a_cavity_is_one_piece_less_the_cavity():
    found, slivers = pieces(join([cube(0, 10), turned(cube(3, 2))]))
    assert [p.volume for p in found] == [pytest.approx(992)]
    assert [p.shell_volume for p in found] == [pytest.approx(1000)]
    assert len(found[0].cavities) == 1 and slivers == 0


def test_pieces_come_largest_first():
    found, _ = pieces(join([cube(0, 1), cube(2, 3), cube(6, 2)]))
    assert [p.volume for p in found] == pytest.approx([27, 8, 1])


def test_a_box_in_a_cavity_is_a_piece_of_its_own():
    found, _ = pieces(join([cube(3.5, 1), cube(0, 10), turned(cube(3, 2))]))
    assert [p.volume for p in found] == pytest.approx([992, 1])


def test_a_cavity_belongs_to_the_smallest_shell_around_it():
    found, _ = pieces(join([cube(0, 10), turned(cube(1, 8)), cube(2, 6), turned(cube(4, 2))]))
    assert [p.volume for p in found] == pytest.approx([1000 - 512, 216 - 8])


def test_a_cavity_inside_a_tube_s_box_but_not_in_its_wall_belongs_to_the_box_there():
    around = tube(0.0, 20.0, 2.0)
    assert mesh_volume(around) == pytest.approx((400 - 256) * 20)
    found, _ = pieces(join([around, cube(6, 8), turned(cube(8, 2))]))
    assert [p.volume for p in found] == pytest.approx([2880, 512 - 8])


def test_a_cavity_in_the_tube_s_wall_stays_there():
    found, _ = pieces(join([tube(0.0, 20.0, 2.0), cube(6, 8), turned(cube(0.5, 1))]))
    assert [p.volume for p in found] == pytest.approx([2879, 512])


@pytest.mark.parametrize("sign", [1, -1])
def test_a_sliver_below_a_cubic_micrometre_is_left_out_and_counted(sign):
    sliver = box((4, 4, 4), (4.5, 4.5, 4 + 0.5 * SLIVER / 0.25))
    found, slivers = pieces(join([cube(0, 10), sliver if sign > 0 else turned(sliver)]))
    assert [p.volume for p in found] == pytest.approx([1000])
    assert slivers == 1
    assert len(found[0].mesh.triangles) == 12


def test_a_cube_of_two_micrometres_is_no_sliver():
    found, slivers = pieces(join([cube(0, 10), cube(20, 0.002)]))
    assert len(found) == 2 and slivers == 0


@pytest.mark.parametrize("mesh", [tube(0.0, 3.0, 0.1), join([cube(0, 4), turned(cube(0.05, 3.9))])])
def test_an_inner_point_of_a_thin_wall_lies_in_the_wall(mesh):
    # inside the outer box, outside the hole: in the closed form of both bodies
    point = inner_point(mesh)
    size = mesh.vertices.max()
    wall = 0.1 if size == 3.0 else 0.05
    depth = np.minimum(point, size - point)
    assert (depth > 0).all()
    assert depth[:2].min() < wall if size == 3.0 else depth.min() < wall


# ------------------------------------------------------------------------------------------------------- separate


def parts_of(outside, inside, keep):
    return separate(pieces(outside), pieces(inside), keep, keep)


def shell_of_channel():
    """A cube of 10 with a hollow cube of channel in it, 3..7 less 4..6: a box of 8 mm3 hangs free in a void."""
    outside = join([cube(0, 10), turned(cube(3, 4)), cube(4, 2)])
    inside = join([cube(3, 4), turned(cube(4, 2))])
    return outside, inside


def test_a_void_with_a_loose_piece_in_it_is_filled_whole():
    parts = parts_of(*shell_of_channel(), keep=False)
    assert parts.scaffold_volume == pytest.approx(1000)
    assert parts.channel_volume == 0 and len(parts.channels.triangles) == 0
    assert parts.void_volumes == (pytest.approx(64),)
    assert parts.loose == ()
    assert [mesh_volume(v) for v in parts.voids] == [pytest.approx(56)]


def test_kept_as_it_is_nothing_is_taken_or_filled():
    parts = parts_of(*shell_of_channel(), keep=True)
    assert parts.scaffold_volume == pytest.approx(1000 - 64 + 8)
    assert parts.channel_volume == pytest.approx(56)
    assert mesh_volume(parts.scaffold) == pytest.approx(parts.scaffold_volume)
    assert parts.loose_volumes == (pytest.approx(8),)
    assert parts.void_volumes == (pytest.approx(64),)
    assert parts.pieces == 2


def test_voids_can_be_kept_and_what_hangs_in_them_taken_away():
    parts = separate(*map(pieces, shell_of_channel()), keep_loose=False, keep_voids=True)
    assert parts.scaffold_volume == pytest.approx(1000 - 64)
    assert parts.channel_volume == pytest.approx(56)
    assert parts.loose_volumes == (pytest.approx(8),)
    assert (parts.pieces, parts.openings, parts.filled) == (1, 1, False)


def test_loose_pieces_can_be_kept_and_voids_filled():
    outside, inside = shell_of_channel()
    outside = join([outside, cube(20, 1)])
    parts = separate(pieces(outside), pieces(inside), keep_loose=True, keep_voids=False)
    assert parts.scaffold_volume == pytest.approx(1001)
    assert parts.loose_volumes == (pytest.approx(1),)


def test_a_piece_beside_the_scaffold_is_loose_and_not_exported():
    parts = parts_of(join([cube(0, 5), cube(8, 1)]), cube(20, 2), keep=False)
    assert parts.scaffold_volume == pytest.approx(125)
    assert parts.loose_volumes == (pytest.approx(1),)
    assert parts.channel_volume == pytest.approx(8)
    assert (parts.pieces, parts.openings) == (1, 1)


def test_an_open_channel_is_no_void_though_the_scaffold_has_one():
    outside = join([cube(0, 10), turned(cube(3, 2))])
    parts = parts_of(outside, join([cube(3, 2), box((10, 0, 0), (11, 10, 10))]), keep=False)
    assert parts.void_volumes == (pytest.approx(8),)
    assert parts.channel_volume == pytest.approx(100)


def test_cavities_are_found_again_in_the_other_body():
    parts = parts_of(*shell_of_channel(), keep=False)
    assert (parts.cavities, parts.matched) == (2, 2)


def test_a_cavity_that_the_other_body_does_not_know_is_not_matched():
    outside, _ = shell_of_channel()
    parts = parts_of(outside, join([cube(3, 3.9), turned(cube(4, 2))]), keep=False)
    assert (parts.cavities, parts.matched) == (2, 1)


# ------------------------------------------------------------------------------------------------------- refusals


def test_channels_that_leave_nothing_are_refused():
    with pytest.raises(MeshError, match="must leave some material, got 0 mm3"):
        parts_of(NOTHING, cube(0, 10), keep=False)


def test_a_body_inside_out_is_refused():
    with pytest.raises(MeshError, match="inside out"):
        pieces(turned(cube(0, 10)))


def test_a_cavity_outside_of_every_body_is_refused_with_the_count():
    with pytest.raises(MeshError, match="but 1 of 2 lie in none"):
        pieces(join([cube(0, 10), turned(cube(2, 1)), turned(cube(20, 1))]))


def test_a_flat_body_has_no_inner_point():
    flat = Mesh(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]]), [[0, 1, 2], [0, 2, 1]])
    with pytest.raises(MeshError, match="must hold some volume"):
        inner_point(flat)
