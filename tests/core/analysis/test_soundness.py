# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faults of triangles: planted ones are counted, sound meshes have none."""

import json
import os
from pathlib import Path

import numpy as np
import pytest

from freecad_trabecula.core.analysis.crossings import crossing_triangles
from freecad_trabecula.core.analysis.neighbours import corner_keys
from freecad_trabecula.core.analysis.soundness import mesh_facts
from freecad_trabecula.core.analysis.triangles import Soup, by_corners, read_soup
from freecad_trabecula.core.meshes import Mesh, join, mesh_area, mesh_volume
from freecad_trabecula.errors import Cancelled

ROOT = Path(__file__).resolve().parents[3]
DATA = Path(os.environ.get("TRABECULA_DATA", str(ROOT.parent / "shared" / "data")))


def torus(n=40, m=24):
    a, b = np.meshgrid(2 * np.pi * np.arange(n) / n, 2 * np.pi * np.arange(m) / m, indexing="ij")
    points = np.stack([(4 + np.cos(b)) * np.cos(a), (4 + np.cos(b)) * np.sin(a), np.sin(b)], -1).reshape(-1, 3)
    i, j = (k.ravel() for k in np.meshgrid(np.arange(n), np.arange(m), indexing="ij"))
    corner = [(i + di) % n * m + (j + dj) % m for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return Mesh(points, np.concatenate([np.stack([corner[k] for k in t], 1) for t in ((0, 1, 2), (0, 2, 3))]))


def box(low, high):
    corners = np.where(np.arange(8)[:, None] >> np.arange(3) & 1, np.asarray(high, float), np.asarray(low, float))
    quads = [(0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6)]
    return Mesh(corners, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]))


def facts(triangles, **more):
    return mesh_facts(Soup(np.asarray(triangles, np.float32)), **more)


TRIANGLES = torus().corners


def test_a_closed_mesh_has_its_volume_area_and_no_faults():
    f = facts(TRIANGLES)
    assert f.volume == pytest.approx(mesh_volume(torus()), rel=1e-6) and f.area == pytest.approx(mesh_area(torus()))
    assert (f.triangles, f.parts) == (1920, 1) and f.is_sound and f.is_closed


def test_parts_are_counted_by_edges():
    shells = join([box([0, 0, 0], [1, 1, 1]), box([1, 1, 1], [2, 2, 2]), box([5, 0, 0], [6, 1, 1])])
    assert facts(shells.corners).parts == 3  # the first two share a corner only


@pytest.mark.parametrize("gone", [[7], [7, 900], [0, 500, 1900]])
def test_open_edges_are_those_round_what_is_missing(gone):
    f = facts(np.delete(TRIANGLES, gone, 0))
    assert f.open_edges == 3 * len(gone)
    assert not f.is_closed and (f.flipped, f.duplicates, f.self_intersecting) == (0, 0, 0)


@pytest.mark.parametrize("some", [[3], [3, 700, 1500], list(range(40, 60)), list(range(0, 1920, 5))])
def test_turned_triangles_are_counted_and_are_no_open_edges(some):
    triangles = TRIANGLES.copy()
    triangles[some] = triangles[some, ::-1]
    f = facts(triangles)
    assert (f.flipped, f.open_edges, f.parts) == (len(some), 0, 1) and not f.is_closed


def test_a_mesh_turned_as_a_whole_is_not_flipped_but_has_a_negative_volume():
    f = facts(TRIANGLES[:, ::-1])
    assert f.flipped == 0 and f.volume < 0


def test_doubles_are_counted_however_they_turn_and_begin():
    f = facts(np.concatenate([TRIANGLES, TRIANGLES[5:8, [1, 2, 0]], TRIANGLES[9:10, ::-1]]))
    assert f.duplicates == 4
    twice = facts(np.concatenate([TRIANGLES] * 2))
    assert twice.duplicates == 1920 and twice.is_closed and not twice.is_sound


def test_triangles_without_area_are_counted_and_open_nothing():
    a, b = TRIANGLES[0, 0], TRIANGLES[0, 1]
    flat = np.array([[a, a, a], [a, b, a], [[0, 0, 0], [1, 1, 1], [3, 3, 3]]])
    f = facts(np.concatenate([TRIANGLES, flat[:2]]), crossings=False)
    assert (f.degenerate, f.open_edges, f.self_intersecting) == (2, 0, -1)
    assert facts(flat).degenerate == 3


def test_one_facet_is_open_all_round():
    f = facts([[[0, 0, 0], [1, 0, 0], [0, 1, 0]]])
    assert (f.triangles, f.parts, f.open_edges, f.area) == (1, 1, 3, 0.5)


def test_crossing_triangles_are_those_on_both_sides_of_a_cut():
    # a bar through the middle of a plate: its 8 long triangles pierce both faces of 2 triangles each
    plate, bar = box([-5, -5, 0], [5, 5, 1]), box([-1, -2, -4], [1.5, 1, 5])
    both = join([plate, bar]).corners.astype(np.float32)
    keys = corner_keys(by_corners(both)).reshape(3, -1)
    found = np.flatnonzero(crossing_triangles(both, keys))
    top_and_bottom = [k for k in range(12) if np.ptp(both[k, :, 2]) == 0]
    upright = [k for k in range(12, 24) if np.ptp(both[k, :, 2]) > 0]
    assert set(found) == {*top_and_bottom, *upright}
    assert facts(join([plate, box([6, 6, 0], [7, 7, 1])]).corners).self_intersecting == 0


def test_touching_and_neighbouring_triangles_do_not_cross():
    assert facts(join([box([0, 0, 0], [1, 1, 1]), box([0, 0, 1], [1, 1, 2])]).corners).self_intersecting == 0


@pytest.mark.parametrize(("name", "expected"), [
    ("trab_ior_3p86mm_12MB", 10), ("shrew_cube_10mm", 5), ("trab_ior_1p17mm_tiny", 0)])  # fmt: skip
def test_self_intersections_of_real_bone_are_those_that_another_program_found(name, expected):
    path = DATA / f"{name}.stl"
    if not path.exists():
        pytest.skip(f"{path.name} is not in {DATA}")
    known = json.loads((ROOT / "tests" / "data" / "slice_reference.json").read_text(encoding="utf-8"))[name]
    f = mesh_facts(read_soup(path))
    assert (f.self_intersecting, f.parts, f.open_edges, f.flipped) == (expected, 1, 0, 0)
    assert f.triangles == known["triangles"]
    assert f.volume == pytest.approx(known["volume"], rel=1e-7)


def test_looking_for_faults_can_be_cancelled():
    def stop(done, total, what):
        if "cross" in what:
            raise Cancelled

    with pytest.raises(Cancelled):
        facts(TRIANGLES, progress=stop)
