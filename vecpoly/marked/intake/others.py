"""Rows that do not hold together: a number beside the sheet or the name of another student."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from ...batch.register import Sheet
from ...batch.roster import numbered, plain
from ...words import Words
from .pages import Page
from .returned import Returned

Sheets = Mapping[str, Sheet]  # student → the sheet that was handed out
_MIXED_UP = Words(
    "：学号可能填错，或行已错位（例如只对部分列排了序）；此行未用，请核对后再交",
    ": the number may be wrong, or rows may have been mixed up (some columns sorted by themselves, say); the row is "
    "not used, correct it and mark again",
)


def of_others(page: Page, i: int, columns: Mapping[str, int], sheets: Sheets, returned: Returned) -> set[int]:
    """The rows with the sheet or the name of another student, as where columns were sorted by themselves: told, and
    not used."""
    found, names = set[int](), {_bare(one.student.name) for one in sheets.values()}
    for n, row in enumerate(page.rows[i + 1 :], i + 1):
        cell = {what: plain(row[at]) if at < len(row) else "" for what, at in columns.items()}
        own = sheets.get(numbered(cell["student"]))
        if own is not None and (told := _anothers(own, cell, names)) is not None:
            column, said = told
            found.add(n)
            returned.fault(page.place(n, columns[column]), f"other-{column}", said + _MIXED_UP, own.student.number)
    return found


def _anothers(own: Sheet, cell: Mapping[str, str], names: Collection[str]) -> tuple[str, Words] | None:
    """The column by which a row is another student's, and what it says there; None where it is one's own."""
    number, sheet, name = own.student.number, cell.get("sheet", ""), cell.get("name", "")
    if sheet and _bare(sheet) != _bare(own.sheet):
        return "sheet", Words(
            f"学号 {number} 的卷号是 {own.sheet}，此行却写 {sheet}",
            f"the sheet of {number} is {own.sheet}, and this row says {sheet}",
        )
    if name and _bare(name) != _bare(own.student.name) and _bare(name) in names:
        return "name", Words(
            f"学号 {number} 的姓名是 {own.student.name}，此行却写另一学生 {name}",
            f"{number} is {own.student.name}, and this row says {name}, who is another student",
        )
    return None


def _bare(text: str) -> str:
    """9km9-pc62 is 9KM9PC62."""
    return "".join(filter(str.isalnum, text)).upper()
