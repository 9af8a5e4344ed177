# SPDX-License-Identifier: LGPL-2.1-or-later
"""The demonstration (``make demo``): case 6 and an anatomical implant; files, report and pictures in build/demo/."""

import subprocess
import sys
import time
from pathlib import Path

import picture

ROOT = Path(__file__).resolve().parent.parent
DESIGNS = ("case6", "cranial")


def main():
    """Design, print the reports, take the pictures; return 0 if all went well."""
    started, status = time.time(), 0
    for name in DESIGNS:
        folder = ROOT / "build" / "demo" / name
        folder.parent.mkdir(parents=True, exist_ok=True)
        print(f"==== {name}", flush=True)
        words = ["--preset", name, "--out", str(folder)]
        code = subprocess.call([sys.executable, "-m", "freecad_trabecula", "design", *words], cwd=str(ROOT))
        if code:
            return code
        print((folder / "report.md").read_text(encoding="utf-8"))
        images = {folder / "scaffold.png": ["Scaffold"], folder / "network.png": ["Network"]}
        status |= picture.take(folder / "design.FCStd", images)
        for image in images:
            print(f"picture: {image}" if image.exists() else f"no picture {image.name}", flush=True)
        print("files: " + ", ".join(sorted(p.name for p in folder.iterdir())))
    print(f"done in {time.time() - started:.0f} s; everything is in {ROOT / 'build' / 'demo'}")
    return status


if __name__ == "__main__":
    sys.exit(main())
