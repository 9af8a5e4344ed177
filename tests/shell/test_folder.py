# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder of results receives all files together, or none."""

from __future__ import annotations

import os
import subprocess
import sys
from unittest import mock

import pytest
from shell_runs import names

from freecad_trabecula.errors import ExportError, ParameterError
from freecad_trabecula.shell.folder import ResultFolder, require_own_folder


def write(folder, *pairs):
    for name, text in pairs:
        folder.path(name).write_text(text)


def test_files_appear_when_they_are_kept_and_not_before(tmp_path):
    target = tmp_path / "out"
    with ResultFolder(str(target)) as folder:
        write(folder, ("a", "new a"), ("b", "new b"))
        assert not target.exists()
        folder.keep("a", "b")
        assert names(target) == ["a", "b"]
    assert names(tmp_path) == ["out"]


def test_files_of_the_same_name_are_replaced_and_others_stay(tmp_path):
    (tmp_path / "a").write_text("old a")
    (tmp_path / "mine").write_text("mine")
    with ResultFolder(str(tmp_path)) as folder:
        write(folder, ("a", "new a"))
        assert (tmp_path / "a").read_text() == "old a"
        folder.keep("a")
    assert (tmp_path / "a").read_text() == "new a"
    assert names(tmp_path) == ["a", "mine"]


def test_a_run_that_fails_leaves_the_folder_as_it_was(tmp_path):
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "a").write_text("old a")
    with pytest.raises(ZeroDivisionError), ResultFolder(str(tmp_path / "out")) as folder:
        write(folder, ("a", "half"))
        raise ZeroDivisionError
    assert (tmp_path / "out" / "a").read_text() == "old a"
    assert names(tmp_path) == ["out"]


def test_a_run_that_fails_leaves_no_folder_that_was_not_there(tmp_path):
    with pytest.raises(ZeroDivisionError), ResultFolder(str(tmp_path / "a" / "b" / "c")):
        raise ZeroDivisionError
    assert names(tmp_path) == []


def test_what_a_killed_run_left_is_removed_by_the_next(tmp_path):
    left = tmp_path / ".out.trabecula"
    left.mkdir()
    (left / "scaffold.stl").write_text("half")
    (left / ".lock").write_text("")
    with ResultFolder(str(tmp_path / "out")) as folder:
        assert names(folder.aside) == [".lock"]
    assert names(tmp_path) == []


def test_two_runs_into_one_folder_are_told_apart_from_a_killed_one(tmp_path):
    script = (
        "import sys, time; sys.path.insert(0, sys.argv[2])\n"
        "from freecad_trabecula.shell.folder import ResultFolder\n"
        "with ResultFolder(sys.argv[1]): print('in', flush=True); time.sleep(60)"
    )
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
    other = subprocess.Popen([sys.executable, "-c", script, str(tmp_path / "out"), root], stdout=subprocess.PIPE)
    try:
        assert other.stdout.readline() == b"in\n"
        with pytest.raises(ParameterError, match="another run is writing into the folder"):
            ResultFolder(str(tmp_path / "out")).__enter__()
        assert names(tmp_path) == [".out.trabecula"]
    finally:
        other.kill()
        other.communicate()
    with ResultFolder(str(tmp_path / "out")):
        pass
    assert names(tmp_path) == []


def test_a_file_in_the_place_of_the_folder_is_refused(tmp_path):
    (tmp_path / "file").write_text("")
    for name in ("file", "file/out", "file/a/b"):
        with pytest.raises(ParameterError, match=r"the folder .*file.* cannot be written"):
            ResultFolder(str(tmp_path / name)).__enter__()
    assert names(tmp_path) == ["file"]


def test_a_name_that_no_disk_takes_is_refused(tmp_path):
    with pytest.raises(ParameterError, match=r"the folder .*xxx cannot be written: .*too long"):
        ResultFolder(str(tmp_path / ("x" * 300))).__enter__()
    assert names(tmp_path) == []


def test_a_folder_with_the_report_of_something_else_is_refused(tmp_path):
    for text, kind in (('{"rods": 27}', ""), ('{"kind": "slice analysis"}', "slice analysis")):
        (tmp_path / "report.json").write_text(text)
        require_own_folder(str(tmp_path), kind)
        with pytest.raises(ParameterError, match=f"holds the report.json of a {kind or 'design'}"):
            require_own_folder(str(tmp_path), "voxel design")
    with pytest.raises(ParameterError, match="the folder of a design must not be that of something else"):
        require_own_folder(str(tmp_path))
    for text in ("[]", "{", ""):  # nobody's
        (tmp_path / "report.json").write_text(text)
        require_own_folder(str(tmp_path))


def test_a_folder_that_may_not_be_written_is_refused_before_anything_is_computed(tmp_path):
    with mock.patch("os.access", return_value=False), pytest.raises(ParameterError, match="permission denied"):
        ResultFolder(str(tmp_path)).__enter__()
    assert names(tmp_path) == []


def test_the_top_of_another_disk_keeps_its_files_inside(tmp_path):
    # files can be renamed within one disk only; a parent that may not be written is the same case
    with mock.patch("os.access", side_effect=lambda path, mode: str(path) != str(tmp_path)):
        (tmp_path / "disk").mkdir()
        folder = ResultFolder(str(tmp_path / "disk"))
    assert folder.aside.parent == tmp_path / "disk"


def test_a_link_to_a_folder_is_followed(tmp_path):
    (tmp_path / "real").mkdir()
    (tmp_path / "link").symlink_to(tmp_path / "real")
    with ResultFolder(str(tmp_path / "link")) as folder:
        write(folder, ("a", "a"))
        folder.keep("a")
    assert names(tmp_path / "real") == ["a"]
    assert (tmp_path / "link").is_symlink()


def test_a_disk_that_is_full_at_the_end_is_said(tmp_path):
    with ResultFolder(str(tmp_path / "out")) as folder:
        write(folder, ("a", "a"))
        full = mock.patch("os.replace", side_effect=OSError(28, "No space left on device"))
        with full, pytest.raises(ExportError, match="could not be written: No space left on device"):
            folder.keep("a")
    assert names(tmp_path) == []
