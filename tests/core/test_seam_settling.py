# SPDX-License-Identifier: LGPL-2.1-or-later
"""Guides, patches and seams of cylinders in a box: topology by counting, volumes and seams by their equations."""

import math

import numpy as np
import pytest

from freecad_trabecula.core.guides import Guide
from freecad_trabecula.core.meshes import Mesh
from freecad_trabecula.core.patchwork import LabelledMesh, patchwork
from freecad_trabecula.core.paths import straight_paths
from freecad_trabecula.core.pores import circles
from freecad_trabecula.core.rods import RodEnds
from freecad_trabecula.core.seam_curves import EXACT
from freecad_trabecula.core.seam_settling import Settling, crossings
from freecad_trabecula.core.seams import Surfaces, kind_of
from freecad_trabecula.core.strips import rod_strips
from freecad_trabecula.errors import MeshError

BEZIER_CIRCLE = 3e-4  # relative; how far four cubics are from a circle
SIZE = 4.0  # mm; of the cube about the origin
QUADS = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))


def cube():
    """A cube, two triangles a face, and the plane (point, normal, axes) of each face."""
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * SIZE / 2
    triangles = np.array([t for a, b, c, d in QUADS for t in ((a, c, b), (a, d, c))])
    volume = np.einsum("ij,ij->i", corners[triangles[:, 0]], np.cross(*corners[triangles[:, 1:]].transpose(1, 0, 2)))
    triangles = triangles if volume.sum() > 0 else triangles[:, ::-1]
    planes = []
    for a, b, c in triangles[::2]:
        u = (corners[b] - corners[a]) / np.linalg.norm(corners[b] - corners[a])
        n = np.cross(u, corners[c] - corners[a])
        n /= np.linalg.norm(n)
        planes.append([corners[a], n, u, np.cross(n, u)])
    return Mesh(corners, triangles), np.array(planes)


def cylinders(*diameters, shift=0.0):
    """Surfaces of a rod along z, of one along x at y = shift if there are two, and of the cube; and the cube."""
    axes = np.array([[[1.0, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 0], [0, 0, 1], [1, 0, 0]]])[: len(diameters)]
    offset = np.array([[0.0, 0, 0], [0, shift, 0]])[: len(diameters)]
    ends = RodEnds(
        np.repeat(axes[:, None], 2, 1),
        circles(np.array(diameters)),
        circles(np.array(diameters)),
        np.zeros(len(diameters)),
    )
    paths = straight_paths(offset - axes[:, 2] * SIZE / 2, offset + axes[:, 2] * SIZE / 2)
    envelope, planes = cube()
    return Surfaces(rod_strips(paths, ends, 1, 0.2), planes), envelope


def settled(*diameters, shift=0.0):
    surfaces, envelope = cylinders(*diameters, shift=shift)
    guide = Guide(surfaces, envelope, surfaces.first_plane + np.repeat(np.arange(6), 2))
    mesh = guide.labelled()
    work = patchwork(mesh)
    settling = Settling(surfaces, mesh, work)
    return surfaces, work, settling, settling.settle()


def test_one_channel_through_a_cube_leaves_ten_patches_and_eight_arcs():
    surfaces, work, _, _ = settled(1.2)
    kinds = [kind_of(surfaces, seam) for seam in work.seams]
    assert len(work.patches) == 6 + 4
    assert sorted(map(kinds.count, ("line", "free", "border"))) == [4, 8, 12]
    assert len(work.shell_volumes) == 1
    assert work.shell_volumes[0] == pytest.approx(SIZE**3 - math.pi * 0.36 * SIZE, rel=2e-3)


def test_patches_edges_and_nodes_meet_eulers_rule_for_two_crossing_channels():
    _, work, _, _ = settled(1.2, 0.8, shift=0.1)
    holes = sum(len(patch.borders) - 1 for patch in work.patches)
    # channels that cross once make a body of genus 3: four openings on one tree of channels
    assert len(work.meeting) - len(work.seams) + len(work.patches) - holes == 2 - 2 * 3


def test_seams_of_crossing_cylinders_lie_on_both():
    surfaces, work, settling, lines = settled(1.2, 0.8, shift=0.1)
    between = [k for k, s in enumerate(work.seams) if max(s.surfaces) < surfaces.first_plane and k in lines.curves]
    assert between
    assert not settling.lowered
    for number in between:
        x, y, z = lines.curves[number].points.T
        assert np.abs(np.hypot(x, y) - 0.6).max() < 0.6 * BEZIER_CIRCLE
        assert np.abs(np.hypot(y - 0.1, z) - 0.4).max() < 0.4 * BEZIER_CIRCLE
        assert lines.curves[number].distance <= EXACT


def test_lowered_seams_are_the_triangles_own_and_tell_their_distance():
    _, work, settling, _ = settled(1.2, 0.8, shift=0.1)
    number = next(iter(settling.lines().curves))
    assert settling.lower([number])
    curve = settling.lines().curves[number]
    assert len(curve.slopes) == 0
    assert len(curve.points) == len(work.seams[number].vertices)
    assert 0 < curve.distance < 0.02  # an arc of 1.2 mm in 32 chords has a sag of 0.003 mm
    assert {surface for surface, _ in settling.doubtful([number])} & set(work.seams[number].surfaces)


def test_lowering_twice_moves_the_ends_and_then_nothing_is_left_to_lower():
    _, _, settling, _ = settled(1.2)
    number = next(iter(settling.lines().curves))
    assert settling.lower([number])
    assert settling.lower([number])
    assert len(settling.lowered_nodes) == 2
    assert not settling.lower([number])


def test_refining_a_guide_takes_its_volume_nearer_to_the_true_one():
    surfaces, envelope = cylinders(1.2)
    guide = Guide(surfaces, envelope, surfaces.first_plane + np.repeat(np.arange(6), 2))
    before = guide.labelled()
    guide.refine([(strip, np.array([0.5, 0.5])) for strip in range(4)])
    after = guide.labelled()
    true = SIZE**3 - math.pi * 0.36 * SIZE
    volumes = [patchwork(mesh).shell_volumes[0] for mesh in (before, after)]
    assert abs(volumes[1] - true) < abs(volumes[0] - true)
    assert len(after.triangles) > len(before.triangles)


def test_pieces_that_cross_are_found_in_their_own_group_only():
    start = np.array([[0.0, 0], [0, 1], [0, 1], [0, 0]])
    end = np.array([[1.0, 1], [1, 0], [1, 0], [0, 1]])
    i, j = crossings(start, end, np.array([0, 0, 1, 0]))
    assert sorted((*i.tolist(), *j.tolist())) == [0, 1]  # the last one only touches the others at their ends


def test_an_open_mesh_is_refused():
    mesh, _ = cube()
    open_mesh = LabelledMesh(mesh.vertices, mesh.triangles[1:], np.zeros(11, int), np.zeros((11, 3, 2)))
    with pytest.raises(MeshError, match="closed mesh each of whose edges has two triangles"):
        patchwork(open_mesh)


def test_a_closed_surface_without_borders_is_refused():
    mesh, _ = cube()
    whole = LabelledMesh(mesh.vertices, mesh.triangles, np.zeros(12, int), np.zeros((12, 3, 2)))
    with pytest.raises(MeshError, match="closed in itself"):
        patchwork(whole)
