# SPDX-License-Identifier: LGPL-2.1-or-later
"""The layers of docs/architecture.md, held: what each module imports is read from its syntax tree, nothing is run.

Runs under pytest, and as ``python3 tests/test_imports.py`` with the standard library alone (3.10 or later).
"""

import ast
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = "freecad_trabecula"

#: Layers: which modules belong to them (the first that fits), what these may import at the top, and what only inside
#: a function. "stdlib" is the standard library; a name that begins with a dot is a layer or module of this package.
#: "bare" modules run in any Python, one without numpy too.
LAYERS = (
    # name, modules, imports, imports inside functions
    (
        "bare",
        (
            *("errors", "__main__", "shell.arguments", "shell.option_values", "shell.slice_options"),
            *("shell.voxel_options", "shell.report_options", "shell.launch", "views"),
        ),
        ("stdlib", ".bare"),
        (),
    ),
    (
        "core",
        ("core.*",),
        ("stdlib", "numpy", ".errors", ".core"),
        ("scipy", "manifold3d", "matplotlib", "openpyxl", "PIL"),
    ),
    (
        "geometry",
        ("geometry.*",),
        ("stdlib", "numpy", "FreeCAD", "Part", "Mesh", "MeshPart", ".errors", ".core", ".geometry"),
        ("scipy", "manifold3d"),
    ),
    (
        "features",
        ("features.*",),
        ("stdlib", "numpy", "FreeCAD", "Part", "Mesh", ".errors", ".core", ".geometry", ".features", ".views"),
        (),
    ),
    (
        "make",
        ("make", "document_files"),
        ("stdlib", "numpy", "FreeCAD", ".errors", ".core", ".geometry", ".features"),
        (),
    ),
    (
        "shell",
        ("shell.*",),
        (*("stdlib", "numpy", "FreeCAD", ".errors", ".core", ".geometry", ".make", ".shell", ".bare"),),
        (),
    ),
    (
        "gui",
        ("gui.*",),
        (
            *("stdlib", "numpy", "FreeCAD", "FreeCADGui", "Part", "Mesh", "MeshPart", "MeshGui", "PySide", "pivy"),
            *(".errors", ".core", ".geometry", ".features", ".make", ".shell", ".gui", ".bare"),
        ),
        (),
    ),
)
#: Top-level files that FreeCAD executes: what they may import at the top. All else waits until the workbench is chosen.
STARTED_BY_FREECAD = {
    "Init.py": ("FreeCAD", PACKAGE),
    "InitGui.py": ("FreeCAD", "FreeCADGui", PACKAGE, PACKAGE + ".views"),
}
#: In the standard library of this Python, but not in that of every Python from 3.8 on.
NOT_ALWAYS_STDLIB = {
    *("annotationlib", "asynchat", "asyncore", "cgi", "cgitb", "compression", "crypt", "distutils"),
    *(
        "graphlib",
        "imghdr",
        "imp",
        "lib2to3",
        "nntplib",
        "pipes",
        "smtpd",
        "sndhdr",
        "telnetlib",
        "tomllib",
        "uu",
        "xdrlib",
        "zoneinfo",
    ),
}
STDLIB = set(sys.stdlib_module_names) - NOT_ALWAYS_STDLIB


class Import:
    """One import statement's target: a dotted name, its line, and where it stands."""

    def __init__(self, name, line, is_lazy, is_for_types):
        self.name = name
        self.line = line
        self.is_lazy = is_lazy
        self.is_for_types = is_for_types


# ---------------------------------------------------------------------------------------------- reading the tree


def module_names(root):
    """Return {dotted name: path} of the package's modules; a package itself goes by its own name."""
    names = {}
    for path in sorted((root / PACKAGE).rglob("*.py")):
        parts = path.relative_to(root).with_suffix("").parts
        names[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return names


def imports_of(source, module, is_package, modules):
    """Return the imports of a module's source, relative ones resolved, dynamic ones with a fixed name included."""
    found = []

    def base_of(node):
        if not node.level:
            return node.module
        parts = module.split(".")
        parts = parts[: len(parts) - node.level + (1 if is_package else 0)]
        return ".".join(parts + ([node.module] if node.module else []))

    def visit(node, is_lazy, is_for_types):
        names = []
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            base = base_of(node)
            # "from . import sites" imports a module, "from .sites import Sites" a name in one.
            inside = [base + "." + alias.name for alias in node.names]
            names = [name if name in modules else base for name in inside]
        elif isinstance(node, ast.Call) and called_name(node) in ("__import__", "import_module"):
            first = node.args[0] if node.args else None
            names = [first.value] if isinstance(first, ast.Constant) and isinstance(first.value, str) else []
        found.extend(Import(name, node.lineno, is_lazy, is_for_types) for name in names)
        is_lazy = is_lazy or isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda))
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.dump(node.test):
            is_for_types = True
        for child in ast.iter_child_nodes(node):
            visit(child, is_lazy, is_for_types)

    visit(ast.parse(source), False, False)
    return found


