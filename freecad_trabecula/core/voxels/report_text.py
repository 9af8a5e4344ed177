# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report of a voxel design for readers (Markdown), and the few lines that the command line prints."""

from __future__ import annotations

from typing import Any, List, Mapping, Sequence, Tuple

from .report import THESIS_SECONDS

#: Phases as the record names them, and as a reader does.
_PHASES = {"feasibility": "whether a design exists", "design": "the design", "verification": "counting it anew"}


def report_markdown(record: Mapping[str, Any], pictures: Sequence[Tuple[str, str]] = ()) -> str:
    """Return a record (``report.design_record``) as Markdown.

    Parameters
    ----------
    record : dict
    pictures : sequence of (file, caption)
    """
    parts = [
        f"# Voxel design of {record['name']}",
        _verdict(record),
        *(f"**Note:** {note}" for note in record["notes"]),
        "## The design",
        _table(("what", "value"), _figures(record)),
        "## Layers",
        _table(
            ("along", "layers", "voxels", "delta", "trabeculae (mean)", "asked for", "mean deviation"), _axes(record)
        ),
        "The deltas are the common total less the sum of the counts rounded by Eq. 6.1.",
        *(f"![{caption}]({name})\n\n{caption}." for name, caption in pictures),
        *_studies(record),
        "## Time",
        _table(("phase", "s"), [(_PHASES.get(name, name), f"{value:.3f}") for name, value in record["phases"].items()]),
        f"The whole run took {record['seconds']:.2f} s.{_thesis_words(record)}",
        "## Choices",
        _table(("choice", "value"), [(k, _words(v)) for k, v in record["parameters"].items()]),
        "## Files",
        _table(("file", "bytes"), [(k, f"{v:,}") for k, v in record["files"].items()]),
        ", ".join(f"{k} {v}" for k, v in record["versions"].items()),
    ]
    return "\n\n".join(part for part in parts if part) + "\n"


def report_summary(record: Mapping[str, Any]) -> str:
    """Return the few lines that the command line prints."""
    layers = record["layers"]
    lines = [
        f"{record['name']}: {layers['N']} x {layers['M']} x {layers['P']} layers, {record['voxels']:,} voxels, "
        f"strategy {record['strategy']}, seed {record['seed']}",
        _verdict(record).replace("**", ""),
        f"{record['components']} component{'s' if record['components'] != 1 else ''}, "
        f"{100 * record['largest_fraction']:.2f} % in the largest; {record['closed_cavities']} closed cavities; "
        f"contacts by an edge alone {record['edge_contacts']}, by a corner alone {record['corner_contacts']}",
        "trabeculae per layer: " + ", ".join(_trabeculae_words(a, t) for a, t in record["trabeculae"].items()),
        *([_rates_words(record["rates"])] if record.get("rates") else []),
        f"{record['seconds']:.2f} s",
    ]
    return "\n".join(lines)


def _studies(record: Mapping[str, Any]) -> List[str]:
    """What was asked besides the design."""
    found = []
    if record.get("counting"):
        found += ["## How many designs", _table(("number of", "log10", "standard error"), _counting(record))]
    if record.get("rates"):
        found += ["## Tables that fit", _rates_words(record["rates"])]
    return found


def _rates_words(rates: Mapping[str, Any]) -> str:
    return (
        f"Of {rates['pairs']} pairs of tables drawn without regard for each other {rates['solved']} came to their end; "
        f"{100 * rates['layers']:.1f} % of their layers were compatible, and {rates['compatible']} pairs in all layers."
    )


def _verdict(record: Mapping[str, Any]) -> str:
    if not record["exact"]:
        return f"**Not exact: {len(record['wrong_layers'])} layers have other counts than asked for.**"
    mesh = record["mesh"]
    if mesh and not mesh["watertight"]:
        return "**Exact on every layer of the three axes, but its mesh is not watertight.**"
    return "Exact on every layer of the three axes" + ("; the mesh is watertight." if mesh else ".")


