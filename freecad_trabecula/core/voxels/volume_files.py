# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of volumes: NPY and NRRD out and in, VTI (ParaView) out; whole or not at all."""

from __future__ import annotations

import gzip
import zlib
from pathlib import Path
from typing import BinaryIO, Callable, Dict, List, NamedTuple, Sequence, Tuple, Union

import numpy as np

from ...errors import ExportError, ParameterError
from ..parameters import require
from ..stl import whole_file

Triple = Tuple[float, float, float]

#: Names of NRRD's number types that scanners write.
_TYPES = {
    **dict.fromkeys(("uchar", "unsigned char", "uint8", "uint8_t"), "u1"),
    **dict.fromkeys(("signed char", "int8", "int8_t"), "i1"),
    **dict.fromkeys(("short", "short int", "signed short", "int16", "int16_t"), "i2"),
    **dict.fromkeys(("ushort", "unsigned short", "uint16", "uint16_t"), "u2"),
    **dict.fromkeys(("int", "signed int", "int32", "int32_t"), "i4"),
    **dict.fromkeys(("uint", "unsigned int", "uint32", "uint32_t"), "u4"),
    "float": "f4",
    "double": "f8",
}
_LONGEST_HEADER = 1_000_000  # bytes
_MM = {"mm": 1.0, "millimeter": 1.0, "um": 1e-3, "µm": 1e-3, "micron": 1e-3, "m": 1e3, "cm": 10.0}


class Volume(NamedTuple):
    """Values at voxels.

    Attributes
    ----------
    values : ndarray of shape (P, M, N)
        Axes z, y, x.
    voxel : tuple of three floats, mm
        dx, dy, dz.
    origin : tuple of three floats, mm
        Low corner of the first voxel.
    """

    values: np.ndarray
    voxel: Triple
    origin: Triple


def write_npy(path: Union[str, Path], voxels: np.ndarray) -> None:
    """Write a design (P, M, N) as NPY.

    Raises
    ------
    ExportError
        If the file cannot be written.
    """
    with whole_file(path) as file:
        np.save(file, np.asarray(voxels), allow_pickle=False)


def read_npy(path: Union[str, Path]) -> np.ndarray:
    """Return the array of three axes of an NPY file.

    Raises
    ------
    ParameterError
        If it is damaged, has not three axes, or holds no numbers.
    ExportError
        If it cannot be read.
    """
    try:
        with Path(path).open("rb") as file:
            values = np.load(file, allow_pickle=False)
    except OSError as error:
        raise ExportError(f"{path} could not be read: {error.strerror or error}") from error
    except (ValueError, EOFError) as error:
        raise ParameterError(f"{path} must be a whole NPY file of numbers: {error}") from error
    return checked_values(values, path)


def checked_values(values: np.ndarray, path: Union[str, Path]) -> np.ndarray:
    """Return values as they are if they are finite numbers on three axes, and refuse them if not.

    Raises
    ------
    ParameterError
    """
    values = np.asarray(values)
    require(values.ndim == 3 and values.size > 0, f"{path} must hold an array of three axes", values.shape)
    require(values.dtype.kind in "biuf", f"{path} must hold numbers", values.dtype)
    if values.dtype.kind == "f" and not np.isfinite(values).all():
        raise ParameterError(f"{path} must hold finite numbers, got {int((~np.isfinite(values)).sum())} that are not")
    return values


def write_nrrd(path: Union[str, Path], voxels: np.ndarray, voxel: Sequence[float], origin: Sequence[float]) -> None:
    """Write a design as NRRD (8 bits, gzip; 0 void, 1 material).

    Parameters
    ----------
    voxels : ndarray of shape (P, M, N), bool
    voxel, origin : sequence of three floats, mm
        dx, dy, dz; low corner of the first voxel (the file gives that voxel's centre, as NRRD wants).

    Raises
    ------
    ExportError
        If the file cannot be written.
    """
    directions = ["(" + ",".join(f"{s:.9g}" if k == a else "0" for k in range(3)) + ")" for a, s in enumerate(voxel)]
    centre = ",".join(f"{o + s / 2:.9g}" for o, s in zip(origin, voxel))
    header = (
        "NRRD0004\n# Trabecula\ntype: uint8\ndimension: 3\nspace dimension: 3\n"
        f"sizes: {voxels.shape[2]} {voxels.shape[1]} {voxels.shape[0]}\nspace directions: {' '.join(directions)}\n"
        f'space units: "mm" "mm" "mm"\nspace origin: ({centre})\nkinds: domain domain domain\nendian: little\n'
        "encoding: gzip\n\n"
    )
    with whole_file(path) as file:
        file.write(header.encode("ascii"))
        file.write(gzip.compress(np.ascontiguousarray(voxels, np.uint8).tobytes(), 6, mtime=0))


