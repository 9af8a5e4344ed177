# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a script ends: its exit code is the truth, its last words are printed."""

import pytest

from freecad_trabecula.shell.script import run_script


def test_a_script_that_does_its_work_ends_with_0(capsys):
    with pytest.raises(SystemExit) as end:
        run_script(lambda: print("done"))
    assert (end.value.code, capsys.readouterr().out) == (0, "done\n")


@pytest.mark.parametrize("error", [ValueError("no size"), KeyboardInterrupt(), SystemExit(0)])
def test_a_script_that_raises_ends_with_1_and_its_trace(capsys, error):
    def main():
        raise error

    with pytest.raises(SystemExit) as end:
        run_script(main)
    said = capsys.readouterr().err
    assert end.value.code == 1
    assert said.startswith("Traceback") and type(error).__name__ in said and str(error) in said
