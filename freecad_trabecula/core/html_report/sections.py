# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a report in one file tells of: folders of results, each with its record, pages, pictures and diagrams."""

from __future__ import annotations

import base64
import json
from pathlib import Path
from typing import Any, Dict, List, Mapping, NamedTuple, Sequence, Tuple, Union

from ...errors import MeshError, ParameterError
from ..analysis import comparison_report
from ..analysis.analysis import Analysis
from ..analysis.folder import load_analysis
from ..analysis.report import KIND as ANALYSIS
from ..analysis.report_text import analysis_markdown
from ..language import Words
from ..report_text import report_markdown as design_markdown
from ..stl import read_stl
from ..voxels.image_stacks import png_bytes
from ..voxels.report import KIND as VOXELS
from ..voxels.report_text import report_markdown as voxels_markdown
from .charts import Line, bar_chart, line_chart
from .shaded_view import shaded_view

DESIGN, COMPARISON = "design", comparison_report.KIND
REPORT = "report.json"
#: Bodies of which a folder's picture is made, the first that is there.
_BODIES = {DESIGN: ("scaffold.stl",), VOXELS: ("design.stl",)}
_PICTURES = {".png": "image/png", ".svg": "image/svg+xml"}
MOST_BYTES = 3_500_000  # of pictures in a page; as text they take a third more


class Picture(NamedTuple):
    """A picture: its caption, its kind (image/png, image/svg+xml), its bytes."""

    caption: str
    kind: str
    content: bytes

    @property
    def address(self) -> str:
        """The picture as an address that holds it."""
        return f"data:{self.kind};base64,{base64.b64encode(self.content).decode('ascii')}"


class Section(NamedTuple):
    """One folder of results.

    Attributes
    ----------
    kind : str
        ``design``, ``slice analysis``, ``slice comparison`` or ``voxel design``.
    record : dict
        What its ``report.json`` holds.
    pictures : tuple of Picture
    charts : tuple of str
        SVG.
    """

    kind: str
    record: Mapping[str, Any]
    pictures: Tuple[Picture, ...] = ()
    charts: Tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """What it is of."""
        return str(self.record.get("name") or ", ".join(map(str, self.record.get("names", ()))))

    def pages(self) -> Sequence[str]:
        """Return the pages of its report as Markdown."""
        if self.kind == COMPARISON:
            return comparison_report.comparison_markdown(self.record), _passports(self.record)
        pages = {DESIGN: design_markdown, ANALYSIS: analysis_markdown, VOXELS: voxels_markdown}
        return (pages[self.kind](self.record),)

    def checks(self) -> List[Mapping[str, Any]]:
        """Return what it worked out twice."""
        found = list(self.record.get("checks", ()))
        mesh = self.record.get("mesh")
        if self.kind == VOXELS and mesh:
            volumes = {"value": mesh["volume_mm3"], "second": self.record["volume_mm3"]}
            name, most = "volume of the mesh and of the voxels, mm3", 1e-9
            found.append(dict(volumes, name=name, difference=abs(mesh["volume_error"]), tolerance=most))
        return found

    def values(self) -> Dict[str, float]:
        """Return the numbers that are second routes to one another, by key."""
        measures = (self.record.get("morphometry") or {}).get("measures", ())
        return {f"morphometry.{one['symbol']}": one["value"] for one in measures if one["value"] is not None}


def _passports(record: Mapping[str, Any]) -> str:
    used = {score["symbol"] for one in record["passports"] for score in one["scores"]}
    definitions = {symbol: text for symbol, text in comparison_report.DEFINITIONS.items() if symbol in used}
    return comparison_report.passport_markdown({"passports": record["passports"], "definitions": definitions})


def read_section(folder: Union[str, Path]) -> Section:
    """Return what a folder of results holds.

    Parameters
    ----------
    folder : str or Path
        Written by ``design``, ``analyse``, ``compare`` or ``voxels``.

    Raises
    ------
    ParameterError
        If there is no report of ours in it.
    """
    place = Path(folder)
    record = _record(place)
    kind = str(record.get("kind", DESIGN))
    charts: Sequence[str] = ()
    plots = _own_pictures(place, record)
    if kind == ANALYSIS and not plots:
        charts = analysis_charts(load_analysis(place))
    elif kind == DESIGN:
        charts = design_charts(record)
    return Section(kind, record, (*_body_pictures(place, kind), *plots), tuple(charts))


def _record(place: Path) -> Dict[str, Any]:
    rule = f"a folder must hold the {REPORT} of design, analyse, compare or voxels, got"
    try:
        record = json.loads((place / REPORT).read_text(encoding="utf-8"))
    except OSError as error:
        raise ParameterError(f"{rule} {place}: {error.strerror or error}") from error
    except ValueError as error:
        raise ParameterError(f"{rule} {place}, which holds no JSON: {error}") from error
    kind = record.get("kind", DESIGN) if isinstance(record, dict) else None
    if kind not in (DESIGN, ANALYSIS, COMPARISON, VOXELS) or (kind == DESIGN and "job" not in record):
        raise ParameterError(f"{rule} {place} with another record")
    return record


def _body_pictures(place: Path, kind: str) -> Sequence[Picture]:
    for name in _BODIES.get(kind, ()):
        try:
            return [body_picture(f"{name}, seen from a corner", place / name)] if (place / name).is_file() else []
        except MeshError:  # a file that was damaged since: the report does without its picture
            return []
    return []


def body_picture(caption: str, path: Union[str, Path]) -> Picture:
    """Return the picture of a mesh file.

    Raises
    ------
    MeshError, ExportError
        If it cannot be read.
    """
    return Picture(caption, "image/png", png_bytes(shaded_view(read_stl(path)), (0.2, 0.2)))


def _own_pictures(place: Path, record: Mapping[str, Any]) -> Sequence[Picture]:
    """The plots that the folder's report names; those beside them belong to somebody else."""
    found = []
    for name in record.get("files", {}):
        path = place / name
        if path.suffix in _PICTURES and path.parent == place and path.is_file():
            found.append(Picture(path.stem.replace("_", " "), _PICTURES[path.suffix], path.read_bytes()))
    return found


def analysis_charts(analysis: Analysis, words: Words = str) -> Sequence[str]:
    """Return the profiles of an analysis along its axes as diagrams (figures 5.8, 5.9, 5.13 to 5.15)."""
    found = []
    for name, title, factor in (
        ("sliced_area", "sliced area, mm²", 1.0),
        ("porosity", "porosity, %", 100.0),
        ("contours", "contours", 1.0),
    ):
        lines = [
            Line(axis.upper(), profile.coordinate, factor * getattr(profile, name))
            for axis, profile in analysis.profiles.items()
        ]
        found.append(line_chart(title, "co-ordinate along the axis, mm", lines, words))
    return [chart for chart in found if chart]


def design_charts(record: Mapping[str, Any], words: Words = str) -> Sequence[str]:
    """Return the sizes of a design's end sections as a diagram."""
    histogram = record["pores"].get("size_histogram")
    if not histogram:
        return ()
    title = "end sections by size"
    return [bar_chart(title, "size, mm", histogram["edges_mm"], histogram["counts"], words)]
