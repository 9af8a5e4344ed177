# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line in a process of its own, as a user runs it, and what it leaves in a folder."""

import json
import os
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

from freecad_trabecula.shell.arguments import read_arguments

ROOT = Path(__file__).resolve().parents[2]
#: -S leaves out the folders where numpy is: a Python with the standard library alone.
BARE = [sys.executable, "-S", "-m", "freecad_trabecula"]


def run(*words, python=None, timeout=180, **environment):
    """Run a command to its end."""
    return subprocess.run(
        [*(python or BARE), *map(str, words)],
        cwd=str(ROOT),
        env=dict(os.environ, **environment),
        capture_output=True,
        text=True,
        timeout=timeout,
    )


def names(folder):
    """Return the names of what is in a folder."""
    return sorted(path.name for path in folder.iterdir())


def report_of(folder):
    """Return the report that a command left."""
    return json.loads((folder / "report.json").read_text(encoding="utf-8"))


def check_a_full_disk(*words):
    """Run a command where no file may be larger than 100 kB: exit code 1, and it says that nothing was written."""
    line = " ".join(shlex.quote(str(word)) for word in [*BARE, *words])
    done = run("-c", f"ulimit -f 100; {line}", python=["bash"], timeout=120)
    assert done.returncode == 1
    assert "could not be written" in done.stderr and "nothing was written" in done.stderr


def check_refusal(words, message, capsys):
    """Read arguments that are refused: exit code 2, one sentence with a message on stderr, nothing on stdout."""
    with pytest.raises(SystemExit) as stop:
        read_arguments(words)
    said = capsys.readouterr()
    assert stop.value.code == 2
    assert message in said.err
    assert said.err.count("\n") == 1
    assert said.out == ""
