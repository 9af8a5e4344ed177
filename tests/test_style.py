# SPDX-License-Identifier: LGPL-2.1-or-later
"""The house style, as far as a machine can hold it (CONTRIBUTING.md has the rest)."""

import ast
import re
import statistics
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "freecad_trabecula"
MODULES = sorted(PACKAGE.rglob("*.py"))
MAX_MODULE_LINES = 400
#: Lines of a function without its docstring.
MAX_FUNCTION_LINES = 60
MAX_MEDIAN_FUNCTION_LINES = 15
#: In two parts: programs that look for licences would take this line for one.
LICENCE = "SPDX-License-" + "Identifier: LGPL-2.1-or-later"
#: A module is a noun of the field.
VAGUE_NAMES = {"util", "utils", "helper", "helpers", "manager", "misc", "common", "tools", "funcs", "stuff"}


def functions_of(path):
    """Return (dotted name, node) of each function of a module, methods included, functions in functions not."""
    found = []

    def visit(node, prefix):
        for child in ast.iter_child_nodes(node):
            if isinstance(child, (ast.FunctionDef, ast.AsyncFunctionDef)):
                found.append((prefix + child.name, child))
            elif isinstance(child, ast.ClassDef):
                visit(child, prefix + child.name + ".")

    visit(ast.parse(path.read_text(encoding="utf-8")), "")
    return found


def code_lines(node):
    """Return how many lines a function has without its docstring."""
    first = node.body[0]
    documented = ast.get_docstring(node) is not None
    return node.end_lineno - node.lineno + 1 - (first.end_lineno - first.lineno + 1 if documented else 0)


def named(path):
    return str(path.relative_to(ROOT))


def test_every_source_file_states_its_licence_in_its_first_lines():
    files = [*ROOT.glob("*.py"), *MODULES, *(ROOT / "tests").rglob("*.py"), *(ROOT / "tools").iterdir()]
    files += (ROOT / "resources" / "examples").glob("*.py")
    sources = [path for path in files if path.suffix in (".py", ".sh")]
    bare = [named(path) for path in sources if LICENCE not in path.read_text(encoding="utf-8")[:200]]
    assert len(sources) > 10
    assert bare == []


def test_no_module_is_longer_than_400_lines():
    lengths = {named(path): path.read_text(encoding="utf-8").count("\n") for path in MODULES}
    assert {name: length for name, length in lengths.items() if length > MAX_MODULE_LINES} == {}


def code_of(path):
    """Return (line number, line without blanks) of a module, without signatures, docstrings, imports and comments."""
    text, left_out = path.read_text(encoding="utf-8"), set()
    for node in ast.walk(ast.parse(text)):
        is_text = isinstance(node, ast.Expr) and isinstance(getattr(node.value, "value", None), str)
        if is_text or isinstance(node, (ast.Import, ast.ImportFrom)):
            left_out.update(range(node.lineno, node.end_lineno + 1))
        elif isinstance(node, ast.FunctionDef):
            left_out.update(range(node.lineno, node.body[0].lineno))
    lines = enumerate((line.strip() for line in text.splitlines()), 1)
    return [(n, line) for n, line in lines if line and n not in left_out and not line.startswith("#")]


def copies(paths, run=6):
    """Return pairs of places that share so many lines of code."""
    seen, found = {}, []
    for path in paths:
        lines = code_of(path)
        for k in range(len(lines) - run + 1):
            place, words = (path, k), tuple(line for _, line in lines[k : k + run])
            first = seen.setdefault(words, place)
            if first != place and not (first[0] == path and k - first[1] < run):
                found.append(f"{path.name}:{lines[k][0]} is like {first[0].name}:{code_of(first[0])[first[1]][0]}")
    return found


def test_no_six_lines_of_code_stand_twice():
    assert copies([*MODULES, *sorted((ROOT / "tools").glob("*.py"))]) == []


def test_six_lines_that_stand_twice_are_found_whatever_their_comments(tmp_path):
    lines = [f"value_{k} = {k}" for k in range(6)]
    (tmp_path / "a.py").write_text("\n".join(lines), encoding="utf-8")
    (tmp_path / "b.py").write_text("import os\n\nif os:\n    " + "\n    # why\n\n    ".join(lines), encoding="utf-8")
    assert copies([tmp_path / "a.py", tmp_path / "b.py"]) == ["b.py:4 is like a.py:1"]
    (tmp_path / "b.py").write_text("\n".join(lines[:5]), encoding="utf-8")
    assert copies([tmp_path / "a.py", tmp_path / "b.py"]) == []


def test_no_function_is_longer_than_60_lines_and_half_are_shorter_than_15():
    lengths = {named(path) + ":" + name: code_lines(node) for path in MODULES for name, node in functions_of(path)}
    assert {name: length for name, length in lengths.items() if length > MAX_FUNCTION_LINES} == {}
    assert statistics.median(lengths.values()) <= MAX_MEDIAN_FUNCTION_LINES


