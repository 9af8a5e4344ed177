# SPDX-License-Identifier: LGPL-2.1-or-later
"""Envelopes: the bodies to be filled, checked at the door. A box, any solid of FreeCAD, or a file."""

from __future__ import annotations

import os
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import Mesh
import numpy as np
import Part

from ..core import meshes, rays
from ..core.laws import Region
from ..errors import EnvelopeError, ExportError
from .extents import exact_box
from .mesh_solids import solids_of_mesh
from .tessellation import default_deflection, find_crossing, tessellate

SHAPE_FILES = (".step", ".stp", ".iges", ".igs", ".brep", ".brp")
MESH_FILES = (".stl", ".obj", ".ply")
#: Names of a box's faces beside FreeCAD's own, as seen from the front (towards +y).
BOX_ALIASES = {"left": "Face1", "right": "Face2", "front": "Face3", "back": "Face4", "bottom": "Face5", "top": "Face6"}
_TINY, _HUGE = 1.0, 1000.0  # mm; an implant whose largest size lies outside was likely drawn in another unit
_LARGEST, _LONGEST = 1e6, 1e5  # mm, and greatest ratio of an envelope's sizes
_SEWING = (1e-6, 1e-4, 1e-2)  # mm; gaps that are closed between the faces of an IGES file, the smallest that do
_KERNEL_ERRORS = (Part.OCCError, RuntimeError, ValueError, OSError)

Choice = Union[str, int, None]


@dataclass(frozen=True, eq=False)
class Envelope:
    """The body to be filled.

    Attributes
    ----------
    solid : Part.Shape
        One closed solid, outside out.
    mesh : Mesh
        Its triangles: closed, turned outwards.
    deflection : float, mm
        Greatest distance of the triangles from the solid.
    low, high : ndarray of shape (3,), mm
        Corners of the exact box around it.
    aliases : mapping
        Further names of faces.
    notes : tuple of str
        What was mended, and what looks wrong.
    """

    solid: Part.Shape
    mesh: meshes.Mesh
    deflection: float
    low: np.ndarray
    high: np.ndarray
    aliases: Mapping[str, str] = field(default_factory=dict)
    notes: Tuple[str, ...] = ()

    @property
    def volume(self) -> float:
        """Volume of the solid, mm³."""
        return self.solid.Volume

    @property
    def centre(self) -> np.ndarray:
        """Geometrical centre of the volume, ndarray of shape (3,), mm."""
        return np.array(tuple(self.solid.CenterOfMass))

    @property
    def region(self) -> Region:
        """Box and centre as the laws of variation take them."""
        low, high, centre = (tuple(float(c) for c in point) for point in (self.low, self.high, self.centre))
        return Region(low, high, centre)

    @property
    def face_names(self) -> Tuple[str, ...]:
        """FreeCAD's names of the faces: Face1, Face2, ..."""
        return tuple(f"Face{k + 1}" for k in range(len(self.solid.Faces)))

    def face(self, name: str) -> Part.Face:
        """Return a face by FreeCAD's name or by an alias.

        Raises
        ------
        EnvelopeError
            If the envelope has no such face.
        """
        own = self.aliases.get(name, name)
        names = self.face_names
        if own not in names:
            others = f" or {', '.join(self.aliases)}" if self.aliases else ""
            raise EnvelopeError(f"a face must be one of Face1..Face{len(names)}{others}, got {name!r}")
        return self.solid.Faces[names.index(own)]

    def contains(self, points: np.ndarray) -> np.ndarray:
        """Return which points (P, 3), mm, lie inside, ndarray of shape (P,), bool; to the deflection."""
        return rays.contains(self.mesh.corners, np.asarray(points, float).reshape(-1, 3))


# ------------------------------------------------------------------------------------------------------- the makers


def box_envelope(l: float, w: float, h: float, deflection: float = 0.0) -> Envelope:  # noqa: E741  the thesis' letters
    """Return a box of length l, width w, height h (mm, along x, y, z) with one corner at the origin.

    Raises
    ------
    EnvelopeError
        If a size is not greater than 0.

    Examples
    --------
    >>> round(box_envelope(10, 10, 5).volume, 6)
    500.0
    """
    for name, size in (("length", l), ("width", w), ("height", h)):
        if not 0 < size < float("inf"):
            raise EnvelopeError(f"the {name} of a box must be greater than 0 mm, got {size:g} mm")
    return envelope_from_shape(Part.makeBox(l, w, h), aliases=BOX_ALIASES, deflection=deflection)


