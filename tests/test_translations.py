# SPDX-License-Identifier: LGPL-2.1-or-later
"""No text of the window escapes translation: read from the syntax trees of ``gui`` and from the .ts files."""

import ast
import json
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tools"))

import translations  # noqa: E402
from window_texts import Text  # noqa: E402

from freecad_trabecula.core.explanations.registry import all_keys, explanation  # noqa: E402

#: Functions and methods that show what they are given: places of the texts among their arguments; None: all.
SHOWS = {
    **dict.fromkeys(
        ("setText", "setToolTip", "setWindowTitle", "setTitle", "setPlaceholderText", "setStatusTip"), None
    ),
    **dict.fromkeys(("setPrefix", "setSuffix", "setLabelText", "setFormat", "setHorizontalHeaderLabels"), None),
    **dict.fromkeys(("setHeaderLabels", "setVerticalHeaderLabels", "QLabel", "QPushButton", "QCheckBox"), None),
    **dict.fromkeys(("QRadioButton", "QAction", "QGroupBox", "QListWidgetItem", "QTableWidgetItem"), None),
    **dict.fromkeys(("QTreeWidgetItem", "QDockWidget", "QProgressDialog", "QMessageBox"), None),
    **dict.fromkeys(("warning", "information", "question", "critical", "say", "show_error"), None),
    **dict.fromkeys(("getOpenFileName", "getSaveFileName", "getExistingDirectory", "getText", "getInt"), None),
    **dict.fromkeys(("Figure", "Checked", "Row", "Diagram", "PanelForm"), (0, 1)),
    **dict.fromkeys(("SwitchField", "WholeField", "TextField", "PointField", "ChoiceField", "NumberField"), None),
    **dict.fromkeys(("addItem", "addItems", "addRow", "addTab", "insertTab", "setTabText"), None),
    **dict.fromkeys(("transaction", "write_step"), (1,)),
    **dict.fromkeys(("openTransaction", "_do"), (0,)),
    **dict.fromkeys(("PrintMessage", "PrintWarning", "PrintError"), None),
    "small_button": (1, 3),
    "drawText": None,
}
#: Functions that give a text in the language of the window.
TRANSLATES = ("translate", "in_words", "description", "choice", "filled", "icon", "icon_path", "_doc")
TRANSLATES += ("local_number", "place_text", "with_decimals", "offer_words", "_text")
#: What is the same in every language: units, axes, tags of rich text, names of programs and of FreeCAD's icons.
PLAIN = re.compile(
    r"</?\w+[^>]*>?|\(\*\.\w+\)|^Trabecula_\w+$|\b(mm|GB|MB|kB|min|nan|inf|XYZ|UV|Face|Trabecula|STL|SSL|SVG|PNG|HTML|CSV|XLSX|pip)\b|mm[²³23]?"
)
WORD = re.compile(r"[A-Za-zÀ-ž]{2,}")


def gui_trees():
    """Return path and syntax tree of each module of the window."""
    paths = sorted((ROOT / "freecad_trabecula" / "gui").glob("*.py"))
    return [(path.name, ast.parse(path.read_text(encoding="utf-8"))) for path in paths]


def name_of(call):
    """Return the last word of what is called."""
    return getattr(call.func, "id", getattr(call.func, "attr", ""))


def bare_words(node):
    """Yield the words of literals in an expression that no translation has seen."""
    if isinstance(node, ast.Call):
        if name_of(node) in TRANSLATES:
            return
        receiver = node.func.value if isinstance(node.func, ast.Attribute) else None
        names = {
            "get",
            "property",
            "itemData",
            "findChild",
            "getattr",
            "hasattr",
            "strftime",
            "join",
            "replace",
            "split",
        }
        if name_of(node) in names:
            if name_of(node) == "join":
                yield from bare_words(node.args[0])
            return
        for one in ([receiver] if receiver is not None else []) + node.args + [key.value for key in node.keywords]:
            yield from bare_words(one)
    elif isinstance(node, ast.Constant) and isinstance(node.value, str):
        if WORD.search(PLAIN.sub("", node.value)):
            yield node.value
    elif isinstance(node, (ast.Subscript, ast.Compare, ast.Lambda, ast.Dict)):
        return
    elif isinstance(node, ast.IfExp):
        yield from bare_words(node.body)
        yield from bare_words(node.orelse)
    elif isinstance(node, ast.FormattedValue):
        yield from bare_words(node.value)
    else:
        for child in ast.iter_child_nodes(node):
            yield from bare_words(child)


