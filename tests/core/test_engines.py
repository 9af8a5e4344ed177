# SPDX-License-Identifier: LGPL-2.1-or-later
"""The choice of an engine: pairs that meet are counted by hand, the rest by order."""

from __future__ import annotations

import numpy as np
import pytest

from freecad_trabecula.core import engines
from freecad_trabecula.core.engines import choose, estimate, near_pairs
from freecad_trabecula.core.field import field_estimate
from freecad_trabecula.core.parameters import LayerParameters, ScaffoldParameters
from freecad_trabecula.errors import ParameterError

TRIANGLES = np.zeros((100, 3), int)
LOW, HIGH = (0, 0, 0), (10, 10, 10)


def rods(count, gap=0.0, points=40, width=0.5):
    """Straight square rods of 10 mm along z in a row along x; ``gap`` 0 puts them in one place."""
    z = np.linspace(0, 10, points // 4).repeat(4)
    ring = np.tile(np.array([[0, 0], [1, 0], [1, 1], [0, 1]]) * width, (points // 4, 1))
    one = np.column_stack([ring, z])
    return one + np.arange(count)[:, None, None] * np.array([gap, 0, 0])


def choice(count, **parameters):
    return choose(ScaffoldParameters(**parameters), rods(count), TRIANGLES, LOW, HIGH)


@pytest.mark.parametrize("count", [2, 5, 64])
def test_rods_in_one_place_are_all_pairs(count):
    assert near_pairs(rods(count)) == pytest.approx(count * (count - 1) / 2)


def test_rods_apart_are_no_pairs():
    assert near_pairs(rods(20, gap=0.6)) == 0


def test_rods_that_touch_their_neighbours_are_one_pair_less_than_rods():
    assert near_pairs(rods(20, gap=0.4)) == pytest.approx(19)


def test_a_sample_stands_for_all_rods():
    assert near_pairs(rods(300)) == pytest.approx(300 * 299 / 2)


@pytest.mark.parametrize("count", [0, 1])
def test_one_rod_makes_no_pair(count):
    assert near_pairs(rods(count)) == 0


def test_crossing_rods_take_longer_than_rods_apart():
    apart, together = (estimate(rods(50, gap), TRIANGLES, LOW, HIGH, 0.1, "mesh") for gap in (0.6, 0.0))
    assert together.seconds > apart.seconds
    assert together.bytes == apart.bytes


def test_the_field_engine_s_estimate_is_its_own_and_that_of_the_accounts():
    found, own = estimate(rods(10), TRIANGLES, LOW, HIGH, 0.2, "field"), field_estimate(LOW, HIGH, 0.2, 1000)
    assert own.seconds < found.seconds < 5 * own.seconds
    assert own.bytes < found.bytes < 2 * own.bytes
    assert "cells of 0.2 mm" in found.reason


def test_few_rods_get_the_exact_engine(monkeypatch):
    monkeypatch.setattr(engines, "manifold_available", lambda: True)
    found = choice(147)
    assert found.engine == "mesh"
    assert "147 rods" in found.reason and found.reason.endswith("exact")


def test_very_many_rods_get_the_field_engine_and_the_reason_says_why(monkeypatch):
    monkeypatch.setattr(engines, "manifold_available", lambda: True)
    found = choice(1500)
    assert found.engine == "field"
    assert "mesh engine would take about" in found.reason


def test_the_choice_can_be_overruled(monkeypatch):
    monkeypatch.setattr(engines, "manifold_available", lambda: True)
    assert choice(1500, engine="mesh").engine == "mesh"
    assert choice(3, engine="field").engine == "field"
    assert choice(3, engine="brep").engine == "mesh"


def test_without_manifold3d_the_field_engine_serves_and_the_reason_says_what_to_install(monkeypatch):
    monkeypatch.setattr(engines, "manifold_available", lambda: False)
    found = choice(3)
    assert found.engine == "field"
    assert "pip install" in found.reason


def test_closed_layers_need_a_boolean_however_many_rods(monkeypatch):
    monkeypatch.setattr(engines, "manifold_available", lambda: False)
    found = choice(1500, layers=LayerParameters(("Face6",)))
    assert found.engine == "mesh"
    assert found.reason.endswith("closed layers need a Boolean")


def test_closed_layers_by_the_field_engine_are_refused_without_manifold3d(monkeypatch):
    monkeypatch.setattr(engines, "manifold_available", lambda: False)
    with pytest.raises(ParameterError, match="closed layers need a Boolean.*manifold3d"):
        choice(3, engine="field", layers=LayerParameters(("Face6",)))


def test_an_estimate_for_another_engine_is_refused():
    with pytest.raises(ParameterError, match="got 'brep'"):
        estimate(rods(2), TRIANGLES, LOW, HIGH, 0.1, "brep")


def test_a_cell_of_no_size_is_refused():
    with pytest.raises(ParameterError, match="above 0 mm"):
        estimate(rods(2), TRIANGLES, LOW, HIGH, 0.0, "field")
