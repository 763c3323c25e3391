"""Printed tables of a problem as a report speaks of them: the whole, then column by column, then remarks."""

from __future__ import annotations

from typing import Any

from ..check.table import TableCheck, check_table
from ..problem.problem import Problem
from ..words import Lang
from .content import Objects
from .flow.table import DataTable

_HEAD = {"zh": ("列", "结论", "说明"), "en": ("Column", "Verdict", "What is behind it")}


def printed_tables(problem: Problem, lang: Lang, objects: Objects) -> list[dict[str, Any]]:
    """One entry a table: its file name, what is to be said of the whole, the verdict on each column, remarks."""
    return [_table(check_table(problem, file), lang, objects) for file in problem.tables]


def _table(checked: TableCheck, lang: Lang, objects: Objects) -> dict[str, Any]:
    rows = [(one.column.header, one.verdict.words.of(lang), one.words.of(lang)) for one in checked.columns]
    return {
        "name": checked.name, "whole": [words.of(lang) for words in checked.whole], "notes": [words.of(lang) for words in checked.notes],
        "columns": objects.add("tab", DataTable(_HEAD[lang], rows, (22.0, 30.0, 118.0), "lll")),
    }
