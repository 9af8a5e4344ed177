# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compact layers on boxes, regular prisms and spheres of triangles, whose volumes have closed forms."""

from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest

from freecad_trabecula.core.booleans import combine, cut_bodies, manifold_available
from freecad_trabecula.core.layers import Patch, border_edges, layered_body, reaches, thicken, unfolded, welded_patch
from freecad_trabecula.core.meshes import Mesh, bounds, component_volumes, components, is_closed, join, mesh_volume
from freecad_trabecula.core.parameters import Coupling, LayerParameters
from freecad_trabecula.core.rays import union_volume
from freecad_trabecula.errors import MeshError

needs_manifold = pytest.mark.skipif(
    not manifold_available(), reason="MANIFOLD3D IS NOT INSTALLED: compact layers are NOT tested; run `make setup`"
)

BOX_TRIANGLES = np.array(
    [[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4], [2, 6, 3], [3, 6, 7], [0, 4, 2], [2, 4, 6],
     [1, 3, 5], [3, 7, 5]]
)  # fmt: skip


def box(low=(0, 0, 0), high=(10, 10, 10)):
    cube = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
    return Mesh(np.array(low) + cube * (np.array(high, float) - np.array(low)), BOX_TRIANGLES)


def face_of(mesh, axis, end):
    """The face of a box at the low (0) or high (1) end of an axis."""
    level = bounds(mesh)[end][axis]
    flat = (mesh.corners[:, :, axis] == level).all(1)
    used, number = np.unique(mesh.triangles[flat], return_inverse=True)
    normals = np.tile(np.eye(3)[axis] * (2 * end - 1), (4, 1))
    return Patch(mesh.vertices[used], normals, number.reshape(-1, 3))


def mantle(count, radius, height, around=None):
    """The mantle of a regular prism about z, outside out, as a kernel gives it: the seam's vertices stand twice."""
    angle = np.linspace(0, around or 2 * math.pi, count + 1)
    ring = np.column_stack([np.cos(angle), np.sin(angle), np.zeros(count + 1)])
    k = np.arange(count)
    a, b, c, d = k, k + 1, k + count + 2, k + count + 1
    vertices = np.concatenate([radius * ring, radius * ring + [0, 0, height]])
    return vertices, np.tile(ring, (2, 1)), np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])


def sector(count, around=2 * math.pi):
    """Area of a regular polygon's sector of radius 1."""
    return count / 2 * math.sin(around / count)


TOP = LayerParameters(("Face6",), 1.0)
SQUARE_ROD = box((4, 4, -0.1), (6, 6, 10.1))


# ------------------------------------------------------------------------------------------------------ thickening


@pytest.mark.parametrize(("inner", "outer"), [(1.0, 0.0), (0.0, 1.0), (0.3, 0.7)])
def test_a_flat_face_becomes_a_plate_of_its_area_times_the_thickness(inner, outer):
    plate = thicken(face_of(box(), 2, 1), inner, outer)
    assert is_closed(plate)
    assert mesh_volume(plate) == pytest.approx(100)
    assert bounds(plate)[0] == pytest.approx([0, 0, 10 - inner])


def test_widening_moves_each_edge_of_the_border_by_its_amount():
    plate = thicken(face_of(box(), 0, 0), 1.0, 0.0, widening=0.5)
    assert bounds(plate)[0] == pytest.approx([0, -0.5, -0.5])
    assert mesh_volume(plate) == pytest.approx(11**2)


def test_a_tucked_wall_runs_inside_the_envelope():
    plate = thicken(face_of(box(), 2, 1), 0.1, 1.0, tuck=0.1)
    assert is_closed(plate)
    # a plate and under it a frustum between squares of 10 and 9.8
    assert mesh_volume(plate) == pytest.approx(100 + 0.1 / 3 * (100 + 9.8**2 + 98))


def test_a_bent_face_grows_by_the_closed_form_of_its_prism():
    plate = thicken(Patch(*mantle(12, 5.0, 3.0, math.pi)), 1.0, 2.0)
    assert is_closed(plate)
    assert mesh_volume(plate) == pytest.approx(sector(12, math.pi) * (7**2 - 4**2) * 3)


def test_a_mantle_with_a_seam_becomes_a_ring():
    patch = welded_patch(*mantle(24, 5.0, 3.0))
    assert len(patch.vertices) == 48
    assert len(border_edges(patch)[0]) == 48
    ring = thicken(patch, 1.0, 0.0)
    assert is_closed(ring)
    assert mesh_volume(ring) == pytest.approx(sector(24) * (5**2 - 4**2) * 3)


def test_a_face_without_a_border_becomes_a_hollow_body():
    mesh = box((-1, -1, -1), (1, 1, 1))
    patch = Patch(mesh.vertices, mesh.vertices / math.sqrt(3), mesh.triangles)
    hollow = thicken(patch, math.sqrt(3) / 2, math.sqrt(3))
    assert is_closed(hollow)
    assert mesh_volume(hollow) == pytest.approx(4**3 - 1)


