# SPDX-License-Identifier: LGPL-2.1-or-later
"""Morphometry: every measure of phantoms whose truth is known, by both routes where there are two."""

import math

import numpy as np
import pytest

from freecad_trabecula.core.analysis import morphometry as m
from freecad_trabecula.core.analysis.analysis import analyse
from freecad_trabecula.core.analysis.json_values import from_values, to_values
from freecad_trabecula.core.analysis.parameters import SliceParameters
from freecad_trabecula.core.analysis.triangles import Soup
from freecad_trabecula.core.analysis.voxelise import Voxels
from freecad_trabecula.errors import Cancelled, ParameterError

CORNERS = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2)]
CORNERS += [(2, 4, 6), (1, 3, 5), (3, 7, 5)]


def box(low, high):
    points = np.array([[(low, high)[n >> k & 1][k] for k in range(3)] for n in range(8)], np.float32)
    return points[np.array(CORNERS)]


def plates():
    """Plates 0.8 thick every 2 mm, cut out of an endless row by a box of 8 x 8 x 6: the outer two are cut in half."""
    return np.concatenate(
        [box([0, 0, low], [8, 8, high]) for low, high in ((0, 0.4), (1.6, 2.4), (3.6, 4.4), (5.6, 6))]
    )


@pytest.fixture(scope="module")
def measured_plates():
    return m.measure(Soup(plates()), 0.1)


def test_plates_have_their_fraction_thickness_distance_and_number(measured_plates):
    found = measured_plates
    assert found["TV"] == pytest.approx(8 * 8 * 6, rel=1e-6)
    assert found["BV/TV"] == pytest.approx(0.8 / 2, rel=1e-6)
    assert found["BV/TV.vox"] == pytest.approx(0.8 / 2, rel=1e-6)
    assert found["Tb.Th"] == pytest.approx(0.8, rel=1e-6)
    assert found["Tb.Sp"] == pytest.approx(1.2, rel=1e-6)
    assert found["Tb.Sp.SD"] == pytest.approx(0, abs=1e-6)
    assert found["Tb.N"] == pytest.approx(1 / 2.0, rel=1e-6)
    assert all(1.2 <= found[f"Po.D{share}"] <= 1.3 for share in (10, 50, 90))  # all in one bin


def test_plates_have_six_surfaces_the_cuts_left_out_by_both_routes(measured_plates):
    found = measured_plates
    # 8 faces across z, of which the lowest and the highest are the box's
    assert found["BS"] == pytest.approx(6 * 64, rel=1e-6)
    assert found["BS/BV"] == pytest.approx(6 / 2.4, rel=1e-6)
    assert found["BS/BV.vox"] == pytest.approx(6 / 2.4, rel=0.06)


def test_plates_are_four_parts_without_cavity_that_are_no_connection(measured_plates):
    found = measured_plates
    assert [found[s] for s in ("Parts", "Cavities", "Euler")] == [4, 0, 4]
    # endless plates have the Euler number 0 in any box
    assert found["Conn"] == pytest.approx(1 - 0)
    assert found["Conn.D"] == pytest.approx(found["Conn"] / found["TV"])


def test_plates_are_crossed_along_their_normal_only(measured_plates):
    assert measured_plates["DA.mesh"] == math.inf
    assert measured_plates["DA"] > 5
    assert np.abs(measured_plates.fabric_axes[2]) == pytest.approx([0, 0, 1], abs=0.03)


def test_pore_sizes_are_shares_of_the_void(measured_plates):
    found = measured_plates
    assert found.spacing_shares.sum() == pytest.approx(1)
    middles = (found.spacing_edges[1:] + found.spacing_edges[:-1]) / 2
    assert (found.spacing_shares * middles).sum() == pytest.approx(1.2, abs=0.06)


def test_every_measure_of_the_table_is_made_for_a_sound_mesh_in_its_order(measured_plates):
    assert [one.symbol for one in measured_plates.measures] == list(m.TABLE)
    assert all(one.definition and one.source and one.unit in ("1", "mm", "mm2", "mm3", "1/mm", "1/mm3")
               for one in measured_plates.measures)  # fmt: skip
    assert measured_plates.notes == ()


