# SPDX-License-Identifier: LGPL-2.1-or-later
"""What core, geometry and features say, as templates with ``{}`` for each value, read from their syntax trees.

Refusals, states, notes, steps of long work, names and explanations of numbers, and the pages of the report in one file.
"""

from __future__ import annotations

import ast
import re
from typing import Callable, Dict, Iterable, List, Optional, Sequence


def callee(call: ast.Call) -> str:
    """Return the last word of what is called."""
    return getattr(call.func, "id", getattr(call.func, "attr", ""))


def literal(node: Optional[ast.AST]) -> Optional[str]:
    """Return the text of a string literal; None of anything else."""
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


class Speech(ast.NodeVisitor):
    """Collects the templates of what a module says."""

    def __init__(self, tree: ast.Module, is_written: bool = False) -> None:
        self.templates: List[str] = []
        self._only_errors = is_written
        self._names: List[Dict[str, List[ast.expr]]] = [_bound(tree.body)]
        self.visit(tree)

    def visit_FunctionDef(self, node: ast.FunctionDef) -> None:
        """Read a function, without its docstring; its names stand for the texts that they are given."""
        self._names.append(_bound(ast.walk(node)))
        for line in node.body[1:] if literal(getattr(node.body[0], "value", None)) else node.body:
            self.visit(line)
        self._names.pop()

    def visit_ClassDef(self, node: ast.ClassDef) -> None:
        """Read a class, without its docstring."""
        for line in node.body:
            self.visit(line)

    def visit_Expr(self, node: ast.Expr) -> None:
        """Pass over docstrings."""
        if literal(node.value) is None:
            self.visit(node.value)

    def visit_Raise(self, node: ast.Raise) -> None:
        """Take what an error says."""
        if isinstance(node.exc, ast.Call) and node.exc.args:
            self._take(node.exc.args[0], is_refusal=True)

    def visit_Call(self, node: ast.Call) -> None:
        """Take a checked rule with what it adds, and the step of a long work, which may be one word."""
        name = callee(node)
        if name == "Explanation":
            self._take_explanation(node)
            return
        if name in RULES:
            self._take(RULES[name](node))
            return
        if name in NOT_SPOKEN:
            return
        if name in ("progress", "report") and len(node.args) == 3:
            self._take(node.args[2], words=1)
        self.generic_visit(node)

    def visit_Constant(self, node: ast.Constant) -> None:
        """Take a text of several words."""
        if not self._only_errors and literal(node):
            self._take(node, words=2)

    def visit_JoinedStr(self, node: ast.JoinedStr) -> None:
        """Take a text with values in it."""
        if not self._only_errors:
            self._take(node, words=2)

    def visit_AnnAssign(self, node: ast.AnnAssign) -> None:
        """Take the names of measures, which may be one word, with the rest of their table."""
        if getattr(node.target, "id", "") in MEASURES and isinstance(node.value, ast.Dict):
            for row in node.value.values:
                self._take(row.elts[0])
        self.generic_visit(node)

    def visit_BinOp(self, node: ast.BinOp) -> None:
        """Take a text that is put together of several, whole."""
        whole = isinstance(node.op, ast.Add) and any(_WORD.search(text) for text in self._read(node))
        if whole and not self._only_errors:
            self._take(node, words=2)
        else:
            self.generic_visit(node)

    def _take_explanation(self, node: ast.Call) -> None:
        """Take name, unit, formula, source, second route, tolerance of a number; articles are the same everywhere."""
        for place in (1, 3, 4, 5, 6, 7):
            for template in self._read(node.args[place]) if place < len(node.args) else ():
                if _WORD.search(template.replace("{}", "")) and not _SAME.fullmatch(template):
                    self.templates.append(template)

    def _texts(self, node: ast.expr) -> Sequence[str]:
        return self._read(node)

    def _take(self, node: ast.expr, words: int = 1, is_refusal: bool = False) -> None:
        for template in self._texts(node):
            plain = re.sub(r"\{\}", " ", template)
            is_speech = words == 1 or " " in template.strip()
            if (
                is_speech
                and len(_WORD.findall(plain)) >= min(words, 1)
                and (is_refusal or not _NO_WORDS.search(template))
            ):
                self.templates.append(template)

    def _read(self, node: ast.AST, depth: int = 0) -> List[str]:
        """All templates that an expression may give; "{}" for what is known at run time only."""
        if literal(node) is not None:
            return [literal(node).replace("{", "{{").replace("}", "}}")]
        if isinstance(node, ast.JoinedStr):
            return self._joined([self._read(one, depth) for one in node.values])
        if isinstance(node, ast.FormattedValue):
            return self._read(node.value, depth) if node.format_spec is None else ["{}"]
        if isinstance(node, ast.IfExp):
            return [*self._read(node.body, depth), *self._read(node.orelse, depth)]
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
            return self._joined([self._read(node.left, depth), self._read(node.right, depth)])
        if isinstance(node, ast.Name) and depth < 2:
            values = next((names[node.id] for names in reversed(self._names) if node.id in names), [])
            found = [text for value in values for text in self._read(value, depth + 1)]
            return found if found and "{}" not in found else ["{}"]
        return ["{}"]

    @staticmethod
    def _joined(parts: Sequence[Sequence[str]]) -> List[str]:
        found = [""]
        for part in parts:
            found = [head + tail for head in found for tail in dict.fromkeys(part)]
            if len(found) > _MOST_VARIANTS:
                return ["".join(part[0] if len(part) == 1 else "{}" for part in parts)]
        return found


