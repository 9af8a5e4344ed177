# SPDX-License-Identifier: LGPL-2.1-or-later
"""The 256 cases and the surfaces made with them: closed for any pattern of nodes, against counted cells."""

import numpy as np
import pytest

from freecad_trabecula.core import marching as mc
from freecad_trabecula.core.meshes import component_volumes, components, is_closed, mesh_volume

FACES = [{c for c in range(8) if (c >> a & 1) == end} for a in range(3) for end in (0, 1)]
EDGE_CORNERS = [(c, c | 1 << a) for a, c in mc.EDGES]
MIDDLES = np.array([[(p >> k & 1) / 2 + (q >> k & 1) / 2 for k in range(3)] for p, q in EDGE_CORNERS])
both_rules = pytest.mark.parametrize("separate_inside", [True, False])


def triangles_of(case, separate_inside):
    table = mc.case_table(separate_inside)
    return table.edges[table.first[case] : table.first[case + 1]].tolist()


def sides(triangles):
    return [(t[k], t[(k + 1) % 3]) for t in triangles for k in range(3)]


def on_a_face(edges):
    return any(all(set(EDGE_CORNERS[e]) <= face for e in edges) for face in FACES)


@both_rules
def test_every_case_has_a_vertex_on_just_the_edges_with_one_end_inside(separate_inside):
    for case in range(256):
        crossed = [e for e, (p, q) in enumerate(EDGE_CORNERS) if (case >> p & 1) != (case >> q & 1)]
        assert sorted({e for t in triangles_of(case, separate_inside) for e in t}) == crossed
        assert sorted(e for loop in mc.case_loops(case, separate_inside) for e in loop) == crossed


@both_rules
def test_sides_of_triangles_are_met_twice_inside_a_cell_and_once_on_its_faces(separate_inside):
    for case in range(256):
        directed = sides(triangles_of(case, separate_inside))
        assert len(set(directed)) == len(directed)
        for a, b in directed:
            assert ((b, a) in directed) != on_a_face((a, b))


@both_rules
def test_no_chord_lies_in_a_face_where_the_next_cell_could_have_it_too(separate_inside):
    for case in range(256):
        loops = mc.case_loops(case, separate_inside)
        segments = {frozenset((loop[k], loop[k - 1])) for loop in loops for k in range(len(loop))}
        chords = {frozenset(s) for s in sides(triangles_of(case, separate_inside))} - segments
        assert not any(on_a_face(chord) for chord in chords)


@both_rules
def test_two_cells_that_share_a_face_have_opposite_segments_on_it(separate_inside):
    for axis in range(3):
        for pattern in range(16):
            # the same four corners as upper face of one cell and lower face of the next, whatever the other corners
            upper = sum(1 << c for n, c in enumerate(c for c in range(8) if c >> axis & 1) if pattern >> n & 1)
            found = set()
            for others in range(16):
                more = sum(1 << c for n, c in enumerate(c for c in range(8) if not c >> axis & 1) if others >> n & 1)
                for case, end in ((upper | more, 1), ((upper >> (1 << axis)) | (more << (1 << axis)), 0)):
                    face = [e for e in range(12) if all((c >> axis & 1) == end for c in EDGE_CORNERS[e])]
                    place = {e: tuple(np.delete(MIDDLES[e], axis)) for e in face}
                    directed = {
                        (place[a], place[b])
                        for loop in mc.case_loops(case, separate_inside)
                        for a, b in zip(loop, loop[1:] + loop[:1])
                        if a in place and b in place
                    }
                    found.add(frozenset(directed if end else {(b, a) for a, b in directed}))
            assert len(found) == 1


def test_a_body_and_its_complement_have_the_same_triangles_turned_round():
    for case in range(256):
        turned = {tuple(t[::-1]) for t in triangles_of(255 - case, False)}
        assert turned == {tuple(t) for t in triangles_of(case, True)}


