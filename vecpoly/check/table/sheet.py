"""A table as it stands in its file: header, perhaps a row of units, and rows of numbers as written."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ...errors import Place, TableError
from ...problem.text.held import Held
from ...tables.texts import decoded, unreadable
from ...tables.workbooks import WORKBOOKS
from ...words import Words
from .file import counted, read_table, rows_of_workbook

FEWEST = 5  # rows below which nothing can be told
_NUMBER = re.compile(r"[+\-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+\-]?\d+)?")
_BLANK = ("", "-", "--", "/", "—", "–", "－", "nan", "NaN", "NAN", "n/a", "N/A", "#N/A", "null")
_PLAIN = str.maketrans({"−": "-", "－": "-", "＋": "+", "．": ".", "\u00a0": " ", "\u2009": " "})

_COMMA = re.compile(r"[+\-]?\d+,\d+(?:[eE][+\-]?\d+)?")
_EXPONENT = re.compile(r"^([+\-]?\d*\.?\d*)[dD]([+\-]?\d+)$")
_SYMBOL = re.compile(r"[^\W_]+_\w+(?:\.\w+)?")  # omega_3, R_12.x
_MARKS = (";", "\t", ",", "，")

Lines = Iterator[tuple[int, list[str]]]


@dataclass(frozen=True, slots=True, kw_only=True)
class Sheet:
    """The cells of a table, and the line of the file on which each row stands."""

    name: str
    header: tuple[str, ...]
    units: tuple[str, ...]  # empty texts where there is no row of units
    rows: tuple[tuple[str, ...], ...]
    lines: tuple[int, ...]
    head_line: int = 1
    title: Words = field(default_factory=lambda: Words.same(""))

    def column(self, i: int) -> tuple[str, ...]:
        """The cells of one column; a blank or a dash is an empty text."""
        return tuple("" if row[i] in _BLANK else row[i] for row in self.rows)

    def at(self, line: int, column: int) -> Words:
        """Where a cell stands, for messages."""
        place, name = Place(self.name, line, column + 1).words, self.header[column]
        return place + Words(f"（{name}）", f" ('{name}')") if name else place

    def number(self, i: int, row: int) -> float:
        """The cell as a number; NaN where it is blank; raises TableError with file, line and column."""
        text = self.rows[row][i]
        if text in _BLANK:
            return float("nan")
        if not is_number(text):
            raise TableError(self.at(self.lines[row], i) + Words(f"：“{text}”不是数", f": '{text}' is not a number"))
        return float(text)


def is_number(text: str) -> bool:
    """Whether a cell holds a finite number as people write it."""
    return _NUMBER.fullmatch(text) is not None and abs(float(text)) < float("inf")


def last_unit(text: str) -> float:
    """One unit of the last written digit: 0.01 of 3.14, 1e-5 of 9.32E-03; 0 of a blank."""
    m = re.fullmatch(r"[+\-]?\d*\.?(\d*)(?:[eE]([+\-]?\d+))?", text)
    return 10.0 ** (int(m[2] or 0) - len(m[1])) if text and m else 0.0


def digits(text: str) -> int:
    """How many significant digits are written."""
    return len(re.split("[eE]", text)[0].translate({ord(c): None for c in "+-."}).lstrip("0"))


def read_sheet(path: Path | Held) -> Sheet:
    """Read a CSV file (comma, semicolon, tab or spaces; UTF-8, UTF-16 or GB 18030;
    3.14 or 3,14) or the first sheet of an XLSX file.

    Raises TableError where the file cannot be read, is ragged, has no header or too few rows.
    """
    lines = _below_titles(path)
    (head_line, header), body = lines[0], _pointed(lines[1:])
    if all(is_number(cell) for cell in header if cell):
        raise TableError(
            Words(
                f"{path.name} 第 {head_line} 行：首行应为列名，如 phi1, omega5, alpha5",
                f"{path.name}, line {head_line}: the first row must name the columns, e.g. phi1, omega5, alpha5",
            )
        )
    while header and not header[-1]:
        header.pop()
    _refuse_ragged(path.name, body, len(header))
    units = [""] * len(header)
    if body and not any(is_number(cell) for cell in body[0][1]):
        units = [cell.strip("[]()（） ") for cell in body.pop(0)[1]]
    if len(body) < FEWEST:
        raise TableError(
            Words(
                f"{path.name}：只有 {len(body)} 行数据；比较至少需要 {FEWEST} 行",
                f"{path.name}: {len(body)} rows of numbers; at least {FEWEST} are needed to compare columns",
            )
        )
    return Sheet(
        name=path.name,
        header=tuple(header),
        units=tuple(units[: len(header)]),
        head_line=head_line,
        title=_title(path),
        rows=tuple(tuple(cells[: len(header)]) for _, cells in body),
        lines=tuple(line for line, _ in body),
    )


def _below_titles(path: Path | Held) -> list[tuple[int, list[str]]]:
    """The lines that are not blank, from the header on."""
    lines = [(n, cells) for n, cells in counted(_lines(path), path) if any(cells)]
    while len(lines) > 1 and sum(map(bool, lines[0][1])) == 1 < sum(map(bool, lines[1][1])):
        lines.pop(0)  # a title
    if not lines:
        raise TableError(Words(f"{path.name}：表是空的", f"{path.name}: the table is empty"))
    if _is_in_words(lines):
        lines.pop(0)
    return lines


def _refuse_ragged(name: str, body: list[tuple[int, list[str]]], width: int) -> None:
    """TableError where a row has not as many cells as the header, blank ones behind its end not counted."""
    for line, cells in body:
        if len(cells) < width or any(cells[width:]):
            raise TableError(
                Words(
                    f"{name} 第 {line} 行：有 {len(cells)} 格，而表头有 {width} 列",
                    f"{name}, line {line}: {len(cells)} cells where the header has {width}",
                )
            )


def _is_in_words(lines: list[tuple[int, list[str]]]) -> bool:
    """Whether the first of three rows without numbers says in words what the second,
    above the units, says in symbols."""
    texts = [cells for _, cells in lines[:3] if not any(is_number(cell) for cell in cells)]
    if len(texts) < 3:
        return False
    words, symbols = (sum(_SYMBOL.fullmatch(cell) is not None for cell in cells) for cells in texts[:2])
    return symbols > words


def _title(path: Path | Held) -> Words:
    """A first line '# 表 1-A / Table 1-A' of a text file; else the file's name."""
    first = b"" if path.suffix.lower() in WORKBOOKS else read_table(path).partition(b"\n")[0]
    if not first.startswith((b"#", b"\xef\xbb\xbf#")):
        return Words.same(path.name)
    zh, _, en = decoded(first, path.name, TableError).lstrip("#").strip().partition(" / ")
    return Words(zh.strip(), (en or zh).strip())