def escaped(tree):
    """Return (line, text) of each literal that is shown as it is."""
    found = []
    constants = {line.targets[0].id: line.value for line in tree.body if is_constant(line)}
    for call in (node for node in ast.walk(tree) if isinstance(node, ast.Call)):
        name = name_of(call)
        if name in SHOWS:
            places = SHOWS[name]
            shown = [one for place, one in enumerate(call.args) if places is None or place in places]
            shown += [key.value for key in call.keywords if key.arg in ("tip", "text", "title")]
            shown = [constants.get(getattr(one, "id", ""), one) for one in shown]
            found += [(call.lineno, words) for one in shown for words in bare_words(one)]
    return found


def is_constant(line):
    """Return whether a line of a module gives a name to a literal."""
    return (
        isinstance(line, ast.Assign) and isinstance(line.targets[0], ast.Name) and isinstance(line.value, ast.Constant)
    )


@pytest.mark.parametrize("source", [
    "box.setToolTip('Size of a pore')",
    "QtGui.QLabel(f'{count} rods')",
    "say('was written' if done else translate('Trabecula', 'failed'))",
    "button.setText('<b>' + 'Build' + '</b>')",
    "document.openTransaction('Design rods')",
    "STEP = 'Open envelope'\nwith transaction(document, STEP): pass",
    "FreeCAD.Console.PrintWarning(f'{label} lost its face')",
])  # fmt: skip
def test_a_literal_that_is_shown_as_it_is_would_be_found(source):
    assert len(escaped(ast.parse(source))) == 1


@pytest.mark.parametrize("source", [
    "box.setToolTip(translate('Trabecula', 'Size of a pore'))",
    "label.setText(f'<b>{local_number(size, \".2f\")} mm</b>')",
    "label.setText(values['name of a key'])",
    "say(translate('Trabecula', '{} was written').format(path))",
])  # fmt: skip
def test_what_is_translated_or_the_same_everywhere_is_not_taken_for_a_literal(source):
    assert escaped(ast.parse(source)) == []


def test_no_literal_is_shown_without_translation():
    found = [f"{name}:{line}: {words!r}" for name, tree in gui_trees() for line, words in escaped(tree)]
    assert found == []


def test_what_objects_write_to_the_report_view_is_put_into_words():
    paths = sorted((ROOT / "freecad_trabecula" / "features").glob("*.py"))
    trees = [(path.name, ast.parse(path.read_text(encoding="utf-8"))) for path in paths]
    assert [f"{name}:{line}: {words!r}" for name, tree in trees for line, words in escaped(tree)] == []


def untranslated_numbers(tree):
    """Return (line, text) of each number that is written with Python's own signs, outside of an error or a warning."""
    quiet = {id(node) for one in ast.walk(tree) if isinstance(one, ast.Raise) for node in ast.walk(one)}
    for call in (node for node in ast.walk(tree) if isinstance(node, ast.Call)):
        if name_of(call) in ("_tell", "PrintWarning", "PrintLog", "PrintMessage"):
            quiet |= {id(node) for node in ast.walk(call)}
    found = []
    for node in ast.walk(tree):
        if isinstance(node, ast.FormattedValue) and node.format_spec is not None and id(node) not in quiet:
            parts = [part.value for part in node.format_spec.values if isinstance(part, ast.Constant)]
            spec = "".join(parts)
            if re.search(r"[efg%,]", spec) and not spec.endswith(".0f"):
                found.append((node.lineno, spec))
        if isinstance(node, ast.Call) and name_of(node) == "format" and id(node) not in quiet:
            texts = [one.value for one in ast.walk(node.func) if isinstance(one, ast.Constant)]
            found += [(node.lineno, text) for text in texts if re.search(r"\{\w*:[^}]*[efg%,]\}", str(text))]
    return found


@pytest.mark.parametrize("source", ["label.setText(f'{x:.2f} mm')", "'{:.3g} mm'.format(x)", "say(f'{count:,}')"])
def test_a_number_with_points_in_every_language_would_be_found(source):
    assert len(untranslated_numbers(ast.parse(source))) == 1


def test_no_number_of_the_window_has_a_point_in_every_language():
    trees = [(name, tree) for name, tree in gui_trees() if name not in ("language.py", "help_pages.py", "qt.py")]
    assert [f"{name}:{line}: {text}" for name, tree in trees for line, text in untranslated_numbers(tree)] == []


def test_every_translate_has_literals_that_the_command_can_find():
    found = []
    for name, tree in gui_trees():
        calls = (node for node in ast.walk(tree) if isinstance(node, ast.Call) and name_of(node) == "translate")
        for call in calls:
            if not all(isinstance(one, ast.Constant) for one in call.args[:2]) and name != "language.py":
                found.append(f"{name}:{call.lineno}: {ast.unparse(call)}")
    assert found == []


# ---------------------------------------------------------------------------------------------- the files themselves


