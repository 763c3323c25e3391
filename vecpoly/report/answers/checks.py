"""The table of the check: drawn beside exact; lengths on paper and directions stand in the box of answers above it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...printed.digits import drawn_number, exact_number, is_hopeless
from ...solution import Answer, Solution
from ...words import Lang, Words, joined
from ..flow.results.halved import HalvedTable
from ..flow.table import DataTable
from ..tables import trimmed
from .alike import named_once
from .errors import NOTHING, beside
from .kinds import parted_by_deviation, table_and_sentences
from .order import listed
from .placed import clean, endless_words, place_words, places_table
from .tables import counted, filled, lone_place, row_of, tabled, unit_of

_KEPT = (0, 1, 4, 6, 7, 8)  # of the columns of readings: not the length, its scale, its direction
_ALIGN = "lcdddd"


def check_tables(solution: Solution, lang: Lang) -> tuple[DataTable, ...]:
    """What was read beside the exact values, and how far it is off, in per cent or in degrees; none
    where all is computed, and exact; a lone place beside other answers, and a lone value of its kind, has a
    sentence."""
    places, others = tabled(checked(solution))
    shared = table_and_sentences(others, len(places) > 1)[0]
    found = [_values(shared, solution, lang)] if shared else []
    rows = places if lone_place(checked(solution)) is None else []
    return (*found, *([HalvedTable.of(places_table(rows, solution, lang))] if rows else []))


def check_words(solution: Solution, lang: Lang) -> str:
    """A lone place, or a value alone in its kind, with what it is exactly, and the places at infinity."""
    every = checked(solution)
    lone, (places, others) = lone_place(every), tabled(every)
    told = (
        *_sentences(table_and_sentences(others, len(places) > 1)[1], solution, lang),
        "" if lone is None else place_words(lone, lang),
        endless_words(every, lang),
    )
    return ("" if lang == "zh" else " ").join(filter(None, told))


def _sentences(answers: Sequence[Answer], solution: Solution, lang: Lang) -> Iterator[str]:
    """Each value in its own; all that vanishes, as it does exactly, in one."""
    nothing = [
        one for one in parted_by_deviation(answers)[1] if drawn_number(one) == "0" == exact_number(one, clean(one))
    ]
    together = nothing if len(nothing) > 1 else []
    yield from (_value_words(one, solution, lang) for one in answers if one not in together)
    if together:
        yield _vanishing_words(together, solution, lang)


def _vanishing_words(answers: Sequence[Answer], solution: Solution, lang: Lang) -> str:
    """What vanishes by the drawing and exactly, with the errors that were to be expected, each told once."""
    once = named_once(answers, solution, lang)
    errors = beside([one for one, _ in once], [NOTHING] * len(once))
    alike = dict[str, list[str]]()
    for (_, name), error in zip(once, errors, strict=True):
        alike.setdefault(error, []).append(name)
    told = joined(
        [
            Words(f"{'、'.join(names)}（预期误差 {error}）", f"{', '.join(names)} (expected error {error})")
            for error, names in alike.items()
        ]
    )
    return Words(f"{told.zh}量得均为 0，与精确值一致。", f"{told.en} were read as 0, which is exact.").of(lang)


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
    """Whether it is no reading, and the same as the exact value: a place that is given, too."""
    seen = answer.is_place and not answer.expected_error and answer.drawn_vector == answer.exact_vector is not None
    return counted(answer) or seen or (answer.computed and not answer.is_place)


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
