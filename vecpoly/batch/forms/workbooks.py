"""The workbooks of a class: the key for the lecturer, the form into which answers are typed from paper."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import datetime
from io import BytesIO
from typing import Any

import xlsxwriter

from ...grading.equations.ticks import shown
from ...grading.key import Graded, Kind
from ...grading.told.scheme import SCHEME, scheme_rows
from ...names import written_unit
from ...words import Lang, Words, bare
from ..register import Part, Register, Sheet
from .columns import CLASSES, IDENTITY, Column, What, columns_of, per_mm

_CREATED = datetime(2000, 1, 1)
_SENSES = ("顺", "逆", "↻", "↺", "cw", "ccw")
TICK_LETTERS = 12  # at most, in each cell of an equation that is copied with its words
_LENGTH, _TURN = 400.0, 360.0  # mm, degrees: nothing on a page is longer, no direction larger
_PAIR = 3  # characters that two coordinates have at least
_ANSWERS, _KEY = Words("答案", "answers"), Words("答案键", "key")
_YES, _NO = Words("是", "yes"), Words("否", "no")
_WRONG = Words("此处应为", "expected here: ")


def answers_bytes(register: Register) -> bytes:
    """The form: a row for each student, who are locked; units in row 2; cells that take only what can be meant."""
    target, lang = BytesIO(), register.lang
    book = _book(target)
    page = book.add_worksheet(_ANSWERS.zh if lang == "zh" else _ANSWERS.en)
    fixed, free = book.add_format({"bg_color": "#EEEEEE"}), book.add_format({"locked": False, "num_format": "@"})
    head, unit = (
        book.add_format({"bold": True, "bg_color": "#DDDDDD"}),
        book.add_format({"italic": True, "bg_color": "#EEEEEE"}),
    )
    columns = columns_of(register)
    first = len(IDENTITY)
    for i, (zh, en) in enumerate(IDENTITY):
        page.write_string(0, i, zh if lang == "zh" else en, head)
        page.write_string(1, i, "", unit)
    for i, column in enumerate(columns, first):
        page.write_string(0, i, column.head, head)
        page.write_string(1, i, column.unit, unit)
        if register.sheets:
            _validated(page, i, column, len(register.sheets), lang)
    for row, sheet in enumerate(register.sheets, 2):
        for i, text in enumerate(identity(sheet)):
            page.write_string(row, i, text, fixed)
        for i in range(first, first + len(columns)):
            page.write_blank(row, i, None, free)
    page.freeze_panes(2, first)
    page.set_column(0, first - 1, 12)
    page.set_column(first, first + len(columns), 11)
    page.protect("", {"format_columns": True, "sort": True, "autofilter": True})
    book.close()
    return target.getvalue()


def identity(sheet: Sheet) -> tuple[str, str, str, str]:
    """Number, name, class, sheet."""
    return sheet.student.number, sheet.student.name, sheet.student.team, sheet.sheet


def _validated(page: Any, i: int, column: Column, count: int, lang: str) -> None:
    """What a cell takes: a warning, for a unit or a remark may stand behind a number."""
    rule: dict[str, Any] = {"error_type": "warning", "ignore_blank": True}
    match column.what:
        case What.SENSE:
            rule |= {"validate": "list", "source": list(_SENSES)}
        case What.YES_NO:
            rule |= {"validate": "list", "source": [_YES.zh, _NO.zh] if lang == "zh" else [_YES.en, _NO.en]}
        case What.CLASS:
            rule |= {"validate": "list", "source": list(CLASSES)}
        case What.LENGTH:
            rule |= {"validate": "decimal", "criteria": "between", "minimum": 0, "maximum": _LENGTH}
        case What.DIRECTION:
            rule |= {"validate": "decimal", "criteria": "between", "minimum": -_TURN, "maximum": _TURN}
        case What.TICKS:
            longest = TICK_LETTERS * column.terms
            rule |= {"validate": "length", "criteria": "between", "minimum": column.terms, "maximum": longest}
        case What.PLACE:
            rule |= {"validate": "length", "criteria": ">=", "value": _PAIR}
        case What.VALUE | What.SCALE:
            rule |= {"validate": "decimal", "criteria": "between", "minimum": -1e9, "maximum": 1e9}
    said = (_WRONG.zh if lang == "zh" else _WRONG.en) + f"{column.key} {column.unit}"
    page.data_validation(2, i, 1 + count, i, rule | {"error_message": said[:255], "error_title": column.head[:32]})


def key_bytes(register: Register) -> bytes:
    """The key: a page for each problem, a row for each student: values, scales, exact answers, tolerances; and one
    with what everything is worth."""
    target = BytesIO()
    book = _book(target)
    bold = book.add_format({"bold": True, "bg_color": "#DDDDDD"})
    for n, exercise in enumerate(register.exercises):
        page = book.add_worksheet(_sheet_name(exercise.id, n))
        parts = [(sheet, part) for sheet in register.sheets for part in sheet.parts if part.problem == exercise.id]
        heads, units = _key_heads(parts[0][1], register.lang) if parts else ([], [])
        for i, (text, unit) in enumerate(zip(heads, units, strict=True)):
            page.write_string(0, i, text, bold)
            page.write_string(1, i, unit, bold)
        for row, (sheet, part) in enumerate(parts, 2):
            write_row(page, row, _key_row(sheet, part, "zh" if register.lang == "zh" else "en"))
        page.freeze_panes(2, len(IDENTITY))
        page.set_column(0, len(heads), 12)
    points_page(book, register, bold)
    book.close()
    return target.getvalue()


def points_page(book: Any, register: Register, head: Any) -> None:
    """A page of what everything is worth, and the rules that are not the usual ones."""
    lang: Lang = "zh" if register.lang == "zh" else "en"
    page = book.add_worksheet(SCHEME.of(lang))
    keys = [part.key for part in register.sheets[0].parts] if register.sheets else []
    for i, row in enumerate(scheme_rows(keys, register.scheme.rules, lang)):
        write_row(page, i, row, head if i == 0 else None)
    page.freeze_panes(1, 0)
    page.set_column(0, 6, 12)


def write_row(page: Any, row: int, cells: Sequence[str | float], look: Any = None) -> None:
    """Texts as texts, never as formulas; numbers as numbers."""
    for i, cell in enumerate(cells):
        if isinstance(cell, str):
            page.write_string(row, i, cell, look)
        else:
            page.write_number(row, i, cell, look)


def _scales(part: Part) -> dict[str, float]:
    """The scales of the sheet in the order of their names, with those that only the drawing chose."""
    return dict(sorted({**part.key.scales, **part.scales}.items()))


def _key_heads(part: Part, lang: str) -> tuple[list[str], list[str]]:
    names = [zh if lang == "zh" else en for zh, en in IDENTITY] + [*part.values, *_scales(part)]
    heads = names + [row.key for row in part.key.equations]
    units = [per_mm(name) for name in names] + [bare(row.printed) for row in part.key.equations]
    for one in _asked(part):
        mark = Words("（连带）", " (follow-through)") if one.demoted else Words.same("")
        heads = [*heads, one.key + (mark.zh if lang == "zh" else mark.en), f"{one.key} T"]
        units = [*units, written_unit(one.written_in), written_unit(one.written_in)]
        if one.kind is Kind.VECTOR:
            heads, units = [*heads, f"{one.key} mm", f"{one.key} deg"], [*units, "mm", "°"]
    return heads, units


def _key_row(sheet: Sheet, part: Part, lang: Lang) -> list[str | float]:
    given = (value.replace(" deg", "°") for value in part.values.values())
    row: list[str | float] = [*identity(sheet), *given, *_scales(part).values()]
    row += [shown(one.known) for one in part.key.equations]
    for one in _asked(part):
        row += [_exact(one, lang), "" if one.kind is Kind.YES_NO else _round(one.allowed / one.one)]
        if one.kind is Kind.VECTOR:
            row.append(_round(one.mm) if one.mm else "")
            row.append("" if one.degrees is None else round(one.degrees, 4) % 360.0)
    return row


def _exact(one: Graded, lang: Lang) -> str | float:
    """The value, of a place both coordinates; yes and no in words."""
    if one.kind is Kind.YES_NO:
        return (_YES if one.exact else _NO).of(lang)
    if one.at is None:
        return _round(one.exact)
    return "({:.6g}, {:.6g})".format(*(at / one.one + 0.0 for at in one.at))


def _asked(part: Part) -> Sequence[Graded]:
    return [one for one in part.key.quantities if one.is_counted]


def _round(value: float) -> float:
    return float(f"{value:.6g}")


def _sheet_name(problem: str, n: int) -> str:
    """As Excel takes it: 31 characters, none of []:*?/\\; the number keeps two apart."""
    bare = "".join("_" if char in "[]:*?/\\" else char for char in problem)
    return bare if len(bare) <= 31 else f"{bare[:28]}~{n + 1}"


def _book(target: BytesIO) -> Any:
    book = xlsxwriter.Workbook(target, {"in_memory": True, "strings_to_formulas": False, "strings_to_urls": False})
    book.set_properties({"created": _CREATED, "author": "vecpoly"})
    return book
