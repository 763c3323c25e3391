"""What a person must look at: whose answer, what was written, where it stands, why."""

from __future__ import annotations

from collections.abc import Sequence

from ...errors import Fault
from ...grading.told.alone import alone
from ...grading.told.message import Message
from ...words import Lang, Words, bare
from ..work import Result

_HEAD = (
    Words("学号", "number"),
    Words("题号", "problem"),
    Words("量", "quantity"),
    Words("所写", "written"),
    Words("位置", "place"),
    Words("原因", "why"),
)


def queue_rows(results: Sequence[Result], lang: Lang, faults: Sequence[Fault] = ()) -> list[list[str | float]]:
    """A row for each answer or figure that waits for a person, and for each row of the files that was of no use."""
    rows: list[list[str | float]] = [[word.of(lang) for word in _HEAD]]
    for result in results:
        for problem, marked in result.marks.items():
            for one in marked.queue:
                why = _why(one.messages, lang)
                where = _where(result, problem, one.key, lang)
                rows.append([result.student.number, problem, one.key, one.written.raw, where, why])
            told = {one.title: one for one in marked.equations}
            for figure, doubt in marked.doubts:
                row = told.get(figure)
                where, raw = ("", "") if row is None else (_where(result, problem, row.row.key, lang), row.raw)
                said = doubt.of(lang) if row is None else _why(row.messages, lang)
                rows.append([result.student.number, problem, figure.of(lang), raw, where, said])
        rows += [[result.student.number, "", "", "", "", fault.of(lang)] for fault in result.faults]
    rows += [
        [
            str(one.numbers.get("student", "")),
            "",
            "",
            "",
            one.place.words.of(lang) if one.place else "",
            one.said.of(lang),
        ]
        for one in faults
    ]
    return rows


def _where(result: Result, problem: str, key: str, lang: Lang) -> str:
    """The cell in which it was written, where that is known."""
    place = result.places.get((problem, key))
    return "" if place is None else place.words.of(lang)


def _why(said: Sequence[Message], lang: Lang) -> str:
    """The reasons, for the person who looks at it."""
    return ("；" if lang == "zh" else "; ").join(bare(one.words.of(lang)) for one in alone(said))
