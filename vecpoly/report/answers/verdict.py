"""What the check comes to, in one sentence: whether every deviation is as small as it may be, and what could hardly be
found by drawing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite

from ...algebra.rounding import read_back
from ...printed.digits import coarse, is_hopeless
from ...solution import Answer, Solution
from ...words import Lang, Words, joined
from .alike import named_once
from .checks import checked
from .errors import NOTHING, beside, sign_of
from .placed import gaps, reaches
from .tables import deviation_told, tabled

ILL, ILL_ANGLE = 2.0, 3.0  # mm on paper, degrees: what may be off by more is hardly found by drawing
PAIR = 2  # names that are told with their errors; of more these are seen in the table
_UNITS = {"": " %", "°": "°", "mm": " mm"}


@dataclass(frozen=True, slots=True)
class _Off:
    """One quantity of the check: its name, by how much it is off and may be off, as printed, and in which unit."""

    name: str
    off: str
    error: str
    sign: str  # "": per cents; "°"; "mm"
    ill: bool

    @property
    def size(self) -> float:
        """The deviation without its sign."""
        return abs(read_back(self.off)[0])

    @property
    def within(self) -> bool:
        """Whether it is no larger than expected, but for its own rounding."""
        size, half = read_back(self.off)
        return abs(size) - half <= read_back(self.error)[0]

    def amount(self, text: str) -> str:
        """A number with the unit."""
        return f"{text.lstrip('+−')}{_UNITS[self.sign]}"


def verdict_of(solution: Solution, lang: Lang) -> str:
    """The sentence under the tables of the check; nothing where a single value was read, whose line says all."""
    found = [*_values(solution, lang), *_places(solution)]
    if not found or (len(checked(solution)) == 1 and len(found) == 1 and found[0].within and not found[0].ill):
        return ""
    told = [_whole(found), _ill([one for one in found if one.ill])]
    return ("" if lang == "zh" else " ").join(words.of(lang) for words in told if words is not None)


def _values(solution: Solution, lang: Lang) -> list[_Off]:
    """What is no place, and is off by per cents or degrees."""
    once = named_once(tabled(checked(solution))[1], solution, lang)
    answers = [one for one, _ in once]
    offs = [deviation_told(one) for one in answers]
    rows = zip(once, offs, beside(answers, offs), strict=True)
    return [
        _Off(name, off.removesuffix("°"), error.removesuffix("°"), sign_of(off), _is_ill(one))
        for (one, name), off, error in rows
        if NOTHING not in (off, error) and not is_hopeless(one)
    ]


def _is_ill(answer: Answer) -> bool:
    if answer.reading.unit == "deg":
        return answer.expected_error > ILL_ANGLE
    share = coarse(answer)
    return share is not None and isfinite(share)


def _places(solution: Solution) -> list[_Off]:
    """The places, off by millimetres."""
    answers = tabled(checked(solution))[0]
    mu = next((figure.scale.value for figure in solution.construction.figures if figure.scale.unit == "m"), 0.0)
    ends = zip(answers, gaps(answers), reaches(answers), strict=True)
    return [
        _Off(f"${one.reading.symbol}$", off, error, "mm", bool(mu) and one.expected_error > ILL * mu)
        for one, off, error in ends
        if NOTHING not in (off, error)
    ]


def _whole(found: Sequence[_Off]) -> Words:
    """All are as small as they may be, or which are not."""
    if not any(one.size for one in found):
        return Words("各量与精确值一致。", "All values equal the exact ones to the last digit.")
    if len(found) == 1:
        return _alone(found[0])
    over = [one for one in found if not one.within]
    if not over:
        return Words("各偏差均不超过预期误差。", "Every deviation is within its expected error.")
    told = joined([_told(one) for one in over])
    return Words(
        f"除{told.zh} 外，各偏差均不超过预期误差。", f"Every deviation but {told.en} is within its expected error."
    )


def _told(one: _Off) -> Words:
    off, error = one.amount(one.off), one.amount(one.error)
    return _with(one.name, Words(f"{off}，预期误差 {error}", f"{off}, expected {error}"))


def _with(name: str, said: Words) -> Words:
    """The name with this in brackets; in those that it has, where it has some: M_d0 (no friction, 0.30 %)."""
    zh = f"{name[:-1]}，{said.zh}）" if name.endswith("）") else f" {name}（{said.zh}）"
    en = f"{name[:-1]}, {said.en})" if name.endswith(")") else f"{name} ({said.en})"
    return Words(zh, en)


def _alone(one: _Off) -> Words:
    off, error = one.amount(one.off), one.amount(one.error)
    zh, en = ("不超过", "is within") if one.within else ("超过", "exceeds")
    return Words(
        f"{one.name} 的偏差 {off} {zh}预期误差 {error}。",
        f"The deviation of {one.name}, {off}, {en} its expected error, {error}.",
    )


def _ill(found: Sequence[_Off]) -> Words | None:
    """What is ill-conditioned, and should be computed."""
    if not found:
        return None
    named = joined([_with(one.name, Words.same(f"±{one.amount(one.error)}")) for one in found])
    if len(found) > PAIR:
        named = joined([Words.same(one.name) for one in found])
    verb, s = ("is", "") if len(found) == 1 else ("are", "s")
    return Words(
        f"{named.zh.lstrip()} 由作图不易准确求得，应以计算值为准。",
        f"{named.en} {verb} ill-conditioned in the drawing: take the computed value{s}.",
    )
