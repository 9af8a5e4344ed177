# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every text that can reach the window, read from the sources: what ``tools/translations.py`` puts into its files.

Texts are ordered by their context, as Qt has it:

* ``Trabecula``: literals handed to ``translate("Trabecula", ...)`` in ``gui/``;
* ``Trabecula_...``: text and tooltip of a command; FreeCAD asks for them under the command's name;
* ``Workbench``: titles of menu and toolbars, and what ``InitGui.py`` says of the workbench;
* ``App::Property``: what a property or a field of a panel is (its tooltip), of parameter classes and features;
* ``Labels``: labels of new objects (``gui/labels.py``);
* ``Choices``: the words of combo boxes, which documents and files keep as they stand in the code;
* ``Core``: what core, geometry and features say, and what gui refuses: refusals, states, notes, names of measures,
  steps of long work. Of an f-string the template is kept, with ``{}`` for each value; ``gui/language.py`` finds it
  again when a message is shown;
* the class of a form in ``resources/ui``: its labels and tooltips.

Of the package only the modules of parameters are run, with a stand-in for FreeCAD: any Python with numpy can do it.
"""

from __future__ import annotations

import ast
import importlib
import json
import sys
import xml.etree.ElementTree as ElementTree
from dataclasses import fields
from pathlib import Path
from typing import Any, Dict, Iterable, Iterator, NamedTuple, Optional, Sequence, Set, Tuple
from unittest.mock import MagicMock

from core_texts import PAGES, WRITTEN, Page, Speech, callee, literal

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "freecad_trabecula"
#: Layers below the window, whose messages are shown in it.
BELOW = ("core", "geometry", "features", "shell/worker.py")
MARKS = ("translate", "QT_TRANSLATE_NOOP")
#: Functions that make a property, and the place of what it is among their arguments, its group before it.
DOCUMENTED = {"Property": 3, "result": 2, "addProperty": 3}


class Text(NamedTuple):
    """A text and its context."""

    context: str
    source: str


Found = Dict[Text, Set[str]]


def window_texts() -> Found:
    """Return all texts, each with the files that hold it."""
    found: Found = {}
    for texts in (_marked(), _commands(), _choices(), _properties(), _below(), _forms()):
        for text, file in texts:
            if text.source.strip():
                found.setdefault(text, set()).add(file)
    return found


# ------------------------------------------------------------------------------------------------ reading sources


def _modules(*places: str) -> Iterator[Tuple[str, ast.Module]]:
    """Yield path and syntax tree of each module below some places of the package."""
    for place in places:
        start = PACKAGE / place
        for path in sorted(start.rglob("*.py")) if start.is_dir() else [start]:
            yield str(path.relative_to(ROOT)), ast.parse(path.read_text(encoding="utf-8"))


def _argument(call: ast.Call, place: int, name: str = "") -> Optional[ast.expr]:
    named = next((one.value for one in call.keywords if name and one.arg == name), None)
    return named if named is not None else (call.args[place] if place < len(call.args) else None)


# -------------------------------------------------------------------------------------------- texts of the window


def _marked() -> Iterator[Tuple[Text, str]]:
    trees = [*_modules("gui"), ("InitGui.py", ast.parse((ROOT / "InitGui.py").read_text(encoding="utf-8")))]
    for file, tree in trees:
        for call in (node for node in ast.walk(tree) if isinstance(node, ast.Call) and callee(node) in MARKS):
            words = [literal(node) for node in call.args[:2]]
            if None not in words:
                yield Text(*words), file


def _commands() -> Iterator[Tuple[Text, str]]:
    """Texts of the classes that have a NAME, in the order in which FreeCAD would ask for them."""
    for file, tree in _modules("gui"):
        for node in (one for one in ast.walk(tree) if isinstance(one, ast.ClassDef)):
            values = dict(_class_values(node))
            for key in ("TEXT", "TIP"):
                if values.get("NAME") and values.get(key):
                    yield Text(values["NAME"], values[key]), file


def _class_values(node: ast.ClassDef) -> Iterator[Tuple[str, str]]:
    for line in (one for one in node.body if isinstance(one, ast.Assign)):
        names, values = line.targets[0], line.value
        pairs = zip(names.elts, values.elts) if isinstance(names, ast.Tuple) and isinstance(values, ast.Tuple) else ()
        for name, value in pairs or ((names, values),):
            if isinstance(name, ast.Name) and literal(value):
                yield name.id, literal(value)


def _forms() -> Iterator[Tuple[Text, str]]:
    for path in sorted((ROOT / "resources" / "ui").glob("*.ui")):
        tree = ElementTree.parse(path).getroot()
        for node in tree.iter("string"):
            if node.get("notr") != "true":
                yield Text(tree.findtext("class"), node.text or ""), str(path.relative_to(ROOT))


# ---------------------------------------------------------------------------------------- choices and properties


def _choices() -> Iterator[Tuple[Text, str]]:
    for cls in parameter_classes():
        for field in fields(cls):
            for word in field.metadata.get("choices", ()):
                yield Text("Choices", word), _file_of(cls)
    for file, tree in _modules("gui"):
        for call in (node for node in ast.walk(tree) if isinstance(node, ast.Call)):
            if callee(call) in ("ChoiceField", "offer_words") and isinstance(call.args[0], (ast.Name, ast.Tuple)):
                words = _words(call.args[0], file)
                is_open = not getattr(call.args[0], "elts", ["?"]) or getattr(call.args[0], "id", "") in ("choices",)
                if not words and not is_open:
                    raise ValueError(f"{file}:{call.lineno}: the words of this choice are found nowhere")
                for word in words:
                    yield Text("Choices", word), file


def _words(node: ast.expr, file: str) -> Sequence[str]:
    """The words of a tuple, or of a name or call that stands for one; none of what only a document knows."""
    if isinstance(node, (ast.Tuple, ast.List)):
        return [word for one in node.elts for word in _words(one, file)]
    if isinstance(node, ast.Starred):
        return _words(node.value, file)
    if literal(node):
        return [literal(node)]
    if isinstance(node, ast.Call) and callee(node) in ("tuple", "list") and node.args:
        return _words(node.args[0], file)
    name = getattr(node, "id", "") or (callee(node) if isinstance(node, ast.Call) else "")
    for line in ast.parse((ROOT / file).read_text(encoding="utf-8")).body:
        if isinstance(line, ast.Assign) and any(isinstance(one, ast.Name) and one.id == name for one in line.targets):
            return _words(line.value, file)
        if isinstance(line, ast.Assign) and isinstance(line.targets[0], ast.Tuple):
            names = [getattr(one, "id", "") for one in line.targets[0].elts]
            if name in names and isinstance(line.value, ast.Tuple):
                return _words(line.value.elts[names.index(name)], file)
        if isinstance(line, ast.ImportFrom) and any((one.asname or one.name) == name for one in line.names):
            return _imported(line, name, file)
    return []


def _imported(line: ast.ImportFrom, name: str, file: str) -> Sequence[str]:
    package = Path(file).parent
    for _ in range(line.level - 1):
        package = package.parent
    if package.parts[1:2] == ("core",) or (line.module or "").startswith("core"):
        with _StandIns():
            module = importlib.import_module(".".join((*package.parts, *(line.module or "").split("."))))
        value = getattr(module, name)
        value = value() if callable(value) else value
        return [word for word in value if isinstance(word, str)]
    path = package.joinpath(*(line.module or "").split(".")).with_suffix(".py")
    return _words(ast.Name(name), str(path)) if (ROOT / path).is_file() else []


class _StandIns:
    """Lets modules that import FreeCAD be read where there is none."""

    NAMES = ("FreeCAD", "Part", "Mesh", "MeshPart")

    def __enter__(self) -> None:
        sys.path.insert(0, str(ROOT))
        for name in self.NAMES:
            sys.modules.setdefault(name, MagicMock())

    def __exit__(self, *_: Any) -> None:
        sys.path.remove(str(ROOT))


def parameter_classes() -> Iterable[type]:
    """Return the classes of parameters that objects and panels are made of."""
    with _StandIns():
        base = importlib.import_module("freecad_trabecula.features.base")
        core = importlib.import_module("freecad_trabecula.core.parameters")
    every = [*base.BINDINGS, *(one for one in vars(core).values() if isinstance(one, type))]
    return [cls for cls in dict.fromkeys(every) if hasattr(cls, "__dataclass_fields__")]


def _file_of(cls: type) -> str:
    return cls.__module__.replace(".", "/") + ".py"


def _properties() -> Iterator[Tuple[Text, str]]:
    with _StandIns():
        base = importlib.import_module("freecad_trabecula.features.base")
    for cls in parameter_classes():
        for field in fields(cls):
            if "doc" in field.metadata:
                yield Text("App::Property", field.metadata["doc"]), _file_of(cls)
    for cls in base.BINDINGS:
        for doc in (*base.descriptions(cls), base.BINDINGS[cls].group):
            yield Text("App::Property", doc), _file_of(cls)
    for file, tree in _modules("features"):
        for call in (node for node in ast.walk(tree) if isinstance(node, ast.Call)):
            place = DOCUMENTED.get(callee(call))
            if place is None:
                continue
            group = _argument(call, place - 1, "group") if callee(call) != "result" else None
            for text in (literal(_argument(call, place, "doc")), literal(group)):
                if text:
                    yield Text("App::Property", text), file


# ---------------------------------------------------------------------------------------- what the layers below say


def _below() -> Iterator[Tuple[Text, str]]:
    for file, tree in _modules(*BELOW):
        speech = Page(tree) if file.endswith(PAGES) else Speech(tree, is_written=file.endswith(WRITTEN))
        for template in speech.templates:
            yield Text("Core", template), file
    for file, tree in _modules("gui"):  # its own refusals; all else that it says is marked
        for template in Speech(tree, is_written=True).templates:
            yield Text("Core", template), file


def main() -> int:
    """Print the texts as JSON, for tests that must not load stand-ins."""
    rows = [[text.context, text.source, sorted(files)] for text, files in window_texts().items()]
    print(json.dumps(rows, ensure_ascii=False, indent=0))
    return 0


if __name__ == "__main__":
    sys.exit(main())
