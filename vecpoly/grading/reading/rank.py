"""The class of a mechanism as it is written: Ⅱ, II 级, class III, 二级, 2, 不能拆分."""

from __future__ import annotations

import re

from ...foundation.roman import NUMERALS
from ...foundation.slotted import replace
from .characters import plain
from .written import State, Written, written

_LATIN = {numeral.lower(): n for n, numeral in enumerate(NUMERALS, 1)}
_SIGNS = {numeral.lower(): n for n, numeral in enumerate(NUMERALS.values(), 1)}
_WORDS = {word: n for n, word in enumerate("一二三四五六", 1)}
_RANK = re.compile(r"(?:class|第)?\s*([iv]+|[ⅰ-ⅵ]|[一二三四五六]|\d)\s*(?:级\s*(?:机构|杆组|组)?|class)?")
_NEVER = re.compile(r"(?:不能|不可|无法)\s*(?:拆分|拆组|再拆)|cannot be taken apart")


def rank(raw: str | float | None) -> Written:
    """What was written of a class; 0 is one that cannot be taken apart. The raw text is kept."""
    text = plain("" if raw is None else f"{raw:g}" if isinstance(raw, float) else str(raw)).lower()
    if _NEVER.fullmatch(text):
        return replace(written("0"), raw=str(raw))
    found = _RANK.fullmatch(text)
    number = None if found is None else {**_LATIN, **_SIGNS, **_WORDS}.get(found[1], found[1])
    told = written(str(number)) if number is not None else None
    return written(raw) if told is None or told.state is not State.READ else replace(told, raw=str(raw))
