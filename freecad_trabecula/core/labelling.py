# SPDX-License-Identifier: LGPL-2.1-or-later
"""What hangs together in an array of voxels, by scipy, which may be missing."""

from __future__ import annotations

from typing import Any

from .optional_packages import optional_module


def scipy_ndimage() -> Any:
    """Return the module ``scipy.ndimage``.

    Raises
    ------
    DependencyError
        If scipy is missing; the message says how to install it.
    """
    return optional_module("scipy.ndimage", "parts of voxels and distances between them need scipy")
