"""What a person must look at: whose answer, what was written, where it stands, why."""

from __future__ import annotations

from collections.abc import Sequence

from ...errors import Fault
from ...grading.told.alone import alone
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
                why = ("；" if lang == "zh" else "; ").join(bare(said.words.of(lang)) for said in alone(one.messages))
                place = result.places.get((problem, one.key))
                where = "" if place is None else place.words.of(lang)
                rows.append([result.student.number, problem, one.key, one.written.raw, where, why])
            rows += [
                [result.student.number, problem, figure.of(lang), "", "", why.of(lang)] for figure, why in marked.doubts
            ]
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
