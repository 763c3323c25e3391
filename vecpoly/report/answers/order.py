"""The order of answers wherever they are listed: by the solutions that they belong to, else by kinds."""

from __future__ import annotations

import re
from collections.abc import Container, Iterable
from dataclasses import dataclass

from ...algebra.formula import Row, plain
from ...foundation.slotted import replace
from ...names import Named
from ...solution import Answer, Solution
from ...words import Lang, Words
from ..statement.groups import by_groups, parted

_OF_SOLUTION = re.compile(r".*\^\((\d+)\)")  # above the symbol with which a line begins


@dataclass(frozen=True, slots=True)
class Part:
    """Answers that stand together, under the number of their solution; 0: of what has none."""

    answers: tuple[Answer, ...]
    solution: int = 0

    def heading(self, lang: Lang, broken: Container[int] = ()) -> str:
        """What stands over them; broken: the numbers of those that do not move."""
        if not self.solution:
            return ""
        told = Words(f"解 {self.solution}", f"Solution {self.solution}")
        return (told + Words("（不能使用）", " (cannot be used)") if self.solution in broken else told).of(lang)


def as_found(answer: Answer) -> Answer:
    """The answer under the symbol that its line has: l_BC of the first solution as l_BC with (1) above."""
    number, own = _in_line(answer), answer.reading.symbol
    if not number or "^{(" in own:
        return answer
    return replace(answer, reading=replace(answer.reading, symbol=f"{own}^{{({number})}}"))


def arranged(answers: Iterable[Answer]) -> tuple[Part, ...]:
    """What is shared, then one solution after the other; of a single one many by kinds, each in the order asked."""
    every = list(answers)
    by_solution: dict[int, list[Answer]] = {}
    for one in every:
        by_solution.setdefault(solution_of(one), []).append(one)
    if len(by_solution.keys() - {0}) > 1:
        return tuple(Part(tuple(by_solution[number]), number) for number in sorted(by_solution))
    if not parted([one.key for one in every]):
        return (Part(tuple(every)),)
    return (Part(tuple(one for _, some in by_groups(every, key=lambda one: one.key) for one in some)),)


def broken(solution: Solution) -> frozenset[int]:
    """The numbers of the solutions of a synthesis that do not move with the lengths read."""
    return frozenset(one.number for one in solution.verification if one.broken is not None)


def listed(answers: Iterable[Answer]) -> tuple[Answer, ...]:
    """All of them in this order."""
    return tuple(one for part in arranged(answers) for one in part.answers)


def solution_of(answer: Answer) -> int:
    """To which of several solutions an answer belongs; 0 where it is one of all, or there is one only."""
    if isinstance(answer.rel, Named) and answer.rel.solution:
        return answer.rel.solution
    return _in_line(answer)


def _in_line(answer: Answer) -> int:
    """The number above the symbol with which its line begins; 0 where there is none."""
    line = answer.reading.formula
    found = _OF_SOLUTION.match(_begins(line)) if isinstance(line, Row) else None
    return int(found[1]) if found else 0


def _begins(line: Row) -> str:
    """What stands before the first equality sign."""
    says = ""
    for item in line.items:
        says += plain(item)
        if "=" in says:
            break
    return says.partition("=")[0]
