# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is known of a mesh file at a glance: of small files all, of large ones from a sample, of faulty ones little."""

from __future__ import annotations

import math
import zipfile

import numpy as np
import pytest

from freecad_trabecula.core import estimates, file_bodies
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.file_bodies import body_of_file, reading_work
from freecad_trabecula.core.mesh_formats import write_3mf, write_obj, write_ply
from freecad_trabecula.core.stl import write_stl
from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.smooth_surface import smooth_surface


def write_text_stl(path, mesh):
    """An STL as text, as CAD programs write it."""
    lines = ["solid sponge"]
    for corners in mesh.vertices[mesh.triangles].tolist():
        lines += ["  facet normal 0 0 0", "    outer loop"]
        lines += ["      vertex {:.6e} {:.6e} {:.6e}".format(*corner) for corner in corners]
        lines += ["    endloop", "  endfacet"]
    path.write_text("\n".join([*lines, "endsolid sponge", ""]))


def write_text_ply(path, mesh):
    """A PLY as text, with a colour before the co-ordinates."""
    head = (
        f"ply\nformat ascii 1.0\nelement vertex {len(mesh.vertices)}\nproperty uchar red\nproperty float x\n"
        f"property float y\nproperty float z\nelement face {len(mesh.triangles)}\n"
        "property list uchar int vertex_indices\nend_header\n"
    )
    points = "".join("255 {:.6g} {:.6g} {:.6g}\n".format(*point) for point in mesh.vertices.tolist())
    path.write_text(head + points + "".join("3 {} {} {}\n".format(*one) for one in mesh.triangles.tolist()))


WRITERS = {
    "text.stl": write_text_stl,
    "binary.stl": write_stl,
    "a.obj": write_obj,
    "binary.ply": write_ply,
    "text.ply": write_text_ply,
    "a.3mf": write_3mf,
}


@pytest.fixture(scope="module")
def sponge():
    """A smooth sponge of 4 x 3 x 2 mm, half of it solid."""
    noise = Stream(5, "sponge").uniform(40 * 30 * 20).reshape(20, 30, 40)
    for axis in (0, 1, 2):
        for _ in range(3):
            noise = sum(np.roll(noise, k, axis) for k in (-2, -1, 0, 1, 2))
    return smooth_surface(noise > np.median(noise), (0.1, 0.1, 0.1), (-3.0, 8.0, 0.0)).mesh


@pytest.mark.parametrize("name", WRITERS)
def test_all_is_known_of_a_small_file(name, tmp_path, sponge, monkeypatch):
    monkeypatch.setattr(file_bodies, "_FEW", len(sponge.triangles))
    WRITERS[name](tmp_path / name, sponge)
    found, all_of_it = body_of_file(tmp_path / name), estimates.body_of(sponge.vertices[sponge.triangles])
    assert found.triangles == all_of_it.triangles
    digits = 1e-6 if name.startswith("binary") else 1e-4
    assert found[2:] == pytest.approx(all_of_it[2:], rel=digits)
    assert found.box == pytest.approx(all_of_it.box, abs=1e-5)
    assert list(estimates.planes_of(SliceParameters(thickness=0.1), found.box)) == ["x", "y", "z"]


