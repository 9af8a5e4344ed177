# SPDX-License-Identifier: LGPL-2.1-or-later
"""The field engine against walls, prisms and cylinders with closed forms; bodies are closed and fill a box."""

import math

import numpy as np
import pytest

from freecad_trabecula.core import field as f
from freecad_trabecula.core import nodes
from freecad_trabecula.core.meshes import Mesh, bounds, is_closed, join, mesh_area, mesh_volume, weld
from freecad_trabecula.errors import Cancelled, MeshError, ParameterError


def box(low, high):
    corners = np.where(np.arange(8)[:, None] >> np.arange(3) & 1, np.asarray(high, float), np.asarray(low, float))
    quads = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
    return Mesh(corners, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]))


def prism(radius, length, axis=2, sides=48, centre=(0.0, 0.0, 0.0)):
    """Prism over a regular polygon along an axis, about a centre; its section has the area of ``polygon``."""
    angle = 2 * np.pi * np.arange(sides) / sides
    ring = np.stack([radius * np.cos(angle), radius * np.sin(angle)], 1)
    points = np.concatenate(
        [np.column_stack([ring, np.full(sides, z)]) for z in (-length / 2, length / 2)]
        + [[[0, 0, -length / 2], [0, 0, length / 2]]]
    )
    i, bottom, top = np.arange(sides), np.full(sides, 2 * sides), np.full(sides, 2 * sides + 1)
    j = (i + 1) % sides
    triangles = [(i, j, j + sides), (i, j + sides, i + sides), (bottom, j, i), (top, i + sides, j + sides)]
    return Mesh(np.roll(points, axis + 1, 1) + centre, np.concatenate([np.stack(t, 1) for t in triangles]))


def polygon(radius, sides=48):
    return sides / 2 * radius**2 * math.sin(2 * math.pi / sides)


def both(rods, envelope, cell, **more):
    found = f.field_bodies(rods, envelope, cell, **more)
    for mesh in found.meshes.values():
        assert is_closed(mesh) or not len(mesh.triangles)
    return found


CUBE = box([0] * 3, [4] * 3)


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_plane_walls_are_exact_whatever_the_cell(axis):
    low, high = np.full(3, -1.0), np.full(3, 5.0)
    low[axis], high[axis] = 1.3345, 2.3456
    found = both(box(low, high).corners, CUBE, 0.33)
    assert mesh_volume(found.meshes["channels"]) == pytest.approx(16 * (2.3456 - 1.3345), rel=1e-12)
    assert mesh_volume(found.meshes["scaffold"]) == pytest.approx(64 - 16 * (2.3456 - 1.3345), rel=1e-12)


def test_overlapping_and_nested_walls_count_once():
    walls = [box([-1, -1, 1.21], [5, 5, 2.31]), box([-1, -1, 1.77], [5, 5, 3.13]), box([-1, -1, 1.9], [5, 5, 2.0])]
    found = both(join(walls).corners, CUBE, 0.25)
    assert mesh_volume(found.meshes["channels"]) == pytest.approx(16 * (3.13 - 1.21), rel=1e-12)


def test_a_gap_thinner_than_a_cell_keeps_its_length_at_the_wall_s_end():
    # nodes at 2 and 2.25: the edge between them is inside for 0.10 + 0.07
    walls = join([box([1.1, -1, -1], [2.10, 5, 5]), box([2.13, -1, -1], [2.20, 5, 5])])
    found = both(walls.corners, CUBE, 0.25)
    assert mesh_volume(found.meshes["channels"]) == pytest.approx(16 * (1.0 + 0.07), rel=1e-12)
    assert found.figures.several == 2 * 17 * 17  # one for each ray and body
    assert found.figures.lost == 0


def test_without_rods_the_scaffold_is_the_box_itself_with_sharp_edges():
    found = both(np.zeros((0, 3, 3)), CUBE, 0.5)
    scaffold, channels = found.meshes["scaffold"], found.meshes["channels"]
    assert mesh_volume(scaffold) == pytest.approx(64, rel=1e-15)
    assert mesh_area(scaffold) == pytest.approx(96, rel=1e-14)
    assert len(channels.triangles) == 0


