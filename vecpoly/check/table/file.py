"""The bytes of a table: a regular file of a size that can be looked through, an archive that does not burst."""

from __future__ import annotations

from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from typing import Any

from ...errors import TableError
from ...limits import CELL, TABLE_COLUMNS, TABLE_ROWS
from ...problem.text.held import Held
from ...tables.files import bytes_of, not_too_large, too_much
from ...tables.workbooks import reading
from ...words import Words

Lines = Iterator[tuple[int, list[Any]]]


def read_table(path: Path | Held) -> bytes:
    """All bytes of the file. Raises TableError for what is no regular file (a pipe,
    a device, a folder) or too large."""
    if isinstance(path, Held):
        return not_too_large(path.name, path.data, TableError)
    return bytes_of(path, TableError)


def rows_of_workbook(path: Path | Held) -> Lines:
    """The rows of the first sheet, numbered from 1.
    Raises TableError where the file is damaged, or would burst when unpacked."""
    try:
        from openpyxl import load_workbook
    except ImportError:
        raise TableError(
            Words(
                f"{path.name}：读取 XLSX 文件需要 openpyxl（pip install openpyxl）；或将工作表另存为 CSV",
                f"{path.name}: to read XLSX files install openpyxl (pip install openpyxl), or save the sheet as CSV",
            )
        ) from None
    data = read_table(path)
    with reading(path.name, data, TableError):
        book = load_workbook(BytesIO(data), read_only=True, data_only=True)
        if not book.worksheets:
            raise TableError(Words(f"{path.name} 中没有工作表", f"{path.name} has no sheet of cells"))
        width = 0  # empty cells at the end of a row are not stored
        for n, row in enumerate(book.worksheets[0].iter_rows(values_only=True), 1):
            width = max(width, len(row))
            yield n, [*row, *[None] * (width - len(row))]


def counted(lines: Iterator[tuple[int, list[str]]], path: Path | Held) -> Iterator[tuple[int, list[str]]]:
    """The lines, as long as rows, columns and cells are within their limits;
    raises TableError for the first that is not."""
    for count, (line, cells) in enumerate(lines, 1):
        if count > TABLE_ROWS:
            raise too_much(path.name, Words(f"多于 {TABLE_ROWS} 行", f"more than {TABLE_ROWS} rows"), TableError)
        while cells and not cells[-1] and len(cells) > TABLE_COLUMNS:
            cells.pop()
        if len(cells) > TABLE_COLUMNS:
            raise too_much(
                path.name,
                Words(
                    f"第 {line} 行有 {len(cells)} 列，多于 {TABLE_COLUMNS} 列",
                    f"line {line} has {len(cells)} columns, more than {TABLE_COLUMNS}",
                ),
                TableError,
            )
        if any(len(cell) > CELL for cell in cells):
            raise too_much(
                path.name,
                Words(
                    f"第 {line} 行有一格多于 {CELL} 个字符", f"line {line} has a cell of more than {CELL} characters"
                ),
                TableError,
            )
        yield line, cells
