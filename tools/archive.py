# SPDX-License-Identifier: LGPL-2.1-or-later
"""The archive of a tree as the Addon Manager fetches it from a forge, and how it unpacks it.

    python3 tools/archive.py FILE.zip       writes the archive of what is committed

A forge gives ``git archive`` of a branch as a zip with one top folder, NAME-BRANCH. The Addon Manager unpacks it into
the folder ``Mod`` as NAME, without that folder. Needs git and the standard library only.
"""

import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NAME, BRANCH = "trabecula", "main"
#: What tests and tools make, and git does not know.
MADE = {".git", "build", "__pycache__", ".ruff_cache", ".pytest_cache"}
#: A day for the files of a tree without git: zip knows none before 1980.
_DAY = (1980, 1, 1, 0, 0, 0)


def write_archive(path):
    """Write the archive of what is committed, and return its path; equal trees give equal bytes.

    Without git (a tree that was itself unpacked, say) it is made of the files as they are.
    """
    path = Path(path)
    command = ["git", "-c", "safe.directory=*", "-C", str(ROOT), "archive", "--format=zip"]
    command += ["--prefix=%s-%s/" % (NAME, BRANCH), "--output=%s" % path.resolve(), "HEAD"]
    if subprocess.run(command, stderr=subprocess.DEVNULL, check=False).returncode == 0:
        return path
    with zipfile.ZipFile(str(path), "w", zipfile.ZIP_DEFLATED) as file:
        for one in sorted(ROOT.rglob("*")):
            name = one.relative_to(ROOT)
            if one.is_file() and not MADE.intersection(name.parts) and one.suffix != ".pyc":
                info = zipfile.ZipInfo("%s-%s/%s" % (NAME, BRANCH, name.as_posix()), _DAY)
                info.external_attr, info.compress_type = 0o644 << 16, zipfile.ZIP_DEFLATED
                file.writestr(info, one.read_bytes())
    return path


def install(path, mod):
    """Unpack an archive into a folder ``Mod`` as the Addon Manager does, and return its folder; the old one goes."""
    place = Path(mod) / NAME
    shutil.rmtree(str(place), ignore_errors=True)
    Path(mod).mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=str(mod)) as folder:
        with zipfile.ZipFile(str(path)) as file:
            file.extractall(folder)
        (top,) = Path(folder).iterdir()
        top.rename(place)
    return place


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    print(write_archive(sys.argv[1]))
