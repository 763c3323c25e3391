"""The bytes of a table: a regular file of a size that can be looked through, an archive that does not burst."""

from __future__ import annotations

import zlib
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from typing import Any
from zipfile import BadZipFile, ZipFile

from ...errors import TableError
from ...limits import CELL, TABLE_BYTES, TABLE_COLUMNS, TABLE_ROWS, TABLE_UNPACKED
from ...problem.text.held import Held
from ...words import Words

Lines = Iterator[tuple[int, list[Any]]]
# what openpyxl, zipfile and the XML parser raise for damaged workbooks
_DAMAGED = (
    OSError,
    ValueError,
    KeyError,
    IndexError,
    AttributeError,
    TypeError,
    ArithmeticError,
    EOFError,
    RuntimeError,
    SyntaxError,
    MemoryError,
    NotImplementedError,
    BadZipFile,
    zlib.error,
)


def read_table(path: Path | Held) -> bytes:
    """All bytes of the file. Raises TableError for what is no regular file (a pipe,
    a device, a folder) or too large."""
    if isinstance(path, Held):
        return _not_too_large(path, path.data)
    try:
        if not path.is_file():
            what = (
                Words("不存在这个文件", "No such file")
                if not path.exists()
                else Words(
                    "不是普通文件（而是文件夹、管道或设备）", "it is no regular file but a folder, a pipe or a device"
                )
            )
            raise TableError(Words(f"{path}：{what.zh}", f"{path}: {what.en}"), code="no file")
        with path.open("rb") as file:
            data = file.read(TABLE_BYTES + 1)
    except OSError as error:
        raise TableError(
            Words(
                f"{path}：不能读取（{error.strerror or type(error).__name__}）",
                f"{path}: {error.strerror or 'cannot be read'}",
            )
        ) from None
    return _not_too_large(path, data)


def _not_too_large(path: Path | Held, data: bytes) -> bytes:
    if len(data) > TABLE_BYTES:
        raise _too_much(path, Words(f"大于 {TABLE_BYTES / 1e6:g} MB", f"larger than {TABLE_BYTES / 1e6:g} MB"))
    return data


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
    try:
        _unpacks(path, data)
        book = load_workbook(BytesIO(data), read_only=True, data_only=True)
        if not book.worksheets:
            raise TableError(Words(f"{path.name} 中没有工作表", f"{path.name} has no sheet of cells"))
        width = 0  # empty cells at the end of a row are not stored
        for n, row in enumerate(book.worksheets[0].iter_rows(values_only=True), 1):
            width = max(width, len(row))
            yield n, [*row, *[None] * (width - len(row))]
    except _DAMAGED as error:
        if isinstance(error, TableError):
            raise
        raise TableError(
            Words(
                f"{path.name} 已损坏，无法作为 XLSX 读取（{type(error).__name__}）；请在电子表格程序中重新保存，"
                "或存为 CSV",
                f"{path.name} is no readable XLSX file, but damaged "
                f"({type(error).__name__}); save it again in a spreadsheet program, or as CSV",
            ),
            code="damaged",
        ) from None


def _unpacks(path: Path | Held, data: bytes) -> None:
    with ZipFile(BytesIO(data)) as archive:
        size = sum(part.file_size for part in archive.infolist())
        for part in archive.infolist():
            if part.filename.endswith((".xml", ".rels")) and b"<!DOCTYPE" in archive.open(part).read(4096):
                raise TableError(
                    Words(
                        f"{path.name}：{part.filename} 含有 DOCTYPE 声明，不予读取",
                        f"{path.name}: {part.filename} declares entities of its own (DOCTYPE) and is not read",
                    ),
                    code="entities",
                )
    if size > TABLE_UNPACKED:
        raise _too_much(
            path,
            Words(
                f"解压后 {size / 1e6:.0f} MB，大于 {TABLE_UNPACKED / 1e6:g} MB",
                f"{size / 1e6:.0f} MB when unpacked, more than {TABLE_UNPACKED / 1e6:g} MB",
            ),
        )


def counted(lines: Iterator[tuple[int, list[str]]], path: Path | Held) -> Iterator[tuple[int, list[str]]]:
    """The lines, as long as rows, columns and cells are within their limits;
    raises TableError for the first that is not."""
    for count, (line, cells) in enumerate(lines, 1):
        if count > TABLE_ROWS:
            raise _too_much(path, Words(f"多于 {TABLE_ROWS} 行", f"more than {TABLE_ROWS} rows"))
        while cells and not cells[-1] and len(cells) > TABLE_COLUMNS:
            cells.pop()
        if len(cells) > TABLE_COLUMNS:
            raise _too_much(
                path,
                Words(
                    f"第 {line} 行有 {len(cells)} 列，多于 {TABLE_COLUMNS} 列",
                    f"line {line} has {len(cells)} columns, more than {TABLE_COLUMNS}",
                ),
            )
        if any(len(cell) > CELL for cell in cells):
            raise _too_much(
                path,
                Words(
                    f"第 {line} 行有一格多于 {CELL} 个字符", f"line {line} has a cell of more than {CELL} characters"
                ),
            )
        yield line, cells


def _too_much(path: Path | Held, what: Words) -> TableError:
    return TableError(
        Words(
            f"{path.name}：{what.zh}，不予读取；请只保留要核对的部分",
            f"{path.name}: {what.en}; it is not read: keep only what is to be checked",
        ),
        code="too large",
    )
