# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes docs/measures.md, why each number is what it is, from the explanations themselves."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

from freecad_trabecula.core.explanations.registry import page  # noqa: E402

PAGE = ROOT / "docs" / "measures.md"

if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
    print(f"{PAGE} was written")
