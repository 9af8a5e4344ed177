# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a design for readers: tables after the thesis, and the few lines that the command line prints.

Faces and sites are as in tables 4.1 and 4.4, couplings as in 4.2 and 4.5, outputs as in 2.4.7, 3.1 to 3.6, 4.3 and 4.6.
Everything is made from the record of ``report.report_record`` alone.
"""

from __future__ import annotations

from collections import Counter
from typing import Any, Dict, List, Mapping, Optional, Tuple

import numpy as np

from .path_laws import PATH_LAWS

_VOLUMES = {
    "envelope": "the envelope",
    "layers": "layers added to it",
    "channels": "the channels",
    "scaffold": "the scaffold",
    "loose": "loose pieces taken away",
    "closed_voids": "closed voids",
}
_PIECES = {"scaffold": "scaffold", "channels": "channels", "loose": "loose", "closed_voids": "closed voids"}


def report_markdown(record: Mapping[str, Any]) -> str:
    """Return a record as Markdown, made from the record alone."""
    parts = [
        f"# {record['name']}",
        "All checks held." if record["ok"] else "**Not all checks held: see Checks.**",
        _outputs(record),
        "## Input",
        _table(("variable", "value"), _inputs(record["job"])),
        "## Checks",
        _checks(record["checks"]),
        "## Faces and sites",
        _faces(record["faces"]),
        "## Couplings",
        _couplings(record["couplings"]),
        "## Pores",
        _pores(record["pores"]),
        "## Recoveries",
        _recoveries(record),
        "## Time",
        _times(record),
        "## Files",
        _table(("file", "size"), [(name, size_words(size)) for name, size in record["files"].items()]),
    ]  # fmt: skip
    if record["warnings"]:
        parts[2:2] = ["\n".join(f"- Warning: {text}" for text in record["warnings"])]
    versions = ", ".join(f"{name} {version}" for name, version in record["versions"].items())
    return "\n\n".join([*parts, f"Made with {versions}." if versions else ""]).rstrip() + "\n"


def report_summary(record: Mapping[str, Any]) -> str:
    """Return the few lines that the command line prints."""
    volume, pieces = record["volume_mm3"], record["pieces"]
    lines = [
        f"{record['name']}, seed {record['seed']}: {record['rods']} rods, porosity {record['porosity_percent']:.2f} % "
        f"(union of the rods {record['union_porosity_percent']:.2f} %, their plain sum "
        f"{record['sum_porosity_percent']:.2f} %)",
        f"volumes in mm3: envelope {digits(volume['envelope'])}, channels {digits(volume['channels'])}, scaffold "
        f"{digits(volume['scaffold'])}, loose {digits(volume['loose'])}",
        f"{'watertight' if record['watertight'] else 'NOT watertight'}; engine {record['engine']['used']}"
        + f"; pieces: {', '.join(f'{words} {pieces[key]}' for key, words in _PIECES.items())}",
        f"{len(record['recoveries'])} rods mended, {len(record['failed_rods'])} failed, "
        f"{len(record['outside_rods'])} leave the envelope",
        f"{record['seconds']:.1f} s; the network {record['seconds_per_rod']:.3f} s a rod (by hand, as the thesis "
        f"estimates: {record['manual_seconds_per_rod']:.0f} s)",
    ]
    failed = [f"FAILED: {_check_words(c)}" for c in record["checks"] if not c["ok"]]
    return "\n".join(lines + (failed or [f"all {len(record['checks'])} checks held"]))


def digits(value: float) -> str:
    """Return a number with six significant digits, without exponent where it can be read without one."""
    if value and not 1e-4 <= abs(value) < 1e7:
        return f"{value:.5e}"
    places = max(5 - (int(np.floor(np.log10(abs(value)))) if value else 0), 0)
    return f"{value:.{min(places, 9)}f}"


def size_words(size: int) -> str:
    """Return a file's size in words, in decimal units."""
    if size < 1000:
        return f"{size} B"
    power = min(int(np.log10(size) / 3), 3)
    return f"{size / 1000**power:.4g} {('kB', 'MB', 'GB')[power - 1]}"


