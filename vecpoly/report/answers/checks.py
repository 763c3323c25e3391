"""The table of the check: what the box of answers, above it, does not say; no value stands there once more."""

from __future__ import annotations

from collections.abc import Sequence

from ...solution import Answer, Solution
from ...words import Lang
from ..flow.results.halved import HalvedTable
from ..flow.table import DataTable
from ..tables import inks_of, trimmed
from .errors import expected_errors
from .order import listed
from .placed import places_table
from .tables import counted, deviations, headed, parted, row_of, unit_of

_KEPT, _UNIT = (0, 1, 6, 7, 8), (6, 8)  # of the columns of readings: not the length, its scale, the value, its way
_ALIGN = "lcudu"
_DRAWN = (1, 2)  # columns of a table of places that stand in the box too


def check_tables(solution: Solution, lang: Lang) -> tuple[DataTable, ...]:
    """The exact values, and how far the answers are off; none where all of them are computed, and exact."""
    places, others = parted(checked(solution))
    found = [_values(others, solution, lang)] if others else []
    return (*found, *([_places(places, solution, lang)] if places else []))


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
    heads, one_unit = headed(answers, lang)
    errors = expected_errors(answers)
    rows = [row_of(one, solution, lang, "" if one_unit else unit_of(one)) for one in answers]
    off, told = deviations(heads[_KEPT[3]], [row[_KEPT[3]] for row in rows], lang)
    header = [off if n == _KEPT[3] else heads[n] for n in _KEPT]
    cells = [(row[0], row[1], row[6], gap, errors[one.key]) for row, gap, one in zip(rows, told, answers, strict=True)]
    inks, units = inks_of(solution, (one.key for one in answers)), [unit_of(one) for one in answers]
    return HalvedTable.of(trimmed(header, cells, (), _ALIGN, lang, inks, groups=units))


def _places(answers: Sequence[Answer], solution: Solution, lang: Lang) -> DataTable:
    whole = places_table(list(answers), solution, lang)
    kept = [n for n in range(len(whole.header)) if n not in _DRAWN]
    return HalvedTable.of(
        DataTable(
            [whole.header[n] for n in kept],
            [[row[n] for n in kept] for row in whole.rows],
            None,
            "".join(whole.align[n] for n in kept),
            lang=lang,
            inks=whole.inks,
            inked=whole.inked,
        )
    )
