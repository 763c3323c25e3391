"""What the families of keys have in common: a second way to the same answers, and how far the two are apart."""

from __future__ import annotations

from functools import lru_cache

from vecpoly import loads
from vecpoly.answer import Answer
from vecpoly.solution import Solution, solve

CLOSE = 1e-9  # of the value, or of a unit


@lru_cache(maxsize=4)
def solved(text: str) -> Solution:
    """By the exact hand."""
    return solve(loads(text), by="exact", repeats=0)


def value(answer: Answer) -> complex:
    """What is exact of an answer."""
    return answer.exact if answer.exact_vector is None else answer.exact_vector


def apart(key: str, one: Answer, other: Answer) -> str:
    """What is wrong where two answers are not alike; "" where they are."""
    if one.undefined and other.undefined:
        return ""
    here, there = value(one), value(other)
    close = abs(here - there) <= CLOSE * max(1.0, abs(there))
    return "" if close else f"{key} is {here}, but {there} when it is said otherwise"
