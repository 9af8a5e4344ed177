# SPDX-License-Identifier: LGPL-2.1-or-later
"""B-Rep engine: the scaffold as a solid, held against the mesh engine.

In a polyhedron the solid is made of patches of its planes and of the rods' surfaces, without any Boolean of the kernel
(``patch_solids``). In other envelopes, and where that does not succeed, rods are cut away group by group. The kernel's
Booleans return valid solids of wrong volume without a word (40 rods: 0.47 mm3 where 912 was right), so a step counts
only if it takes away what the exact mesh Boolean takes away. A group that comes out wrong is undone and halved, down to
single rods; a rod that cannot be cut in any way ends the work, and what was reached is told.
"""

from __future__ import annotations

import sys
import time
from typing import List, NamedTuple, Optional

import numpy as np
import Part

from ..core.booleans import CutSteps
from ..core.parameters import RodParameters, ScaffoldParameters
from ..core.progress import Progress, silent
from ..core.rods import rod_mesh
from ..core.strips import rod_strips
from ..core.wireframe import Wireframe, skin
from ..errors import EnvelopeError, KernelError, MeshError, ParameterError
from .brep_text import read_brep
from .envelopes import Envelope
from .patch_solids import patch_solids
from .rod_solids import rod_texts

GROUP = 8  # rods cut at once
STEP_TOLERANCE = 0.02  # relative, of what a step takes away: a lost rod is an eighth, tessellation under a hundredth
VOLUME_TOLERANCE = 2e-3  # relative, of the scaffold's volume, solid against mesh
_FUZZ = (0.0, 1e-5, 1e-4)  # mm; tolerances tried for one rod
_BEYOND = 0.2  # mm; how far rods are prolonged, so that caps never lie in faces


class SolidCut(NamedTuple):
    """How far the engine came.

    Attributes
    ----------
    shape : Part.Shape
        The envelope less the rods cut so far.
    rods, wanted : int
        Rods cut, and rods asked for.
    reason : str
        Why it stopped; empty if all rods are cut.
    volume, mesh_volume : float, mm3
        Of the shape, and of the same cut by the mesh engine.
    seconds : float
    """

    shape: Part.Shape
    rods: int
    wanted: int
    reason: str
    volume: float
    mesh_volume: float
    seconds: float

    @property
    def complete(self) -> bool:
        """Whether all rods are cut."""
        return self.rods == self.wanted


def cut_solid(
    envelope: Envelope,
    wireframe: Wireframe,
    rods: RodParameters,
    parameters: ScaffoldParameters,
    progress: Progress = silent,
) -> SolidCut:
    """Return the scaffold of a wireframe as a solid, as far as the kernel, the time and the memory allow.

    Parameters
    ----------
    envelope : Envelope
    wireframe : Wireframe
    rods : RodParameters
    parameters : ScaffoldParameters
        ``seconds`` and ``memory_gb`` are the budgets, looked at between steps.
    progress : callable

    Raises
    ------
    DependencyError
        If manifold3d, against which every step is held, is not installed.
    ParameterError
        If compact layers are asked for, which this engine does not make.
    """
    if parameters.layers.faces:
        raise ParameterError(
            f"the B-Rep engine makes no compact layers, got {len(parameters.layers.faces)} faces with a layer: use the "
            "mesh engine"
        )
    work = _Work(envelope, wireframe, rods, parameters, progress)
    if len(wireframe) and all(isinstance(face.Surface, Part.Plane) for face in envelope.solid.Faces):
        made = work.of_patches()
        if made is not None:
            return made
    return cut_by_steps(work)


def cut_by_steps(work: _Work) -> SolidCut:
    """Return the scaffold, its rods cut away by the kernel's Booleans, as far as it comes."""
    work.run()
    return work.result()


