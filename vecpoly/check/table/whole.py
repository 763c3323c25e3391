"""A printed or computed table against the oracle: which columns agree, which do not, and by which slip.

check_table(load("A-16"), "printed.csv").whole
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from ...errors import TableError
from ...foundation.arguments import of_kind
from ...mechanism.model import Mechanism
from ...problem.problem import Problem
from ...problem.text.held import Held
from ...problem.without_cycle import no_cycle
from ...words import Words
from ..slips.base import explained, weighed_by
from ..slips.explain import Explanation, suspect
from .columns import Table, read_table
from .sheet import Sheet, read_sheet
from .told.column import of_column
from .told.whole import of_whole
from .variants import whose_lengths
from .weigh import Column, Level, Weighing

KEPT = 16  # tables


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class ColumnCheck:
    """One column: how it fares with the problem's data (`given`),
    by which slips it becomes right, and all that in words.

    `rows`: positions of the drive (deg, or mm) at which it is wrong although it is right elsewhere.
    """

    column: Column
    given: Weighing
    explanations: tuple[Explanation, ...]
    rows: tuple[float, ...]
    words: Words

    @property
    def verdict(self) -> Level:
        """The verdict with the data of the problem."""
        return self.given.level

    @property
    def best(self) -> Weighing:
        """The weighing under the best explanation; else with the data of the problem."""
        return self.explanations[0].after if self.explanations else self.given


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class TableCheck:
    """The check of a whole table (`title`: how its file's first comment calls it, else its name): its columns, what was
    taken for granted (`notes`), the verdict on the whole."""

    problem: str
    name: str
    title: Words
    table: Table
    columns: tuple[ColumnCheck, ...]
    notes: tuple[Words, ...]
    whole: tuple[Words, ...]

    @property
    def agrees(self) -> bool:
        """Whether no column is wrong, not even in certain rows."""
        return all(one.verdict < Level.ROWS and not one.explanations for one in self.columns)

    def column(self, header: str) -> ColumnCheck:
        """The column with this header."""
        return next(one for one in self.columns if one.column.header == header)


def check_table(problem: Problem, path: str | Path | Held, columns: Mapping[str, str] | None = None) -> TableCheck:
    """Compare each column of a CSV or XLSX table with the exact values;
    `columns`: header → quantity, unit, or - to leave it out.

    Raises TableError where the table cannot be read or has nothing to do with the mechanism.
    """
    of_kind(path, (str, Path, Held), Words("文件名", "the name of a file"))
    of_kind(problem, Problem, Words("题目（load 或 loads 的结果）", "a problem, as load and loads give it,"))
    if not isinstance(problem.subject, Mechanism):
        raise TableError(no_cycle(problem))
    sheet = read_sheet(path if isinstance(path, Held) else Path(path))
    return _compared(problem, sheet, tuple((columns or {}).items()))


@lru_cache(maxsize=KEPT)
def _compared(problem: Problem, sheet: Sheet, columns: tuple[tuple[str, str], ...]) -> TableCheck:
    """The check of these cells: every report of the problem, in each language, tells of the same."""
    table = read_table(sheet, problem, dict(columns))
    given = suspect(problem.mechanism, table.positions, table.columns)
    if given is None:
        raise TableError(
            Words(
                f"{problem.id} 的机构不能装配，{table.name} 无从比较",
                f"{problem.id} cannot be assembled, so there is nothing to compare {table.name} with",
            )
        )
    weighed = [weighed_by(column, given) for column in table.columns]
    told = explained(table.columns, given, weighed)
    checks = tuple(_checked(table, i, weighed, told) for i in range(len(table.columns)))
    names = "、".join(table.left_out), ", ".join(table.left_out)
    left = (Words(f"未比较的列：{names[0]}", f"columns left out: {names[1]}"),) if table.left_out else ()
    return TableCheck(
        problem=problem.id,
        name=table.name,
        title=sheet.title,
        table=table,
        columns=checks,
        notes=(*table.notes, *left),
        whole=(*of_whole(table, weighed, told), *whose_lengths(problem, told)),
    )


def _checked(table: Table, i: int, weighed: Sequence[Weighing], told: Sequence[tuple[Explanation, ...]]) -> ColumnCheck:
    best = told[i][0].after if told[i] else weighed[i]
    rows = tuple(float(table.printed[k]) for k in np.flatnonzero(best.outliers))
    return ColumnCheck(
        column=table.columns[i],
        given=weighed[i],
        explanations=told[i],
        rows=rows,
        words=of_column(table, i, weighed, told),
    )
