# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles from files: units, layouts, and what cannot be a body."""

import struct

import numpy as np
import pytest

from freecad_trabecula.core import stl
from freecad_trabecula.core.analysis.triangles import LARGEST, Soup, by_corners, read_soup, soup_of
from freecad_trabecula.core.mesh_formats import write_3mf, write_obj
from freecad_trabecula.core.meshes import Mesh
from freecad_trabecula.errors import ExportError, MeshError, ParameterError

CORNERS = np.where(np.arange(4)[:, None] > 0, np.eye(4)[:, 1:], 0.0)
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


def tetrahedron(size=8.0):
    return Mesh(CORNERS * size, FACES)


def test_a_file_s_triangles_are_laid_out_so_that_corners_cost_no_copy(tmp_path):
    for name, write in (("a.stl", stl.write_stl), ("a.obj", write_obj), ("a.3mf", write_3mf)):
        write(tmp_path / name, tetrahedron())
        soup = read_soup(tmp_path / name)
        assert soup.triangles.dtype == np.float32
        assert (soup.triangles == tetrahedron().corners).all() and soup.source == name
        assert np.shares_memory(by_corners(soup.triangles), soup.triangles)
        assert soup.box.tolist() == [[0, 0, 0], [8, 8, 8]]


def test_a_mesh_s_triangles_are_laid_out_alike():
    soup = soup_of(tetrahedron(), "design")
    assert (soup.triangles == tetrahedron().corners).all() and soup.source == "design"
    assert np.shares_memory(by_corners(soup.triangles), soup.triangles)


@pytest.mark.parametrize(
    ("size", "unit", "expected"),
    [
        (8.0, "mm", 8.0), (0.5, "mm", 0.5), (2000.0, "mm", 2000.0),
        (0.424, "m (guessed: the body would be 0.424 mm large)", 424.0),  # a femur in metres
        (21552.0, "um (guessed: the body would be 21552 mm large)", 21.552),
    ],
)  # fmt: skip
def test_the_unit_is_guessed_from_the_size_and_said(tmp_path, size, unit, expected):
    stl.write_stl(tmp_path / "a.stl", tetrahedron(size))
    soup = read_soup(tmp_path / "a.stl")
    assert soup.unit == unit and soup.box[1].max() == pytest.approx(expected, rel=1e-6)


def test_a_unit_that_is_named_or_in_the_file_is_not_guessed(tmp_path):
    stl.write_stl(tmp_path / "a.stl", tetrahedron(0.4))
    assert read_soup(tmp_path / "a.stl", "mm").box[1].max() == np.float32(0.4)
    assert read_soup(tmp_path / "a.stl", "inch").box[1].max() == pytest.approx(10.16)
    write_3mf(tmp_path / "a.3mf", tetrahedron(0.4))
    soup = read_soup(tmp_path / "a.3mf")
    assert soup.unit == "mm (the file's)" and soup.box[1].max() == np.float32(0.4)


def test_a_binary_file_that_says_solid_is_read(tmp_path):
    stl.write_stl(tmp_path / "a.stl", tetrahedron())
    data = (tmp_path / "a.stl").read_bytes()
    (tmp_path / "a.stl").write_bytes(b"solid bone".ljust(80) + data[80:])
    assert len(read_soup(tmp_path / "a.stl").triangles) == 4


# --------------------------------------------------------------------------------------------------------- refusals


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 1e30, -1e30])
def test_vertices_that_cannot_be_are_refused(tmp_path, value):
    triangles = tetrahedron().corners.astype("<f4")
    triangles[2, 1, 0] = value
    body = b"".join(struct.pack("<3f", 0, 0, 0) + t.tobytes() + b"\0\0" for t in triangles)
    (tmp_path / "a.stl").write_bytes(b"bone".ljust(80) + struct.pack("<I", 4) + body)
    with pytest.raises(MeshError, match=r"a\.stl.*finite"):
        read_soup(tmp_path / "a.stl", "mm")
    with pytest.raises(MeshError, match="finite"):
        Soup(triangles)


@pytest.mark.parametrize("count", [0, 3, 5, 2**32 - 1])
def test_a_count_that_lies_is_refused(tmp_path, count):
    stl.write_stl(tmp_path / "a.stl", tetrahedron())
    data = (tmp_path / "a.stl").read_bytes()
    (tmp_path / "a.stl").write_bytes(data[:80] + struct.pack("<I", count) + data[84:])
    with pytest.raises(MeshError, match="its header says"):
        read_soup(tmp_path / "a.stl")


@pytest.mark.parametrize("size", [0, 40, 84, 100, 283])
def test_an_empty_or_truncated_file_is_refused(tmp_path, size):
    stl.write_stl(tmp_path / "a.stl", tetrahedron())
    data = (tmp_path / "a.stl").read_bytes()
    if size == 84:
        data = data[:80] + bytes(4)  # a proper file of no triangles
    (tmp_path / "a.stl").write_bytes(data[:size])
    with pytest.raises(MeshError):
        read_soup(tmp_path / "a.stl")


def test_a_file_that_vanishes_or_shrinks_while_it_is_read_is_refused(tmp_path, monkeypatch):
    with pytest.raises(ExportError, match="could not be read"):
        read_soup(tmp_path / "gone.stl")
    stl.write_stl(tmp_path / "a.stl", tetrahedron())
    read = np.fromfile
    monkeypatch.setattr(np, "fromfile", lambda file, dtype, count: read(file, dtype, count)[:-1])
    with pytest.raises(MeshError, match="became shorter while it was read"):
        read_soup(tmp_path / "a.stl")


def test_other_shapes_no_triangles_and_unknown_units_are_refused(tmp_path):
    with pytest.raises(MeshError, match="shape"):
        Soup(np.zeros((4, 3)))
    with pytest.raises(MeshError, match="at least one triangle"):
        Soup(np.zeros((0, 3, 3)))
    with pytest.raises(MeshError, match="at most 1e"):
        Soup(np.full((1, 3, 3), 2 * LARGEST))
    with pytest.raises(ParameterError, match="unit must be auto or one of"):
        read_soup(tmp_path / "a.stl", "parsec")
    with pytest.raises(MeshError, match=r"must end in \.stl"):
        read_soup(tmp_path / "a.step")
