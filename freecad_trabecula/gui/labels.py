# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels of the objects that the window makes, in its language; their names, scripts and files stay as they are.

A label is given once, with the object, in the same step to undo: a document keeps it in whatever language it is opened.
"""

from __future__ import annotations

import re
import unicodedata
from typing import Any, Dict, Iterable, List, Set, Tuple

import FreeCAD

from .language import LANGUAGES, messages, translated

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP
#: The label that an object gets when it is made, ``{}`` for other labels and names, by the start of its name.
_LABELS = (
    ("Envelope", QT_TRANSLATE_NOOP("Labels", "Envelope")),
    ("Sites", QT_TRANSLATE_NOOP("Labels", "Sites")),
    ("Sites", QT_TRANSLATE_NOOP("Labels", "Sites {}")),
    ("Wireframe", QT_TRANSLATE_NOOP("Labels", "Wireframe")),
    ("Network", QT_TRANSLATE_NOOP("Labels", "Network")),
    ("Scaffold", QT_TRANSLATE_NOOP("Labels", "Scaffold")),
    ("SolidScaffold", QT_TRANSLATE_NOOP("Labels", "SolidScaffold")),
    ("Channels", QT_TRANSLATE_NOOP("Labels", "Channels")),
    ("Loose", QT_TRANSLATE_NOOP("Labels", "Loose")),
    ("Voids", QT_TRANSLATE_NOOP("Labels", "Voids")),
    ("Analysis", QT_TRANSLATE_NOOP("Labels", "Analysis {}")),
    ("VoxelDesign", QT_TRANSLATE_NOOP("Labels", "Voxels of drawn curves")),
    ("VoxelDesign", QT_TRANSLATE_NOOP("Labels", "Voxels {}")),
    ("Layers", QT_TRANSLATE_NOOP("Labels", "Layers of {}")),
    ("Bone", QT_TRANSLATE_NOOP("Labels", "Bone")),
    ("Bone", QT_TRANSLATE_NOOP("Labels", "Specimen {}")),
    ("Example", QT_TRANSLATE_NOOP("Labels", "Example_rods")),
    ("Example", QT_TRANSLATE_NOOP("Labels", "Example_measure")),
    ("Example", QT_TRANSLATE_NOOP("Labels", "Example_voxels")),
)
_PLACE = re.compile(r"\{\d*\}")
#: What letters become in the name of a file, where it is not the letter without its marks.
_LETTERS = {"ä": "ae", "ö": "oe", "ü": "ue", "Ä": "Ae", "Ö": "Oe", "Ü": "Ue", "ß": "ss"}


def names_in(document: Any) -> Set[str]:
    """Return the names of all objects of a document."""
    return {obj.Name for obj in document.Objects}


def label_new(document: Any, before: Iterable[str]) -> None:
    """Give what is new in a document its label in the language of the window, if it has the one it was made with.

    Parameters
    ----------
    document : App.Document
    before : iterable of str
        Names of the objects that are not new.
    """
    given: Dict[str, str] = {}  # by the labels before: "Analysis Scaffold" is named after another new object
    for obj in [one for one in document.Objects if one.Name not in set(before)]:
        label = _translated(obj.Name, obj.Label, given)
        if label:
            made, obj.Label = obj.Label, label
            given[made] = obj.Label  # FreeCAD may have put a number behind it


def _translated(name: str, label: str, given: Dict[str, str]) -> str:
    """The label in the language of the window; none if it is not that with which an object of this name is made."""
    for start, source in _LABELS:
        found = _fitting(source, label) if name.startswith(start) else None
        if found is not None:
            form = translated("Labels", source)
            made = form.format(*(given.get(value, value) for value in found[0]))
            return "" if made == source.format(*found[0]) else made  # the number behind it stays too
    return ""


def label_document(document: Any) -> None:
    """Give a new document of ours its label in the language of the window."""
    document.Label = _translated(document.Name, document.Label, {}) or document.Label


def english_label(label: str) -> str:
    """Return the label that an object would have in an English window, whichever made it; a user's own as it is.

    Examples
    --------
    >>> english_label("My plate"), english_label("Scaffold002")
    ('My plate', 'Scaffold002')
    """
    fitting: List[Tuple[int, str]] = []
    for code in LANGUAGES:
        for source, target in messages(code, "Labels"):
            found = _fitting(target, label)
            if found is not None:
                values, number = found
                whole = source.format(*(english_label(value) for value in values)) + number
                fitting.append((len(_PLACE.sub("", target)), whole))
    return max(fitting, default=(0, label))[1]


def _fitting(form: str, label: str) -> Any:
    """Values and the number behind a label that has a form; None if it has not."""
    pattern = "(.+)".join(re.escape(piece) for piece in _PLACE.split(form)) + ("" if form.endswith("}") else r"(\d*)")
    found = re.fullmatch(pattern, label)
    if found is None:
        return None
    values = found.groups()
    return (values, "") if form.endswith("}") else (values[:-1], values[-1])


def file_name(obj: Any, ending: str) -> str:
    """Return the name of a file for an object: ASCII, without blanks, the same in every language.

    Parameters
    ----------
    obj : document object
    ending : str
        What comes behind its name: ``.stl``.
    """
    parts = [_ascii(english_label(one.Label)) or one.Name for one in (obj.Document, obj)]
    return "-".join(parts) + ending


def _ascii(text: str) -> str:
    whole = "".join(_LETTERS.get(letter, letter) for letter in unicodedata.normalize("NFC", text))
    kept = unicodedata.normalize("NFKD", whole).encode("ascii", "ignore").decode("ascii")
    return re.sub(r'[\s/\\:*?"<>|]+', "_", kept).strip("_")