@pytest.mark.parametrize("name", WRITERS)
def test_a_sample_of_a_large_file_tells_nearly_as_much(name, tmp_path, sponge, monkeypatch):
    count = len(sponge.triangles)
    monkeypatch.setattr(file_bodies, "_SAMPLE", count // 8)
    monkeypatch.setattr(file_bodies, "_FEW", count // 8)
    monkeypatch.setattr(file_bodies, "_PIECES", 60)
    monkeypatch.setattr(file_bodies, "_PIECE", 130 * count // 300)  # a fourth of the text in all
    WRITERS[name](tmp_path / name, sponge)
    found, all_of_it = body_of_file(tmp_path / name), estimates.body_of(sponge.vertices[sponge.triangles])
    assert found.triangles == pytest.approx(count, rel=0.03 if name == "text.stl" else 0)
    assert found.surface == pytest.approx(all_of_it.surface, rel=0.05)
    assert found.thickness == pytest.approx(all_of_it.thickness, rel=0.3)
    assert np.abs(found.box - all_of_it.box).max() < 0.3


def test_quadrilaterals_and_vertices_counted_backwards_are_understood(tmp_path):
    corners = [(x, y, z) for z in (0, 3) for x, y in ((0, 0), (1, 0), (1, 2), (0, 2))]
    quads = ((1, 4, 3, 2), (5, 6, 7, 8), (1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (4, 1, 5, 8))
    lines = ["# a box of 1 x 2 x 3", *("v {} {} {}".format(*corner) for corner in corners), "vn 0 0 1"]
    for number, quad in enumerate(quads):
        words = [f"{corner - 9 if number % 2 else corner}//1" for corner in quad]
        lines.append("f " + " ".join(words) + "  # of four corners")
    (tmp_path / "box.obj").write_text("\r\n".join(lines))
    body = body_of_file(tmp_path / "box.obj")
    assert (body.triangles, body.volume, body.surface) == (12, pytest.approx(6), pytest.approx(22))
    assert body.box.tolist() == [[0, 0, 0], [1, 2, 3]]


def model(unit="millimeter", meshes=1, transform=""):
    """A model of tetrahedra as 3MF has it."""
    mesh = (
        '<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/>'
        '<vertex x="0" y="0" z="1"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" '
        'v3="3"/><triangle v1="0" v2="3" v3="2"/><triangle v1="1" v2="2" v3="3"/></triangles></mesh>'
    )
    objects = "".join(f'<object id="{number}">{mesh}</object>' for number in range(meshes))
    items = "".join(f'<item objectid="{number}"{transform}/>' for number in range(meshes))
    return f'<model unit="{unit}"><resources>{objects}</resources><build>{items}</build></model>'


def test_of_a_3mf_of_one_mesh_all_is_known_of_others_the_triangles_by_the_size(tmp_path):
    path = tmp_path / "a.3mf"
    for arguments, is_known in (
        ({}, True),
        ({"unit": "inch"}, False),
        ({"meshes": 2}, False),
        ({"transform": ' transform="2 0 0 0 2 0 0 0 2 0 0 0"'}, False),
    ):
        with zipfile.ZipFile(path, "w") as package:
            package.writestr("3D/3dmodel.model", model(**arguments))
        body = body_of_file(path)
        assert math.isfinite(body.volume) == is_known, arguments
        if is_known:
            assert (body.triangles, body.volume) == (4, pytest.approx(1 / 6))
        else:
            assert body.triangles > 0 and estimates.planes_of(SliceParameters(), body.box) == {}
            assert estimates.analysis_work(body, []).seconds > 0
            assert estimates.voxels(body) == 200**3


@pytest.mark.parametrize(
    "name, text",
    [
        ("a.stl", "solid nothing\nendsolid\n" * 20),
        ("a.obj", "v 0 0 0\n" * 20),
        ("a.obj", "v 0 0 0\nf 1 2 70\n" * 20),
        ("a.obj", "v 0 0 zero\nf 1 1 1\n" * 20),
        ("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nend_header\n0 0 0\n"),
        ("a.ply", "no ply at all, whatever its name says\n" * 20),
        ("a.3mf", "no archive\n" * 20),
        ("a.xyz", "no mesh\n" * 20),
    ],
)
def test_of_a_faulty_file_which_is_refused_when_it_is_read_little_is_known(name, text, tmp_path):
    (tmp_path / name).write_text(text)
    body = body_of_file(tmp_path / name)
    assert np.isnan(body.box).all() and math.isnan(body.volume) and body.triangles >= 0


def test_a_file_that_is_not_there_is_an_error_of_the_system(tmp_path):
    with pytest.raises(OSError, match="nothing.stl"):
        body_of_file(tmp_path / "nothing.stl")
    with pytest.raises(OSError, match="nothing.stl"):
        reading_work(tmp_path / "nothing.stl", 1)


@pytest.mark.parametrize("name", WRITERS)
def test_texts_take_time_to_be_read_binary_files_none(name, tmp_path, sponge):
    WRITERS[name](tmp_path / name, sponge)
    work = reading_work(tmp_path / name, 10**6)
    assert work.seconds == 2 * reading_work(tmp_path / name, 500_000).seconds
    assert (work.seconds > 1) == (work.memory > 1e8) == (not name.startswith("binary"))
