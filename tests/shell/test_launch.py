# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD as a child: what it says arrives, its end is believed only when it is said, its remains are removed."""

from __future__ import annotations

import os
import shlex
import signal
import stat
import subprocess
import sys
import time
from pathlib import Path

import pytest

from freecad_trabecula.errors import DependencyError
from freecad_trabecula.shell import launch

ROOT = Path(__file__).resolve().parents[2]
#: A command as FreeCAD sees it: a module with run(options, report).
COMMAND = """
import os, sys, time
from freecad_trabecula.errors import ParameterError, ExportError, Cancelled, KernelError

def run(options, report):
    what = options["what"]
    if what == "echo":
        import FreeCAD
        report("progress", share=0.5, what="half-way")
        report("text", text="%r %r" % (options["words"], sys.argv[1:]))
        return options["code"]
    if what == "raise":
        raise {"parameter": ParameterError("n must be at least 2, got 1"), "export": ExportError("disk full"),
               "kernel": KernelError("volumes differ"), "bug": ZeroDivisionError("division by zero"),
               "memory": MemoryError(), "exit": SystemExit(0)}[options["error"]]
    if what == "die":
        report("temporary", path=options["folder"])
        os.kill(os.getpid(), options["signal"])
    if what == "leave":
        os._exit(0)
    if what == "wait":
        os.makedirs(options["folder"])
        report("temporary", path=options["folder"])
        report("text", text="waiting")
        while True:
            time.sleep(0.05)
            if not options["deaf"]:
                report("progress", share=0.1, what="waiting")
    if what == "chatter":
        print("chatter", end="")
        sys.stdout.flush()
        os.write(1, b"no line end")
        report("text", text="said")
        return 0
"""


@pytest.fixture
def command(tmp_path, monkeypatch):
    (tmp_path / "trabecula_test_command.py").write_text(COMMAND)
    start = tmp_path / "start.py"  # 1.1 takes no PYTHONPATH
    start.write_text(f"import sys, runpy\nsys.path.insert(0, {str(tmp_path)!r})\nrunpy.run_path({launch.START!r})\n")
    monkeypatch.setattr(launch, "START", str(start))
    return "trabecula_test_command"


def run(command, **options):
    messages = []
    child = launch.Child(command, options, messages.append)
    return child.wait(), messages, child


def texts(messages, kind):
    return [m["text"] for m in messages if m["kind"] == kind]


def gone(pid, seconds=10.0):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        try:
            os.kill(pid, 0)
            state = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0]
            if state == "Z":
                return True
        except (ProcessLookupError, FileNotFoundError):
            return True
        time.sleep(0.05)
    return False


# ------------------------------------------------------------------------------------------------------ messages


def test_options_reach_the_command_whatever_they_look_like(command):
    words = ["--help", "-c", "import os", "ä€😀", "a b\n", "=", ""]
    code, messages, _ = run(command, what="echo", words=words, code=0)
    assert code == 0
    assert texts(messages, "text") == ["%r %r" % (words, [])] or repr(words) in texts(messages, "text")[0]
    assert [m for m in messages if m["kind"] == "progress"] == [{"kind": "progress", "share": 0.5, "what": "half-way"}]


@pytest.mark.parametrize("expected", [0, 1, 2, 130])
def test_the_exit_code_is_that_of_the_command(command, expected):
    assert run(command, what="echo", words=[], code=expected)[0] == expected


def test_messages_are_found_among_freecads_chatter(command):
    code, messages, child = run(command, what="chatter")
    assert (code, texts(messages, "text")) == (0, ["said"])
    trace = Path(child.save_trace())
    assert "no line end" in trace.read_text()
    trace.unlink()


def test_lines_without_the_mark_are_no_messages():
    assert launch.decode("(12 %)\n") is None
    assert launch.decode(launch.MARK + "{half") is None
    line = launch.encode({"kind": "text", "text": "a\nb"}).decode("ascii")
    assert launch.decode(line.strip("\n")) == {"kind": "text", "text": "a\nb"}
    assert line.count("\n") == 2


