# SPDX-License-Identifier: LGPL-2.1-or-later
"""Changes of single sites and pores by hand: each function changes a wireframe object and computes it again."""

from __future__ import annotations

from typing import Any, Optional, Sequence

from ..core.parameters import Point, SiteEdit
from ..errors import ParameterError, TrabeculaError
from .arguments import given_object, given_value
from .base import lines_of, records_of
from .feature import update
from .wireframe import Wireframe


def edits_of(wireframe: Any) -> Sequence[SiteEdit]:
    """Return the changes by hand of a wireframe object."""
    return records_of(given_object(wireframe, Wireframe).Edits, SiteEdit, "edit")


def set_pore(wireframe: Any, site: str, size: Optional[float] = None, turns: Optional[Sequence[float]] = None) -> None:
    """Set size and tangents of one pore by hand.

    Parameters
    ----------
    wireframe : document object
    site : str
        Name of the site, e.g. ``Face1.2.3``.
    size : float, mm, optional
    turns : sequence of float, optional
        Tangent components in 0..1, one per corner.

    Raises
    ------
    ParameterError
        If there is no such site or a value is refused; nothing is changed then.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.presets import preset
    >>> wireframe = make.make_design(FreeCAD.newDocument(), preset("case3")).wireframe
    >>> make.set_pore(wireframe, "Face1.2.3", size=0.5)
    >>> wireframe.Edits
    ['{"site": "Face1.2.3", "action": "pore", "size": 0.5}']
    """
    if size is None and turns is None:
        raise ParameterError(f"the pore at {site} must get a size or tangent components, got neither")
    given_value(turns, list, tuple, type(None))
    _edit(wireframe, SiteEdit(site, "pore", size=size, turns=None if turns is None else tuple(turns)))


def move_site(wireframe: Any, site: str, point: Sequence[float]) -> None:
    """Move one site by hand to a point (3,), mm, on its face.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.presets import preset
    >>> wireframe = make.make_design(FreeCAD.newDocument(), preset("case3")).wireframe
    >>> make.move_site(wireframe, "Face1.2.3", (0, 2.5, 3.5))
    >>> len(wireframe.Edits)
    1
    """
    _edit(wireframe, SiteEdit(site, "move", point=_point(point)))


def switch_off_site(wireframe: Any, site: str) -> None:
    """Switch one site off by hand: no rod uses it.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.presets import preset
    >>> wireframe = make.make_design(FreeCAD.newDocument(), preset("case3")).wireframe
    >>> make.switch_off_site(wireframe, "Face1.2.3")
    >>> wireframe.Rods
    146
    """
    _edit(wireframe, SiteEdit(site, "off"))


def add_site(wireframe: Any, face: str, point: Sequence[float]) -> str:
    """Add a site by hand at a point (3,), mm, of a face; return its name.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.presets import preset
    >>> wireframe = make.make_design(FreeCAD.newDocument(), preset("case3")).wireframe
    >>> make.add_site(wireframe, "Face1", (0, 3, 3.2)), make.add_site(wireframe, "Face2", (10, 3, 3.2))
    ('Face1.hand.1', 'Face2.hand.1')
    >>> wireframe.Rods
    148
    """
    own = [e for e in edits_of(wireframe) if e.action == "add" and e.site.split(".")[0] == face]
    name = f"{face}.hand.{len(own) + 1}"
    _edit(wireframe, SiteEdit(name, "add", point=_point(point)))
    return name


def take_back_edits(wireframe: Any, site: str) -> None:
    """Take back the changes by hand of one site.

    One that was added is switched off and not taken away: the names of those added later count on it.

    Examples
    --------
    >>> import FreeCAD
    >>> from freecad_trabecula import make
    >>> from freecad_trabecula.core.presets import preset
    >>> wireframe = make.make_design(FreeCAD.newDocument(), preset("case3")).wireframe
    >>> make.switch_off_site(wireframe, "Face1.2.3")
    >>> make.take_back_edits(wireframe, "Face1.2.3")
    >>> wireframe.Rods
    147
    """
    edits = edits_of(wireframe)
    added = [e for e in edits if e.site == site and e.action == "add"]
    _set_edits(wireframe, [e for e in edits if e.site != site] + added + [SiteEdit(site) for _ in added])


def _point(point: Sequence[float]) -> Point:
    try:
        x, y, z = (float(one) for one in point)
    except (TypeError, ValueError):
        raise ParameterError(f"a point must be three numbers in mm, got {point!r:.60}") from None
    return (x, y, z)


def _edit(wireframe: Any, edit: SiteEdit) -> None:
    """Put a change behind the others; it replaces an earlier one of the same kind of the same site."""
    kept = [e for e in edits_of(wireframe) if (e.site, e.action) != (edit.site, edit.action)]
    _set_edits(wireframe, [*kept, edit])


def _set_edits(wireframe: Any, edits: Sequence[SiteEdit]) -> None:
    before = wireframe.Edits
    wireframe.Edits = lines_of(edits)
    try:
        update(wireframe)
    except TrabeculaError:
        wireframe.Edits = before
        wireframe.Document.recompute([wireframe])
        raise
