"""vecpoly check --table: the columns of a printed table against the oracle,
each with its verdict and the slip behind it.

Exit code 0: every column agrees; 1: one is wrong, or wrong in certain rows; 2: the table cannot be read.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from ...errors import TableError
from ...limits import LONG_READ
from ...words import Words, bare
from ..errors import DISAGREES, about
from ..files import STDOUT, write_json
from ..options import Lang
from ..terminal import add, say, show, table

if TYPE_CHECKING:
    from ...check.slips.explain import Explanation
    from ...check.table.whole import ColumnCheck, TableCheck
    from ...problem.problem import Problem

_COLUMNS = {
    "zh": ("列", "量", "结论", "正确行数", "最大偏差", "原因", "此时"),
    "en": ("column", "quantity", "verdict", "rows right", "largest deviation", "by which slip", "then"),
}


def columns_said(texts: Sequence[str] | None) -> dict[str, str]:
    """What stands after --columns: header → meaning; raises TableError where there is no '='."""
    said = {}
    for text in (part.strip() for one in texts or () for part in one.split(",") if part.strip()):
        header, equals, meaning = text.partition("=")
        if not (equals and header.strip() and meaning.strip()):
            raise TableError(
                Words(
                    f"--columns {text}：应写作 列名=含义，如 phi_5=rad, w3=omega_4, remarks=-",
                    f"--columns {text}: write HEADER=MEANING, e.g. phi_5=rad, w3=omega_4, remarks=-",
                )
            )
        said[header.strip()] = meaning.strip()
    return said


def check_table_of(
    problems: Sequence[Problem], path: Path, said: Mapping[str, str], json: Path | None, lang: Lang
) -> None:
    """Compare the table with one problem; exit code 1 where a column is wrong."""
    from ...check.table.whole import check_table

    if len(problems) != 1:
        raise TableError(
            Words(
                f"一张表只与一道题比较；这里给出 {len(problems)} 道：{', '.join(one.id for one in problems)}",
                f"a table is compared with one problem; {len(problems)} are named: "
                f"{', '.join(one.id for one in problems)}",
            )
        )
    if path.is_file() and path.stat().st_size > LONG_READ and sys.stderr.isatty():
        say(
            Words(
                f"正在读取并核对 {path.name}（{path.stat().st_size / 1e6:.1f} MB）……",
                f"reading and checking {path.name} ({path.stat().st_size / 1e6:.1f} MB) ...",
            ).of(lang)
        )
    with about(problems[0]):
        checked = check_table(problems[0], path, said)
    if json != STDOUT:
        _print(problems[0], checked, lang)
    if json is not None:
        write_json(as_json(checked), json)
    if not checked.agrees:
        raise typer.Exit(DISAGREES)


def _print(problem: Problem, checked: TableCheck, lang: Lang) -> None:
    right = {3, 4}
    made = table(
        f"{problem.id}  {bare(problem.title.of(lang))}  {checked.name}",
        [(name, "right" if i in right else "left") for i, name in enumerate(_COLUMNS[lang])],
    )
    for one in checked.columns:
        add(made, _row(one, lang))
    show(made)
    for words in (*checked.notes, *checked.whole):
        typer.echo(bare(words.of(lang)))
    typer.echo("")
    for one in checked.columns:
        typer.echo(f"  {bare(one.words.of(lang))}")


def _row(one: ColumnCheck, lang: Lang) -> tuple[str, ...]:
    from ...check.table.told.amounts import amount

    column, given = one.column, one.given
    slips = "; ".join(bare(slip.words.of(lang)) for slip in one.explanations[:1])
    more = f" (+{len(one.explanations) - 1})" if len(one.explanations) > 1 else ""
    return (
        column.header,
        bare(column.target.symbol),
        given.level.words.of(lang),
        f"{given.rows_right}/{int(column.there.sum())}",
        bare(amount(column, given.worst)),
        slips + more,
        one.best.level.words.of(lang) if one.explanations else "",
    )


def as_json(checked: TableCheck) -> dict[str, Any]:
    """The check as plain data."""
    return {
        "id": checked.problem, "table": checked.name, "agrees": checked.agrees, "rows": len(checked.table.positions),
        "notes": [words.en for words in checked.notes], "whole": [words.en for words in checked.whole],
        "columns": [_column(one) for one in checked.columns],
    }  # fmt: skip


def _column(one: ColumnCheck) -> dict[str, Any]:
    column, given = one.column, one.given
    return {
        "header": column.header,
        "symbol": column.target.key,
        "unit": column.unit,
        "verdict": given.level.label,
        "rows": int(column.there.sum()),
        "rows_right": given.rows_right,
        "largest": _number(given.worst / column.factor),
        "wrong_rows": list(one.rows),
        "explanations": [_explanation(slip, column.factor) for slip in one.explanations],
        "words": one.words.en,
    }


def _explanation(one: Explanation, factor: float) -> dict[str, Any]:
    return {
        "slip": one.slip.value, "words": one.words.en, "parameter": one.parameter, "verdict": one.after.level.label,
        "rows_right": one.after.rows_right, "largest": _number(one.after.largest / factor),
    }  # fmt: skip


def _number(value: float) -> float | None:
    return value if isfinite(value) else None
