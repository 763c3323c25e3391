"""The rows of an answer file, page by page, whatever it was saved by."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from zipfile import BadZipFile, ZipFile

from ...batch.roster import decoded
from ...errors import Place, TableError
from ...limits import TABLE_BYTES
from ...words import Words

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
    if path.stat().st_size > TABLE_BYTES:
        raise TableError(
            Words(f"{path}：文件过大；请分成几份", f"{path}: too large for an answer file; split it"), code="too-large"
        )
    if path.suffix.lower() in (".xlsx", ".xlsm"):
        return list(_workbook(path))
    return [Page(str(path), "", tuple(_csv(path)))]


def _workbook(path: Path) -> Iterator[Page]:
    from openpyxl import load_workbook

    try:
        merges = _has(path, b"<mergeCell ")
        book = load_workbook(path, read_only=not merges, data_only=True)
        written = load_workbook(path, read_only=True) if _has(path, b"<f>", b"<f ") else book
        for sheet, formulas in zip(book.worksheets, written.worksheets, strict=True):
            rows = [tuple(_text(cell) for cell in row) for row in sheet.iter_rows(values_only=True)]
            if written is not book:
                rows = list(map(_reckoned, rows, formulas.iter_rows(values_only=True)))
            yield Page(str(path), sheet.title, tuple(rows), tuple(_below(sheet)) if merges else ())
    except (BadZipFile, KeyError, ValueError, IndexError) as error:
        raise TableError(
            Words(
                f"{path}：不是 XLSX 工作簿（{error}）；请另存为 XLSX 或 CSV",
                f"{path}: no XLSX workbook ({error}); save it again as XLSX or CSV",
            ),
            code="no-workbook",
        ) from None


def _has(path: Path, *signs: bytes) -> bool:
    """Whether a worksheet has one of these elements: formulas, merged cells."""
    with ZipFile(path) as parts:
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


def _csv(path: Path) -> Iterator[tuple[str, ...]]:
    text = decoded(path.read_bytes())
    if text is None:
        raise TableError(
            Words(
                f"{path}：既不是 UTF-8 也不是 GB18030；请另存为 UTF-8",
                f"{path}: neither UTF-8 nor GB18030; save it as UTF-8",
            ),
            code="encoding",
        )
    mark = max("\t;,", key=text.partition("\n")[0].count)
    for row in csv.reader(io.StringIO(text), delimiter=mark):
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
