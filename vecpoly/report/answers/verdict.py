"""What must be said of the values of an answer beside what its table shows: which could hardly be found by drawing, and
which are off by more than was expected."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite

from ...algebra.rounding import read_back
from ...names import Named
from ...printed.digits import coarse
from ...solution import Answer, Solution
from ...words import Lang, Words, joined
from .errors import NOTHING, STAR

ILL, ILL_ANGLE = 2.0, 3.0  # mm on paper, degrees: what may be off by more is hardly found by drawing
_STARRED = Words(
    f"{STAR} 由作图不易准确求得，以精确值为准", f"{STAR} ill-conditioned in the drawing: take the exact value"
)


def is_ill(answer: Answer, solution: Solution) -> bool:
    """Whether it is hardly found by drawing: a place, an angle or a share that may be off by much, or a length of a
    linkage that is to be made."""
    if answer.computed or not isfinite(answer.expected_error):
        return False
    if answer.is_place and answer.drawn_vector is not None:
        mu = next((one.scale.value for one in solution.construction.figures if one.scale.unit == "m"), 0.0)
        return bool(mu) and answer.expected_error > ILL * mu
    if answer.reading.unit == "deg":
        return answer.expected_error > ILL_ANGLE
    share = coarse(answer)
    return share is not None or _is_loose(answer, solution)


def _is_loose(answer: Answer, solution: Solution) -> bool:
    """Whether it is a length of a linkage that was found, of which the drawing tells too little."""
    number = answer.rel.solution if isinstance(answer.rel, Named) else 0
    stem = answer.key.removesuffix(f"_{number}")
    return any(stem in one.loose for one in solution.verification if number in (0, one.number))


def starred(error: str, answer: Answer, solution: Solution) -> str:
    """The expected error as it is printed, with a star where a note tells what that is for."""
    return f"{error}{STAR}" if error != NOTHING and is_ill(answer, solution) else error


def exceeds(off: str, error: str) -> bool:
    """Whether a deviation, as printed, is larger than expected, but for its own rounding."""
    if NOTHING in (off, error):
        return False
    size, half = _size(off)
    return abs(size) - half > _size(error)[0]


def _size(text: str) -> tuple[float, float]:
    """The number of a cell, without its unit and the star, and half of its last digit."""
    return read_back(text.partition(" ")[0].rstrip(f"°{STAR}"))


def remarks_on(over: Sequence[str], stars: bool, lang: Lang) -> tuple[str, ...]:
    """The notes: what the star is for; the names of what is off by more than expected."""
    named = joined([Words.same(name) for name in over])
    many = len(over) > 1
    told = Words(
        f"{named.zh} 的偏差超过预期误差",
        f"The deviation{'s' if many else ''} of {named.en} exceed{'' if many else 's'} what is expected",
    )
    return (*((_STARRED.of(lang),) if stars else ()), *((told.of(lang),) if over else ()))
