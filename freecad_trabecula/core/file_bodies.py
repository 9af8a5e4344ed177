# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is known of a mesh file at a glance, from some of its triangles: so much that its work can be estimated."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Callable, Dict, List, NamedTuple, Sequence, Tuple, Union

import numpy as np

from ..errors import MeshError
from .estimates import Body, Work, body_of
from .mesh_readers import model_of_3mf, read_mesh

_BINARY, _HEAD = 50, 84  # bytes of an STL triangle, of the head of the file
_TEXT = {".stl": 260.0, ".obj": 40.0, ".ply": 20.0, ".3mf": 25.0}  # bytes a triangle, about
_SAMPLE = 300_000  # triangles of a binary file that are looked at
_FEW = 12_000  # those of a text, whose numbers must be read one by one
_PIECES, _PIECE = 320, 16_384  # pieces of a text that are looked at, bytes of each
#: CPU seconds and bytes a triangle that reading a whole text takes; a binary file is read in no time.
_READING = {".stl": (5e-6, 1200.0), ".obj": (3.5e-6, 430.0), ".ply": (2.7e-6, 490.0), ".3mf": (8e-6, 1060.0)}
_FACET = re.compile(rb"outer\s+loop" + 3 * rb"\s+vertex\s+(\S+)\s+(\S+)\s+(\S+)" + rb"\s+endloop")
_ATTRIBUTE = re.compile(rb"\b(x|y|z|v1|v2|v3)\s*=\s*[\"']([^\"']+)")


