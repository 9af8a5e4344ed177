# SPDX-License-Identifier: LGPL-2.1-or-later
"""OBJ, PLY and 3MF files of any program: what our writers wrote, what others may write, what is refused."""

import struct
import zipfile

import numpy as np
import pytest

from freecad_trabecula.core.mesh_formats import write_3mf, write_obj, write_ply
from freecad_trabecula.core.mesh_readers import read_mesh
from freecad_trabecula.core.meshes import Mesh, is_closed, mesh_volume, weld
from freecad_trabecula.core.stl import write_stl
from freecad_trabecula.errors import ExportError, MeshError

POINTS = np.array([[x, y, z] for z in (0.0, 3.0) for y in (0.0, 2.0) for x in (0.0, 1.0)])
QUADS = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
BOX = Mesh(POINTS, np.concatenate([QUADS[:, [0, 1, 2]], QUADS[:, [0, 2, 3]]]))  # 1 x 2 x 3 mm
WRITERS = {"stl": write_stl, "obj": write_obj, "ply": write_ply, "3mf": write_3mf}


def assert_is_the_box(path, unit=""):
    triangles, own = read_mesh(path)
    assert triangles.shape == (12, 3, 3) and triangles.dtype == np.float32
    mesh = weld(triangles)
    assert is_closed(mesh) and mesh_volume(mesh) == pytest.approx(6.0)
    assert own == unit


@pytest.mark.parametrize("kind", sorted(WRITERS))
def test_what_was_written_is_read_again(tmp_path, kind):
    WRITERS[kind](tmp_path / f"box.{kind}", BOX)
    assert_is_the_box(tmp_path / f"box.{kind}", "mm" if kind == "3mf" else "")


@pytest.mark.parametrize("turned", [False, True], ids=["counted from the first", "counted from the last"])
def test_an_obj_of_quads_with_textures_and_line_ends_of_windows_is_read(tmp_path, turned):
    lines = ["# a box", "o box", *("v %g %g %g 1.0" % tuple(p) for p in POINTS), "vt 0 0", "vn 0 0 1", "usemtl bone"]
    lines += ["f " + " ".join("%d/1/1" % (n - 8 if turned else n + 1) for n in quad) for quad in QUADS]
    (tmp_path / "box.OBJ").write_bytes("\r\n".join(lines).encode())
    assert_is_the_box(tmp_path / "box.OBJ")


def ply(order, face="property list uchar int vertex_index", quads=True):
    head = ["ply", f"format {order} 1.0", "comment of another program", "element vertex 8"]
    head += [f"property float {c}" for c in ("x", "y", "z", "confidence")]
    head += ["element face %d" % (6 if quads else 12), face, "end_header"]
    return "\n".join(head).encode() + b"\n"


def test_an_ascii_ply_of_quads_is_read(tmp_path):
    rows = ["%g %g %g 1" % tuple(p) for p in POINTS] + ["4 %d %d %d %d" % tuple(q) for q in QUADS]
    (tmp_path / "box.ply").write_bytes(ply("ascii") + "\n".join(rows).encode() + b"\n")
    assert_is_the_box(tmp_path / "box.ply")


@pytest.mark.parametrize("order", ["little", "big"])
@pytest.mark.parametrize("mixed", [False, True], ids=["quads", "triangles and quads"])
def test_a_binary_ply_is_read_whatever_its_order_of_bytes_and_polygons(tmp_path, order, mixed):
    sign = "<" if order == "little" else ">"
    faces = [list(q) for q in QUADS]
    if mixed:
        faces = [faces[0][:3], [faces[0][0], *faces[0][2:]], *faces[1:]]
    data = ply(f"binary_{order}_endian").replace(b"face 6", b"face %d" % len(faces))
    data += b"".join(struct.pack(sign + "4f", *p, 1.0) for p in POINTS)
    data += b"".join(struct.pack(sign + "B%di" % len(f), len(f), *f) for f in faces)
    (tmp_path / "box.ply").write_bytes(data)
    assert_is_the_box(tmp_path / "box.ply")


def model_3mf(path, model, name="3D/3dmodel.model"):
    with zipfile.ZipFile(path, "w") as package:
        package.writestr(name, model)