def test_every_public_module_class_and_function_is_documented():
    missing = []
    for path in MODULES:
        tree = ast.parse(path.read_text(encoding="utf-8"))
        nodes = [("module", tree), *((n.name, n) for n in tree.body if isinstance(n, ast.ClassDef))]
        nodes += functions_of(path)
        for name, node in nodes:
            is_private = any(part.startswith("_") for part in name.split("."))
            if not is_private and ast.get_docstring(node) is None:
                missing.append(named(path) + ":" + name)
    assert missing == []


def test_every_argument_is_hinted_but_self():
    bare, total = [], 0
    for path in MODULES:
        for name, node in functions_of(path):
            arguments = [a for a in node.args.args + node.args.kwonlyargs if a.arg not in ("self", "cls")]
            total += len(arguments)
            bare += [named(path) + ":" + name + "(" + a.arg + ")" for a in arguments if a.annotation is None]
    # FreeCAD's own classes have no names to hint with on every version, hence not all.
    assert len(bare) <= 0.05 * total, bare


def broad_errors(tree):
    """Return the lines where any error at all is raised, or caught and kept; what is raised again may be caught."""
    broad = ("Exception", "BaseException")
    lines = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Raise) and node.exc is not None:
            raised = node.exc.func if isinstance(node.exc, ast.Call) else node.exc
            if getattr(raised, "id", "") in broad:
                lines.append(node.lineno)
        if isinstance(node, ast.ExceptHandler) and (node.type is None or getattr(node.type, "id", "") in broad):
            is_raised_again = any(isinstance(child, ast.Raise) and child.exc is None for child in ast.walk(node))
            if not is_raised_again:
                lines.append(node.lineno)
    return lines


def test_no_error_is_raised_or_swallowed_without_a_name():
    trees = {named(path): ast.parse(path.read_text(encoding="utf-8")) for path in MODULES}
    assert {name: broad_errors(tree) for name, tree in trees.items() if broad_errors(tree)} == {}


def test_an_error_that_is_swallowed_or_raised_without_a_name_is_found():
    swallowed = "try:\n    f()\nexcept Exception:\n    pass\n"
    assert broad_errors(ast.parse(swallowed)) == [3]
    assert broad_errors(ast.parse(swallowed.replace("pass", "raise"))) == []
    assert broad_errors(ast.parse("raise Exception('no')\n")) == [1]


def test_modules_are_named_for_what_they_hold():
    assert [named(path) for path in MODULES if path.stem in VAGUE_NAMES] == []


def test_random_numbers_come_from_streams_only():
    pattern = re.compile(r"np\.random|numpy\.random|^\s*(import|from) random\b", re.MULTILINE)
    found = [named(path) for path in MODULES if pattern.search(path.read_text(encoding="utf-8"))]
    assert [name for name in found if name != "freecad_trabecula/core/streams.py"] == []


#: Called by FreeCAD and Qt, by the names that they give.
_CALLED_FROM_OUTSIDE = re.compile(
    r"(slot|visit_|print_help$|[a-z]+Event$|load_tests$|Get[A-Z]|Is[A-Z]|[a-z]+[A-Z]\w*$|Activated$|allow$|Initialize$|execute$)"
)
#: For tests, scripts and what is yet to come: formulas of the thesis with a closed form, migrations, views of results.
_FOR_OTHERS = {
    *("all_keys", "colour_at", "colouring_of", "component_volumes", "contours_csv", "count_layer", "format_field"),
    *(
        "free_solutions",
        "is_sound",
        "legends_of",
        "measure_voxels",
        "page_of_command",
        "rename_property",
        "row_designs",
    ),
}


def names_used(trees):
    """Return every name that some code uses: as a name, an attribute, a keyword, or a word of a text."""
    used = set()
    for tree in trees:
        for node in ast.walk(tree):
            if isinstance(node, ast.Name):
                used.add(node.id)
            elif isinstance(node, ast.Attribute):
                used.add(node.attr)
            elif isinstance(node, ast.Constant) and isinstance(node.value, str) and " " not in node.value:
                used.update(re.findall(r"\w+", node.value))
    return used


def unused(trees, paths):
    """Return the functions and classes of modules that nothing names, but where they are defined."""
    used = names_used(trees)
    return [
        f"{path.name}:{node.name}"
        for path, tree in zip(paths, trees)
        for node in ast.walk(tree)
        if isinstance(node, (ast.FunctionDef, ast.ClassDef))
        and node.name not in used | _FOR_OTHERS
        and not node.name.startswith("__")
        and not _CALLED_FROM_OUTSIDE.match(node.name)
    ]


def test_there_is_no_function_that_nothing_calls():
    paths = [*MODULES, *sorted((ROOT / "tools").glob("*.py")), *sorted((ROOT / "resources").rglob("*.py"))]
    paths += sorted(ROOT.glob("*.py"))
    trees = [ast.parse(path.read_text(encoding="utf-8")) for path in paths]
    assert unused(trees, paths) == []
    defined = {node.name for tree in trees for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)}
    assert _FOR_OTHERS - defined == set()  # one that is gone goes here too


def test_a_function_that_nothing_calls_is_found():
    tree = ast.parse("def f():\n    return g()\n\ndef g():\n    return 1\n\ndef h():\n    return f()\n")
    assert unused([tree], [Path("a.py")]) == ["a.py:h"]
