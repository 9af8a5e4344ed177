# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of volumes: round trips, fields as other programs write them, damaged files refused."""

import re

import numpy as np
import pytest

from freecad_trabecula.core.voxels.volume_files import read_npy, read_nrrd, write_npy, write_nrrd, write_vti
from freecad_trabecula.errors import ExportError, ParameterError

VOXELS = np.arange(24).reshape(2, 3, 4) % 5 == 0
VOXEL, ORIGIN = (0.1, 0.2, 0.3), (1.0, 2.0, 3.0)
#: As a scanner's software writes it: spacings, micrometres left out, big endian, raw.
SCAN = b"NRRD0004\n# a comment\ntype: short\ndimension: 3\nsizes: 2 1 3\nspacings: 0.02 0.02 0.04\n"
SCAN += b"endian: big\nencoding: raw\n\n" + np.arange(6, dtype=">i2").tobytes()


def written(path, data):
    path.write_bytes(data)
    return path


def test_npy_comes_back(tmp_path):
    write_npy(tmp_path / "a.npy", VOXELS)
    assert (read_npy(tmp_path / "a.npy") == VOXELS).all()


def test_nrrd_comes_back_with_its_place(tmp_path):
    write_nrrd(tmp_path / "a.nrrd", VOXELS, VOXEL, ORIGIN)
    volume = read_nrrd(tmp_path / "a.nrrd")
    assert (volume.values.astype(bool) == VOXELS).all()
    assert volume.voxel == pytest.approx(VOXEL)
    assert volume.origin == pytest.approx(ORIGIN)


def test_nrrd_of_a_scanner_is_read_with_x_fastest_and_its_order_of_bytes(tmp_path):
    volume = read_nrrd(written(tmp_path / "scan.nrrd", SCAN))
    assert volume.values.tolist() == [[[0, 1]], [[2, 3]], [[4, 5]]]
    assert volume.voxel == (0.02, 0.02, 0.04)


def test_units_other_than_mm_are_turned_into_mm(tmp_path):
    data = SCAN.replace(b"spacings: 0.02 0.02 0.04\n", b'spacings: 20 20 40\nunits: "um" "um" "um"\n')
    assert read_nrrd(written(tmp_path / "scan.nrrd", data)).voxel == pytest.approx((0.02, 0.02, 0.04))


def test_vti_holds_one_byte_a_cell_where_its_header_says(tmp_path):
    write_vti(tmp_path / "a.vti", VOXELS, VOXEL, ORIGIN)
    data = (tmp_path / "a.vti").read_bytes()
    assert b'WholeExtent="0 4 0 3 0 2" Origin="1 2 3" Spacing="0.1 0.2 0.3"' in data
    start = re.search(rb'<AppendedData encoding="raw">\n_', data).end()
    assert int.from_bytes(data[start : start + 8], "little") == 24
    assert list(data[start + 8 : start + 32]) == VOXELS.astype(int).ravel().tolist()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ((b"NRRD0004", b"nothing!"), "must begin with NRRD000"),
        ((b"type: short", b"type: block"), "the type must be one of"),
        ((b"sizes: 2 1 3", b"sizes: 2 1"), "three numbers above 0"),
        ((b"sizes: 2 1 3", b"sizes: 2 1 x"), "whole numbers, got '2 1 x'"),
        ((b"sizes: 2 1 3", b"sizes: 2 1 4"), "are 16 bytes, got 12 bytes"),
        ((b"encoding: raw", b"encoding: bzip2"), "raw or gzip, got 'bzip2'"),
        ((b"encoding: raw", b"encoding: gzip"), "damaged or cut off"),
        ((b"spacings: 0.02 0.02 0.04\n", b""), "must give the sizes of its voxels"),
        ((b"0.02 0.02 0.04", b"0.02 0 0.04"), "three edges above 0"),
        ((b"0.02 0.02 0.04", b"0.02 a 0.04"), "must be numbers"),
        ((b"encoding: raw\n", b"encoding: raw\ndata file: other.raw\n"), "in the file itself"),
        ((b"raw\n\n" + np.arange(6, dtype=">i2").tobytes(), b"raw"), "cut off"),
    ],
)
def test_a_damaged_nrrd_is_refused_with_what_is_wrong(tmp_path, change, words):
    data = SCAN.replace(*change)
    assert data != SCAN
    with pytest.raises(ParameterError, match=words):
        read_nrrd(written(tmp_path / "scan.nrrd", data))


def test_a_damaged_npy_is_refused(tmp_path):
    write_npy(tmp_path / "a.npy", VOXELS)
    whole = (tmp_path / "a.npy").read_bytes()
    for data in (whole[:-5], b"no array", b""):
        with pytest.raises(ParameterError, match="whole NPY file"):
            read_npy(written(tmp_path / "b.npy", data))
    np.save(tmp_path / "c.npy", np.array([{}], object), allow_pickle=True)
    with pytest.raises(ParameterError, match="whole NPY file"):
        read_npy(tmp_path / "c.npy")
    for wrong, words in ((np.zeros((2, 2)), "three axes"), (np.full((1, 1, 2), np.nan), "finite numbers, got 2")):
        write_npy(tmp_path / "d.npy", wrong)
        with pytest.raises(ParameterError, match=words):
            read_npy(tmp_path / "d.npy")


def test_a_missing_file_and_a_missing_folder_are_said(tmp_path):
    with pytest.raises(ExportError, match="could not be read"):
        read_nrrd(tmp_path / "none.nrrd")
    with pytest.raises(ExportError, match="could not be read"):
        read_npy(tmp_path / "none.npy")
    with pytest.raises(ExportError, match="could not be written"):
        write_nrrd(tmp_path / "none" / "a.nrrd", VOXELS, VOXEL, ORIGIN)
