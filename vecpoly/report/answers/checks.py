"""The table of the check: drawn beside exact; lengths on paper and directions stand in the box of answers above it."""

from __future__ import annotations

from collections.abc import Sequence

from ...printed.digits import is_hopeless
from ...solution import Answer, Solution
from ...words import Lang, Words
from ..flow.results.halved import HalvedTable
from ..flow.table import DataTable
from ..tables import trimmed
from .alike import named_once
from .errors import NOTHING, beside
from .kinds import tables_and_sentences
from .order import listed
from .placed import endless_words, place_words, places_table
from .tables import counted, filled, lone_place, row_of, tabled, unit_of

_KEPT = (0, 1, 4, 6, 7, 8)  # of the columns of readings: not the length, its scale, its direction
_ALIGN = "lcdddd"


def check_tables(solution: Solution, lang: Lang) -> tuple[DataTable, ...]:
    """What was read beside the exact values, and how far it is off, in per cent, in degrees, or where it vanishes; none
    where all is computed, and exact; a lone place beside other answers, and a lone value of its kind, has a
    sentence."""
    places, others = tabled(checked(solution))
    found = [_values(kind, solution, lang) for kind in tables_and_sentences(others, len(places) > 1)[0]]
    rows = places if lone_place(checked(solution)) is None else []
    return (*found, *([HalvedTable.of(places_table(rows, solution, lang))] if rows else []))


def check_words(solution: Solution, lang: Lang) -> str:
    """A lone place, or a value alone in its kind, with what it is exactly, and the places at infinity."""
    every = checked(solution)
    lone, (places, others) = lone_place(every), tabled(every)
    told = (
        *(_value_words(one, solution, lang) for one in tables_and_sentences(others, len(places) > 1)[1]),
        "" if lone is None else place_words(lone, lang),
        endless_words(every, lang),
    )
    return ("" if lang == "zh" else " ").join(filter(None, told))


def _value_words(answer: Answer, solution: Solution, lang: Lang) -> str:
    """The row of one value as a sentence."""
    name, unit, _, _, drawn, _, exact, off = row_of(answer, solution, lang, unit_of(answer))
    (error,) = beside([answer], [off])
    unit = {NOTHING: "", "°": "°"}.get(unit, f" {unit}")
    told = Words(
        f"{name} 量得 {drawn}{unit}，精确值 {exact}{unit}",
        f"The value of {name} was read as {drawn}{unit}; exactly it is {exact}{unit}",
    )
    if off == NOTHING or is_hopeless(answer):
        return (told + Words(f"（预期误差 {error}）。", f" (expected error {error}).")).of(lang)
    off, error = (text if text.endswith("°") else f"{text} %" for text in (off, error))
    return (
        told + Words(f"，偏差 {off}（预期误差 {error}）。", f": a deviation of {off} (expected error {error}).")
    ).of(lang)


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
    once = named_once(answers, solution, lang)
    answers = [one for one, _ in once]
    heads, rows = filled(answers, solution, lang)
    header = [heads[n] for n in _KEPT]
    cells = [(name, *(row[n] for n in _KEPT[1:])) for (_, name), row in zip(once, rows, strict=True)]
    alike = _alike(answers, cells)
    told = [(Words("、", ", ").of(lang).join(cells[n][0] for n in some), *cells[some[0]][1:]) for some in alike]
    return HalvedTable.of(trimmed(header, told, (), _ALIGN, lang, [unit_of(answers[some[0]]) for some in alike]))


def _alike(answers: Sequence[Answer], cells: Sequence[tuple[str, ...]]) -> list[list[int]]:
    """Rows that say the same of one length on paper, as of a force and of its reaction, have one row."""
    found = dict[tuple[object, ...], list[int]]()
    for n, (one, row) in enumerate(zip(answers, cells, strict=True)):
        mm = one.reading.mm
        found.setdefault((mm, *row[1:]) if mm is not None and one.drawn_vector is not None else (n,), []).append(n)
    return list(found.values())