def read_nrrd(path: Union[str, Path]) -> Volume:
    """Return the volume of an NRRD file (raw or gzip, data in the same file).

    Raises
    ------
    ParameterError
        If it is damaged, has not three axes or no known type or encoding, or gives no sizes of the voxels.
    ExportError
        If it cannot be read.
    """
    path = Path(path)
    try:
        with path.open("rb") as file:
            fields = _nrrd_fields(file, path)
            data = file.read()
    except OSError as error:
        raise ExportError(f"{path} could not be read: {error.strerror or error}") from error
    if "data file" in fields or "datafile" in fields:
        raise ParameterError(f"{path}: the data must stand in the file itself, not in a data file of their own")
    kind = fields.get("type", "").lower()
    require(kind in _TYPES, f"{path}: the type must be one of {', '.join(_TYPES)}", repr(kind))
    sizes = _whole_numbers(fields.get("sizes", ""), path)
    require(len(sizes) == 3 and min(sizes) > 0, f"{path}: sizes must be three numbers above 0", sizes)
    order = ">" if fields.get("endian", "little").lower() == "big" else "<"
    dtype = np.dtype(order + _TYPES[kind])
    raw = _decoded(data, fields.get("encoding", "raw").lower(), path)
    expected = dtype.itemsize * sizes[0] * sizes[1] * sizes[2]
    rule = f"{path}: {sizes[0]} x {sizes[1]} x {sizes[2]} values of {kind} are {expected} bytes"
    require(len(raw) == expected, rule, len(raw), "bytes")
    values = np.frombuffer(raw, dtype).reshape(sizes[::-1]).astype(dtype.newbyteorder("="))
    voxel, centre = _placed(fields, path)
    origin = tuple(c - s / 2 for c, s in zip(centre, voxel))
    return Volume(checked_values(values, path), voxel, origin)  # type: ignore[arg-type]


def _nrrd_fields(file: BinaryIO, path: Path) -> Dict[str, str]:
    """The header's fields, names in lower case; the file stands at the data afterwards."""
    first = file.readline(100)
    require(first.startswith(b"NRRD000"), f"{path} must begin with NRRD000", repr(first[:8].decode("latin-1")))
    fields: Dict[str, str] = {}
    for line in iter(lambda: file.readline(_LONGEST_HEADER), b""):
        text = line.decode("utf-8", "replace").strip()
        if not text:
            return fields
        name, colon, value = text.partition(":")
        if colon and not text.startswith("#"):
            fields[name.strip().lower()] = value.lstrip("=").strip()
    raise ParameterError(f"{path}: the header must end with an empty line; the file is cut off")


def _whole_numbers(text: str, path: Path) -> List[int]:
    try:
        return [int(word) for word in text.split()]
    except ValueError as error:
        raise ParameterError(f"{path}: sizes must be whole numbers, got {text!r}") from error


def _decoded(data: bytes, encoding: str, path: Path) -> bytes:
    if encoding == "raw":
        return data
    require(encoding in ("gzip", "gz"), f"{path}: the encoding must be raw or gzip", repr(encoding))
    try:
        return gzip.decompress(data)
    except (OSError, EOFError, zlib.error) as error:
        raise ParameterError(f"{path}: the packed data are damaged or cut off: {error}") from error


def _placed(fields: Dict[str, str], path: Path) -> Tuple[Triple, Triple]:
    """Edges of a voxel and the centre of the first, mm."""
    try:
        if "space directions" in fields:
            vectors = [_vector(text) for text in fields["space directions"].replace(") (", ")|(").split("|")]
            sizes = [float(np.linalg.norm(v)) for v in vectors]
        elif "spacings" in fields:
            sizes = [abs(float(word)) for word in fields["spacings"].split()]
        else:
            raise ParameterError(f"{path} must give the sizes of its voxels (spacings or space directions)")
        units = fields.get("space units", fields.get("units", "")).replace('"', " ").split()
        centre = _vector(fields["space origin"]) if "space origin" in fields else np.array(sizes) / 2
    except ValueError as error:
        if isinstance(error, ParameterError):
            raise
        raise ParameterError(f"{path}: spacings, directions and origin must be numbers: {error}") from error
    scale = _MM.get(units[0].lower(), 1.0) if units else 1.0
    require(
        len(sizes) == 3 and bool(np.isfinite(sizes).all()) and min(sizes) > 0,
        f"{path}: a voxel must have three edges above 0", sizes,
    )  # fmt: skip
    return tuple(s * scale for s in sizes), tuple(float(c) * scale for c in centre)  # type: ignore[return-value]


def _vector(text: str) -> np.ndarray:
    return np.array([float(word) for word in text.strip().strip("()").split(",")])


def write_vti(path: Union[str, Path], voxels: np.ndarray, voxel: Sequence[float], origin: Sequence[float]) -> None:
    """Write a design as VTK image data (``.vti``), one value ``material`` a cell, for ParaView.

    Parameters as for ``write_nrrd``.

    Raises
    ------
    ExportError
        If the file cannot be written.
    """
    values = np.ascontiguousarray(voxels, np.uint8)
    extent = f"0 {values.shape[2]} 0 {values.shape[1]} 0 {values.shape[0]}"
    places = f'Origin="{" ".join(f"{o:.9g}" for o in origin)}" Spacing="{" ".join(f"{s:.9g}" for s in voxel)}"'
    head = (
        '<?xml version="1.0"?>\n<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" '
        'header_type="UInt64">\n'
        f'<ImageData WholeExtent="{extent}" {places}>\n<Piece Extent="{extent}">\n<CellData Scalars="material">\n'
        '<DataArray type="UInt8" Name="material" format="appended" offset="0"/>\n</CellData>\n</Piece>\n</ImageData>\n'
        '<AppendedData encoding="raw">\n_'
    )
    with whole_file(path) as file:
        file.write(head.encode("ascii"))
        file.write(np.array([values.size], "<u8").tobytes() + values.tobytes())
        file.write(b"\n</AppendedData>\n</VTKFile>\n")


#: Writers ``(path, voxels (P, M, N), voxel, origin)`` by the files' ending; the sizes beforehand are in ``file_sizes``.
WRITERS: Dict[str, Callable[..., None]] = {
    "npy": lambda path, voxels, voxel, origin: write_npy(path, voxels),
    "nrrd": write_nrrd,
    "vti": write_vti,
}
