# SPDX-License-Identifier: LGPL-2.1-or-later
"""Refreshes the translations from the sources and packs them for Qt: ``make translations``.

``resources/translations/Trabecula_<language>.ts`` gets every text of ``tools/window_texts.py``: what is translated
stays, what is new is marked unfinished, what is in no source any more goes. ``lrelease`` then packs each into the
``.qm`` that FreeCAD loads; the format is one for Qt 5 and Qt 6.

    python3 tools/translations.py                  refresh .ts and .qm
    python3 tools/translations.py --check          refresh nothing; exit code 1 if a text is missing or unfinished
    python3 tools/translations.py --todo de        print what is not translated yet, a JSON list of [context, source]
    python3 tools/translations.py --take de FILE   take translations from such a list of [context, source, translation]
"""

from __future__ import annotations

import argparse
import json
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Dict, List, Sequence
from xml.sax.saxutils import escape

from window_texts import ROOT, Found, Text, window_texts

FOLDER = ROOT / "resources" / "translations"
LANGUAGES = ("de", "it")
PACKAGE = "qttools5-dev-tools"
_PLACES = re.compile(r"\{(\d*)([^{}]*)\}")
_HEAD = '<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n'
Translations = Dict[Text, str]


def ts_path(language: str) -> Path:
    """Return the file that is translated."""
    return FOLDER / f"Trabecula_{language}.ts"


def read_ts(path: Path) -> Translations:
    """Return the finished translations of a file; none if it is not there."""
    found: Translations = {}
    if not path.is_file():
        return found
    for context in ElementTree.parse(path).getroot().iter("context"):
        for message in context.iter("message"):
            translation = message.find("translation")
            if translation is not None and translation.get("type") is None and translation.text:
                found[Text(context.findtext("name"), message.findtext("source"))] = translation.text
    return found


def write_ts(path: Path, language: str, texts: Found, translations: Translations) -> None:
    """Write a file to be translated: contexts and texts in order, so that a change of one is a change of its lines."""
    contexts: Dict[str, List[Text]] = {}
    for text in sorted(texts):
        contexts.setdefault(text.context, []).append(text)
    lines = [f'{_HEAD}<TS version="2.1" language="{language}" sourcelanguage="en">']
    for name, found in contexts.items():
        lines += ["<context>", f"    <name>{escape(name)}</name>"]
        for text in found:
            translation = translations.get(text)
            state = "" if translation else ' type="unfinished"'
            lines += [
                "    <message>",
                *(f'        <location filename="../../{file}"/>' for file in sorted(texts[text])),
                f"        <source>{escape(text.source)}</source>",
                f"        <translation{state}>{escape(translation or '')}</translation>",
                "    </message>",
            ]
        lines.append("</context>")
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join([*lines, "</TS>", ""]), encoding="utf-8")


def faults(texts: Found, translations: Translations) -> List[str]:
    """Return what is wrong with translations: missing ones, placeholders that differ, mnemonics that are lost."""
    found = [f"not translated: {text.context}: {text.source}" for text in texts if text not in translations]
    found += [f"no source any more: {text.context}: {text.source}" for text in translations if text not in texts]
    for text, translation in translations.items():
        if places(text.source) != places(translation):
            found.append(f"other placeholders: {text.source!r}: {translation!r}")
        if text.source.count("&") != translation.count("&"):
            found.append(f"other mnemonics: {text.source!r}: {translation!r}")
    return found


def places(text: str) -> List[str]:
    """Return the placeholders of a text, in the order of the values that they show, with their formats.

    Examples
    --------
    >>> places("{:.2f} of {}") == places("{1} von {0:.2f}"), places("{{}} {}")
    (True, ['0 {}'])
    """
    plain = text.replace("{{", "").replace("}}", "")
    found = enumerate(_PLACES.finditer(plain))
    return sorted(f"{place[1] or number} {{{place[2]}}}" for number, place in found)


def lrelease() -> str:
    """Return Qt's program that packs translations, installed by apt if it is not there."""
    for name in ("lrelease", "/usr/lib/qt5/bin/lrelease", "/usr/lib/qt6/bin/lrelease"):
        if shutil.which(name):
            return name
    print(f"translations: installing by apt: {PACKAGE}", flush=True)
    command = ["apt-get", "install", "-y", "-q", "--no-install-recommends", PACKAGE]
    if shutil.which("sudo"):
        command.insert(0, "sudo")
    try:
        subprocess.run(command, check=True, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    except (OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"translations need lrelease, of the package {PACKAGE}, which apt could not install: {error}")
    return shutil.which("lrelease") or "/usr/lib/qt5/bin/lrelease"


def refresh(texts: Found) -> None:
    """Write .ts and .qm of every language, and say how much of each is translated."""
    program = lrelease()
    for language in LANGUAGES:
        path = ts_path(language)
        translations = read_ts(path)
        write_ts(path, language, texts, translations)
        command = [program, "-silent", "-nounfinished", str(path), "-qm", str(path.with_suffix(".qm"))]
        subprocess.run(command, check=True)
        done = sum(text in translations for text in texts)
        print(f"{path.relative_to(ROOT)}: {done} of {len(texts)} texts are translated")


def take(language: str, file: str, texts: Found) -> None:
    """Take translations from a list of [context, source, translation]; those that nothing asks for are refused."""
    path = ts_path(language)
    translations = read_ts(path)
    for context, source, translation in json.loads(Path(file).read_text(encoding="utf-8")):
        if Text(context, source) not in texts:
            sys.exit(f"no text of the window: {context}: {source}")
        translations[Text(context, source)] = translation
    write_ts(path, language, texts, translations)


def check(texts: Found) -> int:
    """Say what is missing or wrong; return the exit code."""
    wrong = 0
    for language in LANGUAGES:
        for fault in faults(texts, read_ts(ts_path(language))):
            print(f"{language}: {fault}")
            wrong = 1
    return wrong


def main(arguments: Sequence[str]) -> int:
    """Do what the command line says."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--todo", choices=LANGUAGES)
    parser.add_argument("--take", nargs=2, metavar=("LANGUAGE", "FILE"))
    choices = parser.parse_args(arguments)
    texts = window_texts()
    if choices.check:
        return check(texts)
    if choices.todo:
        done = read_ts(ts_path(choices.todo))
        print(json.dumps([list(text) for text in sorted(texts) if text not in done], ensure_ascii=False, indent=0))
        return 0
    if choices.take:
        take(*choices.take, texts)
    refresh(texts)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
