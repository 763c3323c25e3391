"""What came back: cells by student and problem, each with where it stands."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from ...errors import Fault, Place
from ...words import Words

Cells = dict[str, str]  # symbol, or scale → as it was written


@dataclass(frozen=True, slots=True, kw_only=True)
class Answers:
    """One student's cells of one problem, and where each stands."""

    student: str
    problem: str
    cells: Mapping[str, str]
    places: Mapping[str, Place] = field(default_factory=dict)


def written_twice(symbol: str, before: Place) -> Words:
    """That one answer stands in two places, by whatever names: nobody knows which of them is meant."""
    return Words(
        f"{symbol} 已在 {before.words.zh} 写了；此处未用，请只留一个",
        f"{symbol} is written in {before.words.en} already; this one is not used, leave one of them",
    )


@dataclass(slots=True)
class Returned:
    """All that was read, in the order of the files; faults: rows and columns that belong to nobody or nothing."""

    answers: dict[tuple[str, str], Answers] = field(default_factory=dict)
    faults: list[Fault] = field(default_factory=list)

    def add(self, one: Answers) -> None:
        """Keep a student's answers to a problem; a second row of the same is told, and does not replace the first."""
        key = one.student, one.problem
        if key not in self.answers:
            self.answers[key] = one
            return
        where, before = (next(iter(each.places.values()), Place("")) for each in (one, self.answers[key]))
        self.fault(
            where,
            "twice",
            Words(
                f"学号 {one.student} 的题 {one.problem} 已在 {before.words.zh} 读入；此行未用，请只留一行",
                f"problem {one.problem} of {one.student} was read from {before.words.en} already; this row is not used",
            ),
            one.student,
        )

    def fault(self, place: Place, code: str, said: Words, student: str = "") -> None:
        """Keep what cannot be used. student: the number, where it is known whose it is."""
        numbers = {"student": student} if student else {}
        self.faults.append(Fault(said=said, code=code, place=place, numbers=numbers))