def test_welding_leaves_out_triangles_without_area_at_a_pole():
    vertices = np.array([[0, 0, 1], [0, 0, 1], [1, 0, 0], [0, 1, 0]], float)
    patch = welded_patch(vertices, vertices, np.array([[0, 1, 2], [0, 2, 3]]))
    assert patch.triangles.shape == (1, 3)


def bumpy(height, count=41, size=10.0):
    """A square face at z = 0 with a sharp bump in its middle, and its normals."""
    grid = np.linspace(-size / 2, size / 2, count)
    x, y = (a.ravel() for a in np.meshgrid(grid, grid, indexing="ij"))
    bump = height * np.exp(-(x**2 + y**2) / 0.5)
    slopes = [bump * 4 * x, bump * 4 * y]
    normals = np.column_stack([*slopes, np.ones_like(x)])
    i = (np.arange(count - 1)[:, None] * count + np.arange(count - 1)).ravel()
    triangles = np.concatenate([np.stack([i, i + count, i + count + 1], 1), np.stack([i, i + count + 1, i + 1], 1)])
    return Patch(np.column_stack([x, y, bump]), normals / np.linalg.norm(normals, axis=1)[:, None], triangles)


def test_a_smooth_face_keeps_its_normals():
    patch, changed = unfolded(Patch(*mantle(12, 5.0, 3.0, math.pi)), 1.0, 2.0)
    assert changed == 0


def test_a_bump_sharper_than_the_layer_is_thickened_along_smoothed_normals():
    with pytest.raises(MeshError, match="triangles fold"):
        thicken(bumpy(0.5), 1.0, 0.0)
    patch, changed = unfolded(bumpy(0.5), 1.0, 0.0)
    assert 0 < changed < 0.2 * len(patch.vertices)
    plate = thicken(patch, 1.0, 0.0)
    assert is_closed(plate)
    low, high = bounds(plate)
    rays = union_volume(plate.corners, low, high, 200)
    assert mesh_volume(plate) == pytest.approx(rays.volume, abs=5 * rays.error)  # nowhere covered twice
    assert mesh_volume(plate) == pytest.approx(100, rel=0.02)


# ----------------------------------------------------------------------------------------------------- on a cube


@needs_manifold
def test_a_closed_layer_inwards_takes_its_thickness_from_the_channel():
    layered = layered_body(box(), [face_of(box(), 2, 1)], TOP)
    bodies = cut_bodies(SQUARE_ROD.vertices[None], BOX_TRIANGLES, layered.body, layered.closed_by)
    assert layered.added == 0
    assert mesh_volume(bodies.channels) == pytest.approx(2 * 2 * 9)
    assert mesh_volume(bodies.scaffold) == pytest.approx(1000 - 36)
    assert is_closed(bodies.scaffold) and is_closed(bodies.channels)


@needs_manifold
def test_closed_layers_outwards_add_to_the_envelope_and_close_both_ends():
    patches = [face_of(box(), 2, 0), face_of(box(), 2, 1)]
    layered = layered_body(box(), patches, LayerParameters(("Face5", "Face6"), 0.5, "outwards"))
    bodies = cut_bodies(SQUARE_ROD.vertices[None], BOX_TRIANGLES, layered.body, layered.closed_by)
    assert layered.added == pytest.approx(100)
    assert bodies.body_volume == pytest.approx(1100)
    assert mesh_volume(bodies.channels) == pytest.approx(40)
    assert mesh_volume(bodies.scaffold) == pytest.approx(1060)


@needs_manifold
def test_a_rod_that_reaches_past_a_thin_layer_leaves_nothing_behind_it():
    layered = layered_body(box(), [face_of(box(), 2, 1)], LayerParameters(("Face6",), 0.05, "outwards"))
    bodies = cut_bodies(SQUARE_ROD.vertices[None], BOX_TRIANGLES, layered.body, layered.closed_by)
    assert mesh_volume(bodies.channels) == pytest.approx(40)
    assert bounds(bodies.scaffold)[1] == pytest.approx([10, 10, 10.05])


@needs_manifold
def test_an_open_layer_outwards_lets_a_longer_rod_through():
    layered = layered_body(box(), [face_of(box(), 2, 1)], LayerParameters(("Face6",), 1.0, "outwards", False))
    assert layered.closed_by == ()
    rod = box((4, 4, -0.1), (6, 6, 11.1))
    bodies = cut_bodies(rod.vertices[None], BOX_TRIANGLES, layered.body, layered.closed_by)
    assert mesh_volume(bodies.channels) == pytest.approx(2 * 2 * 11)


@needs_manifold
def test_layers_on_two_neighbour_faces_share_the_corner():
    layered = layered_body(box(), [face_of(box(), 2, 1), face_of(box(), 0, 1)], TOP)
    together = combine([combine(layered.closed_by, "union"), box()], "intersection")
    assert mesh_volume(together) == pytest.approx(100 + 100 - 10)


