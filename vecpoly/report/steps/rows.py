"""Like steps in a row, of which each has a row for one table: they are told by that table, and said once."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...board.construction import Listing, Step
from ...words import Lang, Words
from ..flow.table import DataTable

_LEAST = 3  # steps that make a table
_NUMBER = Words("步骤", "Step")


def in_runs(steps: Iterable[Step]) -> Iterator[tuple[Step, ...]]:
    """The steps, those together that share a table."""
    run: list[Step] = []
    for step in steps:
        if run and not (step.row is not None and _head(run[-1]) == step.row.head):
            yield from _cut(run)
            run = []
        run.append(step)
    yield from _cut(run)


def _head(step: Step) -> tuple[Words, ...]:
    return () if step.row is None else step.row.head


def _cut(run: list[Step]) -> Iterator[tuple[Step, ...]]:
    if len(run) >= _LEAST:
        yield tuple(run)
    else:
        yield from ((one,) for one in run)


def lead_of(steps: tuple[Step, ...], lang: Lang) -> str:
    """What is said once of all of them, and of single ones."""
    blank = "" if lang == "zh" else " "
    return blank.join((_row(steps[0]).lead.of(lang), *(note for step in steps if (note := _remark(step, lang)))))


def rows_table(steps: tuple[Step, ...], lang: Lang) -> DataTable:
    """A row a step."""
    rows = [(str(step.number), *_row(step).rows[0]) for step in steps]
    heads = [_NUMBER.of(lang), *(head.of(lang) for head in _row(steps[0]).head)]
    return DataTable(heads, rows, None, "c" * len(heads), lang=lang)


def _remark(step: Step, lang: Lang) -> str:
    """What is said behind the sentence for which the row stands, under the name in its first cell."""
    row = _row(step)
    said = row.told.of(lang) if row.told is not None else ""
    more = step.words.of(lang).removeprefix(said).strip()
    return f"{row.rows[0][0]}{Words('：', ': ').of(lang)}{more[:1].lower()}{more[1:]}" if more else ""


def _row(step: Step) -> Listing:
    assert step.row is not None
    return step.row