def test_a_3mf_places_components_and_items_and_tells_its_unit(tmp_path):
    vertices = "".join('<vertex z="%g" x="%g" y="%g"/>' % (z, x, y) for x, y, z in POINTS)
    triangles = "".join('<triangle v1="%d" v2="%d" v3="%d" pid="1"/>' % tuple(t) for t in BOX.triangles)
    model_3mf(
        tmp_path / "two.3mf",
        '<model unit="inch" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>'
        f'<object id="1"><mesh><vertices>{vertices}</vertices><triangles>{triangles}</triangles></mesh></object>'
        '<object id="2"><components><component objectid="1" transform="0 1 0 -1 0 0 0 0 1 10 0 0"/></components>'
        '</object></resources><build><item objectid="1"/><item objectid="2" transform="2 0 0 0 2 0 0 0 2 0 0 0"/>'
        "</build></model>",
    )
    triangles, unit = read_mesh(tmp_path / "two.3mf")
    assert unit == "inch" and len(triangles) == 24
    # turned by 90 degrees about z (x -> y, y -> -x), moved by 10 along x, then made twice as large
    assert triangles[12:].min((0, 1)).tolist() == [16, 0, 0] and triangles[12:].max((0, 1)).tolist() == [20, 2, 6]
    assert mesh_volume(weld(triangles)) == pytest.approx(6.0 + 48.0)


# --------------------------------------------------------------------------------------------------------- refusals


@pytest.mark.parametrize("kind", sorted(WRITERS))
@pytest.mark.parametrize("share", [0.0, 0.3, 0.9])
def test_a_file_that_is_cut_off_is_refused(tmp_path, kind, share):
    path = tmp_path / f"box.{kind}"
    WRITERS[kind](path, BOX)
    data = path.read_bytes()
    if kind == "obj" and share == 0.9:
        data = data[: data.rindex(b"f")] + b"f 1 2"  # a text has no end of its own: in the middle of a line
    else:
        data = data[: int(share * len(data))]
    path.write_bytes(data)
    with pytest.raises(MeshError, match="box"):
        read_mesh(path)


@pytest.mark.parametrize(
    ("name", "text", "rule"),
    [
        ("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "0..2, got 0..3"),
        ("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "got -1"),
        ("a.obj", "v 0 0\nv 1 0 0\nf 1 2 2\n", "three co-ordinates"),
        ("a.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "finite"),
        ("a.obj", "v 0 0 1e39\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "finite"),
        ("a.obj", "v 0 0 x\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "no proper OBJ"),
        ("a.obj", "v 0 0 0\n", "at least one triangle"),
        ("a.ply", "ply\nformat morse 1.0\nend_header\n", "ascii or binary"),
        ("a.ply", "solid\n", "begin with its header"),
        ("a.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nend_header\n1\n", "ends too early"),
        ("a.3mf", "no archive", "ZIP"),
        ("a.step", "ISO-10303-21;", "must end in .stl"),
    ],
)
def test_what_is_no_mesh_is_refused_with_its_rule(tmp_path, name, text, rule):
    (tmp_path / name).write_text(text)
    with pytest.raises(MeshError, match=rule):
        read_mesh(tmp_path / name)


@pytest.mark.parametrize(
    ("model", "rule"),
    [
        ("<model><resources>", "proper XML"),
        ('<model unit="ell"/>', "unit"),
        ("<model/>", "item to build"),
        ('<model><build><item objectid="7"/></build></model>', "'7'"),
        (
            '<model><resources><object id="1"><components><component objectid="1"/></components></object></resources>'
            '<build><item objectid="1"/></build></model>',
            "16 deep",
        ),
    ],
)
def test_a_3mf_whose_model_cannot_be_is_refused(tmp_path, model, rule):
    model_3mf(tmp_path / "a.3mf", model)
    with pytest.raises(MeshError, match=rule):
        read_mesh(tmp_path / "a.3mf")


def test_a_3mf_without_a_model_and_a_file_that_is_not_there_are_refused(tmp_path):
    model_3mf(tmp_path / "a.3mf", "<model/>", "3D/other.model")
    with pytest.raises(MeshError, match="must hold 3D/3dmodel.model"):
        read_mesh(tmp_path / "a.3mf")
    for kind in sorted(WRITERS):
        with pytest.raises(ExportError, match="could not be read"):
            read_mesh(tmp_path / f"gone.{kind}")
