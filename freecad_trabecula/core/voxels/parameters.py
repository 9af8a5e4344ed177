# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user chooses for a voxel design: one frozen dataclass, checked when it is made.

Every field carries ``metadata`` as in ``core/parameters.py``, so that properties, JSON and the panel are made from it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any, Tuple

from ..parameters import check_seed, require
from .registry import strategy_names

Triple = Tuple[float, float, float]

AREAS = ("middle", "slab")
CORRECTIONS = ("remainders", "random")
TOTALS = ("mean", "x", "y", "z")
SOLVERS = ("proportional", "thesis")
PAIRINGS = ("constraint", "repeat")
DIRECTIONS = ("columns", "rows")
FIELDS = ("noise", "gyroid", "sheets", "centre", "border")
CONTACTS = ("any", "edge", "corner")
TRABECULAE = ("off", "x", "y", "z", "xy", "xz", "yz", "xyz")
BOUNDARIES = ("half", "touched", "inside")

SMALLEST_VOXEL = 1e-4  # mm: a tenth of a micrometre, below every scanner and printer
LARGEST_VOXELS = 512_000_000  # cells of a design, 800 x 800 x 800: the largest that a workstation's memory holds
BYTES_PER_VOXEL = 34  # peak of a trabecular design, measured at 400 x 400 x 400


def _f(default: Any, unit: str, doc: str, **more: Any) -> Any:
    return field(default=default, metadata=dict(unit=unit, doc=doc, **more))


@dataclass(frozen=True)
class VoxelParameters:
    """Everything that, with the targets and the mask, makes a voxel design (thesis chapter 6)."""

    size: Triple = _f((0.1, 0.1, 0.1), "mm", "Edges dx, dy, dz of a voxel; one number makes a cube")
    strategy: str = _f("trabecular", "", "How the layers are filled", choices=strategy_names())
    seed: int = _f(1, "", "One number reproduces all random draws")

    areas: str = _f("middle", "", "Targets from sections through the middles of the layers (Eq. 6.1), or from the "
                    "volumes of the slabs", choices=AREAS)  # fmt: skip
    correction: str = _f("remainders", "", "How rounded counts are brought to one total: largest remainders, or the "
                         "thesis' random layers", choices=CORRECTIONS)  # fmt: skip
    total: str = _f("mean", "", "Which axis' real total is the common one (thesis: z)", choices=TOTALS)

    cap_alpha: int = _f(0, "", "Most voxels in a line (x, z), thesis 6.2.4.3; 0 means M", low=0, automatic=0)
    cap_beta: int = _f(0, "", "Most voxels in a line (y, z); 0 means N", low=0, automatic=0)
    solver: str = _f("proportional", "", "How a row of a table is drawn: in proportion to what the columns still need, "
                     "or uniformly as in the thesis", choices=SOLVERS)  # fmt: skip
    pairing: str = _f("constraint", "", "Compatible tables by construction, or by the thesis' try-and-repeat",
                      choices=PAIRINGS)  # fmt: skip
    tries: int = _f(200, "", "Pairs of tables that are tried before the search gives up", low=1)
    direction: str = _f("columns", "", "Minimum zeros propagation: columns are solved one after the other (fewest "
                        "zeros u), or rows (fewest zeros v)", choices=DIRECTIONS)  # fmt: skip
    field: str = _f("noise", "", "Field of the strategies by-field and best-tables: voxels lie where it is high",
                    choices=FIELDS)  # fmt: skip

    wavelength: Triple = _f((0.0, 0.0, 0.0), "mm", "Wavelengths of the trabecular texture along X, Y, Z; 0: fitted to "
                            "the sample, or eight voxels without one",
                            automatic=(0.8, 0.8, 0.8))  # fmt: skip
    rods: float = _f(-1.0, "", "0 makes sheets, 1 makes rods of the texture; -1: fitted to the sample, or 0.3 without "
                     "one", low=-1.0, high=1.0, automatic=0.3)  # fmt: skip
    contacts: str = _f("edge", "", "Contacts that are avoided: none by an edge alone, or none by an edge or a corner "
                       "alone; any: all are allowed", choices=CONTACTS)  # fmt: skip
    thickness: int = _f(1, "", "Least thickness in voxels", low=1, high=9)
    void: int = _f(1, "", "Least void between solid in voxels", low=1, high=9)
    trabeculae: str = _f("off", "", "Axes along which the number of trabeculae per layer is a target too",
                         choices=TRABECULAE)  # fmt: skip
    boundary: str = _f("half", "", "Voxels at the envelope's boundary belong to it when their centre does, when they "
                       "touch it, or when they lie inside it whole", choices=BOUNDARIES)  # fmt: skip

    def __post_init__(self) -> None:
        object.__setattr__(self, "size", _triple(self.size, "the voxel size"))
        object.__setattr__(self, "wavelength", _triple(self.wavelength, "the wavelength"))
        for edge in self.size:
            require(
                edge >= SMALLEST_VOXEL, f"a voxel's edges must be at least {SMALLEST_VOXEL:g} mm", f"{edge:g}", "mm"
            )
        for length in self.wavelength:
            require(length >= 0, "a wavelength must be 0 (fitted) or more", f"{length:g}", "mm")
        check_seed(self.seed)
        for spec in self.__dataclass_fields__.values():
            _check_field(spec.name, getattr(self, spec.name), spec.metadata)


def _check_field(name: str, value: Any, metadata: Any) -> None:
    choices, low, high = (metadata.get(key) for key in ("choices", "low", "high"))
    if choices:
        require(value in choices, f"{name} must be one of {', '.join(choices)}", repr(value))
    if low is not None:
        require(
            low <= value <= (math.inf if high is None else high),
            f"{name} must be at least {low}" if high is None else f"{name} must lie in {low}..{high}",
            value,
        )


def _triple(value: Any, name: str) -> Triple:
    numbers = value if isinstance(value, (tuple, list)) else (value,) * 3
    require(len(numbers) == 3, f"{name} must be one number or three", len(numbers), "numbers")
    for number in numbers:
        require(math.isfinite(number), f"{name} must be finite", f"{number:g}", "mm")
    return tuple(float(n) for n in numbers)  # type: ignore[return-value]


def check_voxel_count(shape: Tuple[int, int, int]) -> None:
    """Refuse a design of more cells than memory holds, with an estimate of what it would take.

    Parameters
    ----------
    shape : tuple of int
        Layers N, M, P along X, Y, Z.

    Raises
    ------
    ParameterError
        If there are more than ``LARGEST_VOXELS``.
    """
    count = math.prod(int(n) for n in shape)
    words = " x ".join(f"{int(n):,}" for n in shape)
    require(
        count <= LARGEST_VOXELS,
        f"a design must have at most {LARGEST_VOXELS:,} voxels; {words} would take about "
        f"{count * BYTES_PER_VOXEL / 1e9:,.0f} GB of memory; larger voxels make fewer",
        f"{count:,}",
        "voxels",
    )