def envelope_from_shape(
    shape: Part.Shape,
    solid: Choice = None,
    aliases: Optional[Mapping[str, str]] = None,
    deflection: float = 0.0,
    notes: Sequence[str] = (),
) -> Envelope:
    """Return the envelope that a shape is, or that one of its solids is.

    Parameters
    ----------
    shape : Part.Shape
    solid : str or int, optional
        Which of several solids: ``Solid2`` or 2; none or an empty name if there is but one.
    aliases : mapping, optional
        Further names of faces, e.g. ``{"A": "Face1"}``.
    deflection : float, mm
        Of the triangles; 0 chooses ``tessellation.default_deflection``.
    notes : sequence of str
        What is known already.

    Raises
    ------
    EnvelopeError
        If there is no solid, several and none chosen, or it is open, invalid, or crosses itself.
    KernelError
        If the kernel cannot triangulate it.
    """
    body, mended = _checked(_choose(shape, solid))
    low, high = exact_box(body)
    _check_extent(high - low)
    deflection = deflection or default_deflection(body)
    mesh, note = tessellate(body, deflection)
    crossing = find_crossing(body, deflection)
    if crossing is not None:
        raise EnvelopeError(
            f"a solid must not cross itself; {crossing.pairs} pairs of its triangles do, the longest crossing is "
            f"{crossing.longest:.3g} mm at ({', '.join(f'{c:.4g}' for c in crossing.middle)}) mm"
        )
    every = (*notes, *mended, *_unit_notes(float((high - low).max())), *([note] if note else []))
    names = dict(aliases or {})
    envelope = Envelope(body, mesh, deflection, low, high, names, every)
    for name in names:
        envelope.face(name)
    return envelope


def load_envelope(
    path: Union[str, Path],
    solid: Choice = None,
    aliases: Optional[Mapping[str, str]] = None,
    deflection: float = 0.0,
) -> Envelope:
    """Return the envelope in a file: STEP, IGES or BREP (its units become mm), or a closed mesh: STL, OBJ or PLY (mm).

    Parameters
    ----------
    path : str or Path
    solid, aliases, deflection
        As in ``envelope_from_shape``.

    Raises
    ------
    ExportError
        If the file cannot be read.
    EnvelopeError
        If it is of another kind, or what is in it is no envelope.
    """
    shape, notes = load_shape(path)
    return envelope_from_shape(shape, solid, aliases, deflection, notes)


def load_shape(path: Union[str, Path]) -> Tuple[Part.Shape, List[str]]:
    """Return what is in a file as a shape, solids where it holds faces or triangles, and notes of what was mended.

    Raises
    ------
    ExportError
        If the file cannot be read.
    EnvelopeError
        If it is of another kind or holds nothing.
    """
    path = Path(path)
    readers: Dict[str, Callable[[Path], Tuple[Part.Shape, List[str]]]] = {
        **dict.fromkeys(SHAPE_FILES, _read_shape),
        **dict.fromkeys(MESH_FILES, _read_mesh),
    }
    kind = path.suffix.lower()
    if kind not in readers:
        raise EnvelopeError(f"the file of an envelope must end in one of {', '.join(readers)}, got {path.name!r}")
    if not path.is_file() or not os.access(str(path), os.R_OK):
        raise ExportError(f"the file of an envelope must be readable, got {path}")
    return readers[kind](path)


# -------------------------------------------------------------------------------------------------------- the files


def _read_shape(path: Path) -> Tuple[Part.Shape, List[str]]:
    shape = Part.Shape()
    try:
        shape.read(str(path))
    except _KERNEL_ERRORS as error:
        raise EnvelopeError(
            f"the file of an envelope must hold a shape, but {path.name} cannot be read as one"
        ) from error
    if shape.isNull():
        raise EnvelopeError(f"the file of an envelope must hold a shape, got none in {path.name}")
    if not shape.Solids and path.suffix.lower() in (".iges", ".igs"):
        return _sewn(shape)
    return shape, []


def _sewn(shape: Part.Shape) -> Tuple[Part.Shape, List[str]]:
    """Return the solids that the faces of an IGES file bound: it holds no solids."""
    for gap in _SEWING:
        sewn = shape.copy()
        try:
            sewn.sewShape(gap)
            closed = [Part.Solid(shell) for shell in _shells(sewn) if shell.isClosed()]
        except _KERNEL_ERRORS:
            continue
        if closed and sum(len(one.Faces) for one in closed) == len(shape.Faces):
            return Part.Compound(closed), [f"{len(shape.Faces)} faces were sewn to a solid, gaps up to {gap:g} mm"]
    raise EnvelopeError(
        f"the faces of an IGES file must bound a closed body; these {len(shape.Faces)} do not, with gaps "
        f"up to {_SEWING[-1]:g} mm closed (a STEP file keeps solids)"
    )


def _shells(shape: Part.Shape) -> List[Part.Shape]:
    """Return the shells of a sewn shape, one face that is closed by itself (a sphere) being one."""
    alone = (
        [child for child in shape.childShapes() if child.ShapeType == "Face"] if shape.ShapeType == "Compound" else []
    )
    return shape.Shells + [Part.Shell([face]) for face in alone]