# ------------------------------------------------------------------------------------------------------- failures


def test_wrong_input_gives_its_sentence_and_exit_code_2(command):
    code, messages, _ = run(command, what="raise", error="parameter")
    assert (code, texts(messages, "error")) == (2, ["n must be at least 2, got 1"])


@pytest.mark.parametrize(
    ("error", "sentence"),
    [
        ("bug", "unexpected ZeroDivisionError: division by zero"),
        ("kernel", "volumes differ"),
        ("memory", "there is not enough memory"),
    ],
)
def test_what_was_not_foreseen_leaves_its_trace(command, error, sentence):
    code, messages, child = run(command, what="raise", error=error)
    assert code == 1
    assert len(texts(messages, "error")) == 1 and sentence in texts(messages, "error")[0]
    assert messages[-1]["unexpected"]
    trace = Path(child.save_trace())
    assert "Traceback" in trace.read_text() and "trabecula_test_command.py" in trace.read_text()
    trace.unlink()


def test_a_file_that_cannot_be_written_needs_no_trace(command):
    code, messages, _ = run(command, what="raise", error="export")
    assert (code, texts(messages, "error")) == (1, ["disk full; nothing was written"])
    assert not messages[-1].get("unexpected")


def test_leaving_by_exit_is_no_success(command):
    assert run(command, what="raise", error="exit")[0] == 1


def test_a_module_that_is_not_there_is_no_success():
    code, messages, _ = run("trabecula_no_such_command")
    assert code == 1
    assert "No module named" in texts(messages, "error")[0]


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGSEGV])
def test_a_crash_is_said_and_its_temporary_folder_removed(command, tmp_path, number):
    folder = tmp_path / "left"
    folder.mkdir()
    (folder / "half").write_text("half")
    code, messages, _ = run(command, what="die", folder=str(folder), signal=int(number))
    assert code == 1
    assert "FreeCAD ended before its work was done" in texts(messages, "error")[0]
    assert not folder.exists()


def test_an_end_without_a_word_is_no_success(command):
    code, messages, _ = run(command, what="leave")
    assert code == 1
    assert "(exit code 0)" in texts(messages, "error")[0]


@pytest.mark.parametrize("deaf", [False, True])
def test_a_stopped_command_ends_within_seconds_and_leaves_nothing(command, tmp_path, deaf):
    folder = tmp_path / "temporary"
    messages = []
    child = launch.Child(command, {"what": "wait", "folder": str(folder), "deaf": deaf}, messages.append)

    def stop(message):
        raise KeyboardInterrupt

    child._receive = stop
    with pytest.raises(KeyboardInterrupt):
        child.wait()
    assert folder.exists()
    start = time.monotonic()
    child.stop()
    assert time.monotonic() - start < 8
    assert not folder.exists()
    assert gone(child._process.pid)


def test_the_child_of_a_killed_starter_ends_by_itself_and_tidies_up(command, tmp_path):
    folder = tmp_path / "temporary"
    script = (
        "import sys; sys.path.insert(0, sys.argv[1])\n"
        "from freecad_trabecula.shell import launch\n"
        "launch.START = sys.argv[4]\n"
        "child = launch.Child(sys.argv[2], {'what': 'wait', 'folder': sys.argv[3], 'deaf': False},\n"
        "                     lambda m: print(m['kind'], child._process.pid, flush=True))\n"
        "child.wait()"
    )
    words = [sys.executable, "-c", script, str(ROOT), command, str(folder), launch.START]
    starter = subprocess.Popen(words, stdout=subprocess.PIPE)
    kind, pid = starter.stdout.readline().split()
    assert kind == b"text" and folder.exists()
    starter.kill()
    starter.communicate()
    assert gone(int(pid))
    assert not folder.exists()


# ------------------------------------------------------------------------------------------------ finding FreeCAD


def test_freecadcmd_comes_before_the_path(tmp_path, monkeypatch):
    program = tmp_path / "my freecad"
    program.write_text("#!/bin/sh\n")
    program.chmod(program.stat().st_mode | stat.S_IXUSR)
    monkeypatch.setenv("FREECADCMD", str(program))
    assert launch.freecad_program() == [str(program)]