def test_two_corners_across_a_face_are_apart_under_one_rule_and_joined_under_the_other():
    case = 0b00001001  # corners (0, 0, 0) and (1, 1, 0)
    assert [len(loop) for loop in mc.case_loops(case, True)] == [3, 3]
    assert [len(loop) for loop in mc.case_loops(case, False)] == [6]


def test_the_triangle_at_one_corner_turns_counter_clockwise_seen_from_outside():
    ((a, b, c),) = triangles_of(1, True)
    normal = np.cross(MIDDLES[b] - MIDDLES[a], MIDDLES[c] - MIDDLES[a])
    assert (normal > 0).all()


def surface_of(inside, slabs, separate_inside=True, share=0.5):
    """The surface of nodes [z, y, x] with the border, at unit distance, vertices at a share of the edges."""
    places = [np.clip(np.arange(n + 2) - 1.0, 0, n - 1) for n in inside.shape[::-1]]
    padded = np.pad(inside, 1)
    _, rows, columns = padded.shape
    surface = mc.Surface(padded.shape[1:], separate_inside)
    base = 0
    for top in slabs:

        def place(axis, edges, base=base):
            index = [edges % columns, edges // columns % rows, edges // (columns * rows) + base]
            points = np.stack([places[a][index[a]] for a in range(3)], 1)
            points[:, axis] += share * (places[axis][index[axis] + 1] - points[:, axis])
            return points

        surface.add(padded[base : top + 1], place, base == 0, top == len(padded) - 1)
        base = top
    return surface.mesh()


@pytest.mark.parametrize("seed", range(6))
@both_rules
def test_any_pattern_of_nodes_gives_a_closed_surface(seed, separate_inside):
    rng = np.random.default_rng(seed)
    inside = rng.random((7, 6, 8)) < rng.uniform(0.2, 0.8)
    mesh = surface_of(inside, [8], separate_inside)
    assert is_closed(mesh)
    assert len(np.unique(mesh.vertices, axis=0)) == len(mesh.vertices)
    assert (np.unique(mesh.triangles) == np.arange(len(mesh.vertices))).all()


@pytest.mark.parametrize("slabs", [[1, 2, 3, 4, 5, 6, 7, 8], [3, 8], [7, 8], [1, 8]])
def test_slabs_of_any_thickness_give_the_same_surface(slabs):
    inside = np.random.default_rng(9).random((7, 6, 8)) < 0.5
    whole, parts = surface_of(inside, [8]), surface_of(inside, slabs)
    assert is_closed(parts)
    key = [np.unique(mesh.corners.reshape(-1, 9), axis=0) for mesh in (whole, parts)]
    assert (key[0] == key[1]).all()


def test_nodes_that_are_all_inside_give_the_exact_box():
    mesh = surface_of(np.ones((3, 4, 6), bool), [2, 4])
    assert is_closed(mesh)
    assert mesh_volume(mesh) == pytest.approx(2 * 3 * 5, rel=1e-15)
    on_face = (mesh.vertices == 0) | (mesh.vertices == [5, 3, 2])
    assert on_face.any(1).all()


def test_a_body_and_its_complement_fill_the_box_exactly():
    inside = np.random.default_rng(10).random((9, 9, 9)) < 0.4
    first, second = surface_of(inside, [10], True, 0.3), surface_of(~inside, [10], False, 0.3)
    assert mesh_volume(first) + mesh_volume(second) == pytest.approx(512, rel=1e-14)


def test_single_nodes_become_octahedra():
    inside = np.zeros((5, 5, 9), bool)
    inside[2, 2, [2, 6]] = True
    mesh = surface_of(inside, [6])
    # half-diagonal 1/2: 4/3 (1/2)³ each
    assert component_volumes(mesh, components(mesh)) == pytest.approx([1 / 6, 1 / 6])


def test_no_node_inside_gives_an_empty_mesh():
    mesh = surface_of(np.zeros((3, 3, 3), bool), [4])
    assert mesh.triangles.shape == (0, 3) and mesh.vertices.shape == (0, 3)
