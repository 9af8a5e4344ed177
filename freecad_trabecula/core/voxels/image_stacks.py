# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stacks of images, one a layer along Z: out for printers that work by layers (PolyJet, DLP), in as samples.

The pitch of the pixels stands in the files (PNG pHYs, BMP and TIFF resolution). An image's first row is the highest Y
of its layer, as one looks down on it. PNG is written by ourselves; BMP, TIFF and all reading need Pillow.
"""

from __future__ import annotations

import re
import struct
import zlib
from pathlib import Path
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from ...errors import ExportError, ParameterError
from ..optional_packages import optional_module
from ..parameters import require
from ..progress import Progress, silent
from ..stl import whole_file
from ..triples import triple
from .volume_files import Volume

KINDS = ("png", "bmp", "tiff")
READ = (".png", ".tif", ".tiff", ".bmp")
MATERIAL, VOID = 255, 0
_INCH = 25.4  # mm
_SIGNATURE = b"\x89PNG\r\n\x1a\n"


def _pillow() -> Any:
    return optional_module("PIL.Image", "images of this kind need Pillow")


def layer_image(layer: np.ndarray) -> np.ndarray:
    """Return a layer (M, N) bool as grey values (M, N) uint8, white = material, highest Y first."""
    return np.where(layer[::-1], np.uint8(MATERIAL), np.uint8(VOID))


def png_bytes(pixels: np.ndarray, pitch: Tuple[float, float]) -> bytes:
    """Return a grey PNG.

    Parameters
    ----------
    pixels : ndarray of shape (rows, columns), uint8
    pitch : (float, float), mm
        Of the pixels along the columns and along the rows (dx, dy); kept as whole pixels a metre.
    """
    rows, columns = pixels.shape
    per_metre = [max(1, round(1000.0 / p)) for p in pitch]
    raw = np.concatenate([np.zeros((rows, 1), np.uint8), pixels], 1).tobytes()  # filter 0 before each row
    parts = [
        (b"IHDR", struct.pack(">IIBBBBB", columns, rows, 8, 0, 0, 0, 0)),
        (b"pHYs", struct.pack(">IIB", *per_metre, 1)),
        (b"IDAT", zlib.compress(raw, 6)),
        (b"IEND", b""),
    ]
    chunks = (struct.pack(">I", len(d)) + n + d + struct.pack(">I", zlib.crc32(n + d)) for n, d in parts)
    return _SIGNATURE + b"".join(chunks)


def write_stack(
    folder: Union[str, Path],
    voxels: np.ndarray,
    voxel: Sequence[float],
    kind: str = "png",
    progress: Progress = silent,
) -> List[Path]:
    """Write a design as one image a layer, ``layer_0001.png`` ..., or as one TIFF of many pages; return the files.

    Parameters
    ----------
    folder : path
        Exists.
    voxels : ndarray of shape (P, M, N), bool
    voxel : sequence of three floats, mm
        dx, dy, dz; dz is not kept by images (TIFF: in its description).
    kind : str
        One of ``KINDS``.
    progress : Progress

    Raises
    ------
    ParameterError
        If the kind is unknown.
    DependencyError
        If Pillow is needed and not installed.
    ExportError
        If a file cannot be written.
    """
    require(kind in KINDS, f"images must be of the kind {', '.join(KINDS)}", repr(kind))
    if kind == "tiff":
        return [_write_tiff(Path(folder) / "layers.tiff", voxels, voxel, progress)]
    digits = max(4, len(str(len(voxels))))
    save = _save_png if kind == "png" else _save_bmp()
    files = []
    for k, layer in enumerate(voxels):
        progress(k, len(voxels), "writing layers")
        files.append(Path(folder) / f"layer_{k + 1:0{digits}d}.{kind}")
        save(files[-1], layer_image(layer), voxel)
    return files


def _save_png(path: Path, pixels: np.ndarray, voxel: Sequence[float]) -> None:
    with whole_file(path) as file:
        file.write(png_bytes(pixels, (voxel[0], voxel[1])))


def _save_bmp() -> Callable[[Path, np.ndarray, Sequence[float]], None]:
    image = _pillow()

    def save(path: Path, pixels: np.ndarray, voxel: Sequence[float]) -> None:
        with whole_file(path) as file:
            image.fromarray(pixels).save(file, "BMP", dpi=(_INCH / voxel[0], _INCH / voxel[1]))

    return save


def _write_tiff(path: Path, voxels: np.ndarray, voxel: Sequence[float], progress: Progress) -> Path:
    image = _pillow()
    pages = [image.fromarray(layer_image(layer)) for layer in voxels]
    words: Dict[str, Any] = {
        "dpi": (_INCH / voxel[0], _INCH / voxel[1]),
        "compression": "tiff_deflate",
        "description": f"spacing={voxel[2]:.9g} unit=mm",  # as ImageJ says it
    }
    progress(0, 1, "writing layers")
    with whole_file(path) as file:
        pages[0].save(file, "TIFF", save_all=True, append_images=pages[1:], **words)
    return path


# ------------------------------------------------------------------------------------------------------------- reading


def stack_files(folder: Union[str, Path]) -> List[Path]:
    """Return the images of a folder in the order of the numbers in their names.

    Raises
    ------
    ParameterError
        If there are none, or of several kinds.
    """
    files = [p for p in Path(folder).iterdir() if p.suffix.lower() in READ and not p.name.startswith(".")]
    require(len(files) > 0, f"{folder} must hold images ({', '.join(READ)})", len(files), "images")
    kinds = sorted({p.suffix.lower() for p in files})
    require(len(kinds) == 1, f"the images of {folder} must be of one kind", ", ".join(kinds))
    return sorted(files, key=lambda p: [int(w) if w.isdigit() else w for w in re.split(r"(\d+)", p.name)])


def read_stack(path: Union[str, Path], voxel: Optional[Sequence[float]] = None, progress: Progress = silent) -> Volume:
    """Return a stack of images as grey values, the first image lowest.

    Parameters
    ----------
    path : path
        A folder of images, or one file of many pages (TIFF).
    voxel : sequence of three floats, mm, optional
        dx, dy, dz; if left out, the resolution in the files is taken, and the distance of the layers from the
        description of a TIFF, or else equal to dx.
    progress : Progress

    Raises
    ------
    ParameterError
        If the images are of unequal sizes or damaged, or no pitch is given or found.
    DependencyError
        If Pillow is not installed.
    ExportError
        If a file cannot be read.
    """
    image, path = _pillow(), Path(path)
    if not path.exists():
        raise ExportError(f"{path} could not be read: there is no such file or folder")
    files = stack_files(path) if path.is_dir() else [path]
    layers: List[np.ndarray] = []
    pitch: Optional[Tuple[float, float, float]] = None
    for k, name in enumerate(files):
        progress(k, len(files), "reading layers")
        try:
            with image.open(name) as pages:
                pitch = pitch or _pitch(pages)
                for page in range(getattr(pages, "n_frames", 1)):
                    pages.seek(page)
                    layers.append(_grey(np.asarray(pages), name))
        except (OSError, SyntaxError, ValueError) as error:
            if isinstance(error, ParameterError):
                raise
            raise ParameterError(f"{name} must be an image that can be read: {error}") from error
        if layers[-1].shape != layers[0].shape:
            first, this = (" x ".join(map(str, a.shape[::-1])) for a in (layers[0], layers[-1]))
            raise ParameterError(
                f"all images of a stack must have one size, {first} pixels, but {name.name} has {this}"
            )
    found = tuple(float(v) for v in voxel) if voxel is not None else pitch
    if found is None:
        raise ParameterError(f"the pixels of {path} must have a pitch: none stands in the images, and none was given")
    require(len(found) == 3 and min(found) > 0, "a pitch must be three lengths above 0", found, "mm")
    return Volume(np.stack(layers)[:, ::-1], triple(found), (0.0, 0.0, 0.0))


def _grey(pixels: np.ndarray, name: Path) -> np.ndarray:
    if pixels.ndim == 3:  # colours: their mean, without a transparent channel
        pixels = pixels[..., :3].mean(-1) if pixels.shape[2] >= 3 else pixels[..., 0]
    require(pixels.ndim == 2, f"{name} must be a flat image", pixels.shape)
    return pixels.astype(np.uint8) if pixels.dtype == bool else pixels


def _pitch(pages: Any) -> Optional[Tuple[float, float, float]]:
    """dx, dy, dz from an image's resolution; None if it has none."""
    dpi = pages.info.get("dpi")
    if not dpi or min(dpi) <= 0:
        return None
    dx, dy = (_INCH / float(d) for d in dpi)
    words = str(getattr(pages, "tag_v2", {}).get(270, ""))  # 270: the description
    spacing = re.search(r"spacing=([0-9.eE+-]+)", words)
    return dx, dy, float(spacing.group(1)) if spacing else dx
