"""Printed tables of a problem as a report speaks of them: the whole, then column by column, then remarks."""

from __future__ import annotations

from typing import Any

from ..check.table import TableCheck, check_table
from ..problem.problem import Problem
from ..words import Lang


def printed_tables(problem: Problem, lang: Lang) -> list[dict[str, Any]]:
    """One entry a table: its file name, what is to be said of the whole, the verdict on each column, remarks."""
    return [_table(check_table(problem, file), lang) for file in problem.tables]


def _table(checked: TableCheck, lang: Lang) -> dict[str, Any]:
    return {
        "name": checked.name, "whole": _run_on([words.of(lang) for words in checked.whole], lang), "notes": _run_on([words.of(lang) for words in checked.notes], lang),
        "columns": [one.words.of(lang) for one in checked.columns],
    }


def _run_on(texts: list[str], lang: Lang) -> str:
    """Several remarks in one box, numbered."""
    return texts[0] if len(texts) == 1 else ("　" if lang == "zh" else "  ").join(f"({i}) {text}" for i, text in enumerate(texts, 1))
