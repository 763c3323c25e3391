"""A press that keeps the tables of a course report instead of setting them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from vecpoly.report.content import Objects
from vecpoly.report.course.numbering import Press
from vecpoly.report.flow.results.blocked import BlockTable
from vecpoly.words import Words


@dataclass(frozen=True, slots=True)
class Made:
    """A table as it was asked for."""

    title: Words
    header: Sequence[str]
    rows: Sequence[tuple[str, ...]]
    style: Any


@dataclass(slots=True)
class Kept(Press):
    """A press that keeps the tables."""

    made: list[Made] = field(default_factory=list)

    def table(self, title: Any, header: Any, rows: Any, align: str, *, style: Any = None, blocks: int = 1) -> str:
        assert len(align) == len(header) and {len(row) for row in rows} == {len(header)}
        wide = BlockTable.of(header, rows, blocks, align, self.lang)
        self.made.append(Made(title, wide.header, wide.rows, style))
        return "made"


def press(lang: Any = "en") -> Kept:
    """One of this language."""
    return Kept(lang, Objects())


def shown(cell: str) -> float:
    """The number in a cell."""
    return float(cell.replace("−", "-"))
