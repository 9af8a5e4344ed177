# SPDX-License-Identifier: LGPL-2.1-or-later
"""How large the files of a design's voxels will be, before they are written."""

from __future__ import annotations

import gzip
import zlib

import numpy as np

from ..parameters import require
from .image_stacks import layer_image, png_bytes
from .volume_files import WRITERS

#: Files of voxels, and stacks of images (one a layer, but TIFF).
VOLUMES = tuple(WRITERS)
_NPY, _NRRD, _VTI = 128, 330, 600  # bytes of headers, about
_BMP_HEAD, _BMP_ROW = 1078, 4  # header with 256 greys; rows end at multiples of so many bytes
_PAGE = 300  # bytes that a TIFF needs for a page besides its pixels
_SAMPLE = 32  # layers that are packed to judge all


def estimated_size(kind: str, voxels: np.ndarray) -> int:
    """Return about how many bytes a design takes (all images of a stack together); packed ones by a sample of layers.

    Parameters
    ----------
    kind : str
        ``npy``, ``nrrd``, ``vti``, ``png``, ``bmp`` or ``tiff``.
    voxels : ndarray of shape (P, M, N), bool

    Raises
    ------
    ParameterError
        If the kind is something else.
    """
    layers, rows, columns = voxels.shape
    chosen = np.unique(np.linspace(0, layers - 1, min(layers, _SAMPLE)).astype(int))
    share = layers / len(chosen)
    if kind == "npy":
        return _NPY + voxels.size
    if kind == "vti":
        return _VTI + voxels.size
    if kind == "nrrd":
        packed = gzip.compress(np.ascontiguousarray(voxels[chosen], np.uint8).tobytes(), 6, mtime=0)
        return _NRRD + round(share * len(packed))
    if kind == "png":
        return round(share * sum(len(png_bytes(layer_image(voxels[k]), (1.0, 1.0))) for k in chosen))
    if kind == "bmp":
        return layers * (_BMP_HEAD + rows * (-(-columns // _BMP_ROW) * _BMP_ROW))
    require(kind == "tiff", "the kind must be one of npy, nrrd, vti, png, bmp, tiff", repr(kind))
    size = sum(len(zlib.compress(layer_image(voxels[k]).tobytes(), 6)) for k in chosen)
    return round(share * size) + _PAGE * layers