def body_of_file(path: Union[str, Path]) -> Body:
    """Return what is known of a mesh file; of a faulty one, which is refused when read, the triangles by its size.

    Raises
    ------
    OSError
        If it cannot be read.
    """
    path = Path(path)
    size, kind = path.stat().st_size, path.suffix.lower()
    count = (size - _HEAD) // _BINARY
    if is_binary_stl(path):
        rows = np.memmap(path, np.uint8, "r", _HEAD, (count, _BINARY))[:: -(-count // _SAMPLE)]
        return body_of(np.ascontiguousarray(rows[:, 12:48]).view("<f4").reshape(-1, 3, 3), count)
    try:
        return body_of(*_LOOKS[kind](path))
    except (KeyError, ValueError, IndexError, MeshError):
        return Body(int(size / _TEXT.get(kind, _BINARY)), np.full((2, 3), math.nan))


def is_binary_stl(path: Path) -> bool:
    """Return whether a file is a binary STL: its size tells."""
    size = path.stat().st_size
    return path.suffix.lower() == ".stl" and size > _HEAD and (size - _HEAD) % _BINARY == 0


def reading_work(path: Union[str, Path], triangles: int) -> Work:
    """Return what reading a mesh file of so many triangles takes.

    Raises
    ------
    OSError
        If it cannot be read.
    """
    path = Path(path)
    kind = path.suffix.lower()
    is_binary = is_binary_stl(path) or (kind == ".ply" and b"format ascii" not in _head_of_ply(path))
    each = (0.0, 0.0) if is_binary else _READING.get(kind, (0.0, 0.0))
    return Work(each[0] * triangles, each[1] * triangles)


# ---------------------------------------------------------------------------------------------- some of the triangles

Sample = Tuple[np.ndarray, int]  # triangles (S, 3, 3), and how many there are in all
# A look raises ValueError, IndexError or KeyError where a file is not as it expects: nobody sees that.


class _Lines(NamedTuple):
    """Places in a text that hold vertices and faces: where each begins, what ends it, and how they are read."""

    text: bytes
    vertices: np.ndarray
    faces: np.ndarray
    point: Callable[[bytes], Sequence[float]]
    corners: Callable[[bytes, int], List[int]]
    end: bytes = b"\n"

    def line(self, start: int) -> bytes:
        """Return what begins at a place."""
        end = self.text.find(self.end, start)
        return self.text[start:end] if end >= 0 else self.text[start:]


def _look_at_stl(path: Path) -> Sample:
    size = path.stat().st_size
    with open(path, "rb") as file:
        if size <= _PIECES * _PIECE:
            pieces = [file.read()]
        else:
            pieces = []
            for place in np.linspace(0, size - _PIECE, _PIECES).astype(int).tolist():
                file.seek(place)
                pieces.append(file.read(_PIECE))
    found = [facet for piece in pieces for facet in _FACET.findall(piece)]
    if not found:
        raise ValueError
    # a facet that is cut off at the end of a piece is counted half at both ends: on an average one is missing
    missing = len(pieces) if len(pieces) > 1 else 0
    count = round((len(found) + missing) * size / sum(map(len, pieces)))
    return np.array(found, "S32").astype(float).reshape(-1, 3, 3), max(count, len(found))


def _look_at_lines(lines: _Lines) -> Sample:
    """Triangles of evenly spread faces; their vertices are looked up."""
    chosen = lines.faces[np.unique(np.linspace(0, len(lines.faces) - 1, min(len(lines.faces), _FEW)).astype(int))]
    names: List[List[int]] = []
    for start in chosen.tolist():
        face = lines.corners(lines.line(start), start)
        names += [[face[0], *face[k : k + 2]] for k in range(1, len(face) - 1)]
    used, place = np.unique(np.array(names, int), return_inverse=True)
    if used[0] < 0:
        raise ValueError
    points = np.array([lines.point(lines.line(start)) for start in lines.vertices[used].tolist()], float)
    return points[place.reshape(-1, 3)], round(len(names) * len(lines.faces) / len(chosen))


def _starts(text: bytes) -> np.ndarray:
    """Where the lines of a text begin."""
    ends = np.flatnonzero(np.frombuffer(text, np.uint8) == ord("\n"))
    return np.concatenate([[0], ends + 1])[: len(ends) + (not text.endswith(b"\n"))]


def _look_at_obj(path: Path) -> Sample:
    text = path.read_bytes()
    starts, data = _starts(text), np.frombuffer(text + b"  ", np.uint8)
    is_blank = np.isin(data[starts + 1], (ord(" "), ord("\t")))
    vertices, faces = (starts[is_blank & (data[starts] == ord(letter))] for letter in "vf")

    def corners(line: bytes, start: int) -> List[int]:
        numbers = [int(word.split(b"/")[0]) for word in line.split(b"#")[0].split()[1:]]
        # numbers below 0 count backwards from where the face stands
        seen = int(np.searchsorted(vertices, start)) if min(numbers) < 0 else 0
        return [number - 1 if number > 0 else seen + number for number in numbers]

    return _look_at_lines(_Lines(text, vertices, faces, lambda line: [float(w) for w in line.split()[1:4]], corners))


def _head_of_ply(path: Path) -> bytes:
    with open(path, "rb") as file:
        return file.read(65_536).partition(b"end_header")[0]


def _look_at_ply(path: Path) -> Sample:
    head = _head_of_ply(path)
    if b"format ascii" not in head:
        found = read_mesh(path)[0]  # its numbers are read at once
        return found[:: -(-len(found) // _SAMPLE)], len(found)
    text, sizes = path.read_bytes(), dict(re.findall(rb"element\s+(\w+)\s+(\d+)", head))
    names = [words.split()[-1] for words in re.findall(rb"property\s+([^\r\n]+)", head.partition(b"element face")[0])]
    columns = [names.index(axis) for axis in (b"x", b"y", b"z")]
    if list(sizes) != [b"vertex", b"face"]:
        raise ValueError
    starts = _starts(text)
    first = int(np.searchsorted(starts, text.index(b"end_header"), "right"))
    count = int(sizes[b"vertex"])
    vertices, faces = starts[first : first + count], starts[first + count : first + count + int(sizes[b"face"])]

    def point(line: bytes) -> List[float]:
        words = line.split()
        return [float(words[k]) for k in columns]

    def corners(line: bytes, start: int) -> List[int]:
        words = line.split()
        return [int(word) for word in words[1 : 1 + int(words[0])]]

    return _look_at_lines(_Lines(text, vertices, faces, point, corners))


def _look_at_3mf(path: Path) -> Sample:
    model = model_of_3mf(path.read_bytes())
    unit = re.search(rb"\bunit\s*=\s*[\"'](\w+)", model[:4096])
    if model.count(b"<mesh") != 1 or b"transform=" in model or b"<component" in model:
        raise ValueError
    if unit and unit[1] != b"millimeter":
        raise ValueError
    data = np.frombuffer(model, np.uint8)
    starts = np.flatnonzero(data[:-9] == ord("<"))
    # <vertex x=, <triangle v1=, as against <vertices> and <triangles>
    second, third = data[starts + 1], data[starts + 2]
    vertices = starts[(second == ord("v")) & (third == ord("e")) & (data[starts + 7] == ord(" "))]
    faces = starts[(second == ord("t")) & (third == ord("r")) & (data[starts + 9] == ord(" "))]

    def numbers(line: bytes, names: Sequence[bytes]) -> List[float]:
        found: Dict[bytes, bytes] = dict(_ATTRIBUTE.findall(line))
        return [float(found[name]) for name in names]

    return _look_at_lines(
        _Lines(
            model, vertices, faces, lambda line: numbers(line, (b"x", b"y", b"z")),
            lambda line, start: [int(one) for one in numbers(line, (b"v1", b"v2", b"v3"))], b">",
        )
    )  # fmt: skip


_LOOKS: Dict[str, Callable[[Path], Sample]] = {
    ".stl": _look_at_stl, ".obj": _look_at_obj, ".ply": _look_at_ply, ".3mf": _look_at_3mf
}  # fmt: skip