def test_freecadcmd_may_have_words_of_its_own(monkeypatch):
    monkeypatch.setenv("FREECADCMD", f"{sys.executable} -c 'a b'")
    assert launch.freecad_program() == [sys.executable, "-c", "a b"]


def test_the_path_is_searched_for_every_name(tmp_path, monkeypatch):
    program = tmp_path / "FreeCADCmd"
    program.write_text("#!/bin/sh\n")
    program.chmod(0o755)
    monkeypatch.delenv("FREECADCMD", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    assert launch.freecad_program() == [str(program)]


def test_without_freecad_the_sentence_says_what_to_do(tmp_path, monkeypatch):
    monkeypatch.delenv("FREECADCMD", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(launch.importlib.util, "find_spec", lambda name: None)
    with pytest.raises(
        DependencyError, match=r"none of freecadcmd, FreeCADCmd, .* install FreeCAD .*or set FREECADCMD"
    ):
        launch.freecad_program()


@pytest.mark.parametrize("value", ["/no/such/program", "no-such-program -c", "/"])
def test_a_freecadcmd_that_cannot_be_run_is_refused(value, monkeypatch):
    monkeypatch.setenv("FREECADCMD", value)
    with pytest.raises(DependencyError, match="FREECADCMD must name a program that can be run, got"):
        launch.freecad_program()


def test_a_program_that_is_no_freecad_is_no_success(monkeypatch):
    monkeypatch.setenv("FREECADCMD", "/bin/true")
    code, messages, _ = run("freecad_trabecula.shell.design", out="x")
    assert code == 1
    assert "ended before its work was done (exit code 0)" in texts(messages, "error")[0]


def test_the_environment_of_the_callers_python_does_not_reach_freecads(monkeypatch):
    monkeypatch.setenv("PYTHONHOME", "/elsewhere")
    environment = launch.child_environment("m", {"a": 1})
    assert "PYTHONHOME" not in environment
    assert os.environ["PYTHONHOME"] == "/elsewhere"


# ------------------------------------------------------------------------------------------- streams that are not there


def shell_line(line):
    """Run a line of the shell, in which ``TRABECULA`` is the command line; return exit code, output, errors."""
    program = f"{shlex.quote(sys.executable)} -m freecad_trabecula"
    done = subprocess.run(
        ["bash", "-c", line.replace("TRABECULA", program)], cwd=str(ROOT), capture_output=True, text=True, timeout=120
    )
    return done.returncode, done.stdout, done.stderr


@pytest.mark.parametrize("closed", ["<&-", ">&-", "2>&-", "<&- >&- 2>&-"])
def test_streams_that_are_closed_change_no_exit_code(closed):
    assert shell_line(f"TRABECULA design --preset list {closed}")[0] == 0
    assert shell_line(f"TRABECULA design --preset none --out x {closed}")[0] == 2
    code, _, errors = shell_line(f"TRABECULA {closed}")
    assert (code, "Traceback" in errors) == (2, False)


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="there is no /dev/full")
@pytest.mark.parametrize("words", ["--help", "design --help", "design --preset list"])
def test_an_output_that_cannot_be_written_is_said_in_one_sentence(words):
    code, _, errors = shell_line(f"TRABECULA {words} > /dev/full")
    assert (code, errors.count("\n")) == (1, 1)
    assert "standard output could not be written: No space left on device" in errors


@pytest.mark.parametrize("words", ["design --help", "design --preset list"])
def test_a_reader_that_has_gone_is_no_trace(words):
    assert shell_line(f"TRABECULA {words} | true")[2] == ""


def test_signs_that_the_terminal_does_not_have_are_written_as_their_numbers():
    code, _, errors = shell_line("PYTHONIOENCODING=ascii TRABECULA design --job 日.json --out x")
    assert (code, "Traceback" in errors, "\\u65e5.json" in errors) == (2, False, True)