class Page(Speech):
    """Collects what a module of the report's pages says: heads and cells of tables may be one word."""

    def visit_FunctionDef(self, node: ast.FunctionDef) -> None:
        """Read a function that is no part of what the command line prints."""
        if not node.name.endswith(("_summary", "check_words", "_trabeculae_words")):
            super().visit_FunctionDef(node)

    def visit_Subscript(self, node: ast.Subscript) -> None:
        """Pass over keys."""
        self.visit(node.value)

    def visit_Compare(self, node: ast.Compare) -> None:
        """Pass over what is compared."""

    def visit_Dict(self, node: ast.Dict) -> None:
        """Pass over keys."""
        for value in node.values:
            self.visit(value)

    def visit_Assign(self, node: ast.Assign) -> None:
        """Pass over lists of keys."""
        if getattr(node.targets[0], "id", "") not in ("keys", "names", "__all__", "_PACKAGES", "_PICTURES", "_BODIES"):
            self.visit(node.value)

    def visit_Call(self, node: ast.Call) -> None:
        """Pass over calls that take a key."""
        if callee(node) not in _KEYS:
            super().visit_Call(node)

    def visit_Constant(self, node: ast.Constant) -> None:
        """Take a text."""
        self._take(node)

    def visit_JoinedStr(self, node: ast.JoinedStr) -> None:
        """Take a text with values in it."""
        self._take(node)

    def _read(self, node: ast.AST, depth: int = 0) -> List[str]:
        """As for every module; a sum is one value."""
        return ["{}" if text and not text.replace("{}", "") else text for text in super()._read(node, depth)]

    def _texts(self, node: ast.expr) -> Sequence[str]:
        """The texts within blocks of Markdown, without marks; what is bold is one (``core/html_report/markup.py``)."""
        found = []
        for text in self._read(node):
            parts = _MARKS.split(text)
            found += [part.strip() for part in parts] if len(parts) > 1 else parts
        return [text for text in found if not _SIGNS.fullmatch(text)]


def _bound(nodes: Iterable[ast.AST]) -> Dict[str, List[ast.expr]]:
    """Names that are given values by plain assignments, with all these values."""
    found: Dict[str, List[ast.expr]] = {}
    for node in nodes:
        if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name):
            found.setdefault(node.targets[0].id, []).append(node.value)
    return found


def _require(call: ast.Call) -> ast.expr:
    """What ``core.parameters.require(ok, rule, value, unit)`` says."""
    return ast.JoinedStr([call.args[1], ast.Constant(", got "), ast.FormattedValue(ast.Constant(None), -1)])


def _optional_module(call: ast.Call) -> ast.expr:
    """What ``core.optional_packages.optional_module(name, purpose)`` says before the command that installs it."""
    return call.args[1]


#: Functions that refuse something with a rule, and what they say.
RULES: Dict[str, Callable[[ast.Call], ast.expr]] = {"require": _require, "optional_module": _optional_module}
#: Functions whose texts are no speech: descriptions of properties (``App::Property``), patterns.
NOT_SPOKEN = ("Property", "result", "_f", "compile", "sub", "match", "search", "fullmatch", "split", "doc")
#: Modules whose texts go into files and stay English, or name those of others; what they refuse is shown.
WRITTEN = (
    *("core/report.py", "plots.py", "workbook.py", "explanations/registry.py", "explanations/report_rows.py"),
    *("mesh_formats.py", "svg_layers.py", "ssl.py", "volume_files.py", "brep_text.py", "job.py", "json_values.py"),
    *("features/scripts.py", "python_text.py"),
)
#: Modules of what the report in one file says: single words too, but for what the command line prints.
PAGES = (
    *("report_text.py", "comparison_report.py", "html_report/sections.py", "html_report/page.py"),
    *("features/report_sections.py", "explanations/explanation.py"),
)
#: Tables of measures: name, unit, definition, source of each.
MEASURES = ("TABLE", "AXIS_TABLE")
#: What is read by its key only: in pages no word that somebody reads.
_KEYS = ("get", "getattr", "namedtuple", "TypeVar", "to_values", "encode")
_WORD = re.compile(r"[A-Za-z]{2,}")
_NO_WORDS = re.compile(r"[\n\\]|<(?![= ])|%[.d]|DOI|python3 -m|https?:|->|^[a-z]+_[a-z_]+ |^[a-z]+ -|\.json|^#|^\*")
#: Articles, and what is a sign in every language.
_SAME = re.compile(r"(?:[A-Z][\w .]+ \d{4}, )?DOI \S+|[A-Z][\w .]+ \d{4}, DOI \S+|h|s|mm\d?|BV/TV")
#: Marks of headings, points and bold words.
_MARKS = re.compile(r"^#+ |^- |\*\*")
#: Names of files, of fields, of axes.
_SIGNS = re.compile(r"\w+\.\w+|\w*_\w+|xyz|lwh|DEC|NMP|mm|utf-8|data:\S+|\w+\.\{\}|image/\S+|log10")
_MOST_VARIANTS = 6
