# SPDX-License-Identifier: LGPL-2.1-or-later
"""While a preview is shown, the envelope lets the eye through and the design's own bodies step aside."""

from __future__ import annotations

from typing import Any, Dict, Sequence, Tuple

_SHARE = 85  # % of transparency: the faces can still be seen and picked


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

    def restore(self, visibility: bool = True) -> None:
        """Give back what there was; objects that have gone are passed over.

        Parameters
        ----------
        visibility : bool
            False where what is seen has been settled anew.
        """
        for view, visible, transparency in self._before.values():
            try:
                if visibility:
                    view.Visibility = visible
                if hasattr(view, "Transparency"):
                    view.Transparency = transparency
            except (ReferenceError, RuntimeError):
                continue
        self._before = {}
