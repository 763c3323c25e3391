"""Item analysis: of each answer how many were right and by what basis, and which slips were made how often."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from ...grading.compare.outcome import Basis, Finding, Outcome
from ...grading.told.slip import SLIPS
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


@dataclass(frozen=True, slots=True, kw_only=True)
class Item:
    """One answer over the class. slips: how often each mistake, or other reason, was behind it, most often first."""

    problem: str
    key: str
    counts: Counter[str]
    share: float
    slips: tuple[tuple[Words, int], ...]


def items(results: Sequence[Result]) -> list[Item]:
    """Of every answer of every problem that somebody gave, or that is worth points."""
    found: dict[tuple[str, str], list[tuple[Finding, Result]]] = {}
    for result in results:
        for problem, marked in result.marks.items():
            for one in marked.findings:
                found.setdefault((problem, one.key), []).append((one, result))
    return [_item(problem, key, each) for (problem, key), each in found.items()]


def _item(problem: str, key: str, each: Sequence[tuple[Finding, Result]]) -> Item:
    counts = Counter(_class(one) for one, _ in each)
    worth = sum(result.marks[problem].key[key].points.total for _, result in each)
    earned = sum(one.earned.total for one, _ in each)
    slips: Counter[Words] = Counter()
    for one, result in each:
        if key in result.marks[problem].slips:
            slips.update([said.words for said in one.messages if said.id in SLIPS])
        elif one.outcome is Outcome.WRONG and one.messages:
            slips.update(
                [said.words for said in one.messages if said.id in ("pow10", "two_pi", "per_minute", "swapped")][:1]
            )
    return Item(
        problem=problem,
        key=key,
        counts=counts,
        share=earned / worth if worth else 0.0,
        slips=tuple(slips.most_common(5)),
    )


def _class(one: Finding) -> str:
    if one.for_a_person:
        return "person"
    if one.basis is not Basis.EXACT and one.is_right:
        return "own"
    match one.outcome:
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


def item_rows(found: Sequence[Item], lang: Lang) -> list[list[str | float]]:
    """As a table, with a header."""
    rows: list[list[str | float]] = [[word.of(lang) for word in _HEAD]]
    for one in found:
        answered = sum(one.counts.values()) - one.counts["blank"]
        numbers = [one.counts[name] for name in ("right", "close", "own", "turned", "wrong", "blank", "person")]
        said = "; ".join(f"{bare(words.of(lang))} ×{count}" for words, count in one.slips)
        rows.append([one.problem, one.key, float(answered), *map(float, numbers), round(one.share, 3), said])
    return rows