def _trabeculae_words(axis: str, row: Mapping[str, Any]) -> str:
    words = f"{axis.upper()} {row['mean']:.1f}"
    if "target_mean" in row:
        words += f" (asked for {row['target_mean']:.1f}, off by {100 * row['mean_deviation']:.1f} %)"
    return words


def _figures(record: Mapping[str, Any]) -> List[Tuple[str, str]]:
    layers, mesh = record["layers"], record["mesh"]
    rows = [
        ("layers N x M x P", f"{layers['N']} x {layers['M']} x {layers['P']}"),
        ("voxel, mm", " x ".join(f"{edge:g}" for edge in record["voxel_mm"])),
        ("solid voxels", f"{record['voxels']:,}"),
        ("volume, mm³", f"{record['volume_mm3']:.4f}"),
        ("bone fraction BV/TV", f"{record['bone_fraction']:.4f}"),
        ("components (6-neighbours)", str(record["components"])),
        ("share of the largest", f"{100 * record['largest_fraction']:.3f} %"),
        ("floating voxels", f"{record['floating_voxels']:,}"),
        ("closed cavities", str(record["closed_cavities"])),
        ("contacts by an edge alone", f"{record['edge_contacts']:,}"),
        ("contacts by a corner alone", f"{record['corner_contacts']:,}"),
        ("largest alpha, beta", f"{record['tables']['alpha_max']}, {record['tables']['beta_max']}"),
        (
            "smallest possible caps on alpha, beta",
            f"{record['tables']['alpha_smallest_cap']}, {record['tables']['beta_smallest_cap']}",
        ),
    ]
    if record["mean_thickness_voxels"] is not None:
        rows.append(("mean thickness of the sample (2 BV/BS), voxels", f"{record['mean_thickness_voxels']:.2f}"))
    if mesh:
        rows.append(("triangles of the mesh", f"{mesh['triangles']:,}"))
        rows.append(("its volume against the voxels'", f"{mesh['volume_error']:+.1e}"))
    return rows


def _axes(record: Mapping[str, Any]) -> List[Tuple[str, ...]]:
    rows: List[Tuple[str, ...]] = []
    for axis, letter, name in zip("xyz", "DEC", "NMP"):
        trabeculae = record["trabeculae"][axis]
        asked = f"{trabeculae['target_mean']:.1f}" if "target_mean" in trabeculae else ""
        off = f"{100 * trabeculae['mean_deviation']:.2f} %" if "mean_deviation" in trabeculae else ""
        counts = record["targets"][letter]
        rows.append(
            (axis.upper(), str(record["layers"][name]), f"{min(counts)} to {max(counts)}",
             f"{record['deltas']['delta_' + axis.upper()]:+d}", f"{trabeculae['mean']:.1f}", asked, off)
        )  # fmt: skip
    return rows


def _counting(record: Mapping[str, Any]) -> List[Tuple[str, str, str]]:
    return [
        (
            name,
            "no sample came to its end" if row["log10"] is None else f"{row['log10']:.2f}",
            "" if row["standard_error"] is None else f"{row['standard_error']:.2f}",
        )
        for name, row in record["counting"].items()
    ]


def _thesis_words(record: Mapping[str, Any]) -> str:
    seconds = THESIS_SECONDS.get(record["strategy"])
    if not seconds:
        return ""
    words = " + ".join(str(s) for s in seconds)
    return f" The thesis needed {words} s for alpha, beta and the layers of 103 x 94 x 103 voxels by this strategy."


def _words(value: Any) -> str:
    return " x ".join(f"{v:g}" for v in value) if isinstance(value, list) else str(value)


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = [f"| {' | '.join(head)} |", "|" + "---|" * len(head)]
    return "\n".join(lines + [f"| {' | '.join(row)} |" for row in rows]) if rows else ""
