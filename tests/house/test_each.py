"""A claim about many cases tries all of them, names all that fail, and fails where there is nothing to try."""

from __future__ import annotations

import inspect

import pytest

from tests.each import ALONE, FULL, Later, each


def judged(cases: list[int], tried: list[int]) -> None:
    @each(cases)
    def even(case: int) -> None:
        tried.append(case)
        assert case % 2 == 0, f"{case} is odd"

    even()


def test_all_cases_are_tried_and_all_that_fail_are_named_a_few_of_them_in_full() -> None:
    tried: list[int] = []
    with pytest.raises(ExceptionGroup, match="10 of 20 cases fail: 1, 3, 5, 7, 9, 11, 13, 15, 17, 19") as failed:
        judged(list(range(20)), tried)
    assert tried == list(range(20)) and len(failed.value.exceptions) == FULL
    assert all("is odd" in str(one) and f"{ALONE}=" in one.__notes__[0] for one in failed.value.exceptions)
    judged([2, 4], tried)


def test_a_claim_about_no_case_fails() -> None:
    with pytest.raises(AssertionError, match="there is no case at all"):
        judged([], [])


def test_one_case_is_tried_alone_and_must_be_there(monkeypatch: pytest.MonkeyPatch) -> None:
    tried: list[int] = []
    monkeypatch.setenv(ALONE, "4")
    judged([1, 4, 5], tried)
    assert tried == [4]
    with pytest.raises(AssertionError, match="there is no case 4"):
        judged([1, 5], [])


def test_cases_are_looked_for_when_the_first_is_wanted_and_once() -> None:
    looked: list[str] = []
    late = Later(lambda: looked.append("here") or ["a", "b"])  # type: ignore[func-returns-value]
    claim = each(late)(lambda case: None)
    assert looked == []
    claim()
    assert list(late) == ["a", "b"] and "a" in late and len(late) == 2 and looked == ["here"]


def test_what_a_claim_wants_beside_its_case_is_given_to_it() -> None:
    @each("ab")
    def claim(case: str, tmp_path: str) -> None:
        assert case in "ab" and tmp_path == "there"

    assert list(inspect.signature(claim).parameters) == ["tmp_path"]
    claim(tmp_path="there")
