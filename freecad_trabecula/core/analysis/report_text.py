# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of an analysis for readers: tables after the thesis' 5.1 to 5.10, made from its record alone."""

from __future__ import annotations

from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple

from ..report_text import digits, size_words

_SMOOTH = {"off": "Off", "normal": "Normal", "heavy": "Heavy"}
_PLANES = {"middle": "at the layers' middles", "bottom": "at the layers' bottoms", "heights": "at given heights"}
_FACTS = {
    "triangles": "facets",
    "parts": "parts",
    "open_edges": "open edges",
    "flipped": "facets turned against their neighbours",
    "duplicates": "facets that are there twice",
    "degenerate": "facets without area",
    "self_intersecting": "facets that run through others",
}

_BRANCHES = {
    "branches": "branches: chains of trabeculae that go on without an event",
    "branches_per_mm": "branches a mm",
    "junctions": "junctions: splits and joins",
    "junctions_per_mm": "junctions a mm",
    "appear": "trabeculae that appear",
    "end": "trabeculae that end",
    "split": "trabeculae that split",
    "join": "trabeculae that join",
    "parts": "parts that hang together from slice to slice",
    "loops": "loops: ways that part and meet again",
    "unresolved": "trabeculae too small to be followed",
}
_BRANCHES_READING = (
    "A graph over the slices (thesis ch. 9): trabeculae are joined where they overlap on neighbouring slices. Its "
    "counts depend on the thickness of the layers."
)


def analysis_markdown(record: Mapping[str, Any]) -> str:
    """Return the record of an analysis as Markdown."""
    parts = [
        f"# Slices of {record['name']}",
        _verdict(record),
        "\n".join(f"- {text}" for text in record["notes"]),
        "## Input",
        table(("variable", "value"), _inputs(record)),
        "## Slices along the axes",
        table(*_main(record["axes"])),
        _reading(record),
        "## Checks",
        checks_table(record["checks"]),
        "## Mesh",
        _mesh(record["mesh"]),
    ]
    if record["interconnectivity"]:
        parts += ["## Interconnectivity", table(*_branches(record["interconnectivity"])), _BRANCHES_READING]
    if record["morphometry"]:
        parts += ["## Morphometry", _morphometry(record["morphometry"])]
    parts += [
        "## Files",
        table(("file", "size"), [(name, size_words(size)) for name, size in record["files"].items()]),
        versions_line(record["versions"]),
    ]
    return "\n\n".join(part for part in parts if part) + "\n"


def analysis_summary(record: Mapping[str, Any]) -> str:
    """Return the few lines that the command line prints."""
    size = " x ".join(f"{value:.6g}" for value in record["size_mm"])
    lines = [f"{record['name']}, {size} mm (unit: {record['unit']}), fill rule {record['fill_rule']}"]
    for axis, own in record["axes"].items():
        summary = own["summary"]
        lines.append(
            f"{axis}: {summary['slices']} slices, sliced area {range_words(summary['sliced_area'])} mm2, porosity "
            f"{range_words(_percent(summary['porosity']))} %, {summary['rods']} rods, {summary['plates']} plates"
        )
    for measure in (record["morphometry"] or {}).get("measures", [])[:1]:
        lines.append(f"{measure['symbol']} {number_words(measure['value'])}")
    lines.append(f"{record['seconds']:.2f} s of processor time")
    lines += [f"note: {text}" for text in record["notes"]]
    lines += [f"FAULT: {text}" for text in record["faults"]]
    failed = [row for row in record["checks"] if not row["ok"]]
    lines += [f"FAILED: {check_words(row)}" for row in failed]
    if record["checks"] and not failed:
        lines.append(f"all {len(record['checks'])} checks held")
    return "\n".join(lines)


# -------------------------------------------------------------------------------------------------------------- pieces


def table(head: Sequence[str], rows: Sequence[Sequence[Any]]) -> str:
    """Return a Markdown table."""
    if not rows:
        return "None."
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(_cell(cell) for cell in line) + " |" for line in lines)


def _cell(cell: Any) -> str:
    return str(cell).replace("|", "\\|").replace("\n", " ")


def checks_table(rows: Sequence[Mapping[str, Any]]) -> str:
    """Return the table of what was worked out twice."""
    return table(
        ("quantity", "", "by one route", "by another", "difference", "at most"),
        [(row["name"], "ok" if row["ok"] else "**FAILED**", *(number_words(row[k]) for k in
          ("value", "second")), f"{row['difference']:.2g}", f"{row['tolerance']:.2g}") for row in rows],
    )  # fmt: skip


def check_words(row: Mapping[str, Any]) -> str:
    """Return one check as a sentence."""
    return (
        f"{row['name']}: {number_words(row['value'])} against {number_words(row['second'])}, {row['difference']:.2g} "
        f"apart, at most {row['tolerance']:.2g}"
    )


def number_words(value: Optional[float]) -> str:
    """Return a number with six significant digits, a dash for none."""
    return "-" if value is None else digits(float(value))


def range_words(limits: Sequence[Optional[float]]) -> str:
    """Return a range as the thesis writes it: 10.1 to 25.08."""
    low, high = limits
    return "-" if low is None or high is None else f"{low:.4g} to {high:.4g}"


def versions_line(versions: Mapping[str, str]) -> str:
    """Return which programs took part."""
    return f"Made with {', '.join(f'{name} {version}' for name, version in versions.items())}." if versions else ""


def _percent(limits: Sequence[Optional[float]]) -> List[Optional[float]]:
    return [None if value is None else 100 * value for value in limits]


