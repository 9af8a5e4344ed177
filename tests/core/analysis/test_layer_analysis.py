# SPDX-License-Identifier: LGPL-2.1-or-later
"""The analysis of a file of layers: the same figures as of the body that was sliced."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from freecad_trabecula.core.analysis.analysis import analyse, contours_of
from freecad_trabecula.core.analysis.layer_analysis import analyse_layers
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.report import analysis_checks, analysis_faults, analysis_notes, analysis_record
from freecad_trabecula.core.analysis.ssl import read_ssl, write_ssl
from freecad_trabecula.errors import ContourError, ParameterError

CHOSEN = SliceParameters(thickness=0.5)
BOX = "0 0\n5 0\n5 5\n0 5\nC\n"


def layers(tmp_path, body, axis="z"):
    (tmp_path / "a.ssl").write_text(f"Slice V0\nFILE(a)\nUNITS(MM)\nSLICES()\n{body}END\n")
    return read_ssl(tmp_path / "a.ssl", axis)


@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_layers_measure_as_the_body_that_they_were_cut_from(cavity, axis, tmp_path):
    contours, _ = contours_of(cavity, CHOSEN, axis)
    write_ssl(tmp_path / "a.ssl", contours, 0.5)
    found, mended = analyse_layers(read_ssl(tmp_path / "a.ssl", axis), "a.ssl", CHOSEN)
    body = analyse(cavity, replace(CHOSEN, axes=(axis,)), morphometry=False)
    assert list(found.profiles) == [axis] and found.parameters.thickness == 0.5
    for name in ("coordinate", "sliced_area", "porosity"):
        expected = getattr(body.profiles[axis], name)
        assert np.allclose(getattr(found.profiles[axis], name), expected, rtol=1e-6, atol=1e-9), name
    assert np.array_equal(found.profiles[axis].contours, body.profiles[axis].contours)
    assert np.allclose(found.box, body.box, atol=1e-6)
    assert len(mended) == len(contours)


def test_there_is_no_mesh_to_check_against_and_it_is_said(tmp_path):
    analysis, _ = analyse_layers(layers(tmp_path, f"Z 0.5 1\n{BOX}Z 1.5 1\n{BOX}"), "a.ssl", SliceParameters())
    assert analysis.facts is None and analysis_checks(analysis) == () and analysis_faults(analysis) == ()
    assert any("there is no mesh" in text for text in analysis_notes(analysis))
    record = analysis_record(analysis)
    assert record["ok"] and record["watertight"] is None and record["mesh"] is None
    assert analysis.summary("z").volume == pytest.approx(50)


def test_open_polylines_spoil_their_slice(tmp_path):
    analysis, _ = analyse_layers(
        layers(tmp_path, f"Z 0.5 1\n{BOX}Z 1.5 1\n{BOX.replace('C', 'O')}"), "a.ssl", SliceParameters()
    )
    assert analysis.profiles["z"].spoilt.tolist() == [False, True]
    assert analysis_faults(analysis) == ("along z 1 of 2 slices are spoilt: layers 1",)


def test_layers_at_uneven_heights_are_planes_at_heights(tmp_path):
    analysis, _ = analyse_layers(layers(tmp_path, f"Z 0.5 1\n{BOX}Z 3.5 1\n{BOX}"), "a.ssl", SliceParameters())
    assert analysis.parameters.at == "heights" and analysis.parameters.heights == (0.5, 3.5)


def test_layers_in_an_oblique_direction_have_their_box_in_space(tmp_path):
    analysis, _ = analyse_layers(layers(tmp_path, f"Z 0.5 1\n{BOX}", "0,0.6,0.8"), "a.ssl", SliceParameters())
    size = analysis.box[1] - analysis.box[0]
    assert (size > 0).all() and np.prod(size) >= 25 * (1 - 1e-9)


def test_no_layers_and_planes_of_one_s_own_are_refused(tmp_path):
    with pytest.raises(ContourError, match="must hold at least one layer, got 0"):
        analyse_layers(layers(tmp_path, ""), "a.ssl", SliceParameters())
    found = layers(tmp_path, f"Z 0.5 1\n{BOX}")
    for chosen in (SliceParameters(at="heights", heights=(1.0,)), SliceParameters(low=1.0)):
        with pytest.raises(ParameterError, match="heights and a range cannot be chosen"):
            analyse_layers(found, "a.ssl", chosen)