def test_a_box_in_a_cavity_in_a_box_is_two_parts_with_one_cavity():
    soup = Soup(np.concatenate([box([0] * 3, [6] * 3), box([1] * 3, [5] * 3)[:, ::-1], box([2] * 3, [4] * 3)]))
    found = m.measure(soup, 0.25)
    assert [found[s] for s in ("Parts", "Cavities", "Euler")] == [2, 1, 3]
    assert found["BV"] == pytest.approx(216 - 64 + 8, rel=1e-6)
    assert found["BS"] == pytest.approx(6 * 16 + 6 * 4, rel=1e-6)  # the outermost faces are the box's
    assert found["BV/TV.vox"] == pytest.approx(160 / 216)


def test_overlapping_rods_are_told_from_the_difference_of_the_two_routes():
    cross = np.concatenate([box([0, 2, 2], [6, 4, 4]), box([2, 0, 2], [4, 6, 4]), box([2, 2, 0], [4, 4, 6])])
    found = m.measure(Soup(cross), 0.2)
    assert found["BV"] == pytest.approx(72, rel=1e-6)  # three times the middle
    assert found["BV/TV.vox"] == pytest.approx(56 / 216)
    assert any("parts of the mesh overlap" in note for note in found.notes)


def test_voxels_alone_are_measured_without_what_needs_triangles():
    solid = np.zeros((20, 20, 20), bool)
    solid[:, 8:12, 8:12] = True
    found = m.measure_voxels(Voxels(solid, 0.1))
    symbols = [one.symbol for one in found.measures]
    assert "BS" not in symbols
    assert found["Tb.Th.max"] == pytest.approx(0.4)
    assert found["Conn"] == 1.0


def test_a_solid_box_has_no_spaces_and_says_what_it_lacks():
    found = m.measure(Soup(box([0] * 3, [2, 3, 4])), 0.5)
    assert found["BV/TV"] == pytest.approx(1)
    assert found["BS"] == 0
    assert not any(one.symbol.startswith(("Tb.", "Po.", "DA")) for one in found.measures)
    assert [note.split(":")[0] for note in found.notes] == ["DA.mesh", "Tb.Th", "DA"]


def test_a_mesh_that_is_open_has_no_measures_but_a_reason():
    found = m.measure(Soup(plates()[:-1]), 0.4)
    assert found.measures == ()
    assert "could not be measured as a whole" in found.notes[0]
    assert "closed meshes" in found.notes[0]


def test_morphometry_goes_into_a_report_and_back(measured_plates):
    again = from_values(m.Morphometry, to_values(measured_plates), "morphometry")
    for one, other in zip(measured_plates.measures, again.measures):
        assert one == other or (math.isinf(one.value) and math.isnan(other.value))
    assert np.array_equal(again.spacing_shares, measured_plates.spacing_shares)
    nothing = m.measure(Soup(plates()[:-1]), 0.4)
    assert from_values(m.Morphometry, to_values(nothing), "morphometry").notes == nothing.notes


def test_an_unknown_symbol_is_a_key_error(measured_plates):
    with pytest.raises(KeyError, match=r"SMI"):
        measured_plates["SMI"]


def test_a_voxel_of_no_size_is_refused():
    with pytest.raises(ParameterError, match="size of voxels must be > 0, got 0"):
        m.measure(Soup(plates()), 0.0)


def test_cancelling_stops_the_measurement():
    def cancel(done, total, what):
        if what == "mean intercept length":
            raise Cancelled("stop")

    with pytest.raises(Cancelled):
        m.measure(Soup(plates()), 0.4, cancel)


def test_branches_along_the_axes_are_measures_too():
    soup = Soup(box([0, 0, 0], [1, 1, 4]))
    found = analyse(soup, SliceParameters(thickness=0.5))
    # one straight rod: one branch in 3.5 mm between the first and the last slice, no junction, no loop
    assert [found.morphometry[symbol] for symbol in ("Br.z", "Jn.z", "Lp.z")] == pytest.approx([1 / 3.5, 0, 0])
    assert found.morphometry["Br.x"] == pytest.approx(1 / 0.5)
    assert analyse(soup, SliceParameters(thickness=0.5), morphometry=False).morphometry is None
