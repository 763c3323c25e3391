"""Answers in tables of their own, so that a column of deviations has one unit."""

from __future__ import annotations

from collections.abc import Sequence

from ...solution import Answer
from .errors import NOTHING
from .tables import sign_of_deviation

_SIGNS = ("", "°", NOTHING)


def kinds(answers: Sequence[Answer]) -> list[list[Answer]]:
    """Those off by per cents, those off by degrees, and those that have no deviation: exactly they are zero."""
    signs = [sign_of_deviation(one) for one in answers]
    found = [[one for one, own in zip(answers, signs, strict=True) if own == sign] for sign in _SIGNS]
    return [kind for kind in found if kind]


def tables_and_sentences(answers: Sequence[Answer], beside: bool) -> tuple[list[list[Answer]], list[Answer]]:
    """The kinds that have a table, and what is alone in its kind, which has a sentence; beside: whether another table
    stands there. Where all are alone they share one table."""
    found = kinds(answers)
    several = [kind for kind in found if len(kind) > 1]
    if several or beside:
        return several, [kind[0] for kind in found if len(kind) == 1]
    return ([list(answers)] if answers else []), []