def _table(head: Tuple[str, ...], rows: List[Tuple[Any, ...]]) -> str:
    if not rows:
        return "None."
    lines = [head, tuple("---" for _ in head), *rows]
    return "\n".join("| " + " | ".join(str(cell).replace("|", "\\|") for cell in line) + " |" for line in lines)


def _outputs(record: Mapping[str, Any]) -> str:
    volume, thesis = record["volume_mm3"], record["thesis"] or {}
    rows = [
        ("rods", record["rods"], thesis.get("rods", "")),
        ("porosity, % (Eq. 2.2)", f"{record['porosity_percent']:.2f}", thesis.get("porosity_percent") or ""),
        ("union of the rods, %", f"{record['union_porosity_percent']:.2f}", ""),
        ("plain sum of the rods, %", f"{record['sum_porosity_percent']:.2f}", ""),
        *((f"volume of {words}, mm3", digits(volume[key]), "") for key, words in _VOLUMES.items()),
        ("watertight", "yes" if record["watertight"] else "**no**", ""),
        *((f"pieces: {words}", record["pieces"][key], "") for key, words in _PIECES.items()),
        ("seed", record["seed"], ""),
        ("engine", " ".join(filter(None, (record["engine"]["used"], _in_brackets(record["engine"]["why"])))), ""),
        ("time of all, s", f"{record['seconds']:.1f}", ""),
        ("time of the network, s", f"{record['seconds_of_network']:.1f}", thesis.get("seconds", "")),
        ("time of the network a rod, s", f"{record['seconds_per_rod']:.3f}", thesis.get("seconds_per_rod", "")),
        ("manual design a rod, s (thesis 2.3.3)", f"{record['manual_seconds_per_rod']:.0f}",
         thesis.get("manual_seconds_per_rod", "")),
    ]  # fmt: skip
    if not thesis:
        return _table(("output", "value"), [row[:2] for row in rows])
    return _table(("output", "value", "thesis"), rows)


def _inputs(job: Mapping[str, Any]) -> List[Tuple[str, str]]:
    pores, path, layers = job["pores"], job["path"], job["scaffold"]["layers"]
    rows = [("pores", f"{pores['layout']}, size {_law(pores['size'])} mm"), ("sections a rod", str(pores["sections"]))]
    if job["prism"]:
        prism = job["prism"]
        rows += [
            ("prism l x w x h, mm", " x ".join(f"{prism[k]:g}" for k in "lwh")),
            ("sites n_x, n_y, n_z", ", ".join(str(prism[f"n_{k}"]) for k in "xyz")),
            ("border a_x, a_y, a_z, mm", ", ".join(f"{prism[f'a_{k}']:g}" for k in "xyz")),
        ]
    else:
        rows.append(("envelope", " ".join(filter(None, (job["envelope"], _in_brackets(job["solid"]))))))
    box = (
        ", box of " + " x ".join(f"{edge:g}" for edge in path["box"]) + " mm"
        if "box" in PATH_LAWS[path["kind"]].fields
        else ""
    )
    points = "; ".join("(" + ", ".join(f"{c:g}" for c in point) + ")" for point in path["points"])
    about = f" about {points} mm" if points else ""
    rows.append(("path", f"{path['kind']}{box}{about}"))
    if layers["faces"]:
        rows.append(("compact layer", f"{layers['thickness']:g} mm {layers['side']} on {', '.join(layers['faces'])}"))
    if job["edits"]:
        rows.append(("changes by hand", str(len(job["edits"]))))
    return rows


def _law(law: Mapping[str, Any]) -> str:
    if law["kind"] == "constant":
        return f"{law['low']:g}"
    words = law["expression"] if law["kind"] == "expression" else law["kind"]
    return f"{law['low']:g} to {law['high']:g} ({words})"


