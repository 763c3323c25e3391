"""Answers in one unit under each other: as many decimals, where their readings have them: 95.6, 127.2 and 264.8 mm."""

from __future__ import annotations

from collections.abc import Mapping

from ..answer import YES_NO, Answer
from ..foundation.slotted import replace
from .digits import decimals, is_hopeless, leads_with_1


def uniform(answers: Mapping[str, Answer]) -> dict[str, Answer]:
    """Each with the decimals of those read off at the same scale, as the least; but not with those that one has more
    because it begins with 1."""
    kinds = dict[tuple[str, str], int]()
    for one in answers.values():
        if _is_read(one) and not leads_with_1(one.drawn) and (places := decimals(one)) is not None:
            kind = (one.reading.unit, one.reading.scale)
            kinds[kind] = max(places, kinds.get(kind, 0))
    return {
        key: replace(one, least=kinds.get((one.reading.unit, one.reading.scale), 0)) if _is_read(one) else one
        for key, one in answers.items()
    }


def _is_read(answer: Answer) -> bool:
    """Whether its number is a length on paper times a scale, and worth its figures."""
    found = answer.reading.mm is not None and answer.reading.unit != YES_NO and not answer.is_place
    return found and not answer.computed and not answer.undefined and not is_hopeless(answer)
