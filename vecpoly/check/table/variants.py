"""The variants of a problem: the files beside it that extend the same one,
and which of them has a length that was found."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path

from ...errors import VecpolyError
from ...problem.load import load
from ...problem.problem import Problem
from ...words import Words
from ..slips.explain import Explanation
from ..slips.guess import Slip
from ..slips.lengths import lengths

_EXTENDS = re.compile(r"^extends:\s*['\"]?([^\s'\"#]+)", re.MULTILINE)
ALIKE = 1e-6  # relative difference below which two lengths are the same


def whose_lengths(problem: Problem, told: Sequence[tuple[Explanation, ...]]) -> tuple[Words, ...]:
    """One sentence for each length of which other values than the problem's were found:
    which variants have these values."""
    best = [slips[0] for slips in told if slips and slips[0].slip in (Slip.LENGTH, Slip.RATES)]
    family = variants(problem) if best else []
    sentences = []
    for length in lengths(problem.mechanism) if len(family) > 1 else ():
        name = length.words.en
        found = [
            [one.parameter for one in best if one.length == name and one.slip is slip and one.parameter]
            for slip in (Slip.LENGTH, Slip.RATES)
        ]
        if any(found):
            sentences.append(_sentence(name, [*(found[0] or [length.value]), *found[1]], family))
    return tuple(words for words in sentences if words is not None)


def variants(problem: Problem) -> list[Problem]:
    """The problem, the one that it extends, and all in the same folder that extend this one."""
    if problem.path is None:
        return []
    base = _base(problem.text) or problem.id
    files = [
        file for file in sorted(problem.path.parent.glob("*.yaml")) if file.stem == base or _base(_text(file)) == base
    ]
    family = []
    for file in files:
        try:
            family.append(load(file))
        except VecpolyError:
            continue
    return [one for one in family if one.source is not None and type(one.subject) is type(problem.subject)]


def _sentence(name: str, values: Sequence[float], family: Sequence[Problem]) -> Words | None:
    """l_AB = 24 mm is that of variant B, 26.5 mm that of variant A; None where none of the values is a variant's."""
    zh, en = [], []
    for value in dict.fromkeys(round(value, 9) for value in values):
        whose = [
            one
            for one in family
            for length in lengths(one.mechanism)
            if length.words.en == name and abs(length.value / value - 1) < ALIKE
        ]
        if len(whose) == 1:
            called = _called(whose[0], family)
            zh.append(f"{1e3 * value:g} mm 即{called.zh}{' ' * called.zh[-1].isascii()}的尺寸")
            en.append(f"{1e3 * value:g} mm that of {called.en}")
    if not zh:
        return None
    return Words(f"{name} = {'，'.join(zh)}。", f"{name} = {', '.join(en).replace(' that', ' is that', 1)}.")


def _called(one: Problem, family: Sequence[Problem]) -> Words:
    """The part of its source by which a variant differs from the others; its title where the sources are alike."""
    assert one.source is not None
    sources = [other.source for other in family if other.source is not None]
    zh, en = one.source.zh.rpartition("，")[2].strip(), one.source.en.rpartition(",")[2].strip()
    if len({source.zh.rpartition("，")[2] for source in sources}) < len(sources):
        return Words(f"“{one.title.zh}”", f"“{one.title.en}”")
    return Words(zh, en)


def _base(text: str) -> str | None:
    found = _EXTENDS.search(text)
    return found[1] if found else None


def _text(file: Path) -> str:
    try:
        return file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):
        return ""
