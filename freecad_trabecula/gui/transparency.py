# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the eye looks through: three ways to choose, and the clear view while a preview is shown."""

from __future__ import annotations

from typing import Any, Dict, NamedTuple, Sequence, Tuple

from ..features.relations import products_of, type_of, wireframe_of

_SHARE = 85  # % of transparency: the faces can still be seen and picked


class Sight(NamedTuple):
    """Transparency of bodies and of the envelope, %; None: the envelope is not shown beside its bodies."""

    bodies: int
    envelope: Any


#: The ways to look through.
SIGHTS: Dict[str, Sight] = {"solid": Sight(0, None), "glass": Sight(0, _SHARE), "xray": Sight(70, 90)}


def look_through(document: Any, sight: str, chosen: Sequence[Any] = ()) -> None:
    """Set how far the eye looks through the bodies of a document and their envelopes.

    Parameters
    ----------
    document : App.Document
    sight : str
        A key of ``SIGHTS``.
    chosen : sequence of document objects
        Of ours; what belongs to other designs stays. None: all.
    """
    designs = {wireframe_of(obj) for obj in chosen} - {None}
    for obj in document.Objects:
        is_meant = obj in chosen or wireframe_of(obj) in designs if chosen else True
        if is_meant and type_of(obj) and hasattr(obj.ViewObject, "Transparency"):
            obj.ViewObject.Transparency = SIGHTS[sight].bodies
    for obj in document.Objects:
        if type_of(obj) == "Trabecula::Wireframe" and obj.Envelope is not None and (not chosen or obj in designs):
            _show_envelope(obj, SIGHTS[sight].envelope)


def _show_envelope(wireframe: Any, share: Any) -> None:
    """Show an envelope as clear as that; None: only where there is nothing else to be seen of its design."""
    view = wireframe.Envelope.ViewObject
    if share is None:
        view.Transparency = 0
        view.Visibility = not any(one.ViewObject.Visibility for one in (wireframe, *products_of(wireframe)))
    else:
        view.Transparency, view.Visibility = share, True


class ClearView:
    """Sets transparency and visibility, and gives both back."""

    def __init__(self) -> None:
        self._before: Dict[str, Tuple[Any, bool, int]] = {}

    def apply(self, envelope: Any, others: Sequence[Any] = ()) -> None:
        """Make the envelope transparent and visible, hide the others."""
        self.restore()
        for obj in ([envelope] if envelope is not None else []) + list(others):
            view = obj.ViewObject
            self._before[obj.Name] = (view, view.Visibility, getattr(view, "Transparency", 0))
            if obj is envelope:
                view.Visibility = True
                view.Transparency = max(_SHARE, view.Transparency)
            else:
                view.Visibility = False

    def forget(self) -> None:
        """Give nothing back: the document is being closed."""
        self._before = {}

    def restore(self) -> None:
        """Give back what there was; objects that have gone are passed over."""
        for view, visible, transparency in self._before.values():
            try:
                view.Visibility = visible
                if hasattr(view, "Transparency"):
                    view.Transparency = transparency
            except (ReferenceError, RuntimeError):
                continue
        self._before = {}
