"""What a framed answer prints, row by row, for claims about it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from vecpoly.report.answers.rows import BY_FORMULA, GIVEN
from vecpoly.report.flow.results.box import AnswerBox
from vecpoly.report.flow.results.framed import FramedTable
from vecpoly.report.flow.results.tabled import TabledAnswers

KNOWN = {*(words for one in (BY_FORMULA, GIVEN) for words in (one.zh, one.en))}
_HEADS = {
    "value": ("Drawn", "Result", "量得", "结果"),
    "unit": ("Unit", "单位"),
    "way": ("Direction", "方向"),
    "exact": ("Exact", "精确"),
    "off": ("Deviation", "偏差", "Distance", "距离"),
    "error": ("Expected error", "预期误差"),
    "name": ("Quantity", "所求量", "Point", "点"),
}


@dataclass(frozen=True)
class Told:
    """One row: what it tells, by columns, each with the unit that stands in its head; x and y of a place share one."""

    keys: tuple[str, ...]
    solution: str
    cells: dict[str, tuple[str, str]]  # the cell, the unit in its head
    is_place: bool

    def __getattr__(self, column: str) -> str:
        return self.cells.get(column, ("", ""))[0]

    def in_unit(self, column: str) -> tuple[str, str]:
        """The number of a cell and its unit, its own or that of its head."""
        text, unit = self.cells.get(column, ("", ""))
        text = text.rstrip("*")
        if text.endswith("°"):
            return text[:-1], "°"
        number, _, own = text.partition(" ")
        return number, own or unit


def tables_of(box: AnswerBox) -> tuple[FramedTable, ...]:
    """The tables of an answer; none where nothing was read."""
    return box.tables if isinstance(box, TabledAnswers) else ()


def rows_in(box: AnswerBox) -> list[Told]:
    """All rows of its tables."""
    return [row for table in tables_of(box) for row in _rows(table)]


def keys_of(box: AnswerBox) -> list[str]:
    """The answers that it tells: in rows, then in lines."""
    in_rows = [key for row in rows_in(box) for key in row.keys]
    return [*in_rows, *(key for line in box.lines for key in (line.key, *line.also))]


def _rows(table: FramedTable) -> Iterator[Told]:
    spots = any(head.startswith(("Distance", "距离")) for head in table.header)
    part = ""
    assert len(table.keys) == len(table.rows)
    for keys, row in zip(table.keys, table.rows, strict=True):
        cells: dict[str, tuple[str, str]] = {}
        last = ""
        for head, cell in zip(table.header, row, strict=True):
            named, _, unit = head.partition(" /")
            column = next((name for name, heads in _HEADS.items() if named.startswith(heads)), "")
            if not named:
                part = cell or part
            elif named == "$y$":
                cells[last] = (f"{cells[last][0]}, {cell}", cells[last][1])
            else:
                assert column, head
                cells[column] = (cell, unit.strip("{}"))
                last = column
        yield Told(keys, part, cells, spots)
