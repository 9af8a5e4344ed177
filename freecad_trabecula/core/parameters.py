# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user chooses: frozen dataclasses, each checked when it is made.

Every field carries ``metadata``: ``unit`` ("mm", "" for a pure number), ``doc`` (the tooltip), and where it helps
``low``/``high``. ``features/base.py`` turns fields into document properties, ``records.py`` into JSON; nothing is
copied by hand.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, Optional, Tuple

from ..errors import ParameterError
from .laws import Law, constant, uniform
from .path_laws import PATH_LAWS

Point = Tuple[float, float, float]

LAYOUTS = ("circle", "spline")
PATHS = tuple(PATH_LAWS)
CHOICES = ("random", "nearest")
ASSOCIATIONS = ("random", "same")
ENGINES = ("auto", "mesh", "field", "brep")
LAYER_SIDES = ("inwards", "outwards")
SMALLEST_SIZE = 1e-3  # mm; a pore under a micrometre is below every process and close to the kernel's tolerance 1e-7
LARGEST_SEED = 2**31 - 1  # what a FreeCAD integer property can hold


def _f(default: Any, unit: str, doc: str, **more: Any) -> Any:
    return field(default=default, metadata=dict(unit=unit, doc=doc, **more))


def require(ok: bool, rule: str, value: object, unit: str = "") -> None:
    """Raise ``ParameterError("<rule>, got <value> <unit>")`` unless ``ok``."""
    if not ok:
        raise ParameterError(f"{rule}, got {value}{' ' + unit if unit else ''}")


def _finite(value: float, name: str, unit: str, low: float = -math.inf, high: float = math.inf) -> None:
    if low == -math.inf and high == math.inf:
        rule = "must be a finite number"
    elif high == math.inf:
        rule = f"must be at least {low:g}"
    else:
        rule = f"must lie in {low:g}..{high:g}"
    try:
        holds, got = math.isfinite(value) and low <= value <= high, f"{value:g}"
    except (TypeError, ValueError):  # a text, nothing, a list
        holds, got = False, f"{value!r:.60}"
    require(holds, f"{name} {rule}", got, unit)


def _one_of(value: str, name: str, allowed: Tuple[str, ...]) -> None:
    require(value in allowed, f"{name} must be one of {', '.join(allowed)}", repr(value))


@dataclass(frozen=True)
class PoreParameters:
    """Pores: their size and shape (thesis 2.4.1, 2.4.2, 7.1)."""

    layout: str = _f("spline", "", "circle, or closed spline through corners with random tangents", choices=LAYOUTS)
    size: Law = _f(uniform(0.2, 0.8), "mm", "Diameter of the circle, or side of the square through the corners")
    corners: int = _f(4, "", "Corners of the spline; with 4 they lie on the square, else on a polygon of its area",
                      low=3, high=12)  # fmt: skip
    turn: Law = _f(uniform(0.0, 1.0), "", "Component of the unit tangent at each corner", low=0.0, high=1.0)
    pull: Law = _f(constant(1.0), "", "Length of the tangents in sides of the square; 1 is the thesis' unit tangent",
                   low=0.0, high=3.0)  # fmt: skip
    scatter: float = _f(0.0, "", "Random displacement of each corner, in sides of the square", low=0.0, high=0.3)
    sections: int = _f(2, "", "Cross-sections of a rod: one all along, or one at each end", low=1, high=2)

    def __post_init__(self) -> None:
        _one_of(self.layout, "pore layout", LAYOUTS)
        low, high = self.size.low, self.size.high
        if self.size.kind == "constant":
            high = low
        require(
            math.isfinite(low) and math.isfinite(high) and min(low, high) >= SMALLEST_SIZE,
            f"pore sizes must be at least {SMALLEST_SIZE:g} mm",
            f"{low:g} and {high:g}",
            "mm",
        )
        require(3 <= self.corners <= 12, "the number of corners of a pore must lie in 3..12", self.corners)
        for law, name, top in ((self.turn, "tangent component", 1.0), (self.pull, "tangent pull", 3.0)):
            least, most = law.range
            require(least >= 0 and most <= top, f"{name} must lie in 0..{top:g}", f"{least:g}..{most:g}")
        _finite(self.scatter, "scatter of the corners", "", 0.0, 0.3)
        require(self.sections in (1, 2), "sections per rod must be 1 or 2", self.sections)


