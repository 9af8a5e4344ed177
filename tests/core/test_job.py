# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jobs: read, written, changed field by field; whatever is wrong is refused with its place."""

from __future__ import annotations

import dataclasses
import json
import math
import typing

import pytest

from freecad_trabecula.core.job import (
    MOST_RODS,
    Job,
    check_rods,
    job_from_json,
    job_to_json,
    opposite_couplings,
    read_job,
    set_values,
    with_seed,
)
from freecad_trabecula.core.laws import Law
from freecad_trabecula.core.parameters import Coupling, FaceParameters, LayerParameters, PathParameters, PrismParameters
from freecad_trabecula.core.presets import preset
from freecad_trabecula.core.records import from_record
from freecad_trabecula.errors import ParameterError

CASE6 = preset("case6")
FACES = (FaceParameters("Face1", "A"), FaceParameters("Face2", "B"))
IMPLANT = Job(envelope="implant.step", faces=FACES, couplings=(Coupling("A", "B"),))


def refused(text, message):
    with pytest.raises(ParameterError, match=message):
        job_from_json(text)


def changed(record_of, **keys):
    return json.dumps(dict(json.loads(job_to_json(record_of)), **keys))


# ----------------------------------------------------------------------------------------------------- files


def test_a_saved_job_names_every_field_and_reads_back_the_same():
    for job in (CASE6, IMPLANT):
        assert set(json.loads(job_to_json(job))) == {f.name for f in dataclasses.fields(Job)}
        assert job_from_json(job_to_json(job)) == job


def test_a_job_needs_few_words():
    job = job_from_json('{"prism": {}, "couplings": [{"first": "Face1", "second": "Face2"}]}')
    assert job.prism == PrismParameters()
    assert job.pores == CASE6.pores


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "a job must be JSON"),
        ("{", "a job must be JSON"),
        ("[]", "job must be an object with keys, got"),
        ("[" * 100_000, "a job must be JSON"),
        ('{"seed": NaN}', "finite, got NaN"),
        ('{"seed": 1, "seed": 2}', "a key of a job may stand once in its object, got 'seed' twice"),
        ('{"seed": -Infinity}', "finite, got -Infinity"),
        ("{}", "a job needs either an envelope file or a prism, got neither"),
    ],
)
def test_a_file_that_is_no_job_is_refused(text, message):
    refused(text, message)


def test_the_mark_that_editors_on_windows_put_in_front_is_passed_over(tmp_path):
    path = tmp_path / "job.json"
    path.write_bytes(b"\xef\xbb\xbf" + job_to_json(CASE6).encode("utf-8"))
    assert read_job(str(path)) == CASE6


@pytest.mark.parametrize(
    ("keys", "message"),
    [
        ({"pore": {}}, "job has no key 'pore'; known are schema, name, envelope"),
        ({"pores": {"sise": {}}}, r"job\.pores has no key 'sise'; known are layout, size"),
        ({"pores": {"size": {"kind": "uniform", "low": 0.8, "high": 0.2}}}, r"low <= high, got 0\.8 and 0\.2"),
        ({"pores": {"size": {"kind": "constant", "low": 0.0}}}, "pore sizes must be at least 0.001 mm, got 0"),
        ({"pores": {"size": {"low": -0.1, "high": 0.2}}}, "pore sizes must be at least 0.001 mm, got -0.1 and 0.2 mm"),
        ({"pores": {"layout": "star"}}, "pore layout must be one of circle, spline, got 'star'"),
        ({"prism": {"n_x": 1}}, "sites along X must be at least 2"),
        ({"prism": {"n_y": 0}}, "sites along Y must be at least 2"),
        ({"prism": {"n_z": 2.5}}, r"job\.prism\.n_z must be a whole number, got 2\.5"),
        ({"prism": {"a_x": 5.0}}, "0 <= a < edge / 2 = 5 mm, got 5 mm"),
        ({"prism": {"l": 0}}, "edge along X must be at least 0.001"),
        ({"seed": -1}, "the seed must lie in 0"),
        ({"seed": 2**31}, "the seed must lie in 0"),
        ({"schema": 99}, "schema must be 1, got 99"),
        ({"couplings": []}, "at least one coupling"),
        ({"couplings": [{"first": "Face1", "second": "Face9"}]}, r"faces of the job \(Face1, .*, got 'Face9'"),
        ({"couplings": [{"first": "Face1"}]}, "a coupling needs two faces"),
        ({"envelope": "bone.step"}, "either an envelope file or a prism, got both"),
        ({"path": {"kind": "box", "box": [1, 2]}}, r"job\.path\.box must have 3 values, got 2"),
        ({"scaffold": {"engine": "magic"}}, "engine must be one of auto, mesh, field, brep, got 'magic'"),
        ({"scaffold": {"layers": {"faces": ["Face1"], "thickness": 0}}}, "thickness must be greater than 0, got 0 mm"),
        ({"edits": [{"site": "Face1.1.1", "action": "move"}]}, "to move site Face1.1.1 a point is needed"),
    ],
)
def test_a_job_that_breaks_a_rule_is_refused_with_rule_and_value(keys, message):
    refused(changed(CASE6, **keys), message)


