# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stacks of images: what another program reads of them, round trips, bad stacks refused."""

import numpy as np
import pytest

from freecad_trabecula.core.voxels.image_stacks import read_stack, write_stack
from freecad_trabecula.errors import ExportError, ParameterError

Image = pytest.importorskip("PIL.Image", reason="PILLOW IS NOT INSTALLED: images are NOT tested; run `make setup`")
VOXEL = (0.1, 0.05, 0.2)


def design():
    """A design that no turning or mirroring maps on itself: (P, M, N) = (3, 4, 5)."""
    voxels = np.zeros((3, 4, 5), bool)
    voxels[0, 0, 1:4] = voxels[1, 2, 0] = voxels[2, 3, 4] = True
    return voxels


@pytest.mark.parametrize("kind", ["png", "bmp", "tiff"])
def test_a_stack_comes_back_as_it_was_with_its_pitch(tmp_path, kind):
    files = write_stack(tmp_path, design(), VOXEL, kind)
    assert len(files) == (1 if kind == "tiff" else 3)
    volume = read_stack(files[0] if kind == "tiff" else tmp_path)
    assert (volume.values > 127).tolist() == design().tolist()
    # BMP and PNG keep whole pixels a metre, and no distance of layers: then it is the pixel's width
    assert volume.voxel == pytest.approx((0.1, 0.05, 0.2 if kind == "tiff" else 0.1), rel=1e-3)


def test_another_program_sees_white_material_with_the_highest_y_on_top(tmp_path):
    first = write_stack(tmp_path, design(), VOXEL)[0]
    image = Image.open(first)
    assert (image.size, image.mode) == ((5, 4), "L")
    assert image.info["dpi"] == pytest.approx((254, 508), rel=1e-3)
    # layer 0 has material at y = 0, which is the lowest row
    assert np.asarray(image)[3].tolist() == [0, 255, 255, 255, 0]
    assert np.asarray(image)[:3].max() == 0


def test_names_are_read_in_the_order_of_their_numbers(tmp_path):
    for k, name in enumerate(("scan2.png", "scan10.png", "scan1.png")):
        Image.fromarray(np.full((2, 2), k, np.uint8)).save(tmp_path / name)
    assert read_stack(tmp_path, (1, 1, 1)).values[:, 0, 0].tolist() == [2, 0, 1]


def test_colours_become_grey_and_16_bits_stay(tmp_path):
    Image.fromarray(np.array([[[30, 60, 90]]], np.uint8)).save(tmp_path / "a.png")
    assert read_stack(tmp_path, (1, 1, 1)).values.tolist() == [[[60]]]
    Image.fromarray(np.array([[40000]], np.uint16)).save(tmp_path / "b.tif")
    assert read_stack(tmp_path / "b.tif", (1, 1, 1)).values.tolist() == [[[40000]]]


def test_images_of_unequal_sizes_are_refused_by_name(tmp_path):
    for k in (2, 3):
        Image.fromarray(np.zeros((2, k), np.uint8)).save(tmp_path / f"{k}.png")
    with pytest.raises(ParameterError, match="2 x 2 pixels.*3.png has 3 x 2"):
        read_stack(tmp_path, (1, 1, 1))


def test_a_folder_without_images_or_of_two_kinds_is_refused(tmp_path):
    with pytest.raises(ParameterError, match="must hold images.*got 0 images"):
        read_stack(tmp_path, (1, 1, 1))
    for name in ("a.png", "b.bmp"):
        Image.fromarray(np.zeros((2, 2), np.uint8)).save(tmp_path / name)
    with pytest.raises(ParameterError, match="of one kind, got .bmp, .png"):
        read_stack(tmp_path, (1, 1, 1))


def test_no_pitch_a_damaged_image_and_no_file_are_refused(tmp_path):
    Image.fromarray(np.zeros((2, 2), np.uint8)).save(tmp_path / "a.png")
    with pytest.raises(ParameterError, match="must have a pitch"):
        read_stack(tmp_path)
    with pytest.raises(ParameterError, match="three lengths above 0"):
        read_stack(tmp_path, (1, 1, 0))
    (tmp_path / "a.png").write_bytes(b"\x89PNG\r\n\x1a\nno")
    with pytest.raises(ParameterError, match="a.png must be an image that can be read"):
        read_stack(tmp_path, (1, 1, 1))
    with pytest.raises(ExportError, match="no such file"):
        read_stack(tmp_path / "none", (1, 1, 1))


def test_an_unknown_kind_is_refused_and_nothing_is_written(tmp_path):
    with pytest.raises(ParameterError, match="png, bmp, tiff, got 'gif'"):
        write_stack(tmp_path, design(), VOXEL, "gif")
    assert list(tmp_path.iterdir()) == []