class _Work:
    """The state of the cut: the solid, the same cut as a mesh, and the rods done."""

    def __init__(
        self,
        envelope: Envelope,
        wireframe: Wireframe,
        rods: RodParameters,
        limits: ScaffoldParameters,
        progress: Progress,
    ) -> None:
        self._wireframe, self._limits, self._progress = wireframe, limits, progress
        self._envelope = envelope
        self._halves = max((rods.stations - 1) // 2, 1)
        self._texts = rod_texts(wireframe, self._halves, _BEYOND)
        self._vertices, self._triangles = rod_mesh(skin(wireframe, rods), _BEYOND)
        self._steps = CutSteps(envelope.mesh)
        # the mesh of a curved envelope is a little smaller than the solid: the difference is no fault of a step
        self._offset = envelope.volume - self._steps.volume
        self._shape = envelope.solid
        self._volume = envelope.volume
        self._done, self._reason, self._start = 0, "", time.perf_counter()
        self._before = ""  # what was tried first, and why it did not succeed

    def of_patches(self) -> Optional[SolidCut]:
        """Return the scaffold made of patches, or None if that does not succeed."""
        strips = rod_strips(self._wireframe.paths, self._wireframe.ends, self._halves, _BEYOND)
        self._steps.cut(self._vertices, self._triangles)
        mesh_volume = self._steps.volume
        self._steps.undo()
        try:
            made = patch_solids(strips, self._envelope.mesh, self._limits.keep_loose, self._within_budget)
        except (KernelError, MeshError) as error:
            if not self._over_budget():  # else that is said, and once is enough
                self._before = f"no solid of patches: {error}; then "
            return None
        if not made.solids or abs(made.volume / mesh_volume - 1) > VOLUME_TOLERANCE:
            self._before = f"no solid of patches: {made.volume:g} mm3 against {mesh_volume:g} of the mesh; then "
            return None
        shape = made.solids[0] if len(made.solids) == 1 else Part.makeCompound(made.solids)
        total, seconds = len(self._wireframe), time.perf_counter() - self._start
        return SolidCut(shape, total, total, "", made.volume, mesh_volume, seconds)

    def run(self) -> None:
        """Cut group after group until all are cut, or something forbids it."""
        total = len(self._wireframe)
        while self._done < total and not self._reason:
            self._progress(self._done, total, f"solid: rod {self._done + 1} of {total}")
            self._cut(list(range(self._done, min(self._done + GROUP, total))))

    def _cut(self, group: List[int]) -> None:
        """Cut a group of rods, or its halves if it comes out wrong."""
        self._reason = self._reason or self._over_budget()
        if self._reason:
            return
        for fuzz in _FUZZ if len(group) == 1 else _FUZZ[:1]:
            if self._try(group, fuzz):
                return
        if len(group) > 1:
            middle = len(group) // 2
            self._cut(group[:middle])
            self._cut(group[middle:])
            return
        self._reason = f"the kernel cuts rod {self._wireframe.names[group[0]]} wrongly in every way tried"

    def _try(self, group: List[int], fuzz: float) -> bool:
        """Cut a group and keep it if the mesh engine agrees; return whether it does."""
        before = self._steps.volume
        taken = before - self._steps.cut(self._vertices[group], self._triangles)
        tools = [read_brep(self._texts[k]).Solids[0] for k in group]
        try:
            shape = self._shape.cut(tools, fuzz) if fuzz else self._shape.cut(tools)
            volume = shape.Volume
        except (Part.OCCError, RuntimeError, ValueError):
            shape, volume = None, np.nan
        agrees = abs((self._volume - volume) - taken) <= STEP_TOLERANCE * taken + 1e-9
        if shape is None or not agrees or not shape.Solids or not shape.isValid():
            self._steps.undo()
            return False
        self._shape, self._volume, self._done = shape, volume, self._done + len(group)
        return True

    def _within_budget(self, done: float, total: float, what: str) -> None:
        """Progress that ends the work when a budget is used up."""
        self._progress(done, total, what)
        spent = self._over_budget()
        if spent:
            raise KernelError(spent)

    def _over_budget(self) -> str:
        seconds = time.perf_counter() - self._start
        if seconds > self._limits.seconds:
            return f"the time budget of {self._limits.seconds:g} s is used up"
        peak = _peak_memory()
        if peak > self._limits.memory_gb:
            return f"the memory budget of {self._limits.memory_gb:g} GB is used up ({peak:.1f} GB)"
        return ""

    def result(self) -> SolidCut:
        """Return the scaffold, loose pieces taken away unless they are to be kept, with both volumes."""
        shape, mesh_volume = self._shape, self._steps.volume + self._offset
        if abs(shape.Volume / mesh_volume - 1) > VOLUME_TOLERANCE:
            raise KernelError(
                f"solid and mesh of the scaffold must agree within {VOLUME_TOLERANCE:g}, got {shape.Volume:g} and "
                f"{mesh_volume:g} mm3"
            )
        if not shape.Solids:
            raise EnvelopeError("nothing is left of the envelope: the rods fill it")
        volume = shape.Volume
        if not self._limits.keep_loose:
            shape = max(shape.Solids, key=lambda solid: solid.Volume)
        seconds = time.perf_counter() - self._start
        reason = self._before + self._reason if self._reason else ""
        return SolidCut(shape, self._done, len(self._wireframe), reason, volume, mesh_volume, seconds)


def _peak_memory() -> float:
    """Peak memory of this process, GB; 0 on Windows, which keeps no such count."""
    try:
        import resource
    except ImportError:
        return 0.0
    # kilobytes on Linux, bytes on macOS
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * (1 if sys.platform == "darwin" else 1024) / 1e9
