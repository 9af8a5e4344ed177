# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mesh engine on square channels, whose volumes follow by inclusion and exclusion."""

from __future__ import annotations

import sys

import numpy as np
import pytest

from freecad_trabecula.core.booleans import (
    CutSteps,
    combine,
    cut_bodies,
    exact_union_volume,
    manifold_available,
    unite,
)
from freecad_trabecula.core.meshes import Mesh, bounds, is_closed, mesh_volume
from freecad_trabecula.core.rays import union_volume
from freecad_trabecula.errors import Cancelled, DependencyError, MeshError, ParameterError

needs_manifold = pytest.mark.skipif(
    not manifold_available(), reason="MANIFOLD3D IS NOT INSTALLED: the mesh engine is NOT tested; run `make setup`"
)

BOX_TRIANGLES = np.array(
    [[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4], [2, 6, 3], [3, 6, 7], [0, 4, 2], [2, 4, 6],
     [1, 3, 5], [3, 7, 5]]
)  # fmt: skip


def corners(low, high):
    cube = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
    return np.array(low) + cube * (np.array(high, float) - np.array(low))


def box(low=(0, 0, 0), high=(10, 10, 10)):
    return Mesh(corners(low, high), BOX_TRIANGLES)


def channel(axis, at=(4.0, 4.0), width=2.0, beyond=0.1):
    """A square rod along an axis through a cube of 10 mm, its low corner at ``at`` in the other two axes' order."""
    low, high = np.full(3, -beyond), np.full(3, 10 + beyond)
    others = [a for a in range(3) if a != axis]
    low[others], high[others] = at, np.add(at, width)
    return corners(low, high)


def tilted(count, seed):
    """Square rods of 1 x 1 x 8 mm in all directions about the centre of the cube."""
    rng = np.random.RandomState(seed)
    turns, _ = np.linalg.qr(rng.normal(size=(count, 3, 3)))
    turns[np.linalg.det(turns) < 0] *= -1
    straight = corners((-0.5, -0.5, -4), (0.5, 0.5, 4))
    return straight @ turns.transpose(0, 2, 1) + 5 + rng.uniform(-1, 1, (count, 1, 3))


# ------------------------------------------------------------------------------------------------ unions and cuts


@needs_manifold
def test_a_square_channel_takes_its_width_squared_times_the_cube_s_height():
    bodies = cut_bodies(channel(2)[None], BOX_TRIANGLES, box())
    assert mesh_volume(bodies.scaffold) == pytest.approx(960, rel=1e-12)
    assert mesh_volume(bodies.channels) == pytest.approx(40, rel=1e-12)
    assert bodies.body_volume == pytest.approx(1000, rel=1e-12)
    assert is_closed(bodies.scaffold) and is_closed(bodies.channels)


@needs_manifold
@pytest.mark.parametrize(("axes", "volume"), [((0, 2), 40 + 40 - 8), ((0, 1, 2), 3 * 40 - 3 * 8 + 8)])
def test_crossing_channels_count_their_overlap_once(axes, volume):
    bodies = cut_bodies(np.stack([channel(a) for a in axes]), BOX_TRIANGLES, box())
    assert mesh_volume(bodies.channels) == pytest.approx(volume, rel=1e-12)
    assert mesh_volume(bodies.scaffold) == pytest.approx(1000 - volume, rel=1e-12)
    assert is_closed(bodies.scaffold) and is_closed(bodies.channels)


@needs_manifold
def test_rods_that_do_not_touch_add_up():
    rods = np.stack([channel(2, (1 + 3 * i, 1 + 3 * j), 1.0) for i in range(3) for j in range(3)])
    assert exact_union_volume(rods, BOX_TRIANGLES) == pytest.approx(9 * 10.2, rel=1e-12)
    assert exact_union_volume(rods, BOX_TRIANGLES, box()) == pytest.approx(90, rel=1e-12)


@needs_manifold
def test_a_rod_that_stands_twice_counts_once():
    rods = np.stack([channel(2)] * 3)
    assert exact_union_volume(rods, BOX_TRIANGLES) == pytest.approx(4 * 10.2, rel=1e-12)


@needs_manifold
@pytest.mark.parametrize("count", [2, 7, 16])
def test_the_union_of_tilted_rods_has_the_volume_that_rays_find(count):
    rods = tilted(count, count)
    united = unite(rods, BOX_TRIANGLES)
    rays = union_volume(rods[:, BOX_TRIANGLES].reshape(-1, 3, 3), *bounds(united), 300)
    assert is_closed(united)
    assert abs(mesh_volume(united) - rays.volume) < 5 * rays.error


@needs_manifold
def test_the_order_of_the_rods_changes_nothing():
    rods = tilted(9, 1)
    volumes = [exact_union_volume(rods[order], BOX_TRIANGLES) for order in (slice(None), slice(None, None, -1))]
    assert volumes[0] == pytest.approx(volumes[1], rel=1e-10)


