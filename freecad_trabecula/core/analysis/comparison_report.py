# SPDX-License-Identifier: LGPL-2.1-or-later
"""A comparison as files: tables 5.11 to 5.13, profiles on shared layers, the slice passport, a page for readers."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

from ..report_text import size_words
from ..stl import whole_file
from .comparison import QUANTITIES, Comparison, SharedAxis
from .json_values import to_values, values_json
from .passport import DEFINITIONS, Passport
from .report_text import number_words, table, versions_line
from .tables import Column, csv_text

KIND, SCHEMA = "slice comparison", 1
REPORT, PAGE = "report.json", "report.md"
PASSPORT, PASSPORT_PAGE = "passport.json", "passport.md"
_UNITS = {"mm2": "_mm2", "1": ""}


def save_comparison(
    comparison: Comparison,
    passports: Sequence[Passport],
    folder: Union[str, Path],
    also: Sequence[str] = (),
    versions: Optional[Mapping[str, str]] = None,
    notes: Sequence[str] = (),
) -> Dict[str, Any]:
    """Write a comparison into a folder that is there, the report last; return its record.

    Parameters
    ----------
    comparison : Comparison
    passports : sequence of Passport
        One for each sample but the first.
    folder : str or Path
    also : sequence of str
        Further files in the folder that the report is to name.
    versions : mapping of name to version, optional
    notes : sequence of str
        Further things to be said.

    Raises
    ------
    ExportError
        If a file cannot be written; each is written whole or not at all.
    """
    folder = Path(folder)
    head, rows = comparison.table()
    texts = {"comparison.csv": csv_text({name: [row[i] for row in rows] for i, name in enumerate(head)})}
    for axis, shared in comparison.axes.items():
        texts[f"comparison_{axis}.csv"] = shared_csv(shared, comparison.names)
    scores = passport_record(passports)
    texts.update({PASSPORT_PAGE: passport_markdown(scores), PASSPORT: values_json(scores)})
    for name, text in texts.items():
        _write(folder / name, text)
    sizes = {name: (folder / name).stat().st_size for name in (*texts, *also)}
    record = comparison_record(comparison, scores, sizes, versions, notes)
    _write(folder / PAGE, comparison_markdown(record))
    _write(folder / REPORT, values_json(record))
    return record


def _write(path: Path, text: str) -> None:
    with whole_file(path) as file:
        file.write(text.encode())


def shared_csv(shared: SharedAxis, names: Sequence[str]) -> str:
    """Return the profiles of all samples on the shared layers of an axis as CSV text, one row per layer."""
    columns: Dict[str, Column] = {
        "layer": list(range(len(shared.middles))),
        "middle_mm": shared.middles,
        "bottom_mm": shared.edges[:-1],
        "top_mm": shared.edges[1:],
    }
    for quantity, _, unit in QUANTITIES:
        for k, name in enumerate(names):
            columns[f"{quantity}{_UNITS[unit]} {k + 1} {name}"] = shared.values[quantity][k]
        for k in range(1, len(names)):
            columns[f"{quantity}{_UNITS[unit]} difference {k + 1} - 1"] = shared.difference(quantity, k).values
    return csv_text(columns)


# ------------------------------------------------------------------------------------------------------------- records


def comparison_record(
    comparison: Comparison,
    scores: Mapping[str, Any],
    files: Optional[Mapping[str, int]] = None,
    versions: Optional[Mapping[str, str]] = None,
    notes: Sequence[str] = (),
) -> Dict[str, Any]:
    """Return all numbers of a comparison but those of single layers."""
    head, rows = comparison.table()
    return {
        "kind": KIND,
        "schema": SCHEMA,
        "names": list(comparison.names),
        "alignment": comparison.alignment,
        "notes": [*notes, *comparison.notes],
        "table": {"head": head, "rows": rows},
        "axes": {axis: _axis_record(shared, comparison.names) for axis, shared in comparison.axes.items()},
        "passports": scores["passports"],
        "files": dict(files or {}),
        "versions": dict(versions or {}),
    }


def _axis_record(shared: SharedAxis, names: Sequence[str]) -> Dict[str, Any]:
    differences = []
    for k in range(1, len(names)):
        for quantity, words, unit in QUANTITIES:
            own = shared.difference(quantity, k)._asdict()
            del own["values"]
            differences.append({"sample": names[k], "of": words, "unit": unit, **to_values(own)})
    return {
        "layers": len(shared.middles),
        "thickness_mm": shared.thickness,
        "from_mm": float(shared.edges[0]),
        "to_mm": float(shared.edges[-1]),
        "origins_mm": to_values(shared.origins),
        "left_out_mm": to_values(shared.left_out),
        "resampled": list(shared.resampled),
        "totals": to_values(shared.totals),
        "differences": differences,
    }


def passport_record(passports: Sequence[Passport]) -> Dict[str, Any]:
    """Return the scores of all passports, with what each score is."""
    found = []
    for one in passports:
        scores = [
            {"where": where, "of": of, "symbol": symbol, "value": to_values(value), "unit": unit}
            for where, of, symbol, value, unit in one.rows()
        ]
        found.append({"reference": one.names[0], "sample": one.names[1], "scores": scores})
    return {"kind": "slice passport", "schema": SCHEMA, "passports": found, "definitions": dict(DEFINITIONS)}


# --------------------------------------------------------------------------------------------------------------- pages


def passport_markdown(record: Mapping[str, Any]) -> str:
    """Return the page of the slice passports: one table for each sample, then what each score is."""
    parts = ["# Slice passport"]
    for one in record["passports"]:
        parts += [f"## {one['sample']} against {one['reference']}", _score_table(one["scores"])]
    used = dict.fromkeys(score["symbol"] for one in record["passports"] for score in one["scores"])
    rows = [(symbol, record["definitions"][symbol]) for symbol in used]
    return "\n\n".join([*parts, "## Definitions", table(("score", "definition"), rows)]) + "\n"


def _score_table(scores: Sequence[Mapping[str, Any]]) -> str:
    """Scores as rows, axes and the whole as columns."""
    places = list(dict.fromkeys(score["where"] for score in scores))
    cells: Dict[Tuple[str, str, str], Dict[str, str]] = {}
    for score in scores:
        unit = "" if score["unit"] == "1" else score["unit"]
        cells.setdefault((score["of"], score["symbol"], unit), {})[score["where"]] = _score(score["value"])
    rows = [[*key, *(values.get(place, "") for place in places)] for key, values in cells.items()]
    return table(["of", "score", "unit", *("whole" if place == "whole" else place.upper() for place in places)], rows)


def _score(value: Optional[float]) -> str:
    return "-" if value is None else f"{value:.4g}"


def comparison_markdown(record: Mapping[str, Any]) -> str:
    """Return the record of a comparison as Markdown: tables after the thesis' 5.11 to 5.13 and 5.4."""
    first, *others = record["names"]
    parts = [
        f"# {', '.join(others)} against {first}",
        "\n".join(f"- {text}" for text in record["notes"]),
        "## Totals and ranges",
        "Rods and plates as in the thesis: every contour, voids too, by area / box.",
        table(record["table"]["head"], record["table"]["rows"]),
        "## Differences on shared layers",
        "Sections with the same value, as the thesis counts them, are where two curves meet.",
        table(*_difference_table(record)),
        f"The scores are in [{PASSPORT_PAGE}]({PASSPORT_PAGE}).",
        "## Files",
        table(("file", "size"), [(name, size_words(size)) for name, size in record["files"].items()]),
        versions_line(record["versions"]),
    ]
    return "\n\n".join(part for part in parts if part) + "\n"


