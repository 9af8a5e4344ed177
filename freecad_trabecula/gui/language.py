# SPDX-License-Identifier: LGPL-2.1-or-later
"""The language of the window, which is FreeCAD's: texts of the layers below, choices, numbers.

Literals of ``gui`` go through ``translate``. What core, geometry and features say is English when it is raised, and is
put into words where it is shown: the message is matched against the templates that ``tools/translations.py`` took from
the sources. Modules of ``gui`` that translate when they are imported must import this one, or ``qt``, before.
"""

from __future__ import annotations

import re
import string
import xml.etree.ElementTree as ElementTree
from functools import lru_cache
from pathlib import Path
from typing import Any, Dict, List, NamedTuple, Optional, Pattern, Sequence, Tuple

import FreeCAD
from PySide import QtCore

translate = FreeCAD.Qt.translate
FOLDER = Path(__file__).resolve().parents[2] / "resources" / "translations"
_PLACE = re.compile(r"\{\d*\}")
#: Numbers as Python writes them, thousands parted or not; none of an equation, a chapter, a name or a path.
_NUMBER = re.compile(
    r"(?<!Eq\. )(?<!thesis )(?<!ch\. )(?<![\w./',])-?(?:\d{1,3}(?:,\d{3})+(?:\.\d+)?|\d+\.\d+(?:e[+-]?\d+)?)"
    r"(?![\w/']|[.,]\d)"
)
_LEAST_LETTERS = 4  # of a template, below which it fits anything but numbers
_NUMERAL = re.compile(r"[-+]?\d")
_DEPTH = 4  # of messages in messages


if FreeCAD.GuiUp:
    import FreeCADGui

    FreeCADGui.addLanguagePath(str(FOLDER))
    FreeCADGui.updateLocale()


def description(text: str) -> str:
    """Return what a parameter or a property is, in the language of the window."""
    return translate("App::Property", text) if text else ""


def choice(word: str) -> str:
    """Return a word of a combo box in the language of the window; documents and files keep it as it is."""
    return translate("Choices", word) if word else ""


# ------------------------------------------------------------------------------------------------------- numbers


def decimal_point() -> str:
    """Return the decimal sign of the window."""
    return _sign(QtCore.QLocale().decimalPoint())


def _sign(found: Any) -> str:
    return found if isinstance(found, str) else chr(found)  # PySide2 gives numbers for some


def _localised(text: str) -> str:
    """Change the signs of a number that Python wrote for those of the window."""
    point = decimal_point()
    if point == ".":
        return text
    return text.translate({ord("."): point, ord(","): _sign(QtCore.QLocale().groupSeparator())})


def local_number(value: float, form: str = "g") -> str:
    """Return a number with the signs of the window for decimals and thousands; ``form`` is one of Python's."""
    return _localised(format(value, form))


class _Filling(string.Formatter):
    def format_field(self, value: Any, form: str) -> str:
        text = format(value, form)
        return _localised(text) if isinstance(value, (int, float)) else text


def filled(text: str, *values: Any) -> str:
    """Return a translated text with its values: ``str.format`` with the decimal sign of the window."""
    return _Filling().format(text, *values)


def place_text(point: Sequence[float], form: str = ".3f") -> str:
    """Return a place, mm, in the numbers of the window."""
    between = "; " if decimal_point() == "," else ", "
    return f"({between.join(local_number(part, form) for part in point)}) mm"


def with_decimals(text: str) -> str:
    """Return a text of numbers with the decimal sign of the window."""
    sign = decimal_point()
    if sign == ".":
        return text
    local = _NUMBER.sub(lambda found: _localised(found[0]), text)
    # 0,1, 0,2 would be read as four numbers
    return re.sub(rf"(?<=\d{sign}\d), (?=-?\d)|(?<=\d), (?=-?\d+{sign}\d)", "; ", local) if sign == "," else local


# ---------------------------------------------------------------------------------- what the layers below say


class _Template(NamedTuple):
    pieces: Tuple[str, ...]  # what stands between its values
    longest: str  # its longest piece between values: a quick way to see that it does not fit
    letters: int
    source: str
    target: str


def in_words(text: str, depth: int = _DEPTH) -> str:
    """Return what a layer below the window said in the window's language; as it is where there is no translation.

    Parameters
    ----------
    text : str
        A refusal, a state, a note, a step of a long work, the name of a measure.
    depth : int
        How many messages may stand in one another.
    """
    if not text or not isinstance(text, str):
        return text
    if "\n" in text:
        return "\n".join(in_words(line, depth) for line in text.split("\n"))
    return _in_words(text, depth, language(), decimal_point())


@lru_cache(maxsize=2000)
def _in_words(text: str, depth: int, code: str, sign: str) -> str:
    if code == "en" and sign == ".":
        return text
    fixed, templates = _speech(code)
    if text in fixed:
        return fixed[text]
    fitting = [
        (one, found)
        for one in templates
        if one.longest in text and (one.letters >= _LEAST_LETTERS or _NUMERAL.match(text))
        for found in [_pattern(one.pieces).fullmatch(text)]
        if found
    ]
    if fitting and depth:
        best, found = max(fitting, key=lambda pair: pair[0].letters)
        return best.target.format(*(in_words(value, depth - 1) if value else "" for value in found.groups()))
    for between in ("; ", ": "):  # notes in a row; a name before its message
        head, sign_between, tail = text.partition(between)
        if sign_between and depth and tail:
            return in_words(head, depth - 1) + between + in_words(tail, depth - 1)
    return with_decimals(text)


def language() -> str:
    """Return the code of the window's language, ``en`` for those that we have no translation of."""
    code = translate("Trabecula", "language code")
    return code if len(code) == 2 else "en"


@lru_cache(maxsize=2000)
def _pattern(pieces: Tuple[str, ...]) -> Pattern[str]:
    """The pattern of a template, made when a message may be one: all of them at once would take a third of a second."""
    return re.compile("(.*?)".join(re.escape(piece) for piece in pieces), re.DOTALL)


@lru_cache(maxsize=4)
def _speech(code: str) -> Tuple[Dict[str, str], List[_Template]]:
    """Fixed texts and templates of the layers below, from the file of a language; for English those of another."""
    fixed: Dict[str, str] = {}
    templates: List[_Template] = []
    for source, target in _messages(code):
        target = source if code == "en" else target
        if _PLACE.search(source) is None:
            fixed[source.replace("{{", "{").replace("}}", "}")] = target.replace("{{", "{").replace("}}", "}")
            continue
        pieces = [piece.replace("{{", "{").replace("}}", "}") for piece in _PLACE.split(source)]
        letters = sum(len(re.findall(r"\w", piece)) for piece in pieces)
        if letters:
            templates.append(_Template(tuple(pieces), max(pieces, key=len), letters, source, target))
    return fixed, templates


def _messages(code: str) -> List[Tuple[str, str]]:
    path = FOLDER / f"Trabecula_{'de' if code == 'en' else code}.ts"
    root: Optional[ElementTree.Element] = ElementTree.parse(path).getroot() if path.is_file() else None
    contexts = root.iter("context") if root is not None else ()
    found = []
    for message in (
        one for context in contexts if context.findtext("name") == "Core" for one in context.iter("message")
    ):
        source, target = message.findtext("source") or "", message.findtext("translation") or ""
        if target or code == "en":
            found.append((source, target or source))
    return found