def test_an_envelope_needs_faces_each_named_once():
    refused('{"envelope": "a.step", "couplings": [{"first": "A", "second": "B"}]}', "an envelope file needs faces")
    twice = [{"face": "Face1", "name": "A"}, {"face": "Face2", "name": "A"}]
    refused(changed(IMPLANT, faces=twice), "every face must be named once")


# ---------------------------------------------------------------------------------------------- size of a job


def test_a_thousand_million_rods_are_refused_with_time_and_memory():
    prism = {"n_x": 2, "n_y": 31_623, "n_z": 31_623}  # Face1 has 31,623^2 sites
    refused(
        changed(CASE6, prism=prism, couplings=[{"first": "Face1", "second": "Face2"}]),
        r"at most 20,000 rods; .* about [\d,.]+ hours and [\d,.]+ GB, got 1,000,014,129 rods",
    )


def test_the_estimate_grows_with_the_rods():
    texts = []
    for count in (10 * MOST_RODS, 100 * MOST_RODS):
        with pytest.raises(ParameterError) as error:
            check_rods(count)
        texts.append(str(error.value))
    hours = [float(text.split("about ")[1].split(" hours")[0].replace(",", "")) for text in texts]
    assert hours[1] == pytest.approx(10 * hours[0], rel=0.1)


def test_the_most_rods_are_allowed():
    check_rods(MOST_RODS)


def test_a_coupling_that_is_off_counts_no_rods():
    job = dataclasses.replace(
        CASE6,
        prism=PrismParameters(n_x=2, n_y=200, n_z=200),
        couplings=(Coupling("Face1", "Face2", on=False), Coupling("Face3", "Face4")),
    )
    assert job.prism.n_y == 200


# ------------------------------------------------------------------------------------------------ single fields


def test_fields_are_set_by_name():
    job = set_values(
        CASE6,
        [
            "pores.size.high=0.6",
            "prism.n_x=9",
            "path.kind=centre",
            "couplings.0.on=false",
            "name=my design",
            "path.box=[1, 2, 3]",
        ],
    )
    assert job.pores.size == Law("uniform", 0.2, 0.6)
    assert job.prism == PrismParameters(n_x=9)
    assert job.path == PathParameters("centre", box=(1.0, 2.0, 3.0))
    assert [c.on for c in job.couplings] == [False, True, True]
    assert job.name == "my design"


def test_setting_nothing_changes_nothing():
    assert set_values(CASE6, []) == CASE6


def test_a_text_may_hold_an_equals_sign():
    job = set_values(CASE6, ['pores.size={"kind": "expression", "expression": "0.4", "low": 0.2, "high": 0.8}'])
    assert job.pores.size.kind == "expression"
    assert set_values(CASE6, ["name=a=b"]).name == "a=b"


