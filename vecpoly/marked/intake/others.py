"""Rows that do not hold together: a number beside the sheet or the name of another student."""

from __future__ import annotations

from collections.abc import Mapping

from ...batch.register import Sheet
from ...batch.roster import plain
from ...words import Words
from .pages import Page
from .returned import Returned

Sheets = Mapping[str, Sheet]  # student → the sheet that was handed out


def of_others(page: Page, i: int, columns: Mapping[str, int], sheets: Sheets, returned: Returned) -> set[int]:
    """The rows with the sheet or the name of another student, as where columns were sorted by themselves: told, and
    not used."""
    found, names = set[int](), {_bare(one.student.name) for one in sheets.values()}
    for n, row in enumerate(page.rows[i + 1 :], i + 1):
        cell = {what: plain(row[at]) if at < len(row) else "" for what, at in columns.items()}
        own = sheets.get(cell["student"])
        if own is None:
            continue
        sheet, name = cell.get("sheet", ""), cell.get("name", "")
        if sheet and _bare(sheet) != _bare(own.sheet):
            found.add(n)
            said = _other_sheet(own, sheet)
            returned.fault(page.place(n, columns["sheet"]), "other-sheet", said, own.student.number)
        elif _bare(name) != _bare(own.student.name) and _bare(name) in names:
            found.add(n)
            said = _other_name(own, name)
            returned.fault(page.place(n, columns["name"]), "other-name", said, own.student.number)
    return found


def _bare(text: str) -> str:
    """9km9-pc62 is 9KM9PC62."""
    return "".join(filter(str.isalnum, text)).upper()


def _other_sheet(own: Sheet, sheet: str) -> Words:
    number = own.student.number
    return Words(
        f"学号 {number} 的卷号是 {own.sheet}，此行却写 {sheet}：行可能错位（例如只对部分列排了序）；"
        "此行未用，请核对后再交",
        f"the sheet of {number} is {own.sheet}, and this row says {sheet}: rows may have been mixed up (some columns "
        "sorted by themselves, say); the row is not used, correct it and mark again",
    )


def _other_name(own: Sheet, name: str) -> Words:
    number = own.student.number
    return Words(
        f"学号 {number} 的姓名是 {own.student.name}，此行却写另一学生 {name}：学号可能填错，或行已错位；"
        "此行未用，请核对后再交",
        f"{number} is {own.student.name}, and this row says {name}, who is another student: the number may be wrong, "
        "or rows mixed up; the row is not used, correct it and mark again",
    )
