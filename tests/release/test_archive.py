# SPDX-License-Identifier: LGPL-2.1-or-later
"""The archive, as the Addon Manager would fetch and unpack it, works in a clean FreeCAD home with numpy alone.

The home has no settings but those that keep FreeCAD quiet, no additional packages; what else may be missing is hidden.
"""

import importlib.util
import json
import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from freecad_trabecula.core.presets import PRESETS

ROOT = Path(__file__).resolve().parents[2]
HERE = Path(__file__).resolve().parent
MISSING = ("scipy", "manifold3d", "matplotlib", "openpyxl", "PIL")
PATIENCE = 120  # s


def module_of(path):
    """Import a script by its path."""
    specification = importlib.util.spec_from_file_location(path.stem, str(path))
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


archive = module_of(ROOT / "tools" / "archive.py")


@pytest.fixture(scope="module")
def home(tmp_path_factory):
    """A FreeCAD home in which the archive was unpacked as the Addon Manager does it."""
    folder = tmp_path_factory.mktemp("home")
    (folder / "user.cfg").write_text(module_of(ROOT / "tests" / "run.py").SETTINGS, encoding="utf-8")
    path = archive.write_archive(folder / "fetched.zip")
    archive.install(path, folder / "Mod")
    path.unlink()
    return folder


def look(home, tmp_path, command):
    """Start FreeCAD in the home, without the packages that may be missing; return what was found and the log."""
    result = tmp_path / "found.json"
    choice = {"folder": str(home / "Mod" / archive.NAME), "missing": MISSING, "result": str(result)}
    keep = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "TRABECULA_PACKAGES")}
    environment = {
        **keep,
        **{"FREECAD_USER_HOME": str(home), "TRABECULA_INSTALLED": json.dumps(choice)},
        **{"PYTHONDONTWRITEBYTECODE": "1", "QTWEBENGINE_DISABLE_SANDBOX": "1", "LIBGL_ALWAYS_SOFTWARE": "1"},
    }
    done = subprocess.run(
        [*command, str(HERE / "installed.py")],
        env=environment,
        cwd=str(tmp_path),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        timeout=PATIENCE,
        check=False,
    )
    log = done.stdout.decode("utf-8", "replace")
    assert result.exists(), log[-3000:]
    found = json.loads(result.read_text(encoding="utf-8"))
    assert "error" not in found, found["error"]
    assert Path(found["package"]).resolve().is_relative_to((home / "Mod").resolve())
    return found, log


def test_the_archive_has_one_folder_named_like_the_forges_and_the_files_that_freecad_starts_with(tmp_path):
    path = archive.write_archive(tmp_path / "one.zip")
    names = zipfile.ZipFile(path).namelist()
    assert {name.split("/")[0] for name in names} == {f"{archive.NAME}-{archive.BRANCH}"}
    top = {name.split("/", 1)[1] for name in names}
    assert {"package.xml", "Init.py", "InitGui.py", "README.md", "LICENSE", "docs/glossary.md"} <= top
    assert not [name for name in top if "__pycache__" in name or name.startswith((".git/", "build/"))]
    assert path.stat().st_size < 20e6


def test_the_same_tree_gives_the_same_archive_byte_by_byte(tmp_path):
    first, second = (archive.write_archive(tmp_path / f"{one}.zip").read_bytes() for one in "ab")
    assert first == second


def test_it_designs_and_slices_with_numpy_alone_and_asks_politely_for_more(home, tmp_path):
    found, log = look(home, tmp_path, ["freecadcmd"])
    assert "Traceback" not in log, log[-3000:]
    assert (found["rods"], found["engine"], found["invalid"]) == (75, "field", [])
    assert found["facets"] > 1000
    assert 0.08 < found["porosity"] < 0.20  # case 1: 13.9 % on average, sd 1.2
    assert found["area"] == pytest.approx(4.0)  # a cube of 2 mm
    for package, (kind, words) in found["refusals"].items():
        assert (kind, package in words, "pip install" in words) == ("DependencyError", True, True), (
            package,
            kind,
            words,
        )


def test_its_workbench_opens_in_a_window_with_all_commands_and_a_panel_and_no_traceback(home, tmp_path):
    found, log = look(home, tmp_path, ["xvfb-run", "-a", "-s", "-screen 0 1280x800x24", "freecad"])
    assert "Traceback" not in log, log[-3000:]
    assert (found["workbench"], found["panel"]) == (True, True)
    assert {"Trabecula_Preset_" + name for name in PRESETS} < set(found["commands"])
    assert {"Trabecula_Design", "Trabecula_Analysis", "Trabecula_Voxels", "Trabecula_Help"} < set(found["commands"])
    assert all(found["texts"].values())
    assert [name for name in found["toolbars"] if name.startswith("Trabecula")]
    assert not [text for text in found["report"] if "Traceback" in text]


if __name__ == "__main__":
    sys.exit(pytest.main([__file__, "-q", "-p", "no:cacheprovider"]))