@pytest.mark.parametrize(
    ("setting", "message"),
    [
        ("seed", "a setting must read name=value, got 'seed'"),
        ("=3", "a setting must read name=value"),
        ("sead=3", "sead must name a field of the job; known here are schema, name"),
        ("pores.size.hihg=1", "known here are kind, low, high, direction, expression, got 'hihg'"),
        ("couplings.9.on=true", "couplings.9.on must number one of 3 entries, got '9'"),
        ("couplings.x.on=true", "must number one of 3 entries, got 'x'"),
        ("couplings.-1.on=true", "must number one of 3 entries, got '-1'"),
        ("seed.low=1", "known here are none"),
        ("seed=one", r"job\.seed must be a whole number, got 'one'"),
        ("seed=1.5", r"job\.seed must be a whole number, got 1\.5"),
        ("pores.scatter=NaN", "scatter of the corners must lie in 0..0.3, got nan"),
        ("scaffold.cell=Infinity", "the cell must be greater than 0, got inf mm"),
        ("pores.size.low=0.9", "low <= high, got 0.9 and 0.8"),
    ],
)
def test_a_setting_that_does_not_fit_is_refused(setting, message):
    with pytest.raises(ParameterError, match=message):
        set_values(CASE6, [setting])


def test_another_seed_changes_the_seed_only():
    assert with_seed(CASE6, 7) == dataclasses.replace(CASE6, seed=7)
    with pytest.raises(ParameterError, match="the seed must lie in"):
        with_seed(CASE6, -1)


# -------------------------------------------------------------------------------------------- numbers in general


def full_job():
    """A job in which nothing is missing, so that every number of the format stands somewhere."""
    point = [1.0, 2.0, 3.0]
    record = json.loads(job_to_json(dataclasses.replace(IMPLANT, envelope="", prism=PrismParameters())))
    record["faces"][0].update(origin=point, d1=point, d2=point)
    record["path"].update(points=[point])
    record["couplings"][0]["path"] = json.loads(json.dumps(record["path"]))
    record["scaffold"]["layers"]["faces"] = ["A"]
    edit = {"site": "A.1.1", "action": "pore", "point": point, "size": 0.5, "turns": [0.5] * 4}
    record["edits"] = [edit]
    return record


def places_of_numbers(value, way=()):
    if isinstance(value, dict):
        for key, one in value.items():
            yield from places_of_numbers(one, (*way, key))
    elif isinstance(value, list):
        for key, one in enumerate(value):
            yield from places_of_numbers(one, (*way, key))
    elif isinstance(value, float):
        yield way


PLACES = sorted(places_of_numbers(full_job()), key=str)


@pytest.mark.parametrize("way", PLACES, ids=lambda way: ".".join(map(str, way)))
def test_no_number_may_be_infinite_or_no_number(way):
    for bad in (math.nan, math.inf, -math.inf):
        record = full_job()
        owner = record
        for key in way[:-1]:
            owner = owner[key]
        owner[way[-1]] = bad
        with pytest.raises(ParameterError):
            from_record(Job, record, "job")


def test_the_full_job_is_one():
    assert job_from_json(json.dumps(full_job())).faces[0].origin == (1.0, 2.0, 3.0)
    assert len(PLACES) > 60


def test_every_field_says_its_unit_and_what_it_is():
    seen, waiting = set(), [Job]
    while waiting:
        cls = waiting.pop()
        if cls in seen or cls is Law:
            continue
        seen.add(cls)
        for field in dataclasses.fields(cls):
            assert set(field.metadata) >= {"unit", "doc"}, (cls, field.name)
        hints = str(typing.get_type_hints(cls))
        waiting += [
            c for c in (PathParameters, LayerParameters, PrismParameters, FaceParameters) if c.__name__ in hints
        ]


def test_opposite_faces_are_coupled_in_the_order_of_the_axes():
    assert [(c.first, c.second, c.association) for c in opposite_couplings("same")] == [
        ("Face1", "Face2", "same"),
        ("Face3", "Face4", "same"),
        ("Face5", "Face6", "same"),
    ]