@needs_manifold
def test_a_layer_inwards_of_a_prism_s_mantle_is_the_ring_in_it():
    vertices, normals, triangles = mantle(16, 5.0, 3.0)
    patch = welded_patch(vertices, normals, triangles)
    inner = thicken(patch, 0.0, 0.0001)  # only to have its two rings of vertices
    assert is_closed(inner)
    whole = prism(16, 5.0, 3.0)
    layered = layered_body(whole, [patch], LayerParameters(("Face1",), 1.0))
    ring = combine([layered.closed_by[0], whole], "intersection")
    assert mesh_volume(ring) == pytest.approx(sector(16) * (25 - 16) * 3)


def prism(count, radius, height):
    angle = np.arange(count) * 2 * math.pi / count
    ring = radius * np.column_stack([np.cos(angle), np.sin(angle), np.zeros(count)])
    k, n = np.arange(count), (np.arange(count) + 1) % count
    triangles = np.concatenate(
        [
            np.stack([k, n, count + n], 1),
            np.stack([k, count + n, count + k], 1),
            np.stack([n, k, np.full(count, 2 * count)], 1),
            np.stack([count + k, count + n, np.full(count, 2 * count + 1)], 1),
        ]
    )
    return Mesh(np.concatenate([ring, ring + [0, 0, height], [[0, 0, 0], [0, 0, height]]]), triangles)


@needs_manifold
def test_gaps_between_a_face_and_its_layer_are_filled_and_cavities_of_the_envelope_kept():
    cavity = box((2, 2, 2), (4, 4, 4))
    envelope = join([box(), Mesh(cavity.vertices, cavity.triangles[:, ::-1])])
    # a face that was triangulated higher than the envelope: under its middle there is a gap
    dome = np.array([[0, 0, 10], [10, 0, 10], [10, 10, 10], [0, 10, 10], [5, 5, 10.5]], float)
    dome = Patch(dome, np.tile([0.0, 0, 1], (5, 1)), np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]))
    layered = layered_body(envelope, [dome], LayerParameters(("Face6",), 1.0, "outwards"))
    volumes = component_volumes(layered.body, components(layered.body))
    assert sorted(volumes) == pytest.approx([-8, 1100 + 100 * 0.5 / 3])


def test_an_open_layer_inwards_changes_nothing_and_says_so():
    layered = layered_body(box(), [face_of(box(), 2, 1)], LayerParameters(("Face6",), 1.0, "inwards", False))
    assert layered.body is not None and layered.closed_by == () and layered.added == 0
    assert "nothing changes" in layered.note


def test_no_faces_no_layer():
    assert layered_body(box(), [], LayerParameters()).closed_by == ()


# -------------------------------------------------------------------------------------------------------- reaches


def wireframe_of(couplings):
    return SimpleNamespace(coupling=np.array(couplings))


COUPLINGS = (Coupling("A", "B"), Coupling("C", "A"))


def test_rods_are_prolonged_through_open_outward_layers_only_at_their_ends_there():
    layers = LayerParameters(("A",), 1.5, "outwards", False)
    assert reaches(wireframe_of([0, 1, 1]), COUPLINGS, layers, 0.1) == pytest.approx(
        np.array([[1.6, 0.1], [0.1, 1.6], [0.1, 1.6]])
    )


@pytest.mark.parametrize(
    "layers", [LayerParameters(), LayerParameters(("A",)), LayerParameters(("A",), 1.0, "outwards", True)]
)
def test_other_layers_prolong_nothing(layers):
    assert reaches(wireframe_of([0, 1]), COUPLINGS, layers, 0.2) == pytest.approx(np.full((2, 2), 0.2))


# ------------------------------------------------------------------------------------------------------- refusals


def test_a_layer_thicker_than_the_radius_of_its_face_is_refused():
    with pytest.raises(MeshError, match="thinner than the least radius .* at 6 mm 24 of 24 triangles fold"):
        thicken(Patch(*mantle(12, 5.0, 3.0, math.pi)), 6.0, 0.0)


def test_a_layer_thicker_than_the_radius_of_a_closed_mantle_is_refused_after_smoothing():
    with pytest.raises(MeshError, match="smoothing does not help"):
        unfolded(welded_patch(*mantle(24, 5.0, 3.0)), 6.0, 0.0)


@needs_manifold
def test_a_layer_that_takes_the_whole_envelope_is_refused():
    with pytest.raises(MeshError, match="but 11 mm take all of it"):
        layered_body(box(), [face_of(box(), 2, 1)], LayerParameters(("Face6",), 11.0))


def test_a_face_without_triangles_is_refused():
    with pytest.raises(MeshError, match="at least one triangle, got 0"):
        Patch(np.zeros((0, 3)), np.zeros((0, 3)), np.zeros((0, 3), int))


def test_a_face_without_all_its_normals_is_refused():
    with pytest.raises(MeshError, match="got 3 for 4 vertices"):
        Patch(np.zeros((4, 3)), np.zeros((3, 3)), np.array([[0, 1, 2]]))


def test_a_face_whose_triangles_turn_both_ways_is_refused():
    with pytest.raises(MeshError, match="at most once each way"):
        border_edges(Patch(np.eye(3), np.eye(3), np.array([[0, 1, 2], [0, 1, 2]])))
