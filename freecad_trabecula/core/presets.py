# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thesis' designs as jobs: cases 1 to 6 (chapter 3), the prism of 420 rods (3.4), two anatomical studies (4)."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Callable, Dict, NamedTuple, Optional, Tuple

from ..errors import ParameterError
from .job import Job, opposite_couplings
from .laws import uniform
from .parameters import Coupling, FaceParameters, PathParameters, PoreParameters, PrismParameters


class ThesisFigures(NamedTuple):
    """What the thesis gives for a design: rods, porosity %, seconds, seconds a rod, manual seconds a rod."""

    rods: int
    porosity: Optional[float]
    seconds: float
    seconds_per_rod: float
    manual_seconds_per_rod: float


#: Tables 3.1 to 3.6, section 3.4, tables 4.3 and 4.6.
THESIS: Dict[str, ThesisFigures] = {
    "case1": ThesisFigures(75, 16.66, 600, 8.0, 30),
    "case2": ThesisFigures(75, 55.27, 780, 10.4, 30),
    "case3": ThesisFigures(147, 44.49, 1080, 7.35, 30),
    "case4": ThesisFigures(147, 44.16, 1200, 8.16, 45),
    "case5": ThesisFigures(147, 33.56, 1200, 8.16, 75),
    "case6": ThesisFigures(147, 36.77, 1320, 9.0, 75),
    "prism420": ThesisFigures(420, None, 900, 2.14, 75),
    "cranial": ThesisFigures(160, 53.4, 787, 4.9, 75),
    "femur": ThesisFigures(284, 30.15, 2924, 10.29, 75),
}

_BOX = PathParameters("box", box=(4.0, 4.0, 4.0))  # table 3.6: +-2 mm (3.2.4 says 2 mm; the table is what was run)
#: case: layout, n, sections, association, path
_CASES: Dict[str, Tuple[str, int, int, str, PathParameters]] = {
    "case1": ("circle", 5, 1, "same", PathParameters("orthogonal")),
    "case2": ("spline", 5, 1, "same", PathParameters("orthogonal")),
    "case3": ("spline", 7, 1, "random", PathParameters("straight")),
    "case4": ("spline", 7, 2, "random", PathParameters("straight")),
    "case5": ("spline", 7, 2, "random", PathParameters("centre")),
    "case6": ("spline", 7, 2, "random", _BOX),
}


def _case(name: str) -> Job:
    layout, n, sections, association, path = _CASES[name]
    return Job(
        name=name,
        prism=PrismParameters(n_x=n, n_y=n, n_z=n),
        pores=PoreParameters(layout=layout, size=uniform(0.2, 0.8), sections=sections),
        path=path,
        couplings=opposite_couplings(association),
    )


def _prism420() -> Job:
    """51 x 40.6 x 8.55 mm; 39 + 31 columns of 6 rods join the lateral faces, an even spacing of 1.3 mm (thesis 3.4)."""
    return Job(
        name="prism420",
        prism=PrismParameters(l=51.0, w=40.6, h=8.55, n_x=39, n_y=31, n_z=6),
        path=PathParameters("centre"),
        couplings=opposite_couplings("random")[:2],
    )


def example_file(name: str) -> str:
    """Return the path of a file shipped in resources/examples."""
    return str(Path(__file__).resolve().parents[2] / "resources" / "examples" / name)


#: Faces of cranial_plate.step in the letters of Fig. 4.9: face, c_u, c_v, b_u, b_v (table 4.1 where its values fit).
#: The rim is 6.2 mm high: the table's borders of 5 mm (I, K) would leave no site, those of F, G, H, J, L leave so many
#: that table 4.2's couplings would starve, and L's c_v of 0.5 mm is less than the largest pore.
_CRANIAL_FACES: Dict[str, Tuple[str, float, float, float, float]] = {
    "A": ("Face1", 3.0, 3.0, 3.5, 1.5),
    "B": ("Face7", 1.5, 1.5, 0.5, 0.5),
    "C": ("Face8", 2.0, 2.0, 0.5, 0.5),
    "D": ("Face5", 1.5, 1.5, 0.3, 0.3),
    "E": ("Face12", 3.0, 3.0, 1.5, 1.0),
    "F": ("Face6", 1.5, 1.5, 1.5, 1.0),
    "G": ("Face2", 1.5, 1.5, 1.7, 1.0),
    "H": ("Face11", 1.5, 1.5, 1.2, 0.5),
    "I": ("Face9", 1.5, 1.5, 0.5, 0.5),
    "J": ("Face3", 1.0, 1.0, 2.5, 2.5),
    "K": ("Face10", 1.5, 1.5, 1.0, 0.5),
    "L": ("Face4", 1.0, 1.0, 3.0, 1.5),
}
#: Table 4.2, in its order.
_CRANIAL_COUPLINGS = ("LC", "FI", "KD", "DI", "HD", "GB", "BL", "JB", "HB", "AE")
_Y, _X, _Z = (0.0, 1.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)


def _cranial() -> Job:
    """The craniofacial study (thesis 4.3.1) on a plate of the same kind; its Y and X are the thesis' Z and X."""
    broad = {"d1": _Y, "d2": _X}
    faces = tuple(
        FaceParameters(face, letter, c_u=c_u, c_v=c_v, b_u=b_u, b_v=b_v, **(broad if letter in "AE" else {}))
        for letter, (face, c_u, c_v, b_u, b_v) in _CRANIAL_FACES.items()
    )
    return Job(
        name="cranial",
        envelope=example_file("cranial_plate.step"),
        faces=faces,
        path=PathParameters("centre"),
        couplings=tuple(Coupling(*pair) for pair in _CRANIAL_COUPLINGS),
    )


def _femur() -> Job:
    """The humerus study (thesis 4.3.2) on a femur's metaphysis of the same size; lines run along the bone.

    Table 4.4's directions belong to a bone that lies otherwise: here they would bring 117 sites within a pore of
    another.
    """
    face = FaceParameters(d1=_Z, d2=_X, c_u=1.25, c_v=1.25, b_u=0.25, b_v=0.25)
    return Job(
        name="femur",
        envelope=example_file("femur_metaphysis.step"),
        faces=(
            replace(face, face="Face1", name="A", origin=(11.16, 20.17, 12.88)),
            replace(face, face="Face2", name="B", origin=(11.04, 4.3, 12.88)),
        ),
        pores=PoreParameters(size=uniform(0.2, 0.4)),
        path=_BOX,
        couplings=(Coupling("A", "B"),),
    )


_MAKERS: Dict[str, Callable[[], Job]] = {name: partial(_case, name) for name in _CASES}
_MAKERS.update(prism420=_prism420, cranial=_cranial, femur=_femur)

PRESETS: Tuple[str, ...] = tuple(_MAKERS)


def preset(name: str) -> Job:
    """Return the job of a preset.

    Parameters
    ----------
    name : str
        One of ``PRESETS``.

    Raises
    ------
    ParameterError
        If there is none of that name.

    Examples
    --------
    >>> preset("case6").path.box
    (4.0, 4.0, 4.0)
    """
    if name not in _MAKERS:
        raise ParameterError(f"a preset must be one of {', '.join(PRESETS)}, got {name!r}")
    return _MAKERS[name]()
