"""Which answers of the check share its table, and which have a sentence."""

from __future__ import annotations

from collections.abc import Sequence

from ...solution import Answer
from .errors import NOTHING
from .tables import sign_of_deviation


def parted_by_deviation(answers: Sequence[Answer]) -> tuple[list[Answer], list[Answer]]:
    """Those that are off by per cents or degrees, and those that have no deviation: exactly they are zero."""
    off = [one for one in answers if sign_of_deviation(one) != NOTHING]
    return off, [one for one in answers if sign_of_deviation(one) == NOTHING]


def table_and_sentences(answers: Sequence[Answer], beside: bool) -> tuple[list[Answer], list[Answer]]:
    """What shares one table, and what a sentence tells: a value alone beside others, and what vanishes; beside: whether
    another table stands there."""
    off, vanishing = parted_by_deviation(answers)
    if len(off) > 1:
        return off, vanishing
    return ([], [*off, *vanishing]) if beside or len(answers) > 1 else ([*answers], [])
