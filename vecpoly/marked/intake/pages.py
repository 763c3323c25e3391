"""The rows of an answer file, page by page, whatever it was saved by."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any
from zipfile import ZipFile

from ...errors import Place, TableError
from ...tables.files import bytes_of
from ...tables.texts import decoded, separated
from ...tables.workbooks import WORKBOOKS, reading

_MARKS = "\t;,"
CELL_LETTERS = 200  # of a cell that are kept


@dataclass(frozen=True, slots=True)
class Page:
    """One worksheet, or a file of comma-separated values: its name, and its rows of texts.

    merged: the cells, row and column from 0, that have their text in another row, with which they are merged.
    """

    file: str
    name: str
    rows: tuple[tuple[str, ...], ...]
    merged: tuple[tuple[int, int], ...] = ()

    def place(self, row: int, column: int) -> Place:
        """Where a cell stands, both from 0."""
        return Place(f"{self.file}{f' [{self.name}]' if self.name else ''}", row + 1, column + 1)


def pages(path: Path) -> list[Page]:
    """All pages of a workbook, or the one of a CSV file. Raises TableError where it is none, OSError."""
    data = bytes_of(path, TableError)
    if path.suffix.lower() in WORKBOOKS:
        return list(_workbook(str(path), data))
    return [Page(str(path), "", tuple(_csv(str(path), data)))]


def _workbook(name: str, data: bytes) -> Iterator[Page]:
    from openpyxl import load_workbook

    with reading(name, data, TableError):
        merges = _has(data, b"<mergeCell ")
        book = load_workbook(BytesIO(data), read_only=not merges, data_only=True)
        reckons = _has(data, b"<f>", b"<f ")
        written = load_workbook(BytesIO(data), read_only=True) if reckons else book
        for sheet, formulas in zip(book.worksheets, written.worksheets, strict=True):
            rows = [tuple(_text(cell) for cell in row) for row in sheet.iter_rows(values_only=True)]
            if written is not book:
                rows = list(map(_reckoned, rows, formulas.iter_rows(values_only=True)))
            yield Page(name, sheet.title, tuple(rows), tuple(_below(sheet)) if merges else ())


def _has(data: bytes, *signs: bytes) -> bool:
    """Whether a worksheet has one of these elements: formulas, merged cells."""
    with ZipFile(BytesIO(data)) as parts:
        sheets = [name for name in parts.namelist() if name.startswith("xl/worksheets/")]
        return any(sign in parts.read(name) for name in sheets for sign in signs)


def _below(sheet: Any) -> Iterator[tuple[int, int]]:
    """The cells of merged ranges that are in another row than their text."""
    for one in sheet.merged_cells.ranges:
        rows, columns = range(one.min_row, one.max_row), range(one.min_col - 1, one.max_col)
        yield from ((row, column) for row in rows for column in columns)


def _reckoned(row: tuple[str, ...], formulas: tuple[object, ...]) -> tuple[str, ...]:
    """The row, with the formula itself where the file does not hold its value."""
    pairs = zip(row, formulas, strict=True)
    return tuple(_text(one) if not text and str(one).startswith("=") else text for text, one in pairs)


def _csv(name: str, data: bytes) -> Iterator[tuple[str, ...]]:
    text = decoded(data, name, TableError)
    first = next((line for line in text.splitlines() if any(mark in line for mark in _MARKS)), "")  # below a title
    mark = max(_MARKS, key=first.count)
    for row in separated(text, mark, name, TableError):
        yield tuple(cell[:CELL_LETTERS].removeprefix("'") for cell in row)


def _text(cell: object) -> str:
    """A cell as a text: a number as it is shown, without what binary fractions add."""
    if cell is None:
        return ""
    if isinstance(cell, bool):
        return "yes" if cell else "no"
    if isinstance(cell, float):
        return f"{cell:.12g}"
    return str(cell)[:CELL_LETTERS].removeprefix("'")
