"""Answers in one unit under each other: as many decimals, where their readings have them: 95.6, 127.2 and 264.8 mm."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import floor, isclose, isfinite, log10

from ..algebra.formula import Row
from ..answer import YES_NO, Answer
from ..foundation.slotted import replace
from .digits import READ, TENTH, decimals, is_hopeless, leads_with_1, places_for
from .lengths import only_length
from .units import printed_unit


def uniform(answers: Mapping[str, Answer]) -> dict[str, Answer]:
    """Each with the decimals of those read off at the same scale, as the least; but not with those that one has more
    because it begins with 1."""
    kinds = dict[tuple[str, str], int]()
    for one in answers.values():
        if _is_read(one) and not leads_with_1(one.drawn) and (places := decimals(one)) is not None:
            kind = (one.reading.unit, one.reading.scale)
            kinds[kind] = max(places, kinds.get(kind, 0))
    told = {
        key: replace(one, least=kinds.get((one.reading.unit, one.reading.scale), 0)) if _is_read(one) else one
        for key, one in answers.items()
    }
    return {key: _as_its_equal(one, told.values()) for key, one in told.items()}


def _as_its_equal(answer: Answer, others: Iterable[Answer]) -> Answer:
    """With the figures of the length on paper from which it follows, three at most, 5.60 rad/s; as another answer of
    its size, ω_7 = ω_2 = 5.60 rad/s."""
    if not _follows(answer):
        return answer
    same = [one for one in others if _follows(one) and one.reading.unit == answer.reading.unit]
    equal = [one for one in same if isclose(abs(one.drawn), abs(answer.drawn), rel_tol=1e-9)]
    return replace(answer, least=max(map(_places_read, equal), default=0))


def _places_read(answer: Answer) -> int:
    """The decimals with which it has the figures of the only length on paper in its line; none of another."""
    line = answer.reading.formula
    length = only_length(line) if isinstance(line, Row) else None
    if not length or length < TENTH:
        return 0
    return places_for(printed_unit(answer.reading.unit)[0] * answer.drawn, min(READ, floor(log10(length)) + 2))


def _follows(answer: Answer) -> bool:
    """Whether it is worked out from what was read, and no length on paper times a scale itself."""
    sized = answer.reading.unit not in (YES_NO, "deg", "") and not answer.is_place and isfinite(answer.drawn)
    return sized and answer.reading.mm is None and not answer.computed and bool(answer.drawn)


def _is_read(answer: Answer) -> bool:
    """Whether its number is a length on paper times a scale, and worth its figures."""
    found = answer.reading.mm is not None and answer.reading.unit != YES_NO and not answer.is_place
    return found and not answer.computed and not answer.undefined and not is_hopeless(answer)
