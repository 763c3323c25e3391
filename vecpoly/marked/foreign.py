"""Answers that are another student's: they agree throughout with somebody else's key, and not with one's own."""

from __future__ import annotations

from collections.abc import Mapping

from ..batch.register import Register
from ..foundation.slotted import replace
from ..grading.compare.band import target_of, weigh
from ..grading.compare.measured import Measured, measured
from ..grading.compare.outcome import Finding
from ..grading.key import AnswerKey, Kind
from ..grading.marking.marked import Marked
from ..grading.marking.marker import mark
from ..grading.scheme import Scheme
from ..grading.sheet import sheet_of
from ..words import Words
from .intake.returned import Answers, Returned
from .work import Result

FEWEST = 2  # answers that one's own key does not bear out


def own_work(register: Register, result: Result, scheme: Scheme, returned: Returned) -> Result:
    """The result; where the answers are another's, marked by one's own exact values alone, and left for a person."""
    for problem, marked in result.marks.items():
        whose = _whose(register, result.student.number, problem, marked)
        answers = returned.answers.get((result.student.number, problem))
        if whose is not None and answers is not None:
            result = _alone(register, result, answers, scheme, whose)
    return result


def _whose(register: Register, number: str, problem: str, marked: Marked) -> str | None:
    """The number of the student whose key all values agree with; lengths may have been found from them, by one's own
    scale."""
    answered = [one for one in marked.findings if one.outcome.answered]
    values = [one for one in answered if marked.key[one.key].kind is not Kind.READING]
    told = values if len(values) > FEWEST else answered
    given = {one.key: _measured(one, marked.key) for one in told}
    if sum(_off(one, marked.key) for one in told) < FEWEST:
        return None
    for sheet in register.sheets:
        part = next((part for part in sheet.parts if part.problem == problem), None)
        if part is not None and sheet.student.number != number and _agree(given, part.key):
            return sheet.student.number
    return None


def _off(one: Finding, key: AnswerKey) -> bool:
    """Whether an answer is not right by one's own exact values."""
    graded = key[one.key]
    return one.off is not None and abs(one.off) > key.allowance.wrong * graded.allowed


def _measured(one: Finding, key: AnswerKey) -> Measured | None:
    """What was written, by one's own scales."""
    return measured(one.written, key[one.key], key.scales.get(key[one.key].mu))


def _agree(given: Mapping[str, Measured | None], key: AnswerKey) -> bool:
    for name, mine in given.items():
        one = key.find(name)
        if one is None or mine is None or not weigh(mine, one, target_of(one), key.allowance).is_right:
            return False
    return True


def _alone(register: Register, result: Result, answers: Answers, scheme: Scheme, whose: str) -> Result:
    """All that was handed in, marked afresh: its equations and scales are one's own work."""
    sheet, problem = register.sheet(result.student.number), answers.problem
    part = next((part for part in sheet.parts if part.problem == problem), None) if sheet else None
    if part is None:
        return result
    key, work = scheme.key(part.key), result.drawings.get(problem)
    rules, drawing = replace(scheme.rules, following=False), None if work is None else work.mark
    again = mark(register.variant(part), key, tuple, sheet_of(key, answers.cells), rules, drawing)
    said = Words(
        f"题 {problem} 的答案与学号 {whose} 的数据一致，而与本人的不符；未作连带评分，请人工核对",
        f"the answers to {problem} agree with the numbers of student {whose}, and not with one's own; nothing was "
        "followed through, check them",
    )
    return replace(result, marks={**result.marks, problem: again}, faults=(*result.faults, said))
