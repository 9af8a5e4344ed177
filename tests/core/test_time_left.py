# SPDX-License-Identifier: LGPL-2.1-or-later
"""The time left: exact for even work, calm for uneven work, honest when the work becomes slower. The clock is ours."""

import math
import random

import pytest

from freecad_trabecula.core.time_left import TimeLeft


class Work:
    """A work with a clock of its own."""

    def __init__(self):
        self.now = 100.0
        self.left = TimeLeft(lambda: self.now)

    def go(self, seconds, share):
        self.now += seconds
        self.left.report(share)
        return self.left.seconds()


@pytest.mark.parametrize("total", [5.0, 90.0, 4000.0])
def test_even_work_is_known_from_the_start(total):
    work = Work()
    for k in range(1, 101):
        said = work.go(total / 100, k / 100)
        if k >= 11:
            assert said == pytest.approx(total * (1 - k / 100), abs=1e-6 * total)


def test_before_a_share_of_the_work_is_done_nothing_is_said():
    work = Work()
    assert work.left.seconds() is None
    assert work.go(10.0, 0.01) is None
    assert work.go(10.0, 0.5) is not None


def test_it_runs_down_between_reports_and_never_below_nothing():
    work = Work()
    assert work.go(10.0, 0.5) == 10.0
    for passed, said in ((4.0, 6.0), (5.0, 1.0), (20.0, 0.0)):
        work.now += passed
        assert work.left.seconds() == pytest.approx(said)


@pytest.mark.parametrize("seed", range(5))
def test_uneven_reports_of_an_even_work_never_let_it_go_up(seed):
    """Steps of one work take between half and one and a half times as long as they say."""
    rng = random.Random(seed)
    work, before, rises = Work(), math.inf, 0
    share = 0.0
    while share < 1.0:
        step = rng.uniform(0.005, 0.02)
        share = min(share + step, 1.0)
        said = work.go(100 * step * rng.uniform(0.5, 1.5), share)
        if said is not None:
            rises += said > before + 1e-9
            before = said
    assert rises == 0


def test_a_work_that_becomes_three_times_slower_says_so_in_few_steps_and_comes_to_the_right_end():
    work, said, rises, before = Work(), None, 0, math.inf
    for k in range(1, 101):
        said = work.go(1.0 if k <= 50 else 3.0, k / 100)
        if said is not None:
            rises += said > before
            before = said
        if k == 75:
            assert said == pytest.approx(75.0, rel=0.35)
    assert 1 <= rises <= 5
    assert said < 3.0


def test_a_work_that_becomes_faster_is_told_at_once():
    work = Work()
    for k in range(1, 51):
        work.go(2.0, k / 100)
    slow = work.left.seconds()
    for k in range(51, 81):
        said = work.go(0.2, k / 100)
    assert said < slow / 3


def test_shares_that_go_back_or_stand_change_nothing():
    work = Work()
    work.go(10.0, 0.5)
    assert work.go(1.0, 0.4) == work.go(0.0, 0.5) == pytest.approx(9.0)