@pytest.fixture(scope="module")
def texts():
    """Return all texts, read in a process of its own: the stand-ins for FreeCAD must not stay in this one."""
    done = subprocess.run([sys.executable, str(ROOT / "tools" / "window_texts.py")], capture_output=True, check=True)
    return {Text(context, source): set(files) for context, source, files in json.loads(done.stdout)}


def test_texts_of_every_kind_are_found(texts):
    for context, source in (
        ("Trabecula", "Voxel size"),
        ("Trabecula_Design", "Design rods"),
        ("Choices", "trabecular"),
        ("App::Property", "Width along Y"),
        ("App::Property", "Engine that cut the channels"),
        ("Core", "the number of corners of a pore must lie in 3..12, got {}"),
        ("Core", "{} must be at least {}, got {}"),
        ("Core", "porosity {} % by the {} engine"),
        ("Core", "trabecular thickness"),
        ("Core", "divergence theorem over its triangles in double precision"),
        ("Core", "connectivity"),
        ("Core", "numbers by two routes"),
        ("Core", "Not all checks held: see Checks."),
        ("Core", "{}, box of {} mm about {} mm"),
    ):
        assert Text(context, source) in texts


def test_every_refusal_of_the_layers_below_is_among_the_texts(texts):
    known = " ".join(text.source for text in texts if text.context == "Core")
    missed, count = [], 0
    for path in sorted((ROOT / "freecad_trabecula").rglob("*.py")):
        if path.relative_to(ROOT / "freecad_trabecula").parts[0] not in ("core", "geometry", "features"):
            continue
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            said = node.exc.args[:1] if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call) else []
            parts = getattr(said[0], "values", said) if said else []
            pieces = [one.value for one in parts if isinstance(one, ast.Constant) and isinstance(one.value, str)]
            longest = max(pieces, key=len, default="")
            count += bool(longest)
            if len(WORD.findall(longest)) > 1 and longest.replace("{", "{{").replace("}", "}}") not in known:
                missed.append(f"{path.name}:{node.lineno}: {longest}")
    assert count > 200
    assert "\n".join(missed) == ""


def test_all_that_an_explanation_says_is_among_the_texts(texts):
    said = {one for key in all_keys() for one in explanation(key)[1:8] if one and one != explanation(key).symbol}
    assert len(said) > 250
    forms = [re.compile(".*".join(map(re.escape, text.source.split("{}")))) for text in texts if text.context == "Core"]
    # articles, formulas and units are the same everywhere
    free = re.compile(r"[A-Z].* \d{4}\b.*|[\w^/ .²³%]*\d|[\w/%²³]{1,3}|1/mm³?")
    left = sorted(one for one in said if not any(form.fullmatch(one) for form in forms) and not free.fullmatch(one))
    assert left == []


@pytest.mark.parametrize("language", translations.LANGUAGES)
def test_every_text_of_the_window_is_translated_with_its_placeholders_and_mnemonics(language, texts):
    done = translations.read_ts(translations.ts_path(language))
    found = translations.faults(texts, done)
    assert not found, "run make translations, and fill in what is new:\n" + "\n".join(found)


def test_a_text_that_is_missing_and_one_without_a_source_are_told():
    new, old = Text("Trabecula", "new"), Text("Core", "old")
    assert [fault.split(":")[0] for fault in translations.faults({new: set()}, {old: "alt"})] == [
        "not translated",
        "no source any more",
    ]


@pytest.mark.parametrize("language", translations.LANGUAGES)
def test_the_file_of_a_language_is_what_the_command_writes(language, texts, tmp_path):
    path, again = translations.ts_path(language), tmp_path / "again.ts"
    translations.write_ts(again, language, texts, translations.read_ts(path))
    assert again.read_text(encoding="utf-8") == path.read_text(encoding="utf-8"), "run make translations"


def test_a_translation_with_another_placeholder_is_told():
    text = Text("Trabecula", "{} of {:.2f}")
    for translation in ("{} von", "{:.2f} von {}", "{} von {:.3f}"):
        assert translations.faults({text: set()}, {text: translation})
    for translation in ("{} von {:.2f}", "{1:.2f}, davon {0}"):
        assert translations.faults({text: set()}, {text: translation}) == []


def test_what_was_translated_stays_and_what_is_new_is_unfinished(tmp_path):
    path, old, new = tmp_path / "x.ts", Text("Trabecula", "A & <b>"), Text("Trabecula", "new")
    translations.write_ts(
        path, "de", {old: {"a.py"}, new: {"b.py"}}, {old: "Ä & <b>", Text("Trabecula", "gone"): "weg"}
    )
    assert translations.read_ts(path) == {old: "Ä & <b>"}
    assert 'type="unfinished"' in path.read_text(encoding="utf-8")
    assert "weg" not in path.read_text(encoding="utf-8")