def _verdict(record: Mapping[str, Any]) -> str:
    if record["faults"]:
        faults = "\n".join(f"- **{text}**" for text in record["faults"])
        return f"**The mesh is faulty: the numbers are not to be trusted where it is.**\n\n{faults}"
    return "All checks held." if record["ok"] else "**Not all checks held: see Checks.**"


def _inputs(record: Mapping[str, Any]) -> List[Tuple[str, str]]:
    chosen = record["parameters"]
    low, high = chosen["low"], chosen["high"]
    ends = [("its own end" if end is None else f"{end:g}") for end in (low, high)]
    return [
        ("sample size, bounding box, mm", " x ".join(f"{value:.6g}" for value in record["size_mm"])),
        ("unit of the file", record["unit"]),
        ("layer thickness, mm", f"{chosen['thickness']:g}"),
        ("planes", _PLANES[chosen["at"]]),
        *([] if low is None and high is None else [("range, mm", f"{ends[0]} to {ends[1]}")]),
        ("gap fill, maximum, mm", f"{chosen['gap']:g}"),
        ("gap fill, iterations", str(chosen["iterations"])),
        ("contour filter, open, mm", f"{chosen['filter_open']:g}"),
        ("contour filter, closed, mm", f"{chosen['filter_closed']:g}"),
        ("smoothing", _SMOOTH[chosen["smoothing"]]),
        ("tool compensation, mm", f"{chosen['compensation']:g}"),
        ("fill rule", chosen["fill"]),
        ("rod if area / box is at least", f"{chosen['rod_ratio']:g}"),
        ("contours counted above, mm2", f"{chosen['least_area']:g}"),
        ("time of the slices, processor s", f"{record['seconds']:.2f}"),
    ]


def _main(axes: Mapping[str, Mapping[str, Any]]) -> Tuple[List[str], List[List[str]]]:
    """Return tables 5.2, 5.4, 5.6, 5.8, 5.10 with what they lack."""
    columns = [own["summary"] for own in axes.values()]
    rows = [
        ["slices", *(str(c["slices"]) for c in columns)],
        ["spoilt slices", *(str(c["spoilt_slices"]) for c in columns)],
        ["total number of rods", *(str(c["rods"]) for c in columns)],
        ["total number of plates", *(str(c["plates"]) for c in columns)],
        ["plates, voids among them", *(str(c["plates_with_holes"]) for c in columns)],
        ["rods, by the rule that turning does not change", *(str(c["rods_invariant"]) for c in columns)],
        ["plates, by that rule", *(str(c["plates_invariant"]) for c in columns)],
        ["trabecular area range, mm2", *(range_words(c["trabecular_area"]) for c in columns)],
        ["the same, net of holes, mm2", *(range_words(c["net_trabecular_area"]) for c in columns)],
        ["porosity range, %", *(range_words(_percent(c["porosity"])) for c in columns)],
        ["sliced area, mm2", *(range_words(c["sliced_area"]) for c in columns)],
        ["mean sliced area, mm2", *(number_words(c["mean_sliced_area"]) for c in columns)],
        ["contours a slice", *(range_words(c["contours"]) for c in columns)],
        ["outer contours a slice", *(range_words(c["outer_contours"]) for c in columns)],
        ["sum of area x thickness, mm3", *(number_words(c["volume"]) for c in columns)],
        ["mean bone fraction, %", *(percent_words(c["mean_bone_fraction"]) for c in columns)],
    ]
    return ["", *(axis.upper() for axis in axes)], rows


def percent_words(fraction: Optional[float]) -> str:
    """Return a fraction in percent, a dash for none."""
    return "-" if fraction is None else f"{100 * fraction:.4g}"


def _reading(record: Mapping[str, Any]) -> str:
    envelopes = sorted({own["envelope"] for own in record["axes"].values()})
    against = ", ".join("the rectangle of the bounding box" if name == "box" else name for name in envelopes)
    return (
        "Rods and plates are outer contours; the thesis classes voids with the plates, and counts every contour as a "
        f"trabecula. A negative trabecular area is a void's. Porosity refers to {against}."
    )


def _mesh(facts: Optional[Mapping[str, Any]]) -> str:
    if facts is None:
        return "None: the slices came from a file of layers."
    rows: List[Tuple[str, str]] = [
        (words, "not looked for" if facts[key] < 0 else str(facts[key])) for key, words in _FACTS.items()
    ]
    rows += [("volume, mm3", number_words(facts["volume"])), ("surface, mm2", number_words(facts["area"]))]
    return table(("quantity", "value"), rows)


def _measure_words(value: Optional[float]) -> str:
    return f"{value:.0f}" if value is not None and float(value).is_integer() else number_words(value)


def _branches(record: Mapping[str, Mapping[str, Any]]) -> Tuple[List[str], List[List[str]]]:
    rows = []
    for key, words in _BRANCHES.items():
        values = [own[key] for own in record.values()]
        rows.append([words, *(str(v) if isinstance(v, int) else number_words(v) for v in values)])
    return ["", *(axis.upper() for axis in record)], rows


def _morphometry(record: Mapping[str, Any]) -> str:
    measures: List[Dict[str, Any]] = record.get("measures", [])
    head = [
        key for key in ("symbol", "name", "value", "unit", "definition", "source") if measures and key in measures[0]
    ]
    rows = [[_measure_words(row[key]) if key == "value" else row[key] for key in head] for row in measures]
    return table(head, rows)
