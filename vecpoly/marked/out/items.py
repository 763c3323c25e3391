"""Item analysis: of each answer, each row of the equations, each line of the drawings, how many were right and by
what basis, and which slips were made how often."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import assert_never

from ...grading.compare.outcome import Basis, Finding, Outcome
from ...grading.drawings.judging.mark import Basis as DrawnBasis
from ...grading.drawings.judging.mark import DrawingMark, VectorMark, Verdict
from ...grading.marking.marked import Marked
from ...grading.told.slip import SLIPS, told_of
from ...words import Lang, Words, bare
from ..work import Result

_HEAD = tuple(
    Words(*both)
    for both in (
        ("题号", "problem"), ("量", "quantity"), ("作答", "answered"), ("正确", "right"),
        ("接近", "close"), ("连带正确", "right by own values"),
        ("转向或方向错", "sense or direction"), ("错误", "wrong"), ("未答", "blank"),
        ("待人工", "for a person"), ("得分率", "share of points"),
        ("常见错误", "slips"),
    )
)  # fmt: skip
LINE = Words("（图线）", " (line)")
_FACTORS = ("pow10", "two_pi", "per_minute", "swapped", "exchanged")


@dataclass(frozen=True, slots=True, kw_only=True)
class Item:
    """One answer, or one line, over the class. slips: how often each mistake, or other reason, was behind it, most
    often first."""

    problem: str
    key: Words
    counts: Counter[str]
    share: float
    slips: tuple[tuple[Words, int], ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class _Entry:
    """What one student made of it. sort: the column that counts it; why: the mistakes behind it."""

    problem: str
    key: Words
    sort: str
    earned: float
    worth: float
    why: tuple[Words, ...] = ()


def items(results: Sequence[Result]) -> list[Item]:
    """Of every answer of every problem that somebody gave, or that is worth points; then of every line of the drawings
    that were handed in."""
    found: dict[tuple[str, Words], list[_Entry]] = {}
    for entries in (_numbers, _equations, _lines):
        for result in results:
            for one in entries(result):
                found.setdefault((one.problem, one.key), []).append(one)
    return [_item(problem, key, each) for (problem, key), each in found.items()]


def _item(problem: str, key: Words, each: Sequence[_Entry]) -> Item:
    worth, earned = sum(one.worth for one in each), sum(one.earned for one in each)
    slips = Counter(why for one in each for why in one.why)
    return Item(
        problem=problem, key=key, counts=Counter(one.sort for one in each), share=earned / worth if worth else 0.0,
        slips=tuple(slips.most_common(5)),
    )  # fmt: skip


# -- numbers ------------------------------------------------------------------------------------------------------


def _numbers(result: Result) -> Iterator[_Entry]:
    for problem, marked in result.marks.items():
        for one in marked.findings:
            yield _Entry(
                problem=problem, key=Words.same(one.key), sort=_class(one), earned=one.earned.total,
                worth=marked.key[one.key].points.total, why=_why(one, marked),
            )  # fmt: skip


def _why(one: Finding, marked: Marked) -> tuple[Words, ...]:
    if one.key in marked.slips:
        return tuple(said.words for said in one.messages if said.id in SLIPS)
    if one.outcome is not Outcome.WRONG:
        return ()
    return tuple(said.words for said in one.messages if said.id in _FACTORS)[:1]


def _class(one: Finding) -> str:
    if one.for_a_person:
        return "person"
    if one.basis is not Basis.EXACT and one.is_right:
        return "own"
    return _sort(one.outcome)


def _sort(outcome: Outcome) -> str:
    match outcome:
        case Outcome.RIGHT | Outcome.UNSAID:
            return "right"
        case Outcome.CLOSE:
            return "close"
        case Outcome.SENSE | Outcome.DIRECTION:
            return "turned"
        case Outcome.WRONG:
            return "wrong"
        case Outcome.BLANK | Outcome.NONE:
            return "blank"
        case Outcome.UNREADABLE | Outcome.AMBIGUOUS:
            return "person"
        case _:
            assert_never(outcome)


def _equations(result: Result) -> Iterator[_Entry]:
    for problem, marked in result.marks.items():
        for one in marked.equations:
            why = tuple(said.words for said in one.messages) if one.outcome in (Outcome.CLOSE, Outcome.WRONG) else ()
            yield _Entry(
                problem=problem, key=one.title, sort=_sort(one.outcome), earned=one.earned, worth=one.worth, why=why
            )


# -- lines --------------------------------------------------------------------------------------------------------


def _lines(result: Result) -> Iterator[_Entry]:
    """Every vector of every figure of the drawing, whether or not it has points by it."""
    for problem, work in result.drawings.items():
        paid = {one.key: one for one in result.marks[problem].lines}
        for figure in work.mark.figures:
            doubtful = bool(work.mark.doubt or figure.doubt) or not figure.declared
            for one in figure.vectors:
                lines = [paid[key] for key in one.keys if key in paid]
                yield _Entry(
                    problem=problem, key=Words.same(one.key) + LINE, sort=_drawn(one, doubtful=doubtful),
                    earned=sum(line.earned for line in lines), worth=sum(line.worth for line in lines),
                    why=_behind(one, work.mark),
                )  # fmt: skip


def _drawn(one: VectorMark, *, doubtful: bool) -> str:
    if one.verdict is Verdict.MISSING:
        return "blank"
    if doubtful:
        return "person"
    if one.basis is DrawnBasis.SLIP:
        return "own"
    match one.verdict:
        case Verdict.RIGHT | Verdict.CLOSE if one.basis is DrawnBasis.OWN:
            return "own"
        case Verdict.RIGHT:
            return "right"
        case Verdict.CLOSE:
            return "close"
        case Verdict.WRONG:
            turned = one.length in (Verdict.RIGHT, Verdict.CLOSE)
            return "turned" if turned else "wrong"
        case _:
            assert_never(one.verdict)


def _behind(one: VectorMark, mark: DrawingMark) -> tuple[Words, ...]:
    return (told_of(mark.slip).words,) if one.costs and mark.slip is not None else ()


# -- the table ----------------------------------------------------------------------------------------------------


def item_rows(found: Sequence[Item], lang: Lang) -> list[list[str | float]]:
    """As a table, with a header."""
    rows: list[list[str | float]] = [[word.of(lang) for word in _HEAD]]
    for one in found:
        answered = sum(one.counts.values()) - one.counts["blank"]
        numbers = [one.counts[name] for name in ("right", "close", "own", "turned", "wrong", "blank", "person")]
        said = "; ".join(f"{bare(words.of(lang))} ×{count}" for words, count in one.slips)
        rows.append([one.problem, one.key.of(lang), float(answered), *map(float, numbers), round(one.share, 3), said])
    return rows