def _difference_table(record: Mapping[str, Any]) -> Tuple[Sequence[str], List[List[str]]]:
    head = ("axis", "sample", "of", "unit", "mean", "largest", "at, mm", "in the middle", "equal layers", "meetings")
    rows = []
    for axis, own in record["axes"].items():
        for one in own["differences"]:
            unit = "" if one["unit"] == "1" else one["unit"]
            numbers = [number_words(one[key]) for key in ("mean", "largest", "at", "middle")]
            counts = [f"{one['equal_layers']} of {own['layers']}", str(one["meetings"])]
            rows.append([axis.upper(), one["sample"], one["of"], unit, *numbers, *counts])
    return head, rows


def comparison_summary(record: Mapping[str, Any]) -> str:
    """Return the few lines that the command line prints."""
    lines = []
    for one in record["passports"]:
        values = {(s["of"], s["symbol"]): _score(s["value"]) for s in one["scores"] if s["where"] == "whole"}
        words = (
            f"sliced area L1 {values['sliced area', 'L1']}, correlation {values['sliced area', 'r']}; "
            f"trabecular area KS {values['trabecular area', 'KS']}"
        )
        lines.append(f"{one['sample']} against {one['reference']}: {words}")
    return "\n".join([*lines, *(f"note: {text}" for text in record["notes"])])
