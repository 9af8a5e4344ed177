# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stratasys SSL, the text format of slices that the thesis read (5.2.2): in and out.

::

    Slice V0
    FILE(part.ssl)              may hold a path
    UNITS(MM)                   or INCH; absent in some files: mm, unless the caller knows better
    SLICES()
    Z 0.05 0.1                  co-ordinate of the layer and its thickness
    0 0                         corners, one a line; the first is not repeated
    5 0
    5 5
    C                           closes the contour; O ends an open polyline
    END                         what follows is not read

Counter-clockwise contours hold material, clockwise ones are voids. Descriptions of the format do not say whether Z is
the bottom, the middle or the top of a layer: here it is the co-ordinate of the plane, in and out.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Dict, List, Sequence, Tuple, Union

import numpy as np

from ...errors import ContourError, ExportError, ParameterError
from ..progress import Progress, silent
from ..stl import whole_file
from .contours import Contours
from .layer_corners import distinct_corners
from .triangles import LARGEST

#: mm in the units that a file can name.
UNITS = {"mm": 1.0, "inch": 25.4}
_UNIT_WORDS = {"MM": "mm", "MILLIMETER": "mm", "MILLIMETERS": "mm", "INCH": "inch", "INCHES": "inch", "IN": "inch"}
_DECIMALS = {"mm": 6, "inch": 8}  # 1 and 0.25 nm: less than single precision tells apart in a part of 10 mm
_NUMBER = b"0123456789+-."
_COMMENT = (b"#", b";", b"//", b"(")
_BLOCK = 50_000  # lines between two reports of progress


@dataclass(frozen=True, eq=False)
class LayerFile:
    """Layers as a file holds them.

    Attributes
    ----------
    name : str
        What the file says in FILE(...), which may be a path of another time.
    unit : str
        ``mm`` or ``inch``: what the numbers stood for; here all are mm.
    contours : Contours
        In the order of their layers.
    thicknesses : ndarray of shape (S,), mm
    notes : tuple of str
        What the file has that the format does not ask for, or lacks, one sentence each.
    """

    name: str
    unit: str
    contours: Contours
    thicknesses: np.ndarray
    notes: Tuple[str, ...]

    @property
    def thickness(self) -> float:
        """The thickness that all layers have, mm.

        Raises
        ------
        ContourError
            If they differ, or there are none.
        """
        if not len(self.thicknesses) or np.ptp(self.thicknesses) > 1e-6:
            low, high = (float(f(self.thicknesses)) if len(self.thicknesses) else 0.0 for f in (np.min, np.max))
            raise ContourError(
                f"all layers must have one thickness, got {low:g} to {high:g} mm in {len(self.thicknesses)} layers"
            )
        return float(np.median(self.thicknesses))


# ------------------------------------------------------------------------------------------------------------- reading


def read_ssl(path: Union[str, Path], axis: str = "z", unit: str = "auto", progress: Progress = silent) -> LayerFile:
    """Return the layers of an SSL file: of any case, line ends, order of layers, with comments or without END.

    Parameters
    ----------
    path : str or Path
    axis : str
        The axis along which the part was sliced: the file does not say.
    unit : str
        ``mm`` or ``inch``, or ``auto``: what the file says, else mm.

    Raises
    ------
    ContourError
        If a line is no SSL (its number is told), a layer comes twice, or the file is cut off in a contour.
    ExportError
        If the file cannot be read.
    ParameterError
        If the unit is none of these.
    """
    if unit != "auto" and unit not in UNITS:
        raise ParameterError(f"the unit must be one of auto, {', '.join(UNITS)}, got {unit!r}")
    try:
        data = Path(path).read_bytes()
    except OSError as error:
        raise ExportError(f"{path} could not be read: {error.strerror or error}") from error
    lines = [line.strip() for line in data.replace(b"\r\n", b"\n").replace(b"\r", b"\n").split(b"\n")]
    found = _Layers(str(path))
    start = found.take_header(lines)
    found.take_body(lines, start, progress)
    return found.layer_file(axis, unit)


