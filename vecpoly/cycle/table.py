"""The columns of a cycle as a table with units: CSV and XLSX."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from datetime import datetime
from io import BytesIO, StringIO
from typing import Any
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

import numpy as np
from numpy.typing import NDArray

from ..errors import AssemblyError
from ..words import Lang, Words, bare
from .column import Column
from .cycle import Cycle
from .facts.transmission import folded

Reals = NDArray[np.float64]
SHEET_ROWS = 1_048_576  # of a spreadsheet
NOTHING = 1e-14  # of a vector: a component that is nothing but the rounding of the other
WRITTEN = datetime(1980, 1, 1)  # the hour that every workbook tells


@dataclass(frozen=True, slots=True, eq=False)
class Table:
    """Real columns in shown units (mm, m/s, °, rad/s, N ...): values[row, column]; NaN where there is none."""

    columns: tuple[Column, ...]
    values: Reals


def table(cycle: Cycle, keys: tuple[str, ...] = (), rows: NDArray[np.intp] | None = None) -> Table:
    """The drive's position, then these columns (all of the cycle), vectors as x and y;
    rows: indices, all where none are given."""
    names = keys or tuple(column.key for column in cycle.columns)
    parts = [part for name in dict.fromkeys(names) for part in cycle.info(name).parts]
    columns = [cycle.drive, *(cycle.info(part) for part in parts if part != cycle.drive.key)]
    index = np.arange(len(cycle.phi)) if rows is None else rows
    values = np.empty((len(index), len(columns)))
    for i, column in enumerate(columns):
        values[:, i] = column.told(_real(cycle, column.key)[index])
    return Table(tuple(columns), values)


def _real(cycle: Cycle, key: str) -> Reals:
    base, _, part = key.partition(".")
    whole = cycle.column(base)
    if part in ("x", "y"):
        own = whole.real if part == "x" else whole.imag
        return np.where(np.abs(own) <= NOTHING * np.abs(whole), 0.0, own)
    values = np.asarray(cycle.column(key), np.float64)
    return folded(values) if key.startswith("gamma_") else values  # the acute angle is the transmission angle


def csv_bytes(made: Table) -> bytes:
    """UTF-8 CSV: a row of keys, a row of units, then the rows with all digits;
    an empty field where there is no value."""
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([column.key for column in made.columns])
    writer.writerow([plain(column.shown_unit) for column in made.columns])
    for row in made.values.tolist():
        writer.writerow([f"{value:.15g}" if value == value else "" for value in row])
    return text.getvalue().encode()


def xlsx_bytes(made: Table, title: str, lang: Lang) -> bytes:
    """XLSX: rows of words, keys and units, frozen, then numbers.
    Raises AssemblyError for more rows than a sheet holds."""
    from openpyxl import Workbook
    from openpyxl.styles import Alignment, Font

    if len(made.values) > SHEET_ROWS - 3:
        raise AssemblyError(
            Words(
                f"共 {len(made.values)} 行，超过电子表格的容量（{SHEET_ROWS - 3}）；请加大步长，或用 CSV",
                f"{len(made.values)} rows are more than a spreadsheet holds ({SHEET_ROWS - 3}); take a coarser "
                "step, or CSV",
            )
        )
    book = Workbook(write_only=True)
    sheet = book.create_sheet("".join(c for c in title if c not in "[]:*?/\\")[:31] or "cycle")
    sheet.freeze_panes = "B4"
    for i in range(len(made.columns)):
        sheet.column_dimensions[_letters(i)].width = 15
    for line in (
        [bare(c.words.of(lang)) for c in made.columns],
        [c.key for c in made.columns],
        [plain(c.shown_unit) for c in made.columns],
    ):
        sheet.append([_cell(sheet, text, Font(bold=True), Alignment(wrap_text=True, vertical="top")) for text in line])
    for row in made.values.tolist():
        sheet.append([value if value == value else None for value in row])
    return _packed(book)


def _packed(book: Any) -> bytes:
    """The workbook as a file: the same bytes every time, for neither its properties nor its archive tell the hour."""
    from openpyxl.writer.excel import ExcelWriter

    book.properties.created = book.properties.modified = WRITTEN
    loose, target = BytesIO(), BytesIO()
    ExcelWriter(book, ZipFile(loose, "w")).save()
    with ZipFile(loose) as parts, ZipFile(target, "w", ZIP_DEFLATED) as archive:
        for name in parts.namelist():
            archive.writestr(ZipInfo(name, WRITTEN.timetuple()[:6]), parts.read(name), ZIP_DEFLATED)
    return target.getvalue()


def _cell(sheet: object, text: str, font: object, alignment: object) -> object:
    from openpyxl.cell import WriteOnlyCell

    cell = WriteOnlyCell(sheet, value=text)
    cell.font, cell.alignment = font, alignment
    return cell


def _letters(index: int) -> str:
    from openpyxl.utils import get_column_letter

    return str(get_column_letter(index + 1))


def plain(unit: str) -> str:
    """rad/s^2 as rad/s²."""
    return unit.replace("^2", "²")