def called_name(call):
    """Return the last part of the name that a call calls."""
    return getattr(call.func, "attr", getattr(call.func, "id", ""))


def fits(name, pattern):
    """Return whether a name inside the package is the pattern's, or inside it for ``folder.*``."""
    if pattern.endswith(".*"):
        return name == pattern[:-2] or name.startswith(pattern[:-1])
    return name == pattern


def layer_of(module):
    """Return the layer of a module of the package."""
    inside = module[len(PACKAGE) + 1 :]
    for layer in LAYERS:
        if any(fits(inside, pattern) for pattern in layer[1]):
            return layer
    return None


def is_allowed(name, rules):
    """Return whether an import of `name` is among the rules."""
    top = name.split(".")[0]
    if top != PACKAGE:
        return top in rules or ("stdlib" in rules and top in STDLIB)
    inside = name[len(PACKAGE) :]
    # The package itself and its folders are empty but for words: any module may import the package.
    if not inside:
        return True
    layer = layer_of(name)
    layer_name = "." + layer[0] if layer else None
    return inside in rules or layer_name in rules or any(inside.startswith(r + ".") for r in rules if r[0] == ".")


# ------------------------------------------------------------------------------------------------------ the laws


def layer_breaches(root):
    """Return a sentence for each import that its layer forbids."""
    modules = module_names(root)
    breaches = []
    for module, path in modules.items():
        is_package = path.name == "__init__.py"
        where = path.relative_to(root)
        if is_package:
            name, allowed, lazily = "__init__", ("stdlib",), ()
        else:
            layer = layer_of(module)
            if layer is None:
                breaches.append("%s belongs to no layer of tests/test_imports.py" % where)
                continue
            name, allowed, lazily = layer[0], layer[2], layer[3]
        for one in imports_of(path.read_text(encoding="utf-8"), module, is_package, modules):
            if is_allowed(one.name, allowed):
                continue
            if not is_allowed(one.name, lazily):
                breaches.append("%s:%d (layer %s) imports %s" % (where, one.line, name, one.name))
            elif not one.is_lazy and not one.is_for_types:
                breaches.append("%s:%d imports %s at the top, not in a function" % (where, one.line, one.name))
    return breaches


def start_file_breaches(root):
    """Return a sentence for each import of Init.py and InitGui.py that would slow down or stop FreeCAD's start."""
    breaches = []
    for file_name, allowed in STARTED_BY_FREECAD.items():
        path = root / file_name
        if not path.exists():
            breaches.append("%s is missing" % file_name)
            continue
        for one in imports_of(path.read_text(encoding="utf-8"), file_name, False, {}):
            if not one.is_lazy and one.name not in allowed:
                breaches.append("%s:%d imports %s at the top" % (file_name, one.line, one.name))
    return breaches


def cycles(root):
    """Return the circles of modules that import each other, at the top or in functions."""
    modules = module_names(root)
    graph = {}
    for module, path in modules.items():
        graph[module] = {
            one.name
            for one in imports_of(path.read_text(encoding="utf-8"), module, path.name == "__init__.py", modules)
            if one.name in modules and not one.is_for_types
        }
    found, done = [], set()

    def visit(module, way):
        if module in way:
            found.append(" -> ".join([*way[way.index(module) :], module]))
        elif module not in done:
            for other in sorted(graph[module]):
                visit(other, [*way, module])
            done.add(module)

    for module in graph:
        visit(module, [])
    return found


# ----------------------------------------------------------------------------------------------------- the tests


def test_every_module_imports_only_what_its_layer_may():
    found = layer_breaches(ROOT)
    assert not found, "\n".join(found)


def test_the_files_that_freecad_executes_at_its_start_import_next_to_nothing():
    found = start_file_breaches(ROOT)
    assert not found, "\n".join(found)


def test_the_files_that_freecad_executes_at_its_start_are_tiny_and_do_not_ask_where_they_are():
    for name in STARTED_BY_FREECAD:
        text = (ROOT / name).read_text(encoding="utf-8")
        assert text.count("\n") <= 60, name
        names = {node.id for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Name)}
        assert "__file__" not in names, name  # FreeCAD gives them none


def test_no_modules_import_each_other_in_a_circle():
    found = cycles(ROOT)
    assert not found, "\n".join(found)


def planted(files):
    """Return a tree with the given files, {path: source}, and the start files; the caller cleans it up."""
    folder = tempfile.TemporaryDirectory()
    root = Path(folder.name)
    start = {"Init.py": "import FreeCAD\nimport freecad_trabecula\n", "InitGui.py": "import FreeCADGui\n"}
    packages = {"%s/%s__init__.py" % (PACKAGE, name): "" for name in ("", "core/", "geometry/", "gui/", "shell/")}
    for name, source in {**start, **packages, **files}.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(source, encoding="utf-8")
    return folder