class _Layers:
    """Collects what the lines of a file say."""

    def __init__(self, path: str) -> None:
        self.path = path
        self.name, self.unit = "", ""
        self.points: List[bytes] = []  # lines that hold corners
        self.rows: List[int] = []  # their numbers in the file
        self.starts, self.layer_of, self.closed = [0], [], []  # type: ignore[var-annotated]
        self.layers: List[Tuple[float, float, int]] = []  # co-ordinate, thickness, line
        self.ended = False
        self.counts: Dict[str, int] = {}

    def refuse(self, row: int, rule: str, line: bytes = b"") -> ContourError:
        """Return the error that names a line (``row`` counts from 0)."""
        got = f", got {line[:40].decode('latin-1')!r}" if line else ""
        return ContourError(f"{self.path}, line {row + 1}: {rule}{got}")

    def count(self, what: str) -> None:
        """Remember something that is to be said."""
        self.counts[what] = self.counts.get(what, 0) + 1

    # ------------------------------------------------------------------------------------------------------- header

    def take_header(self, lines: Sequence[bytes]) -> int:
        """Read up to SLICES(), or the first layer; return the row where the layers begin."""
        version = ""
        for row, line in enumerate(lines):
            word = line.lstrip(b"\xef\xbb\xbf").upper()
            if not word or word.startswith(_COMMENT):
                continue
            if not version:
                version = word.decode("latin-1")
                if version.split() not in (["SLICE", "V0"], ["SLICE", "VO"]):
                    raise self.refuse(row, "an SSL file must begin with 'Slice V0'", line)
            elif word.startswith(b"FILE"):
                self.name = self._argument(row, line)
            elif word.startswith(b"UNITS"):
                text = self._argument(row, line).strip().upper()
                if text not in _UNIT_WORDS:
                    raise self.refuse(row, "the units must be MM or INCH", line)
                self.unit = _UNIT_WORDS[text]
            elif word.startswith(b"SLICES"):
                return row + 1
            elif word.startswith(b"Z"):
                self.count("SLICES() is missing")
                return row
            else:
                raise self.refuse(row, "a header must hold FILE(...), UNITS(...), SLICES() only", line)
        raise ContourError(
            f"{self.path}: an SSL file must begin with 'Slice V0' and 'SLICES()'; this one holds neither"
        )

    def _argument(self, row: int, line: bytes) -> str:
        _, opened, rest = line.partition(b"(")
        inside, closed, _ = rest.rpartition(b")")
        if not (opened and closed):
            raise self.refuse(row, "what FILE and UNITS say must stand in brackets", line)
        try:
            return inside.decode("utf-8")
        except UnicodeDecodeError:  # a path of a Windows of that time
            return inside.decode("latin-1")

    # --------------------------------------------------------------------------------------------------------- body

    def take_body(self, lines: Sequence[bytes], start: int, progress: Progress) -> None:
        """Read layers, corners and ends of polylines."""
        points, rows = self.points, self.rows
        for row in range(start, len(lines)):
            line = lines[row]
            if (row - start) % _BLOCK == 0:
                progress(row, len(lines), "reading layers")
            if line[:1] in _NUMBER and line:
                points.append(line)
                rows.append(row)
            elif line:
                self._take_word(row, line)
                if self.ended:
                    break
        pending = len(points) - self.starts[-1]
        if pending:
            first = rows[self.starts[-1]] + 1
            raise ContourError(f"{self.path}: a polyline must end with C or O; that of line {first} is cut off")
        if not self.ended:
            self.count("END is missing")

    def _take_word(self, row: int, line: bytes) -> None:
        word = line.upper().partition(b"#")[0].strip()
        if not word or line.startswith(_COMMENT):
            return
        if word in (b"C", b"O"):
            self._take_end(row, word == b"C")
        elif word == b"END":
            self.ended = True
        elif word[:1] == b"Z":
            self._take_layer(row, line, word[1:])
        else:
            raise self.refuse(row, "a line must be 'Z height thickness', two co-ordinates, C, O or END", line)

    def _take_layer(self, row: int, line: bytes, numbers: bytes) -> None:
        if len(self.points) > self.starts[-1]:
            raise self.refuse(row, "a polyline must end with C or O before the next layer", line)
        values = _floats(numbers.split())
        if len(values) != 2 or not np.isfinite(values).all() or values[1] <= 0:
            raise self.refuse(row, "a layer must be 'Z height thickness', two numbers, the second above 0", line)
        self.layers.append((values[0], values[1], row))

    def _take_end(self, row: int, is_closed: bool) -> None:
        if not self.layers:
            raise self.refuse(row, "a polyline must belong to a layer; there is no Z line before it")
        if len(self.points) == self.starts[-1]:
            raise self.refuse(row, "a polyline must have corners, got none before its end")
        self.starts.append(len(self.points))
        self.layer_of.append(len(self.layers) - 1)
        self.closed.append(is_closed)

    # ------------------------------------------------------------------------------------------------------- result

    def layer_file(self, axis: str, unit: str) -> LayerFile:
        """Return what was collected, in mm, layers in ascending order."""
        unit, scale = self._scale(unit)
        table = np.array([layer[:2] for layer in self.layers], float).reshape(-1, 2)
        self._within(table * scale, [layer[2] for layer in self.layers])
        order = np.argsort(table[:, 0], kind="stable")
        if (order != np.arange(len(order))).any():
            self.count("the layers stand in another order than their co-ordinates; they were sorted")
        twice = np.flatnonzero(np.diff(table[order, 0]) == 0)
        if len(twice):
            row, height = self.layers[order[twice[0] + 1]][2], table[order[twice[0]], 0]
            raise self.refuse(row, f"each layer must come once; Z {height:g} has come before")
        contours = self._contours(axis, order, table[order, 0] * scale, scale)
        return LayerFile(self.name, unit, contours, table[order, 1] * scale, self._notes())

    def _scale(self, unit: str) -> Tuple[str, float]:
        if not self.unit:
            self.count(f"UNITS is missing: {'mm' if unit == 'auto' else unit} taken")
        elif unit not in ("auto", self.unit):
            self.count(f"UNITS says {self.unit}, {unit} was asked for and taken")
        unit = (self.unit or "mm") if unit == "auto" else unit
        return unit, UNITS[unit]

    def _contours(self, axis: str, order: np.ndarray, heights: np.ndarray, scale: float) -> Contours:
        corners = self._within(self._corners() * scale, self.rows)
        starts, closed = np.array(self.starts), np.array(self.closed, bool)
        layer = np.argsort(order, kind="stable")[np.array(self.layer_of, int)] if len(closed) else np.zeros(0, int)
        ranges = [np.arange(a, b) for a, b in zip(starts[:-1], starts[1:])]
        kept = []
        for contour, rows in enumerate(ranges):
            if closed[contour] and len(rows) > 1 and (corners[rows[0]] == corners[rows[-1]]).all():
                ranges[contour] = rows = rows[:-1]
                self.count("contours repeat their first corner at the end; it was left out")
            if closed[contour] and len(rows) < 3:
                self.count("contours of fewer than three corners were left out")
            else:
                kept.append(contour)
            if not closed[contour]:
                self.count("polylines are open (O): they hold no area")
        kept_rows = np.array(sorted(kept, key=lambda contour: layer[contour]), int)  # stable: as they stand in a layer
        picked = [ranges[contour] for contour in kept_rows]
        rows = np.concatenate(picked) if picked else np.zeros(0, int)
        return Contours(
            axis=axis,
            heights=heights,
            points=corners[rows],
            starts=np.concatenate([[0], np.cumsum([len(p) for p in picked])]).astype(int),
            plane=layer[kept_rows],
            closed=closed[kept_rows],
        )

    def _corners(self) -> np.ndarray:
        """Return the corners, ndarray of shape (N, 2); a line that is not two numbers is named."""
        text = b"\n".join(self.points)
        values = _floats(text.split()) if not (b"#" in text or b"_" in text) else []
        if len(values) == 2 * len(self.points):
            corners = np.array(values, float).reshape(-1, 2)
            # As many numbers as there should be, yet three in one line and one in the next?
            if np.isfinite(corners).all() and all(len(line.split(None, 2)) == 2 for line in self.points):
                return corners
        return np.array([self._corner(row, line) for row, line in zip(self.rows, self.points)], float).reshape(-1, 2)

    def _corner(self, row: int, line: bytes) -> List[float]:
        values = _floats(line.partition(b"#")[0].split())
        if len(values) != 2 or not np.isfinite(values).all() or b"_" in line.partition(b"#")[0]:
            raise self.refuse(row, "a corner must be two finite numbers", line)
        return values

    def _within(self, values: np.ndarray, rows: Sequence[int]) -> np.ndarray:
        """Return numbers in mm (N, 2) as they are; a line with one that cannot be is named."""
        beyond = np.flatnonzero((np.abs(values) > LARGEST).any(1))
        if len(beyond):
            raise self.refuse(rows[beyond[0]], f"co-ordinates must be at most {LARGEST:g} mm")
        return values

    def _notes(self) -> Tuple[str, ...]:
        return tuple(what if n == 1 else f"{n} {what}" for what, n in self.counts.items())