def _checks(rows: List[Dict[str, Any]]) -> str:
    return _table(
        ("quantity", "", "by one route", "by another", "difference", "at most"),
        [(row["name"], "ok" if row["ok"] else "**FAILED**", f"{row['value']:.9g}", f"{row['second']:.9g}",
          f"{row['difference']:.2g}", f"{row['tolerance']:.2g}") for row in rows],
    )  # fmt: skip


def _check_words(row: Mapping[str, Any]) -> str:
    return (
        f"{row['name']}: {row['value']:.9g} against {row['second']:.9g}, {row['difference']:.2g} apart, at most "
        f"{row['tolerance']:.2g}"
    )


def _in_brackets(text: str) -> str:
    return f"({text})" if text else ""


def _faces(rows: List[Dict[str, Any]]) -> str:
    if not any("c_u" in row for row in rows):
        return _table(("face", "sites"), [(row["label"], row["sites"]) for row in rows])
    return _table(
        ("face", "in the envelope", "d1", "d2", "c_u, mm", "c_v, mm", "b_u, mm", "b_v, mm", "sites"),
        [(row["label"], row["face"], _direction(row["d1"]), _direction(row["d2"]), *(f"{row[k]:g}" for k in
          ("c_u", "c_v", "b_u", "b_v")), row["sites"]) for row in rows],
    )  # fmt: skip


def _direction(values: Optional[List[float]]) -> str:
    return ", ".join(f"{v:.3g}" for v in values) if values else "the face's own"


def _couplings(rows: List[Dict[str, Any]]) -> str:
    head = ("face 1", "face 2", "initial sites 1", "initial sites 2", "rods", "final sites 1", "final sites 2")
    keys = ("first", "second", "available_first", "available_second", "rods", "left_first", "left_second")
    cells: List[Tuple[Any, ...]] = [tuple(row[key] for key in keys) for row in rows]
    total = ("all", "", "", "", sum(row["rods"] for row in rows), "", "")
    return _table(head, [*cells, total])


def _pores(figures: Mapping[str, Any]) -> str:
    if not figures["count"]:
        return "None."
    names = ("size_mm", "estimated_area_mm2", "true_area_mm2")
    titles = ("size, mm", "estimated area s^2, mm2", "true area, mm2")
    columns = ("mean", "sd", "least", "greatest")
    rows = [(title, *(f"{figures[name][k]:.4f}" for k in columns)) for title, name in zip(titles, names)]
    histogram = figures["size_histogram"]
    edges = histogram["edges_mm"]
    bars = [(f"{a:.3f} .. {b:.3f}", n) for a, b, n in zip(edges, edges[1:], histogram["counts"])]
    share = figures["true_by_estimated_area"]
    words = f"{figures['count']} end sections; their true area is {share:.3f} of the estimated."
    return "\n\n".join([words, _table(("", *columns), rows), _table(("size, mm", "sections"), bars)])


def _recoveries(record: Mapping[str, Any]) -> str:
    rows = record["recoveries"]
    counts = Counter((one["fault"], one["remedy"]) for one in rows)
    parts = [f"{len(rows)} of {record['rods'] + len(record['failed_rods'])} rods were faulty when they were drawn."]
    if rows:
        parts.append(_table(("fault", "mended by", "rods"), [(*key, counts[key]) for key in sorted(counts)]))
        keys = ("rod", "fault", "remedy", "attempts")
        parts.append(_table(("rod", "fault", "mended by", "attempts"), [tuple(one[k] for k in keys) for one in rows]))
    for key, words in (("failed_rods", "Left out, since nothing mended them"), ("outside_rods", "Leave the envelope")):
        if record[key]:
            parts.append(f"{words}: {', '.join(record[key])}.")
    return "\n\n".join(parts)


def _times(record: Mapping[str, Any]) -> str:
    rows = [(step, f"{seconds:.2f}") for step, seconds in record["seconds_by_step"].items()]
    rows += [("all", f"{record['seconds']:.2f}"), ("all, processor time", f"{record['cpu_seconds']:.2f}")]
    return _table(("step", "s"), rows)