def _read_mesh(path: Path) -> Tuple[Part.Shape, List[str]]:
    try:
        mesh = Mesh.Mesh(str(path))
    except _KERNEL_ERRORS as error:
        raise EnvelopeError(
            f"the file of an envelope must hold a mesh, but {path.name} cannot be read as one"
        ) from error
    solids, notes = solids_of_mesh(mesh)
    return Part.Compound(solids), notes


# ------------------------------------------------------------------------------------------------------- the checks


def _choose(shape: Part.Shape, solid: Choice) -> Part.Shape:
    """Return the one solid of a shape, or the chosen one."""
    if shape is None or shape.isNull():
        raise EnvelopeError("an envelope must have a shape, got an empty one")
    solids = shape.Solids
    if not solids:
        closed = (
            " (closed: make a solid of it first)" if shape.Shells and all(s.isClosed() for s in shape.Shells) else ""
        )
        raise EnvelopeError(
            f"an envelope must be one closed solid, got a {shape.ShapeType.lower()} of {len(shape.Faces)} faces and no "
            f"solid{closed}"
        )
    if solid in (None, ""):
        if len(solids) > 1:
            listed = ", ".join(f"Solid{k + 1} ({_size_text(one)})" for k, one in enumerate(solids))
            raise EnvelopeError(
                f"one solid of {len(solids)} must be chosen as the envelope: {listed}; a compound is taken apart by "
                "Part > Compound > Explode compound"
            )
        return solids[0]
    number = str(solid)[5:] if str(solid).startswith("Solid") else str(solid)
    if not number.isdigit() or not 1 <= int(number) <= len(solids):
        raise EnvelopeError(f"the solid must be one of Solid1..Solid{len(solids)}, got {solid!r}")
    return solids[int(number) - 1]


def _size_text(solid: Part.Shape) -> str:
    low, high = exact_box(solid)
    return f"{' x '.join(f'{s:.4g}' for s in high - low)} mm, {solid.Volume:.4g} mm3"


def _checked(solid: Part.Shape) -> Tuple[Part.Shape, List[str]]:
    """Return a solid that is valid and outside out, and notes of what was mended."""
    notes = []
    if not solid.isClosed():
        raise EnvelopeError(f"an envelope must be a closed solid, got an open one of {len(solid.Faces)} faces")
    if not solid.isValid():
        solid, before = _mended(solid), solid
        notes.append(f"the solid was invalid ({_faults(before)}) and has been mended")
    if solid.Volume < 0:
        notes.append(f"the solid was inside out (volume {solid.Volume:.6g} mm3) and has been turned")
        solid = solid.reversed()
    if not solid.Volume > 1e-12:
        raise EnvelopeError(f"an envelope must have a volume greater than 0 mm3, got {solid.Volume:.3g} mm3")
    return solid, notes


def _check_extent(sizes: np.ndarray) -> None:
    """Refuse what is so long for its width that the kernel's search for crossings takes FreeCAD down."""
    least, largest = float(sizes.min()), float(sizes.max())
    if not largest <= _LARGEST:
        raise EnvelopeError(f"an envelope must be at most {_LARGEST:g} mm large, got {largest:.4g} mm")
    if not largest <= _LONGEST * least:
        raise EnvelopeError(
            f"the largest size of an envelope must be at most {_LONGEST:g} times its least, got {largest:.4g} and "
            f"{least:.4g} mm"
        )


def _mended(solid: Part.Shape) -> Part.Shape:
    """Return an invalid solid mended by the kernel, if that leaves its faces and its volume as they are."""
    mended = solid.copy()
    try:
        mended.fix(1e-6, 1e-7, 1e-3)
        same = len(mended.Solids) == 1 and len(mended.Faces) == len(solid.Faces)
        if same and mended.isValid() and abs(mended.Volume - solid.Volume) <= 1e-6 * abs(solid.Volume):
            return mended.Solids[0]
    except _KERNEL_ERRORS as error:
        raise EnvelopeError(f"an envelope must be a valid solid; the kernel finds: {_faults(solid)}") from error
    raise EnvelopeError(f"an envelope must be a valid solid; the kernel finds: {_faults(solid)}")


def _faults(solid: Part.Shape) -> str:
    """Return the kernel's complaints about a shape, each with its count."""
    try:
        solid.check()
    except _KERNEL_ERRORS as error:
        lines = Counter(line.strip().lower() for line in str(error).splitlines())
        named = [f"{line} ({count})" for line, count in lines.items() if line and line != "no error"]
        return ", ".join(named) or "a fault without a name"
    return "a fault without a name"


def _unit_notes(largest: float) -> List[str]:
    if largest < _TINY:
        return [f"the envelope is only {largest:.4g} mm large: was its file in metres or inches, not mm?"]
    if largest > _HUGE:
        return [f"the envelope is {largest:.4g} mm large: was its file in micrometres, not mm?"]
    return []