def _floats(words: Sequence[bytes]) -> List[float]:
    """Return numbers for words, or nothing if one is none."""
    try:
        return list(map(float, words))
    except ValueError:
        return []


# ------------------------------------------------------------------------------------------------------------- writing


def write_ssl(
    path: Union[str, Path],
    contours: Contours,
    thickness: float,
    name: str = "",
    unit: str = "mm",
    progress: Progress = silent,
) -> None:
    """Write contours as SSL, six decimals (inches: eight); corners that fall together are written once.

    Parameters
    ----------
    path : str or Path
    contours : Contours
    thickness : float, mm
        Of each layer.
    name : str
        For FILE(...); by default the file's own.
    unit : str
        ``mm`` or ``inch``.

    Raises
    ------
    ParameterError
        If the unit is none of these, or the thickness is not above 0.
    ExportError
        If the file cannot be written; what stood under that name before stays.
    """
    if unit not in UNITS:
        raise ParameterError(f"the unit must be one of {', '.join(UNITS)}, got {unit!r}")
    if not thickness > 0:
        raise ParameterError(f"the thickness of a layer must be above 0 mm, got {thickness:g}")
    scale, decimals = UNITS[unit], _DECIMALS[unit]
    title = (name or Path(path).name).replace("\n", " ").replace("\r", " ")
    points, starts, plane, closed = distinct_corners(contours, scale, decimals)
    first = np.searchsorted(plane, np.arange(len(contours.heights) + 1))
    row = f"%.{decimals}f %.{decimals}f\n"
    with whole_file(path) as file:
        file.write(f"Slice V0\nFILE({title})\nUNITS({unit.upper()})\nSLICES()\n".encode())
        for layer, height in enumerate(contours.heights.tolist()):
            progress(layer, len(contours.heights), "writing layers")
            parts = [f"Z {height / scale:.{decimals}f} {thickness / scale:.{decimals}f}\n"]
            for contour in range(first[layer], first[layer + 1]):
                corners = points[starts[contour] : starts[contour + 1]]
                parts.append(row * len(corners) % tuple(corners.ravel().tolist()))
                parts.append("C\n" if closed[contour] else "O\n")
            file.write("".join(parts).encode("ascii"))
        file.write(b"END\n")
