# SPDX-License-Identifier: LGPL-2.1-or-later
"""Targets from files: what each kind gives, and what is refused in each."""

from __future__ import annotations

import json
import os
from pathlib import Path

import numpy as np
import pytest

from freecad_trabecula.core.analysis.analysis import analyse
from freecad_trabecula.core.analysis.folder import save_analysis
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.triangles import read_soup
from freecad_trabecula.core.stl import write_stl
from freecad_trabecula.core.streams import Stream
from freecad_trabecula.core.voxels.blocks import block_mesh
from freecad_trabecula.core.voxels.parameters import VoxelParameters
from freecad_trabecula.core.voxels.sources import (
    layers_of_source,
    read_mask,
    read_targets,
    targets_record,
)
from freecad_trabecula.core.voxels.targets import targets_of_voxels
from freecad_trabecula.errors import InfeasibleError, ParameterError

DATA = Path(os.environ.get("TRABECULA_DATA") or Path(__file__).resolve().parents[4] / "shared" / "data")
VOXELS = Stream(1, "sources").many(6 * 5 * 4).reshape(6, 5, 4) < 0.5
VOXELS[0, 0, 0] = VOXELS[-1, -1, -1] = True


def chosen(size=0.1, **more):
    return VoxelParameters(**{"strategy": "sequential", "size": size, **more})


@pytest.fixture
def mesh_file(tmp_path):
    write_stl(tmp_path / "bone.stl", block_mesh(VOXELS, (0.1, 0.1, 0.1), (1.0, 2.0, 3.0)))
    return tmp_path / "bone.stl"


def counts_of(targets):
    return [c.tolist() for c in targets.counts]


@pytest.mark.parametrize("areas", ["middle", "slab"])
def test_a_mesh_of_blocks_asks_for_its_own_voxels(mesh_file, areas):
    targets = read_targets(mesh_file, chosen(areas=areas))
    assert counts_of(targets) == counts_of(targets_of_voxels(VOXELS))
    assert targets.origin == pytest.approx((1, 2, 3))
    assert targets.deltas == (0, 0, 0)
    assert (targets.sample == VOXELS).all()
    assert layers_of_source(mesh_file, chosen()) == (4, 5, 6)


def test_cells_that_are_no_cubes_ask_for_the_same_volume(mesh_file):
    targets = read_targets(mesh_file, chosen((0.2, 0.1, 0.3), areas="slab"))
    assert targets.layers == (2, 5, 2)
    assert targets.total == round(VOXELS.sum() / 6)


def test_trabeculae_are_asked_for_only_when_chosen(mesh_file):
    assert read_targets(mesh_file, chosen()).trabeculae is None
    assert [len(t) for t in read_targets(mesh_file, chosen(trabeculae="xyz")).trabeculae] == [4, 5, 6]


def test_an_analysis_asks_for_the_same_as_its_mesh(mesh_file, tmp_path):
    (tmp_path / "analysis").mkdir()
    save_analysis(
        analyse(read_soup(mesh_file), SliceParameters(thickness=0.1), morphometry=False), tmp_path / "analysis"
    )
    targets = read_targets(tmp_path / "analysis", chosen())
    assert counts_of(targets) == counts_of(targets_of_voxels(VOXELS))
    with pytest.raises(ParameterError, match=r"0.1 mm along X, got 0.05 mm, which makes 8 layers of the sample's 4"):
        read_targets(tmp_path / "analysis", chosen(0.05))


def test_targets_and_voxels_written_are_read_again(tmp_path):
    targets = targets_of_voxels(VOXELS, (0.1, 0.2, 0.3))
    (tmp_path / "targets.json").write_text(json.dumps(targets_record(targets)))
    again = read_targets(tmp_path / "targets.json", chosen())
    assert counts_of(again) == counts_of(targets) and again.voxel == (0.1, 0.2, 0.3)
    np.save(tmp_path / "design.npy", VOXELS)
    assert counts_of(read_targets(tmp_path / "design.npy", chosen())) == counts_of(targets)


def csv_file(folder, column="voxels", change=lambda rows: rows):
    rows = [(axis, k, n) for axis, c in zip("xyz", targets_of_voxels(VOXELS).counts) for k, n in enumerate(c.tolist())]
    lines = [f"axis,layer,{column}", *(f"{a},{k},{n}" for a, k, n in change(rows))]
    (folder / "t.csv").write_text("\n".join(lines) + "\n")
    return folder / "t.csv"


def test_a_table_of_counts_or_areas_asks_for_them(tmp_path):
    asked = counts_of(targets_of_voxels(VOXELS))
    assert counts_of(read_targets(csv_file(tmp_path), chosen())) == asked
    areas = csv_file(tmp_path, "sliced_area_mm2", lambda rows: [(a, k, n * 0.01) for a, k, n in reversed(rows)])
    assert counts_of(read_targets(areas, chosen())) == asked


def test_a_mask_from_a_mesh_or_a_file_is_on_the_grid_of_the_targets(mesh_file, tmp_path):
    targets = read_targets(mesh_file, chosen())
    for boundary in ("half", "touched", "inside"):
        assert (read_mask(mesh_file, targets, boundary) == VOXELS).all()
    np.save(tmp_path / "mask.npy", VOXELS)
    assert (read_mask(tmp_path / "mask.npy", targets, "half") == VOXELS).all()
    half = block_mesh(np.ones((6, 5, 4), bool), (0.08, 0.1, 0.1), (1.0, 2.0, 3.0))  # to 3.2 voxels along x
    write_stl(tmp_path / "half.stl", half)
    widths = {b: int(read_mask(tmp_path / "half.stl", targets, b)[0, 0].sum()) for b in ("half", "touched", "inside")}
    assert widths == {"half": 3, "touched": 4, "inside": 3}


