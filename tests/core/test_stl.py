# SPDX-License-Identifier: LGPL-2.1-or-later
"""STL files: round trips, both kinds, and the traps that files from elsewhere set."""

import struct
import zlib

import numpy as np
import pytest

from freecad_trabecula.core import stl
from freecad_trabecula.core.meshes import Mesh, is_closed, mesh_volume
from freecad_trabecula.errors import ExportError, MeshError

CORNERS = np.where(np.arange(4)[:, None] > 0, np.eye(4)[:, 1:] * 2.5, 0.0)
TETRAHEDRON = Mesh(CORNERS, np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]))  # volume 2.5**3 / 6


def ascii_stl(mesh, line="\n", word=str, number="%.9g"):
    rows = ["solid test of it"]
    for triangle in mesh.corners:
        rows += ["facet normal 0 0 0", "  outer loop"]
        rows += ["    vertex  " + " ".join(number % x for x in corner) for corner in triangle]
        rows += ["  endloop", "endfacet"]
    return word(line.join([*rows, "endsolid test of it", ""])).encode()


def binary_stl(mesh, header=b"", count=None):
    data = header.ljust(80) + struct.pack("<I", len(mesh.triangles) if count is None else count)
    for triangle in mesh.corners:
        data += struct.pack("<12fH", 0, 0, 0, *triangle.ravel(), 0)
    return data


@pytest.fixture
def path(tmp_path):
    return tmp_path / "body.stl"


def test_a_mesh_written_and_read_again_is_the_same_and_closed(path):
    stl.write_stl(path, TETRAHEDRON)
    mesh = stl.read_stl(path)
    assert (mesh.corners == TETRAHEDRON.corners).all()
    assert is_closed(mesh) and mesh_volume(mesh) == pytest.approx(2.5**3 / 6)
    assert path.stat().st_size == stl.stl_bytes(4) == 84 + 4 * 50


def test_the_bytes_written_are_the_format_s(path):
    stl.write_stl(path, TETRAHEDRON)
    data = path.read_bytes()
    assert not data.startswith(b"solid")
    assert struct.unpack("<I", data[80:84]) == (4,)
    normal, corners = struct.unpack("<12fH", data[84 + 150 : 134 + 150])[:3], TETRAHEDRON.corners[3].ravel()
    assert normal == pytest.approx([3**-0.5] * 3)
    assert struct.unpack("<12fH", data[84 + 150 : 134 + 150])[3:] == (*corners, 0)


def test_more_triangles_than_one_block_are_written(path, monkeypatch):
    monkeypatch.setattr(stl, "_BLOCK", 3)
    stl.write_stl(path, TETRAHEDRON)
    assert stl.read_triangles(path).tolist() == TETRAHEDRON.corners.tolist()


def test_a_binary_file_whose_header_says_solid_is_read_as_binary(path):
    path.write_bytes(binary_stl(TETRAHEDRON, b"solid made by a CAD program"))
    assert stl.read_triangles(path).tolist() == TETRAHEDRON.corners.tolist()


@pytest.mark.parametrize("line", ["\n", "\r\n"])
@pytest.mark.parametrize("word", [str, str.upper], ids=["small", "capital"])
def test_an_ascii_file_is_read_whatever_its_line_ends_and_capitals(path, line, word):
    path.write_bytes(ascii_stl(TETRAHEDRON, line, word))
    mesh = stl.read_stl(path)
    assert (mesh.corners == TETRAHEDRON.corners).all() and is_closed(mesh)


def test_numbers_with_exponents_are_read_from_ascii(path):
    path.write_bytes(ascii_stl(TETRAHEDRON, number="%+.5E"))
    assert stl.read_triangles(path).tolist() == TETRAHEDRON.corners.tolist()


def test_two_solids_in_one_ascii_file_are_taken_together(path):
    path.write_bytes(ascii_stl(TETRAHEDRON) * 2)
    assert len(stl.read_triangles(path)) == 8


