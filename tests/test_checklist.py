# SPDX-License-Identifier: LGPL-2.1-or-later
"""The forty-five points: all there, answered, and every proof that is named exists."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "checklist.md"


def rows(text):
    """Return (number, point, answer, proof) of the rows."""
    return re.findall(r"^\| (\w+) \| (.+?) \| (yes|no) \| (.*?) ?\|$", text, re.MULTILINE)


def missing_proofs(text, root=ROOT):
    """Return the files, tests and commands that a text names in code and that are not there."""
    missing = []
    rules = re.findall(r"^([\w -]+):", (root / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)
    targets = {name for names in rules for name in names.split()}
    for words in re.findall(r"`([^`]+)`", text):
        name, _, test = words.partition("::")
        if name.startswith("make "):
            is_there = name.split()[1].replace("-latest", "") in targets
        elif "/" in name or name.endswith((".py", ".md", ".xml", ".toml", ".yaml")):
            is_there = (root / name).exists()
            if is_there and test:
                is_there = f"def {test}(" in (root / name).read_text(encoding="utf-8")
        else:
            continue  # a word of the text, no proof
        if not is_there:
            missing.append(words)
    return missing


def test_every_point_has_its_row_in_order_with_an_answer():
    found = rows(PAGE.read_text(encoding="utf-8"))
    assert [number for number, *_ in found] == [*map(str, range(1, 46)), *"abcd"]


def test_every_yes_has_a_proof_that_is_there():
    for number, _, answer, proof in rows(PAGE.read_text(encoding="utf-8")):
        if answer == "yes":
            assert re.search(r"`[^`]*[/.][^`]*`", proof), number
        assert missing_proofs(proof) == [], number


def test_a_proof_that_is_not_there_is_found():
    text = "`tests/none.py` `tests/test_checklist.py::test_nothing` `make nonsense` `.ts` `make test-latest`"
    assert missing_proofs(text) == ["tests/none.py", "tests/test_checklist.py::test_nothing", "make nonsense"]
