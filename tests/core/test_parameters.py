# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every parameter is checked when it is made; the message holds rule, value and unit."""

import dataclasses

import pytest

from freecad_trabecula.core import parameters as p
from freecad_trabecula.core.laws import Law, constant, uniform
from freecad_trabecula.errors import ParameterError

NAN = float("nan")
CLASSES = [
    p.PoreParameters, p.PathParameters, p.Coupling, p.PrismParameters, p.FaceParameters, p.SiteEdit, p.RodParameters,
    p.LayerParameters, p.ScaffoldParameters,
]  # fmt: skip


@pytest.mark.parametrize("cls", CLASSES)
def test_every_field_has_a_unit_and_a_tooltip(cls):
    for f in dataclasses.fields(cls):
        assert "unit" in f.metadata and len(f.metadata["doc"]) > 10, f.name


@pytest.mark.parametrize("cls", CLASSES)
def test_parameters_cannot_be_changed_behind_the_checks(cls):
    assert cls.__dataclass_params__.frozen


@pytest.mark.parametrize(
    "make, words",
    [
        (lambda: p.PoreParameters(size=uniform(0.0, 0.8)), "at least 0.001 mm, got 0 and 0.8 mm"),
        (lambda: p.PoreParameters(size=constant(-1.0)), "got -1 and -1 mm"),
        (lambda: p.PoreParameters(size=Law("uniform", NAN, 0.8)), "finite"),
        (lambda: p.PoreParameters(size=uniform(0.8, 0.2)), "low <= high, got 0.8 and 0.2"),
        (lambda: p.PoreParameters(turn=uniform(0, 1.5)), "tangent component must lie in 0..1"),
        (lambda: p.PoreParameters(pull=constant(3.5)), "tangent pull must lie in 0..3"),
        (lambda: p.PoreParameters(layout="star"), "circle, spline, got 'star'"),
        (lambda: p.PoreParameters(corners=2), "3..12, got 2"),
        (lambda: p.PoreParameters(sections=3), "1 or 2, got 3"),
        (lambda: p.PoreParameters(scatter=0.5), "0..0.3, got 0.5"),
        (lambda: p.PrismParameters(n_x=0), "at least 2 .* got 0"),
        (lambda: p.PrismParameters(n_z=1), "along Z must be at least 2 .* got 1"),
        (lambda: p.PrismParameters(a_y=5.0), "0 <= a < edge / 2 = 5 mm, got 5 mm"),
        (lambda: p.PrismParameters(a_x=-0.1), "got -0.1 mm"),
        (lambda: p.PrismParameters(h=NAN), "edge along Z .* got nan mm"),
        (lambda: p.PrismParameters(w=0.0), "edge along Y must be at least 0.001, got 0 mm"),
        (lambda: p.FaceParameters(c_u=0.0), "spacing c_u must be greater than 0, got 0 mm"),
        (lambda: p.FaceParameters(b_v=-1.0), "border distance b_v must be at least 0, got -1 mm"),
        (lambda: p.FaceParameters(d1=(0.0, 0.0, 0.0)), "direction d1 must not be zero"),
        (lambda: p.FaceParameters(face=""), "must be named"),
        (lambda: p.FaceParameters(name="A.1"), "short name of a face must hold no dot, got 'A.1'"),
        (lambda: p.Coupling("A", ""), "two faces"),
        (lambda: p.Coupling("A", "B", "nearest"), "random, same"),
        (lambda: p.Coupling("A", "B", limit=-1), "got -1"),
        (lambda: p.PathParameters("spiral"), "path must be one of"),
        (lambda: p.PathParameters(box=(1.0, -1.0, 1.0)), "at least 0, got -1 mm"),
        (lambda: p.PathParameters(points=((0.0, NAN, 0.0),)), "finite number, got nan mm"),
        (lambda: p.PathParameters(tension_first=constant(0.0)), "tension must be greater than 0"),
        (lambda: p.RodParameters(stations=2), "3..33, got 2"),
        (lambda: p.RodParameters(deflection=-0.1), "got -0.1 mm"),
        (lambda: p.LayerParameters(thickness=0.0), "greater than 0, got 0 mm"),
        (lambda: p.LayerParameters(side="up"), "inwards, outwards"),
        (lambda: p.ScaffoldParameters(engine="magic"), "auto, mesh, field, brep"),
        (lambda: p.ScaffoldParameters(cell=0.0), "cell must be greater than 0, got 0 mm"),
        (lambda: p.ScaffoldParameters(seconds=NAN), "time budget"),
        (lambda: p.SiteEdit("A.1.1", "move"), "a point is needed"),
        (lambda: p.SiteEdit("A", "off"), "face.i.j"),
        (lambda: p.SiteEdit("A.1.1", "pore", size=0.0), "size of the pore at A.1.1"),
        (lambda: p.SiteEdit("A.1.1", "pore", turns=(0.1, 2.0, 0.1, 0.1)), "0..1, got 2"),
        (lambda: p.check_seed(-1), "seed must lie in 0..2147483647, got -1"),
    ],
)
def test_a_broken_rule_is_refused_with_rule_value_and_unit(make, words):
    with pytest.raises(ParameterError, match=words):
        make()


def test_defaults_are_those_of_the_thesis():
    assert p.PoreParameters().size == uniform(0.2, 0.8)
    prism = p.PrismParameters()
    assert [axis[1:] for axis in prism.axes] == [(10.0, 7, 1.0)] * 3
    assert p.LayerParameters().thickness == 1.0


def test_a_face_is_called_by_its_short_name_if_it_has_one():
    assert p.FaceParameters("Face3", name="A").label == "A"
    assert p.FaceParameters("Face3").label == "Face3"
