# SPDX-License-Identifier: LGPL-2.1-or-later
"""What hangs together in an array of voxels, by scipy, which may be missing."""

from __future__ import annotations

from typing import Any

from ..errors import DependencyError

INSTALL = "python3 -m pip install scipy (Debian: apt install python3-scipy)"


def scipy_ndimage() -> Any:
    """Return the module ``scipy.ndimage``.

    Raises
    ------
    DependencyError
        If scipy is missing; the message says how to install it.
    """
    try:
        from scipy import ndimage
    except ImportError as error:
        raise DependencyError(f"parts of voxels and distances between them need scipy: {INSTALL}") from error
    return ndimage