@pytest.mark.parametrize("count", [0, 3, 5, 4_000_000_000])
def test_a_count_that_does_not_fit_the_size_is_refused(path, count):
    path.write_bytes(binary_stl(TETRAHEDRON, count=count))
    with pytest.raises(MeshError, match=f"says {count} triangles, 284 bytes hold 4 and 0 bytes more"):
        stl.read_stl(path)


def test_a_binary_file_that_is_cut_off_is_refused(path):
    path.write_bytes(binary_stl(TETRAHEDRON)[:-20])
    with pytest.raises(MeshError, match="84 \\+ 50 bytes for each triangle"):
        stl.read_stl(path)


def test_an_ascii_file_that_is_cut_off_is_refused(path):
    path.write_bytes(ascii_stl(TETRAHEDRON)[:-60])
    with pytest.raises(MeshError, match="must end with 'endsolid'"):
        stl.read_stl(path)


def test_a_file_of_a_few_bytes_is_refused(path):
    path.write_bytes(b"\x00\x01")
    with pytest.raises(MeshError, match="at least 84 bytes, got 2"):
        stl.read_stl(path)


@pytest.mark.parametrize("data", [binary_stl(Mesh(np.zeros((0, 3)), np.zeros((0, 3)))), b"solid a\nendsolid a\n"])
def test_a_file_without_triangles_is_refused(path, data):
    path.write_bytes(data)
    with pytest.raises(MeshError, match="at least one triangle, got 0"):
        stl.read_stl(path)


@pytest.mark.parametrize("value", [float("nan"), float("inf")])
def test_a_coordinate_that_is_not_finite_is_refused_with_its_triangle(path, value):
    corners = CORNERS.copy()
    corners[3] = value
    for data in (binary_stl, ascii_stl):
        path.write_bytes(data(Mesh(corners, TETRAHEDRON.triangles)))
        with pytest.raises(MeshError, match="finite; triangle 2 of 4"):
            stl.read_stl(path)


def test_a_facet_of_four_vertices_is_refused(path):
    path.write_bytes(ascii_stl(TETRAHEDRON).replace(b"  endloop", b"    vertex 1 2 3\n  endloop", 1))
    with pytest.raises(MeshError, match="three vertices, got 13 vertices in 4 facets"):
        stl.read_stl(path)


def test_a_word_in_the_place_of_a_number_is_refused(path):
    path.write_bytes(ascii_stl(TETRAHEDRON).replace(b"2.5", b"2,5", 1))
    with pytest.raises(MeshError, match="co-ordinates must be numbers"):
        stl.read_stl(path)


def test_a_missing_file_and_a_folder_are_refused_by_name(path, tmp_path):
    for wrong in (path, tmp_path):
        with pytest.raises(ExportError, match=f"{wrong.name} could not be read"):
            stl.read_stl(wrong)


def test_a_missing_folder_is_refused_and_nothing_is_made(tmp_path):
    with pytest.raises(ExportError, match="could not be written"):
        stl.write_stl(tmp_path / "none" / "body.stl", TETRAHEDRON)
    assert list(tmp_path.iterdir()) == []


def test_a_full_disk_leaves_the_old_file_and_nothing_half_written(path):
    resource = pytest.importorskip("resource")
    path.write_bytes(b"old")
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, limits[1]))
    try:
        with pytest.raises(ExportError, match=r"body\.stl could not be written: File too large"):
            stl.write_stl(path, TETRAHEDRON)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert [p.name for p in path.parent.iterdir()] == ["body.stl"]
    assert path.read_bytes() == b"old"


def test_an_error_while_writing_is_let_through_and_leaves_nothing(path):
    with pytest.raises(ZeroDivisionError), stl.whole_file(path) as file:
        file.write(b"half")
        raise ZeroDivisionError
    assert list(path.parent.iterdir()) == []


def test_the_same_mesh_gives_the_same_bytes(path):
    sums = set()
    for _ in range(2):
        stl.write_stl(path, TETRAHEDRON)
        sums.add(zlib.crc32(path.read_bytes()))
    assert len(sums) == 1