BREACHES = {
    "core imports FreeCAD": ("core/a.py", "import FreeCAD\n"),
    "core imports Part in a function": ("core/a.py", "def f():\n    import Part\n"),
    "core imports PySide": ("core/a.py", "from PySide import QtCore\n"),
    "core imports scipy at the top": ("core/a.py", "import scipy.spatial\n"),
    "core imports manifold3d at the top": ("core/a.py", "from manifold3d import Manifold\n"),
    "core imports a package that is not declared": ("core/a.py", "import trimesh\n"),
    "core imports geometry relatively": ("core/a.py", "from ..geometry import solids\n"),
    "core imports geometry's folder relatively": ("core/a.py", "from .. import geometry\n"),
    "core imports geometry by name": ("core/a.py", "import importlib as i\ni.import_module('Part')\n"),
    "core imports for types only": ("core/a.py", "if TYPE_CHECKING:\n    import Part\n"),
    "core's folder imports its modules": ("core/__init__.py", "from . import a\n"),
    "errors imports numpy": ("errors.py", "import numpy\n"),
    "the command line's arguments import numpy": ("shell/arguments.py", "def f():\n    import numpy\n"),
    "the command line's start imports the core": ("__main__.py", "from .core import a\n"),
    "the launcher imports the design": ("shell/launch.py", "from . import design\n"),
    "geometry imports features": ("geometry/a.py", "from ..features import network\n"),
    "geometry imports the window": ("geometry/a.py", "def f():\n    import FreeCADGui\n"),
    "features import the window": ("features/a.py", "import FreeCADGui\n"),
    "features import makers": ("features/a.py", "from .. import make\n"),
    "makers import the window": ("make.py", "def f():\n    from .gui import view_providers\n"),
    "features import view providers": ("features/a.py", "def f():\n    from ..gui import view_providers\n"),
    "the window imports Qt past the shim": ("gui/a.py", "from PySide2 import QtCore\n"),
    "a library younger than Python 3.8": ("core/a.py", "import tomllib\n"),
    "a module in no layer": ("helpers.py", ""),
}
#: Modules that the planted breaches name.
TARGETS = (
    *("geometry/solids", "core/b", "features/network", "features/__init__", "gui/design_panel"),
    *("gui/view_providers", "shell/design", "make"),
)


def test_planted_breaches_are_all_caught():
    missed = []
    for what, (path, source) in BREACHES.items():
        files = {"%s/%s.py" % (PACKAGE, name): "" for name in TARGETS}
        with planted({**files, "%s/%s" % (PACKAGE, path): source}) as root:
            if len(layer_breaches(Path(root))) != 1:
                missed.append(what)
    assert missed == []


def test_what_the_layers_allow_is_not_called_a_breach():
    allowed = {
        "core/a.py": "import math\nimport numpy as np\nfrom .. import errors\nfrom ..errors import X\nfrom . import b\n"
        "def f():\n    from scipy import spatial\n    import manifold3d\n",
        "core/b.py": "",
        "errors.py": "",
        "geometry/solids.py": "import Part\nfrom FreeCAD import Vector\nfrom ..core.b import X\n",
        "make.py": "import FreeCAD\nfrom .core import a\n",
        "gui/view_providers.py": "from PySide import QtGui\nimport FreeCADGui\nfrom pivy import coin\n",
        "shell/launch.py": "import subprocess\nfrom ..errors import X\nfrom . import arguments\n",
        "shell/arguments.py": "import argparse\n",
        "shell/design.py": "from .. import make\nfrom ..core import a\nfrom .arguments import X\n",
        "__main__.py": "from .shell import launch\n",
    }
    with planted({"%s/%s" % (PACKAGE, path): source for path, source in allowed.items()}) as root:
        assert layer_breaches(Path(root)) == []
        assert cycles(Path(root)) == []


def test_planted_circles_are_caught_and_types_are_no_circle():
    pairs = {
        ("from . import b\n", "from . import a\n"): 1,
        ("from . import b\n", "def f():\n    from .a import X\n"): 1,
        ("from . import b\n", "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from . import a\n"): 0,
        ("from . import b\n", "import math\n"): 0,
    }
    for (first, second), expected in pairs.items():
        with planted({PACKAGE + "/core/a.py": first, PACKAGE + "/core/b.py": second}) as root:
            assert len(cycles(Path(root))) == expected, (first, second)


def test_a_start_file_that_imports_the_window_at_the_top_is_caught():
    source = "import FreeCADGui\nfrom freecad_trabecula.gui import commands\n"
    with planted({"InitGui.py": source}) as root:
        assert len(start_file_breaches(Path(root))) == 1
    source = "import FreeCADGui\ndef f():\n    from freecad_trabecula.gui import commands\n"
    with planted({"InitGui.py": source}) as root:
        assert start_file_breaches(Path(root)) == []


if __name__ == "__main__":
    for test in [function for name, function in sorted(globals().items()) if name.startswith("test_")]:
        test()
    print("layers: no breach, and every planted breach is caught")