@dataclass(frozen=True)
class PathParameters:
    """Paths of the rods (thesis 2.4.4, 3.2.4, 4.2.4, 5.5, 7.1)."""

    kind: str = _f(
        "box",
        "",
        "; ".join(f"{name}: {law.summary}" for name, law in PATH_LAWS.items()),
        choices=PATHS,
    )
    points: Tuple[Point, ...] = _f((), "mm", "Convergence points; none means the centre of the envelope")
    choice: str = _f("random", "", "Which of several convergence points a rod takes", choices=CHOICES)
    box: Point = _f((4.0, 4.0, 4.0), "mm", "Edges of the box for the random middle point (Eq. 3.1)")
    tension_first: Law = _f(constant(3.0), "mm", "Length of the tangent at the first end of a 2-point curve")
    tension_second: Law = _f(constant(3.0), "mm", "Length of the tangent at the second end of a 2-point curve")

    def __post_init__(self) -> None:
        _one_of(self.kind, "path", PATHS)
        _one_of(self.choice, "choice of the convergence point", CHOICES)
        for point in self.points:
            for value in point:
                _finite(value, "a convergence point's co-ordinate", "mm")
        for value in self.box:
            _finite(value, "an edge of the box of middle points", "mm", 0.0)
        for law in (self.tension_first, self.tension_second):
            require(law.range[0] > 0, "a path's tension must be greater than 0", f"{law.range[0]:g}", "mm")


@dataclass(frozen=True)
class Coupling:
    """A pair of faces to be joined by rods (thesis 2.4.5, 4.2.3)."""

    first: str = _f("", "", "Face at which the rods start")
    second: str = _f("", "", "Face at which they end")
    association: str = _f("random", "", "random pairs of sites, or site (i, j) to site (i, j)", choices=ASSOCIATIONS)
    reuse: bool = _f(False, "", "Sites that earlier couplings used may be used again")
    limit: int = _f(0, "", "Greatest number of rods; 0 means as many as the smaller face has sites", low=0,
                    automatic=0)  # fmt: skip
    on: bool = _f(True, "", "Off: the coupling makes no rods")
    path: Optional[PathParameters] = _f(None, "", "Paths of this coupling; none means those of the design")

    def __post_init__(self) -> None:
        require(bool(self.first) and bool(self.second), "a coupling needs two faces", repr((self.first, self.second)))
        _one_of(self.association, "association", ASSOCIATIONS)
        require(self.limit >= 0, "the greatest number of rods of a coupling must be 0 (all) or more", self.limit)


@dataclass(frozen=True)
class PrismParameters:
    """A prism (cuboid) and its sites (Eq. 2.1), one corner at the origin, edges along X, Y, Z."""

    l: float = _f(10.0, "mm", "Length along X")  # noqa: E741  the thesis' letters
    w: float = _f(10.0, "mm", "Width along Y")
    h: float = _f(10.0, "mm", "Height along Z")
    n_x: int = _f(7, "", "Sites along X", low=2)
    n_y: int = _f(7, "", "Sites along Y", low=2)
    n_z: int = _f(7, "", "Sites along Z", low=2)
    a_x: float = _f(1.0, "mm", "Least distance of the sites from the borders along X")
    a_y: float = _f(1.0, "mm", "Least distance of the sites from the borders along Y")
    a_z: float = _f(1.0, "mm", "Least distance of the sites from the borders along Z")

    def __post_init__(self) -> None:
        for axis, size, n, a in self.axes:
            _finite(size, f"the prism's edge along {axis}", "mm", 1e-3)
            require(n >= 2, f"sites along {axis} must be at least 2 (Eq. 2.1 divides by n - 1)", n)
            require(
                math.isfinite(a) and 0 <= a < size / 2,
                f"the border distance along {axis} must satisfy 0 <= a < edge / 2 = {size / 2:g} mm",
                f"{a:g}",
                "mm",
            )

    @property
    def axes(self) -> Tuple[Tuple[str, float, int, float], ...]:
        """Per axis: its letter, edge (mm), number of sites, border distance (mm)."""
        return (
            ("X", self.l, self.n_x, self.a_x),
            ("Y", self.w, self.n_y, self.a_y),
            ("Z", self.h, self.n_z, self.a_z),
        )


@dataclass(frozen=True)
class FaceParameters:
    """Sites of one face by curvilinear co-ordinates (thesis 4.2.2)."""

    face: str = _f("Face1", "", "Face of the envelope, as FreeCAD names it")
    name: str = _f("", "", "Short name used in couplings and reports, e.g. A; none means the face's own")
    origin: Optional[Point] = _f(None, "mm", "Origin P of the co-ordinate lines; none means the centre of the face")
    d1: Optional[Point] = _f(None, "", "Direction of the co-ordinate line u; none means the face's own")
    d2: Optional[Point] = _f(None, "", "Direction of the co-ordinate line v; none means across d1")
    c_u: float = _f(1.5, "mm", "Spacing of the sites along u")
    c_v: float = _f(1.5, "mm", "Spacing of the lines along v")
    b_u: float = _f(0.5, "mm", "Least distance from the border along u")
    b_v: float = _f(0.5, "mm", "Least distance from the border along v")

    def __post_init__(self) -> None:
        require(bool(self.face), "a face must be named", repr(self.face))
        # sites are called Face1.2.-3
        require("." not in self.name, "the short name of a face must hold no dot", repr(self.name))
        for value, name in ((self.c_u, "c_u"), (self.c_v, "c_v")):
            require(
                math.isfinite(value) and value > 0, f"the spacing {name} must be greater than 0", f"{value:g}", "mm"
            )
        for value, name in ((self.b_u, "b_u"), (self.b_v, "b_v")):
            _finite(value, f"the border distance {name}", "mm", 0.0)
        for direction, name in ((self.d1, "d1"), (self.d2, "d2")):
            if direction is not None:
                length = math.sqrt(sum(c * c for c in direction))
                require(math.isfinite(length) and length > 1e-9, f"the direction {name} must not be zero", direction)

    @property
    def label(self) -> str:
        """The name used in couplings: the short one if there is one, else the face's own."""
        return self.name or self.face