def test_a_rod_that_holds_the_box_leaves_no_scaffold():
    found = both(box([-1] * 3, [5] * 3).corners, CUBE, 0.5)
    assert mesh_volume(found.meshes["channels"]) == pytest.approx(64, rel=1e-15)
    assert len(found.meshes["scaffold"].triangles) == 0


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_a_round_channel_errs_with_the_square_of_the_cell(axis):
    rod = prism(1.1, 9, axis, centre=(2.03, 1.98, 2.01))
    errors = []
    for cell in (0.2, 0.1, 0.05):
        found = both(rod.corners, CUBE, cell)
        errors.append(mesh_volume(found.meshes["channels"]) / (4 * polygon(1.1)) - 1)
        assert mesh_volume(found.meshes["channels"]) + mesh_volume(found.meshes["scaffold"]) == pytest.approx(64)
    assert abs(errors[2]) < 4e-4
    assert 2.5 < errors[0] / errors[1] < 6 and 2.5 < errors[1] / errors[2] < 6


def test_crossing_channels_have_the_volume_of_their_union():
    # two equal cylinders at right angles share 16/3 r³ (Steinmetz, by Archimedes)
    radius, sides = 0.9, 400
    rods = join([prism(radius, 9, a, sides, (2, 2, 2)) for a in (0, 1)])
    exact = 2 * 4 * polygon(radius, sides) - 16 / 3 * radius**3
    found = both(rods.corners, CUBE, 0.05)
    assert mesh_volume(found.meshes["channels"]) == pytest.approx(exact, rel=1e-3)


def test_the_result_does_not_depend_on_the_slabs(monkeypatch):
    rods = join([prism(0.7, 9, a, 20, (2, 2.1, 1.9)) for a in range(3)]).corners
    envelope = prism(1.9, 3.9, 0, 12, (2, 2, 2))
    for body in (CUBE, envelope):
        whole = both(rods, body, 0.21)
        with monkeypatch.context() as patch:
            patch.setattr(nodes, "_SLAB", 1)
            patch.setattr(nodes, "_LAYERS", 2)
            parts = both(rods, body, 0.21)
        for name in f.BODIES:
            sets = [np.unique(found.meshes[name].corners.reshape(-1, 9), axis=0) for found in (whole, parts)]
            assert (sets[0] == sets[1]).all()


def test_vertices_stay_apart_in_single_precision():
    shift = np.array([900.0, -500, 0])
    rods = join([prism(0.7, 9, a, 20, shift + 2) for a in range(3)]).corners
    found = both(rods, Mesh(CUBE.vertices + shift, CUBE.triangles), 0.1)
    for mesh in found.meshes.values():
        welded = weld(mesh.corners.astype(np.float32))
        assert len(welded.vertices) == len(mesh.vertices) and is_closed(welded)


def test_an_envelope_that_is_no_box_is_filled_to_the_square_of_the_cell():
    envelope = prism(2.0, 4.0, 0, 60, (0.3, 0.2, 0.1))
    rod = prism(0.9, 9, 0, 60, (0.3, 0.2, 0.1))  # along the same axis: closed form
    exact = {"channels": 4 * polygon(0.9, 60), "scaffold": 4 * (polygon(2.0, 60) - polygon(0.9, 60))}
    for cell, bound in ((0.2, 2e-2), (0.1, 6e-3), (0.05, 1.8e-3)):
        found = both(rod.corners, envelope, cell)
        for name, volume in exact.items():
            assert mesh_volume(found.meshes[name]) == pytest.approx(volume, rel=bound)


def test_flat_faces_of_an_envelope_that_is_no_box_stay_flat():
    envelope = prism(2.0, 4.0, 2, 60)
    scaffold = both(np.zeros((0, 3, 3)), envelope, 0.13).meshes["scaffold"]
    inner = np.linalg.norm(scaffold.vertices[:, :2], axis=1) < 1.8
    assert np.abs(np.abs(scaffold.vertices[inner, 2]) - 2).max() < 1e-12


def test_a_cavity_of_the_envelope_stays_empty():
    cavity = box([1.3] * 3, [2.7] * 3)
    envelope = join([CUBE, Mesh(cavity.vertices, cavity.triangles[:, ::-1])])
    rod = box([-1, 1.6, 1.6], [5, 2.4, 2.4])
    found = both(rod.corners, envelope, 0.05)
    assert mesh_volume(found.meshes["channels"]) == pytest.approx((4 - 1.4) * 0.8**2, rel=1e-2)
    assert mesh_volume(found.meshes["scaffold"]) == pytest.approx(64 - 1.4**3 - (4 - 1.4) * 0.8**2, rel=1e-3)


