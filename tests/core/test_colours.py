# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours that carry meaning: told apart by every eye, and named by their legend."""

from dataclasses import replace

import numpy as np
import pytest

from freecad_trabecula.core.assembly import make_wireframe
from freecad_trabecula.core.colours import CLASSES, GREY, SCALE, by_class, by_value, scale_colours
from freecad_trabecula.core.laws import Region
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.rod_colours import OUTCOMES, ROD_COLOURINGS, failed_lines, rod_colouring
from freecad_trabecula.core.sites import prism_sites
from freecad_trabecula.core.wireframe import Recovery, without
from freecad_trabecula.errors import ParameterError

#: What eyes without red, green or blue cones see of linear red, green, blue: Machado, Oliveira, Fernandes 2009, full
#: severity (doi:10.1109/TVCG.2009.113, table 1).
BLIND = {
    "protan": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    "deutan": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
}


def linear(colours):
    c = np.asarray(colours, float) / 255
    return np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)


def lab(light):
    """CIE L*a*b* of linear sRGB (IEC 61966-2-1, D65)."""
    xyz = (
        np.clip(light, 0, 1)
        @ np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]).T
        / np.array([0.9505, 1.0, 1.089])
    )
    f = np.where(xyz > (6 / 29) ** 3, np.cbrt(xyz), xyz * (29 / 6) ** 2 / 3 + 4 / 29)
    return np.stack([116 * f[:, 1] - 16, 500 * (f[:, 0] - f[:, 1]), 200 * (f[:, 1] - f[:, 2])], 1)


@pytest.mark.parametrize("eyes", ["all", *BLIND])
def test_the_scale_grows_lighter_all_along_for_every_eye(eyes):
    light = linear(scale_colours(np.linspace(0, 1, 40)))
    if eyes in BLIND:
        light = light @ np.array(BLIND[eyes]).T
    assert (np.diff(lab(light)[:, 0]) > 0.5).all()


@pytest.mark.parametrize("eyes", ["all", *BLIND])
def test_outcomes_and_classes_differ_for_every_eye(eyes):
    for colours in (CLASSES, list(OUTCOMES.values())):
        light = linear(colours)
        if eyes in BLIND:
            light = light @ np.array(BLIND[eyes]).T
        seen = lab(light)
        apart = np.linalg.norm(seen[:, None] - seen[None], axis=2) + 1e9 * np.eye(len(seen))
        assert apart.min() > 3 * 2.3  # three times what is just noticeable (Mahy 1994)


def test_values_run_over_the_whole_scale_and_what_is_not_known_is_grey():
    colouring = by_value([5.0, np.nan, 1.0, 3.0], "size", "mm")
    assert colouring.colours.tolist() == [list(SCALE[4]), list(GREY), list(SCALE[0]), list(SCALE[2])]
    assert (colouring.legend.low, colouring.legend.high) == (1.0, 5.0)


def test_equal_values_and_none_have_a_scale_too():
    assert by_value([2.0, 2.0], "size").legend.high == 2.0
    assert len(by_value([], "size").colours) == 0


def test_classes_without_any_are_not_in_the_legend_and_colours_repeat_after_the_last():
    colouring = by_class(np.array([0, 8, 8]), [str(k) for k in range(9)], "coupling")
    assert [(one.name, one.count) for one in colouring.legend.entries] == [("0", 1), ("8", 2)]
    assert (colouring.colours[0] == colouring.colours[1]).all()


def case6():
    prism = preset("case6").prism
    high = (prism.l, prism.w, prism.h)
    return make_wireframe(preset("case6").wireframe, prism_sites(prism), Region((0.0,) * 3, high, (high[0] / 2,) * 3))


def test_rods_are_coloured_by_the_mean_of_their_end_sections():
    made = case6()
    colouring = rod_colouring(made, "size")
    sizes = np.stack([made.ends.first.size, made.ends.second.size], 1)
    assert (colouring.legend.low, colouring.legend.high) == (sizes.min(), sizes.max())
    order = np.argsort(sizes.mean(1))
    assert (np.diff(colouring.colours[order][:, 1].astype(int)) >= 0).all()  # green rises along the scale


def test_rods_of_a_coupling_have_one_colour_and_the_legend_counts_them():
    made = case6()
    colouring = rod_colouring(made, "coupling")
    assert {one.name: one.count for one in colouring.legend.entries} == {
        f"{row.first} - {row.second}": row.rods for row in made.rows if row.rods
    }
    for number in np.unique(made.coupling):
        assert len(np.unique(colouring.colours[made.coupling == number], axis=0)) == 1


def test_recovery_tells_mended_outside_and_failed_rods():
    made = case6()
    names = made.names
    made = replace(
        made,
        recoveries=(Recovery(names[3], "twisted", "roll", 1),),
        outside=(names[5],),
        failed=("Face1.9.9-Face2.9.9",),
    )
    colouring = rod_colouring(made, "recovery")
    assert [tuple(colouring.colours[k]) for k in (3, 5, 0)] == [
        OUTCOMES["mended"], OUTCOMES["leaves the envelope"], OUTCOMES["as drawn"]
    ]  # fmt: skip
    counts = {one.name: one.count for one in colouring.legend.entries}
    assert counts == {
        "as drawn": len(names) - 2, "mended": 1, "leaves the envelope": 1, "failed, left out": 1
    }  # fmt: skip


def test_failed_rods_are_lines_between_the_pores_that_they_would_have_joined():
    made = case6()
    assert failed_lines(made).shape == (0, 2, 3)
    lost = np.array([0, 7, 40])  # of the first coupling, from Face1 to Face2
    keep = np.setdiff1d(np.arange(len(made)), lost)
    sites = {face: replace(one, index=one.index - 3) for face, one in made.sites.items()}
    names = [f"{sites['Face1'].names[a]}-{sites['Face2'].names[b]}" for a, b in made.site_numbers[lost].tolist()]
    assert "-2.-2-" in names[0]  # hyphens in the sites' names too
    failed = replace(without(made, keep), sites=sites, failed=tuple(names))
    assert np.abs(failed_lines(failed) - made.paths[lost][:, [0, 1], [0, 3]]).max() < 1e-12


def test_another_colouring_is_refused():
    with pytest.raises(ParameterError, match="one of size, coupling, recovery, got 'length'"):
        rod_colouring(case6(), "length")
    assert set(ROD_COLOURINGS) == {"size", "coupling", "recovery"}
