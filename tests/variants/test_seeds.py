"""The same names give the same numbers for ever; whole numbers below n are equally likely."""

from __future__ import annotations

from collections import Counter

from hypothesis import given
from hypothesis import strategies as st

from vecpoly.variants.seeds import Seed, Stream

SEED = Seed(assignment="作业 3", problem="3-9", student="20231234", salt="")


def test_numbers_that_were_printed_once_come_again() -> None:
    """Written down on the day on which the scheme was made: a sheet must be found again years later."""
    stream = SEED.stream(0)
    assert [stream.below(1000) for _ in range(6)] == PRINTED


PRINTED = [586, 565, 791, 537, 447, 865]


@given(st.text(max_size=8), st.text(max_size=8))
def test_names_do_not_run_into_each_other(left: str, right: str) -> None:
    here = Seed(assignment=left + "|", problem=right, student="s").stream(0)
    there = Seed(assignment=left, problem="|" + right, student="s").stream(0)
    assert [here.below(1 << 60) for _ in range(2)] != [there.below(1 << 60) for _ in range(2)]


@given(st.integers(1, 10**9), st.text(max_size=4))
def test_a_number_stays_below_its_bound(n: int, name: str) -> None:
    assert 0 <= Stream(name).below(n) < n


def test_every_number_below_n_is_as_likely_as_any_other() -> None:
    """χ² over 7 values of 7,000 draws: 22.5 is exceeded once in a thousand."""
    stream = Stream("likely")
    found = Counter(stream.below(7) for _ in range(7000))
    assert sum((found[i] - 1000) ** 2 / 1000 for i in range(7)) < 22.5


@given(st.lists(st.integers(), max_size=20))
def test_a_shuffle_loses_nothing(items: list[int]) -> None:
    assert sorted(Stream("s").shuffled(items)) == sorted(items)
