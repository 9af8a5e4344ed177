# SPDX-License-Identifier: LGPL-2.1-or-later
"""The history of mended rods: the same outcome as without it, and only what changed is mended again."""

from dataclasses import replace

import numpy as np
import pytest

from freecad_trabecula.core import history, recovery
from freecad_trabecula.core.assembly import draft_wireframe
from freecad_trabecula.core.job import opposite_couplings
from freecad_trabecula.core.laws import Region
from freecad_trabecula.core.parameters import PathParameters, PrismParameters, SiteEdit
from freecad_trabecula.core.sites import prism_sites
from freecad_trabecula.core.wireframe import WireframeParameters

REGION = Region((0.0, 0.0, 0.0), (10.0, 10.0, 10.0), (5.0, 5.0, 5.0))
#: Middle points far out: many rods are flat, some leave the cube, some cannot be mended.
WILD = WireframeParameters(path=PathParameters("box", box=(14.0, 14.0, 14.0)), couplings=opposite_couplings("random"))


def inside(points):
    return ((points >= 0) & (points <= 10)).all(1)


def draft(parameters, n=4):
    return draft_wireframe(parameters, prism_sites(PrismParameters(n_x=n, n_y=n, n_z=n)), REGION)


def assert_same(a, b):
    assert a.names == b.names
    assert a.keys() == b.keys()
    assert (a.recoveries, a.failed, a.outside) == (b.recoveries, b.failed, b.outside)
    assert (a.coupling == b.coupling).all() and (a.site_numbers == b.site_numbers).all()


@pytest.fixture
def mended(monkeypatch):
    """Numbers of rods that were handed to ``mend``, in order."""
    counts = []

    def counted(raw, *others):
        counts.append(len(raw))
        return recovery.mend(raw, *others)

    monkeypatch.setattr(history, "mend", counted)
    return counts


def test_the_outcome_is_that_of_mending_all_at_once():
    raw = draft(WILD)
    plain = recovery.mend(raw, WILD, REGION, inside)
    assert len(plain.recoveries) > 5
    ours = history.History()
    assert_same(ours.mend(raw, WILD, REGION, inside).wireframe, plain)
    assert_same(ours.mend(raw, WILD, REGION, inside).wireframe, plain)


def test_what_was_mended_once_is_not_mended_again(mended):
    ours, raw = history.History(), draft(WILD)
    ours.mend(raw, WILD, REGION, inside)
    ours.mend(raw, WILD, REGION, inside)
    assert mended == [len(raw)]
    assert len(ours) == len(raw)


def test_after_the_change_of_one_pore_one_rod_is_mended(mended):
    ours = history.History()
    ours.mend(draft(WILD), WILD, REGION, inside)
    edited = replace(WILD, edits=(SiteEdit("Face1.2.2", "pore", size=0.5),))
    raw = draft(edited)
    assert_same(ours.mend(raw, edited, REGION, inside).wireframe, recovery.mend(raw, edited, REGION, inside))
    assert mended[1:] == [1]


@pytest.mark.parametrize(
    "changed",
    [
        replace(WILD, seed=2),
        replace(WILD, rods=replace(WILD.rods, redraws=1)),
        replace(WILD, pores=replace(WILD.pores, scatter=0.1)),
        replace(WILD, path=replace(WILD.path, box=(13.0, 14.0, 14.0))),
    ],
)
def test_a_change_of_what_all_share_is_never_answered_from_the_past(changed):
    ours = history.History()
    ours.mend(draft(WILD), WILD, REGION, inside)
    raw = draft(changed)
    assert_same(ours.mend(raw, changed, REGION, inside).wireframe, recovery.mend(raw, changed, REGION, inside))


def test_another_envelope_is_another_history(mended):
    ours, raw = history.History(), draft(WILD)
    ours.mend(raw, WILD, REGION, inside, "a")
    other = ours.mend(raw, WILD, REGION, lambda points: np.ones(len(points), bool), "b")
    assert mended == [len(raw), len(raw)]
    assert other.wireframe.outside == ()


def test_a_full_history_starts_again(monkeypatch):
    monkeypatch.setattr(history, "_MOST", 50)
    ours, raw = history.History(), draft(WILD)
    assert_same(ours.mend(raw, WILD, REGION, inside).wireframe, recovery.mend(raw, WILD, REGION, inside))
    ours.mend(draft(replace(WILD, seed=2)), replace(WILD, seed=2), REGION, inside)
    assert len(ours) == len(raw)


def test_no_rods_are_no_error():
    parameters = replace(WILD, couplings=(replace(WILD.couplings[0], on=False),))
    assert len(history.History().mend(draft(parameters), parameters, REGION, inside).wireframe) == 0


def test_what_one_history_mended_another_can_learn(mended):
    raw = draft(WILD)
    done = history.History().mend(raw, WILD, REGION, inside)
    other = history.History()
    other.learn(done)
    assert_same(other.mend(raw, WILD, REGION, inside).wireframe, done.wireframe)
    assert mended == [len(raw)]


def test_rods_that_no_remedy_mends_fail_again_without_being_tried(monkeypatch, mended):
    monkeypatch.setattr(recovery, "REMEDIES", dict.fromkeys(recovery.FAULTS, ()))
    raw = draft(WILD)
    done = history.History().mend(raw, WILD, REGION, inside)
    assert len(done.wireframe.failed) > 5
    assert sum(done.failed) == len(done.wireframe.failed)
    other = history.History()
    other.learn(done)
    assert_same(other.mend(raw, WILD, REGION, inside).wireframe, done.wireframe)
    assert mended == [len(raw)]


def test_last_bits_make_no_other_key_and_a_micrometre_does():
    raw = draft(WILD)
    keys = history.rounded_keys(raw)
    assert len(set(keys)) == len(raw)
    assert history.rounded_keys(replace(raw, paths=raw.paths * (1 + 1e-15))) == keys
    assert not set(history.rounded_keys(replace(raw, paths=raw.paths + 1e-3))) & set(keys)