@pytest.mark.parametrize("seed", range(4))
def test_many_rods_of_any_direction_leave_closed_bodies(seed):
    rng = np.random.default_rng(seed)
    rods = []
    for _ in range(30):
        rod = prism(rng.uniform(0.1, 0.5), 9, 2, 12)
        turn, _ = np.linalg.qr(rng.normal(size=(3, 3)))
        turn *= np.sign(np.linalg.det(turn))
        rods.append(Mesh(rod.vertices @ turn.T + rng.uniform(0, 4, 3), rod.triangles))
    found = both(join(rods).corners, CUBE, 0.17)
    assert sum(map(mesh_volume, found.meshes.values())) == pytest.approx(64, rel=1e-12)
    both(join(rods).corners, prism(1.9, 3.9, 0, 12, (2, 2, 2)), 0.17)


def test_only_the_wanted_body_is_made():
    rod = prism(1.0, 9, 0, 12, (2, 2, 2)).corners
    found = f.field_bodies(rod, CUBE, 0.2, want=("channels",))
    assert list(found.meshes) == ["channels"]
    assert (found.meshes["channels"].corners == both(rod, CUBE, 0.2).meshes["channels"].corners).all()


def test_the_union_in_a_box_is_the_channels_of_that_box():
    rod = prism(1.0, 9, 0, 12, (2, 2, 2)).corners
    union = f.field_union(rod, [0, 0, 0], [4, 4, 4], 0.2)
    assert (union.corners == f.field_bodies(rod, CUBE, 0.2).meshes["channels"].corners).all()
    assert [b.tolist() for b in bounds(union)] == [[0, *bounds(union)[0][1:]], [4, *bounds(union)[1][1:]]]


def test_progress_rises_to_its_total_and_cancelling_gets_through(monkeypatch):
    monkeypatch.setattr(nodes, "_SLAB", 1)
    rod, seen = prism(1.0, 9, 0, 12, (2, 2, 2)).corners, []
    f.field_bodies(rod, CUBE, 0.05, lambda done, total, what: seen.append((done, total, what)))
    assert [s[0] for s in seen] == sorted(s[0] for s in seen)
    assert seen[-1][0] == seen[-1][1] and len(seen) > 10

    def stop(done, total, what):
        raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        f.field_bodies(rod, CUBE, 0.2, stop)


def test_an_estimate_grows_with_the_nodes_and_with_the_triangles():
    few, fine, many = (f.field_estimate([0] * 3, [10] * 3, c, t) for c, t in ((0.1, 1e4), (0.05, 1e4), (0.1, 1e7)))
    assert 3 < fine.seconds / few.seconds < 9 and fine.bytes > few.bytes
    assert many.seconds > few.seconds + 10 and many.bytes > few.bytes


@pytest.mark.parametrize("cell", [0.0, -0.1, math.nan, math.inf])
def test_a_cell_that_is_no_length_is_refused(cell):
    rod = prism(1.0, 9).corners
    for run in (lambda: f.field_bodies(rod, CUBE, cell), lambda: f.field_estimate([0] * 3, [4] * 3, cell, 10)):
        with pytest.raises(ParameterError, match="the cell size must be above 0 mm"):
            run()


def test_an_unknown_body_is_refused():
    with pytest.raises(ParameterError, match="must be of scaffold, channels, got 'bone'"):
        f.field_bodies(np.zeros((0, 3, 3)), CUBE, 0.2, want=("scaffold", "bone"))


@pytest.mark.parametrize(
    "envelope, rule",
    [
        (Mesh(CUBE.vertices, CUBE.triangles[1:]), "the envelope must be a closed mesh.*3 open edges"),
        (Mesh(CUBE.vertices, CUBE.triangles[:, ::-1]), "counter-clockwise seen from outside; its volume is -64 mm"),
    ],
    ids=["open", "inside out"],
)
def test_an_envelope_that_is_open_or_inside_out_is_refused(envelope, rule):
    with pytest.raises(MeshError, match=rule):
        f.field_bodies(prism(1.0, 9).corners, envelope, 0.2)


def test_rods_that_are_open_or_not_finite_are_refused():
    rod = prism(1.0, 9, centre=(2, 2, 2)).corners
    with pytest.raises(MeshError, match="closed meshes"):
        f.field_bodies(rod[1:40], CUBE, 0.2)
    rod[5, 0, 1] = math.nan
    with pytest.raises(MeshError, match="must be finite"):
        f.field_bodies(rod, CUBE, 0.2)


@pytest.mark.parametrize("high", [[4, 0, 4], [4, math.nan, 4]])
def test_an_empty_box_for_the_union_is_refused(high):
    with pytest.raises(ParameterError, match="low < high"):
        f.field_union(prism(1.0, 9).corners, [0, 0, 0], high, 0.2)