@pytest.mark.skipif(not DATA.is_dir(), reason=f"NO SAMPLES IN {DATA}: targets of real bone are NOT tested")
def test_real_bone_has_the_same_slab_volume_along_every_axis():
    targets = read_targets(DATA / "trab_ior_10mm_13MB.stl", chosen(areas="slab"))
    volumes = [float(a.sum() * s) for a, s in zip(targets.areas, targets.voxel)]
    assert volumes == pytest.approx([volumes[0]] * 3, rel=1e-9)
    assert max(map(abs, targets.deltas)) < 10
    assert targets.thickness / 0.1 < 3  # too thin for voxels of 0.1 mm


# ------------------------------------------------------------------------------------------------------- refusals


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda rows: rows[1:], r"must have the layers 0, 1, ... along x, got \[1, 2, 3\]"),
        (lambda rows: rows[:4], r"along y, got \[\]"),
        (lambda rows: [*rows, rows[0]], "a layer must stand there once, got layer 0 along x"),
        (lambda rows: [("w", 0, 3), *rows], "line 2: the axis must be x, y or z, got 'w'"),
        (lambda rows: [("x", 0, "many"), *rows[1:]], "line 2: it must be a number, got 'many'"),
        (lambda rows: [("x", 0, "nan"), *rows[1:]], "must be finite"),
        (lambda rows: [("x", 0, 1.5), *rows[1:]], "must be whole numbers"),
        (lambda rows: [("x", 0, -1), *rows[1:]], "must not be negative"),
    ],
)
def test_a_table_that_is_wrong_is_refused_where_it_is_wrong(tmp_path, change, words):
    with pytest.raises(ParameterError, match=words):
        read_targets(csv_file(tmp_path, change=change), chosen())


def test_a_table_with_unequal_totals_is_refused(tmp_path):
    with pytest.raises(InfeasibleError, match="X - Z = 1"):
        read_targets(csv_file(tmp_path, change=lambda rows: [(*rows[0][:2], rows[0][2] + 1), *rows[1:]]), chosen())


def test_files_that_are_not_what_they_seem_are_refused(tmp_path):
    (tmp_path / "a.csv").write_text("layer,voxels\n0,1\n")
    with pytest.raises(ParameterError, match="must have a column 'axis'"):
        read_targets(tmp_path / "a.csv", chosen())
    (tmp_path / "empty.csv").write_text("")
    with pytest.raises(ParameterError, match="one for each layer, got 0"):
        read_targets(tmp_path / "empty.csv", chosen())
    (tmp_path / "t.json").write_text("{")
    with pytest.raises(ParameterError, match="could not be read as JSON"):
        read_targets(tmp_path / "t.json", chosen())
    (tmp_path / "u.json").write_text('{"D": [1]}')
    with pytest.raises(ParameterError, match="must hold, got E"):
        read_targets(tmp_path / "u.json", chosen())
    (tmp_path / "v.npy").write_bytes(b"\x93NUMPY damaged")
    with pytest.raises(ParameterError):
        read_targets(tmp_path / "v.npy", chosen())
    (tmp_path / "w.stl").write_bytes(b"too short")
    with pytest.raises(ParameterError, match="STL"):
        read_targets(tmp_path / "w.stl", chosen())
    (tmp_path / "x.doc").write_text("")
    with pytest.raises(ParameterError, match="targets are read from"):
        read_targets(tmp_path / "x.doc", chosen())
    with pytest.raises(ParameterError, match="must be a file or folder of that name"):
        read_targets(tmp_path / "missing.stl", chosen())


def test_an_open_mesh_and_a_voxel_larger_than_the_mesh_are_refused(mesh_file, tmp_path):
    mesh = block_mesh(VOXELS, (0.1, 0.1, 0.1))
    write_stl(tmp_path / "open.stl", type(mesh)(mesh.vertices, mesh.triangles[1:]))
    with pytest.raises(ParameterError, match="must be closed"):
        read_targets(tmp_path / "open.stl", chosen())
    write_stl(tmp_path / "turned.stl", type(mesh)(mesh.vertices, mesh.triangles[:, ::-1]))
    with pytest.raises(ParameterError, match="inside out"):
        read_targets(tmp_path / "turned.stl", chosen())
    with pytest.raises(ParameterError, match="a voxel must not be larger than the sample, 0.4 mm along X"):
        read_targets(mesh_file, chosen(0.5))


def test_a_mask_without_cells_or_of_another_shape_is_refused(mesh_file, tmp_path):
    targets = read_targets(mesh_file, chosen())
    write_stl(tmp_path / "far.stl", block_mesh(VOXELS, (0.1, 0.1, 0.1), (9.0, 9.0, 9.0)))
    with pytest.raises(ParameterError, match="at least one cell; far.stl has in the targets' box, got 0"):
        read_mask(tmp_path / "far.stl", targets, "half")
    np.save(tmp_path / "mask.npy", VOXELS[1:])
    with pytest.raises(ParameterError, match=r"must have the shape \(6, 5, 4\), got \(5, 5, 4\)"):
        read_mask(tmp_path / "mask.npy", targets, "half")
