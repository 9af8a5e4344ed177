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
#: Codes of the languages that we have a translation for, besides English.
LANGUAGES = tuple(sorted(path.stem.rpartition("_")[2] for path in FOLDER.glob("Trabecula_*.ts")))
_PLACE = re.compile(r"\{\d*\}")
#: Numbers as Python writes them, thousands parted or not; none of an equation, a chapter, a name or a path.
_NUMBER = re.compile(
    r"(?<!Eq\. )(?<!thesis )(?<!ch\. )(?<![\w./',])-?(?:\d{1,3}(?:,\d{3})+(?:\.\d+)?|\d+\.\d+(?:e[+-]?\d+)?)"
    r"(?![\w/']|[.,]\d)"
)
#: A number as somebody types it, whole thousands, and the blank that parts them.
_TYPED, _THOUSANDS = re.compile(r"\d[\d.,]*|[.,]\d+"), re.compile(r"\d{1,3}([.,]\d{3})+")
_BLANK = re.compile(r"(?<=\d)[ \u00a0\u202f](?=\d{3}(?!\d))")
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


def translated(context: str, text: str) -> str:
    """Return a text that the sources mark with ``QT_TRANSLATE_NOOP`` in the language of the window."""
    return translate(context, text)


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


def typed_numbers(text: str) -> str:
    """Return a text with its numbers as the window's fields read them, whether a point or a comma was typed.

    One sign is the decimal sign; of several the last one is, if those before it part thousands. Left alone, a field of
    a German window would read 0.5 as 5, for there the point parts thousands.

    Examples
    --------
    >>> typed_numbers("0,5 mm"), typed_numbers("1.234,5"), typed_numbers("1 234.5")
    ('0.5 mm', '1,234.5', '1234.5')
    """
    sign = decimal_point()
    return _TYPED.sub(lambda found: _typed(found[0], sign), _BLANK.sub("", text)) if sign in ".," else text


def _typed(number: str, sign: str) -> str:
    head, between, tail = re.fullmatch(r"(.*?)(?:([.,])(\d*))?", number).groups()
    other = "," if sign == "." else "."
    if not between or (not head and not tail):
        return number
    if head.isdigit() or not head:
        return f"{head}{sign}{tail}"
    if _THOUSANDS.fullmatch(number) and number.count(between) == len(re.findall("[.,]", number)) > 1:
        return re.sub("[.,]", other, number)
    return re.sub("[.,]", other, head) + sign + tail if _THOUSANDS.fullmatch(head) else number


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
    for source, target in messages("de" if code == "en" else code, "Core"):
        target = source if code == "en" else target
        if _PLACE.search(source) is None:
            fixed[source.replace("{{", "{").replace("}}", "}")] = target.replace("{{", "{").replace("}}", "}")
            continue
        pieces = [piece.replace("{{", "{").replace("}}", "}") for piece in _PLACE.split(source)]
        letters = sum(len(re.findall(r"\w", piece)) for piece in pieces)
        if letters:
            templates.append(_Template(tuple(pieces), max(pieces, key=len), letters, source, target))
    return fixed, templates


@lru_cache(maxsize=8)
def messages(code: str, context: str) -> Tuple[Tuple[str, str], ...]:
    """Return all texts of a context, each with its translation into a language; as it is where there is none.

    Parameters
    ----------
    code : str
        One of ``LANGUAGES``.
    context : str
        As ``tools/window_texts.py`` has it: ``Core``, ``Labels``.
    """
    path = FOLDER / f"Trabecula_{code}.ts"
    root: Optional[ElementTree.Element] = ElementTree.parse(path).getroot() if path.is_file() else None
    found = []
    for part in root.iter("context") if root is not None else ():
        if part.findtext("name") == context:
            for message in part.iter("message"):
                source = message.findtext("source") or ""
                found.append((source, message.findtext("translation") or source))
    return tuple(found)
