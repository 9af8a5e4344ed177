# SPDX-License-Identifier: LGPL-2.1-or-later
"""The field's grid: where its nodes lie, and what rays find at them."""

import numpy as np
import pytest

from freecad_trabecula.core import nodes as n
from freecad_trabecula.core.meshes import Mesh, join
from freecad_trabecula.errors import MeshError, ParameterError


def box(low, high, turned=False):
    corners = np.where(np.arange(8)[:, None] >> np.arange(3) & 1, np.asarray(high, float), np.asarray(low, float))
    quads = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
    triangles = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])
    return Mesh(corners, triangles[:, ::-1] if turned else triangles)


def sheared(mesh):
    return Mesh(mesh.vertices + 0.3 * mesh.vertices[:, [1, 2, 0]], mesh.triangles)


def test_a_box_is_divided_evenly_with_nodes_on_its_faces():
    grid = n.NodeGrid.of_envelope(box([1, 2, 3], [2, 4.05, 6]), 0.1)
    assert grid.flush
    assert grid.cells.tolist() == [10, 21, 30]
    assert grid.places(1)[[0, 1, -2, -1]] == pytest.approx([2, 2, 4.05, 4.05])
    assert grid.shape == (33, 24, 13)


def test_other_envelopes_have_all_outermost_nodes_outside():
    envelope = sheared(box([0, 0, 0], [3, 3, 3]))
    grid = n.NodeGrid.of_envelope(envelope, 0.25)
    assert not grid.flush
    for axis in range(3):
        places = grid.places(axis)
        assert places[0] < envelope.vertices[:, axis].min() and places[-1] > envelope.vertices[:, axis].max()
        assert np.diff(places)[1:-1] == pytest.approx(0.25)


@pytest.mark.parametrize(
    "envelope",
    [sheared(box([0] * 3, [3] * 3)), join([box([0] * 3, [3] * 3), box([1] * 3, [2] * 3, True)]),
     join([box([0, 0, 0], [1, 1, 3]), box([2, 2, 0], [3, 3, 3])])],
    ids=["sheared", "with a cavity", "two boxes"],
)  # fmt: skip
def test_what_is_no_box_is_not_taken_for_one(envelope):
    assert not n.NodeGrid.of_envelope(envelope, 0.5).flush


def test_a_box_whose_faces_are_cut_into_many_triangles_is_a_box():
    # each triangle of a box cut in four at the middles of its sides
    corners = box([0] * 3, [3] * 3).corners
    middle = (corners + np.roll(corners, -1, 1)) / 2
    a, b, c = (corners[:, k] for k in range(3))
    ab, bc, ca = (middle[:, k] for k in range(3))
    four = np.concatenate([np.stack(t, 1) for t in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))])
    assert n.NodeGrid.of_envelope(Mesh(four.reshape(-1, 3), np.arange(4 * 12 * 3).reshape(-1, 3)), 0.5).flush


def test_winding_numbers_at_nodes_count_the_rods_that_hold_them():
    rods = np.concatenate([box([1.1] * 3, [3.1] * 3).corners, box([2.1] * 3, [9] * 3).corners])
    rays = n.NodeRays(n.NodeGrid.of_envelope(box([0] * 3, [4] * 3), 1.0), rods, None)
    (slab,) = rays.slabs()
    expected = np.zeros((5, 5, 5), int)
    expected[2:4, 2:4, 2:4] += 1
    expected[3:, 3:, 3:] += 1
    assert (slab.rods[1:-1, 1:-1, 1:-1] == expected).all()
    assert slab.envelope.sum() == 125 and (slab.envelope[1:-1, 1:-1, 1:-1] == 1).all()


def test_slabs_share_their_layers_and_cover_the_grid(monkeypatch):
    monkeypatch.setattr(n, "_SLAB", 1)
    monkeypatch.setattr(n, "_LAYERS", 3)
    rods = box([1.1] * 3, [3.1] * 3).corners
    rays = n.NodeRays(n.NodeGrid.of_envelope(box([0] * 3, [4, 4, 7]), 0.5), rods, None)
    slabs = list(rays.slabs())
    assert [s.base for s in slabs] == [0, 3, 6, 9, 12]
    for first, second in zip(slabs, slabs[1:]):
        assert (first.rods[-1] == second.rods[0]).all()
    assert slabs[-1].base + len(slabs[-1].rods) == 17


def test_a_rod_with_a_hole_is_refused():
    rods = box([1.1] * 3, [3.1] * 3).corners[2:]
    rays = n.NodeRays(n.NodeGrid.of_envelope(box([0] * 3, [4] * 3), 0.5), rods, None)
    with pytest.raises(MeshError, match="must leave as often as it enters"):
        list(rays.slabs())


@pytest.mark.parametrize("cell, rule", [(2.1, "at least two cells thick"), (1e-3, r"may have 4e\+09 nodes.*6.4e\+10")])
def test_cells_too_large_or_too_small_for_the_envelope_are_refused(cell, rule):
    with pytest.raises(ParameterError, match=rule):
        n.NodeGrid.of_envelope(box([0] * 3, [4] * 3), cell)
