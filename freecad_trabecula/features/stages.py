# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a document has come: which bodies, designs and analyses it holds, and whether each is up to date.

Read from the document alone, so that work can be left and taken up again, in another session too.
"""

from __future__ import annotations

from typing import Any, Callable, List, NamedTuple, Sequence

from .bodies import is_body, wholes
from .feature import ERROR
from .on_demand import COMPUTING
from .relations import products_of, type_of, wireframe_of

NONE, DONE, STALE, WORKING, FAILED = "", "done", "stale", "working", "failed"
ANALYSIS, VOXELS, WIREFRAME = "Trabecula::Analysis", "Trabecula::VoxelDesign", "Trabecula::Wireframe"


class Stages(NamedTuple):
    """What a document holds; objects are None where there are none.

    Attributes
    ----------
    bodies : list of document objects
        Solids and meshes that are not ours: what can be filled, measured, or be a sample.
    solids : list of document objects
        Those of them that are solids.
    wireframe, scaffold : document object
        The design of rods, and what is analysed of it: scaffold, STEP scaffold or network.
    voxels : document object
        The voxel design.
    analyses : list of document objects
    of_scaffold, of_voxels, of_bone : document object
        Analyses of the designs, and the first of anything else, such as bone.
    chosen : list of document objects
        Bodies that are selected: they come before others.
    """

    bodies: List[Any]
    solids: List[Any]
    wireframe: Any
    scaffold: Any
    voxels: Any
    analyses: List[Any]
    of_scaffold: Any
    of_voxels: Any
    of_bone: Any
    chosen: List[Any]

    @property
    def bones(self) -> List[Any]:
        """Bodies that no design fills and no analysis measures yet, selected ones first."""
        filled = self.wireframe.Envelope if self.wireframe is not None else None
        measured = [one.Source for one in self.analyses]
        found = [body for body in self.bodies if body is not filled and body not in measured]
        return sorted(found, key=lambda body: body not in self.chosen)


def _last(objects: Sequence[Any], chosen: Sequence[Any] = ()) -> Any:
    """The chosen one, else the last; None if there is none."""
    return next((obj for obj in objects if obj in chosen), objects[-1] if objects else None)


def stages_of(document: Any, chosen: Sequence[Any] = ()) -> Stages:
    """Return what a document holds; of several designs that to which a chosen object belongs, else the latest.

    Parameters
    ----------
    document : App.Document or None
    chosen : sequence of document objects
    """
    objects = document.Objects if document is not None else []
    kinds = [type_of(obj) for obj in objects]

    def of(kind: str) -> List[Any]:
        return [obj for obj, its in zip(objects, kinds) if its == kind]

    bodies = [obj for obj in objects if is_body(obj)]
    wireframe = _last(of(WIREFRAME), [wireframe_of(obj) for obj in chosen if type_of(obj)])
    voxels, analyses = _last(of(VOXELS), chosen), of(ANALYSIS)
    products = sorted(products_of(wireframe), key=_worth) if wireframe is not None else []
    scaffold = products[0] if products else None
    ours = [obj for obj in objects if type_of(obj)]

    def analysis(suits: Callable[[Any], bool]) -> Any:
        return _last([one for one in analyses if suits(one.Source)])

    return Stages(
        bodies,
        [body for body in bodies if hasattr(body, "Shape")],
        wireframe,
        scaffold,
        voxels,
        analyses,
        analysis(lambda source: scaffold is not None and source in products),
        analysis(lambda source: voxels is not None and source is voxels),
        next((one for one in analyses if one.Source not in ours), None),
        [body for body in wholes(chosen) if body in bodies],
    )


def _worth(product: Any) -> int:
    """What is analysed first: the scaffold as a mesh, as a solid, the network."""
    return ("scaffold", "solid", "network").index(product.Proxy.KIND)


def state_of(obj: Any) -> str:
    """Return how an object is: ``NONE`` if there is none, ``DONE``, ``STALE``, ``WORKING`` or ``FAILED``.

    What is made of something stale is stale too.
    """
    if obj is None:
        return NONE
    status = getattr(obj, "Status", "")
    if not obj.isValid() or status.startswith(ERROR):
        return FAILED
    if COMPUTING in status:
        return WORKING
    if not getattr(obj, "UpToDate", True):
        return STALE
    before = [getattr(obj, name, None) for name in ("Source", "Wireframe")]
    states = [state_of(one) for one in before if one is not None]
    return STALE if any(state in (STALE, WORKING, FAILED) for state in states) else DONE


def stale_objects(document: Any) -> List[Any]:
    """Return the objects that must be updated for all to be up to date, those first of which others are made."""
    objects = document.Objects if document is not None else []
    return [obj for obj in objects if type_of(obj) and state_of(obj) == STALE and not getattr(obj, "UpToDate", True)]
