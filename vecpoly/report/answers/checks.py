"""The table of the check: drawn beside exact; lengths on paper and directions stand in the box of answers above it."""

from __future__ import annotations

from collections.abc import Sequence

from ...solution import Answer, Solution
from ...words import Lang
from ..flow.results.halved import HalvedTable
from ..flow.table import DataTable
from ..tables import inks_of, trimmed
from .order import listed
from .placed import place_words, places_table
from .tables import counted, filled, lone_place, parted, unit_of

_KEPT = (0, 1, 4, 6, 7, 8)  # of the columns of readings: not the length, its scale, its direction
_ALIGN = "lcuudu"


def check_tables(solution: Solution, lang: Lang) -> tuple[DataTable, ...]:
    """What was read beside the exact values, and how far it is off; none where all is computed, and exact; a lone place
    beside other answers has a sentence."""
    places, others = parted(checked(solution))
    found = [_values(others, solution, lang)] if others else []
    rows = places if lone_place(checked(solution)) is None else []
    return (*found, *([HalvedTable.of(places_table(rows, solution, lang))] if rows else []))


def check_words(solution: Solution, lang: Lang) -> str:
    """A lone place beside its exact one."""
    lone = lone_place(checked(solution))
    return "" if lone is None else place_words(lone, lang)


def checked(solution: Solution) -> tuple[Answer, ...]:
    """The answers of which the check has something to say."""
    return tuple(one for one in listed(solution.answers.values()) if not _settled(one))


def unlisted(solution: Solution) -> bool:
    """Whether there are answers that the check does not list, because they are computed, and exact."""
    return 0 < len(checked(solution)) < len(solution.answers)


def _settled(answer: Answer) -> bool:
    """Whether it is no reading, and the same as the exact value."""
    return counted(answer) or (answer.computed and not answer.is_place)


def _values(answers: Sequence[Answer], solution: Solution, lang: Lang) -> DataTable:
    heads, rows = filled(answers, solution, lang)
    header, cells = [heads[n] for n in _KEPT], [tuple(row[n] for n in _KEPT) for row in rows]
    inks, units = inks_of(solution, (one.key for one in answers)), [unit_of(one) for one in answers]
    return HalvedTable.of(trimmed(header, cells, (), _ALIGN, lang, inks, groups=units))