def _lines(path: Path | Held) -> Lines:
    if path.suffix.lower() in WORKBOOKS:
        return ((n, [_cell(cell) for cell in row]) for n, row in rows_of_workbook(path))
    return _of_text(path)


def _of_text(path: Path | Held) -> Lines:
    text = decoded(read_table(path), path.name, TableError)
    rows = [(n, line) for n, line in enumerate(text.splitlines(), 1) if line.strip() and not line.startswith("#")]
    first = max((line for _, line in rows[:3]), key=lambda line: max(map(line.count, _MARKS)), default="")
    mark = max(_MARKS, key=first.count)
    if not first.count(mark):
        apart = re.compile(r"\s{2,}" if re.search(r"\S\s{2,}\S", first) else r"\s+")
        return ((n, [_cell(cell) for cell in apart.split(line.strip())]) for n, line in rows)
    if mark == "，":
        rows, mark = [(n, line.replace("，", ",")) for n, line in rows], ","
    return _separated(rows, mark, path)


def _separated(rows: list[tuple[int, str]], mark: str, path: Path | Held) -> Lines:
    """The cells between these marks; quotes may hold marks and new lines."""
    cells = csv.reader((line for _, line in rows), delimiter=mark)
    try:
        for row in cells:
            yield rows[min(cells.line_num, len(rows)) - 1][0], [_cell(cell) for cell in row]
    except csv.Error as error:
        line = rows[min(cells.line_num, len(rows)) - 1][0]
        raise unreadable(path.name, line, error, TableError) from None


def _pointed(lines: list[tuple[int, list[str]]]) -> list[tuple[int, list[str]]]:
    """Numbers with a point: 3,14 is 3.14 where no cell has a point; 1.5D+02 is 1.5E+02; 30° is 30."""
    lines = [
        (
            n,
            [
                _EXPONENT.sub(r"\1e\2", cell.removesuffix("°")) if cell[:1] in "+-.0123456789" else cell
                for cell in cells
            ],
        )
        for n, cells in lines
    ]
    cells = [cell for _, row in lines for cell in row]
    if any("." in cell and is_number(cell) for cell in cells) or not any(_COMMA.fullmatch(cell) for cell in cells):
        return lines
    return [(n, [cell.replace(",", ".") if _COMMA.fullmatch(cell) else cell for cell in row]) for n, row in lines]


def _cell(value: Any) -> str:
    """A cell as text; a number of a workbook with the digits that it has."""
    if value is None:
        return ""
    if isinstance(value, float):
        return f"{value:.15g}"
    return str(value).translate(_PLAIN).strip()