SITE_ACTIONS = ("off", "move", "add", "pore")


@dataclass(frozen=True)
class SiteEdit:
    """A change of one site by hand (off, moved, added) or of its pore."""

    site: str = _f("", "", "Name of the site, e.g. Face1.2.-3; for add: the face and any new word, e.g. Face1.extra")
    action: str = _f("off", "", "off, move (to point), add (at point), pore (size and turns)", choices=SITE_ACTIONS)
    point: Optional[Point] = _f(None, "mm", "New place; it is set on the face")
    size: Optional[float] = _f(None, "mm", "New size of the pore")
    turns: Optional[Tuple[float, ...]] = _f(None, "", "New tangent components, one per corner, in 0..1")

    def __post_init__(self) -> None:
        _one_of(self.action, "the change of a site", SITE_ACTIONS)
        named = isinstance(self.site, str) and "." in self.site
        require(named, "a site's name must read face.i.j", repr(self.site))
        if self.action in ("move", "add"):
            require(self.point is not None, f"to {self.action} site {self.site} a point is needed", self.point)
            for value in self.point or ():
                _finite(value, "a site's co-ordinate", "mm")
        if self.size is not None:
            _finite(self.size, f"the size of the pore at {self.site}", "mm", SMALLEST_SIZE)
        if self.turns is not None:
            for value in self.turns:
                _finite(value, f"a tangent component of the pore at {self.site}", "", 0.0, 1.0)


@dataclass(frozen=True)
class RodParameters:
    """How rods are skinned and mended (thesis 3.3.5, 4.2.4)."""

    deflection: float = _f(
        0.0,
        "mm",
        "Greatest distance of the triangles from the true rod; 0 chooses 1/40 of the mean size",
        automatic=0.02,
    )
    stations: int = _f(5, "", "Sections through which the surface of a solid rod is laid", low=3, high=33)
    lean: float = _f(0.0, "", "Tilt of the inner sections towards the path's normal planes", low=0.0, high=1.0)
    redraws: int = _f(
        10, "", "Times that tangents or middle points are drawn again before the path is changed", low=0, high=100
    )

    def __post_init__(self) -> None:
        _finite(self.deflection, "the deflection", "mm", 0.0)
        require(3 <= self.stations <= 33, "the stations of a rod must lie in 3..33", self.stations)
        _finite(self.lean, "the lean", "", 0.0, 1.0)
        require(0 <= self.redraws <= 100, "redraws must lie in 0..100", self.redraws)


@dataclass(frozen=True)
class LayerParameters:
    """Compact layers on chosen faces (thesis 4.3.1)."""

    faces: Tuple[str, ...] = _f((), "", "Faces to be thickened; none means no layer")
    thickness: float = _f(1.0, "mm", "Thickness of the layer")
    side: str = _f("inwards", "", "inwards: the outer part of the envelope; outwards: added to it", choices=LAYER_SIDES)
    closed: bool = _f(True, "", "On: made after the channels and closes them; off: the channels go through")

    def __post_init__(self) -> None:
        require(math.isfinite(self.thickness) and self.thickness > 0, "a layer's thickness must be greater than 0",
                f"{self.thickness:g}", "mm")  # fmt: skip
        _one_of(self.side, "the side of a layer", LAYER_SIDES)


@dataclass(frozen=True)
class ScaffoldParameters:
    """From rods to channels."""

    engine: str = _f(
        "auto", "", "mesh: exact triangles; field: rays and cells, for many rods; brep: STEP", choices=ENGINES
    )
    cell: float = _f(0.1, "mm", "Cell of the field engine")
    keep_loose: bool = _f(False, "", "Keep pieces that channels cut off all round, and closed voids as they are")
    layers: LayerParameters = _f(LayerParameters(), "", "Compact layers")
    seconds: float = _f(600.0, "s", "Time budget of the B-Rep engine")
    memory_gb: float = _f(8.0, "GB", "Memory budget of the B-Rep engine")

    def __post_init__(self) -> None:
        _one_of(self.engine, "the engine", ENGINES)
        require(math.isfinite(self.cell) and self.cell > 0, "the cell must be greater than 0", f"{self.cell:g}", "mm")
        _finite(self.seconds, "the time budget", "s", 1.0)
        _finite(self.memory_gb, "the memory budget", "GB", 0.5)


def check_seed(seed: int) -> None:
    """Refuse a seed that a document could not hold."""
    require(0 <= seed <= LARGEST_SEED, f"the seed must lie in 0..{LARGEST_SEED}", seed)