@needs_manifold
def test_no_rods_leave_the_whole_envelope():
    bodies = cut_bodies(np.zeros((0, 8, 3)), BOX_TRIANGLES, box())
    assert mesh_volume(bodies.scaffold) == pytest.approx(1000)
    assert len(bodies.channels.triangles) == 0


@needs_manifold
def test_scaffold_and_channels_share_the_vertices_between_them():
    bodies = cut_bodies(tilted(5, 2), BOX_TRIANGLES, box())
    inner = [
        set(map(tuple, m.vertices[((m.vertices > 1e-6) & (m.vertices < 10 - 1e-6)).all(1)]))
        for m in (bodies.scaffold, bodies.channels)
    ]
    assert inner[0] == inner[1] and len(inner[0]) > 40


@needs_manifold
def test_a_layer_that_closes_is_taken_from_the_channels():
    bodies = cut_bodies(channel(2)[None], BOX_TRIANGLES, box(), [box((-1, -1, 9), (11, 11, 11))])
    assert mesh_volume(bodies.channels) == pytest.approx(36, rel=1e-12)
    assert mesh_volume(bodies.scaffold) == pytest.approx(964, rel=1e-12)


@needs_manifold
@pytest.mark.parametrize(("kind", "volume"), [("union", 15), ("difference", 5), ("intersection", 3)])
def test_combinations_of_two_boxes(kind, volume):
    meshes = [box((0, 0, 0), (2, 2, 2)), box((0, 0, 1.25), (2, 2, 3.75))]
    assert mesh_volume(combine(meshes, kind)) == pytest.approx(volume, rel=1e-12)


@needs_manifold
def test_cuts_in_steps_can_be_undone():
    steps = CutSteps(box())
    assert steps.cut(channel(0)[None], BOX_TRIANGLES) == pytest.approx(960)
    assert steps.cut(channel(2)[None], BOX_TRIANGLES) == pytest.approx(928)
    assert steps.undo() == pytest.approx(960)
    assert steps.steps == 1
    assert steps.cut(channel(1, (0.5, 0.5), 1.0)[None], BOX_TRIANGLES) == pytest.approx(950)
    assert mesh_volume(steps.mesh()) == pytest.approx(950)


@needs_manifold
def test_progress_rises_and_reaches_its_total():
    seen = []
    cut_bodies(tilted(9, 3), BOX_TRIANGLES, box(), progress=lambda done, total, what: seen.append(done / total))
    assert seen == sorted(seen)
    assert seen[-1] == 1
    assert len(seen) >= 8


# ------------------------------------------------------------------------------------------------------- refusals


@needs_manifold
def test_cancelling_between_two_steps_gets_through():
    def stop(done, total, what):
        raise Cancelled("stopped")

    with pytest.raises(Cancelled):
        unite(tilted(4, 1), BOX_TRIANGLES, stop)


@needs_manifold
def test_an_open_rod_is_refused_by_its_number():
    with pytest.raises(MeshError, match="rod 1 of 2 must be a closed mesh"):
        unite(tilted(2, 1), BOX_TRIANGLES[:-1])


@needs_manifold
def test_a_rod_inside_out_is_refused_with_its_volume():
    with pytest.raises(MeshError, match="rod 1 of 1 .* got a volume of -8 mm3"):
        unite(tilted(1, 1), BOX_TRIANGLES[:, ::-1])


@needs_manifold
def test_a_rod_with_a_co_ordinate_that_is_no_number_is_refused():
    rods = tilted(2, 1)
    rods[1, 0, 0] = np.nan
    with pytest.raises(MeshError, match="rod 2 of 2 .*finite"):
        unite(rods, BOX_TRIANGLES)


@needs_manifold
def test_an_open_envelope_is_refused():
    with pytest.raises(MeshError, match="the envelope must be a closed mesh"):
        cut_bodies(channel(2)[None], BOX_TRIANGLES, Mesh(box().vertices, BOX_TRIANGLES[:-1]))


@needs_manifold
def test_rods_without_a_number_are_refused():
    with pytest.raises(MeshError, match=r"\(rods, vertices, 3\), got \(8, 3\)"):
        unite(channel(2), BOX_TRIANGLES)


@needs_manifold
def test_an_unknown_boolean_is_refused():
    with pytest.raises(ParameterError, match="union, difference, intersection, got 'xor'"):
        combine([box()], "xor")


@needs_manifold
def test_there_is_nothing_to_undo_before_the_first_cut():
    with pytest.raises(ParameterError, match="got 0 cuts"):
        CutSteps(box()).undo()


def test_without_manifold3d_the_command_that_installs_it_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "manifold3d", None)
    assert not manifold_available()
    with pytest.raises(DependencyError, match="pip install .*manifold3d==") as caught:
        unite(tilted(2, 1), BOX_TRIANGLES)
    assert "\n" not in str(caught.value)
