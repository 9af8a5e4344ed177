# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thesis' designs as jobs: cases 1 to 6 (chapter 3), the prism of 420 rods (3.4), two anatomical studies (4)."""

from __future__ import annotations

from pathlib import Path
from typing import Callable, Dict, NamedTuple, Optional, Tuple

from ..errors import ParameterError
from .job import Job, opposite_couplings
from .laws import uniform
from .parameters import PathParameters, PoreParameters, PrismParameters


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


_MAKERS: Dict[str, Callable[[], Job]] = {name: (lambda name=name: _case(name)) for name in _CASES}
_MAKERS["prism420"] = _prism420

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
