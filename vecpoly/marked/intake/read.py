"""An answer file of any kind: what was returned, by student and problem."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from ...batch.roster import numbered
from ...errors import Place, TableError, UnknownNameError
from ...grading.key import AnswerKey
from ...grading.reading.unit import unit
from ...grading.reading.written import State, written
from ...words import Words
from .documents import documents
from .heads import NO_PROBLEM, Head, Part, head, identity
from .joined import cell_of, joined, twice, with_unit
from .others import Sheets, of_others
from .pages import Page, pages
from .returned import Answers, Returned, written_twice

KeysOf = Callable[[str], Mapping[str, AnswerKey] | None]  # of a student: problem → key; None for a stranger
HEADS = 10  # rows among which the header is looked for
_LONG = {
    "step": ("step", "量", "symbol", "符号", "quantity"),
    "value": ("value", "值", "数值", "答案", "结果", "answer"),
    "unit": ("unit", "单位"),
    "sense": ("sense", "转向"),
    "mm": ("mm",),
    "deg": ("deg", "方向"),
    "problem": ("problem", "题号", "题"),
}


def read_answers(path: Path, any_keys: Mapping[str, AnswerKey], keys_of: KeysOf, sheets: Sheets) -> Returned:
    """What a file holds; any_keys: problem → the key of some student, for the names; keys_of: those of one.

    Raises TableError where no page of it can be read, OSError. What belongs to nobody, or to the sheet of another
    student, is kept as a fault.
    """
    returned = Returned()
    if path.suffix.lower() in (".yaml", ".yml", ".json"):
        documents(path, any_keys, keys_of, returned)
        return returned
    found = [_read(page, any_keys, keys_of, sheets, returned) for page in pages(path)]
    counts = [one for one in found if one is not None]
    if counts and not any(counts):
        raise TableError(
            Words(
                f"{path}：没有一列是这次作业的答案；请核对文件和作业文件夹（题号有 {'、'.join(any_keys)}；"
                f"有几题时表头写明题号，如 {next(iter(any_keys))}:v_E）",
                f"{path}: no column holds answers to this class; check the file and the folder (the problems are "
                f"{', '.join(any_keys)}; of several the head names the problem, as {next(iter(any_keys))}:v_E)",
            ),
            code="no-answers",
        )
    if not counts:
        raise TableError(
            Words(
                f"{path}：前 {HEADS} 行中没有“学号”一列；请用生成的答案表，或加表头 学号,v_C,…",
                f"{path}: no column of student numbers in the first {HEADS} rows; use the answers form, or add a "
                "header number,v_C,...",
            ),
            code="no-header",
        )
    return returned


def _read(page: Page, keys: Mapping[str, AnswerKey], keys_of: KeysOf, sheets: Sheets, returned: Returned) -> int | None:
    """Read one page: how many columns of answers it has; None where it has no header."""
    for i, row in enumerate(page.rows[:HEADS]):
        columns = {what: j for j, cell in enumerate(row) if (what := identity(cell)) is not None}
        if "student" not in columns:
            continue
        long = _long(row)
        if "step" in long and "value" in long:
            _long_rows(page, i, columns["student"], long, keys_of, returned)
            return 1
        others, heads = of_others(page, i, columns, sheets, returned), _heads(page, i, columns, keys, returned)
        if heads:
            _wide_rows(page, i, columns["student"], heads, keys_of, returned, others)
        return len(heads)
    return None


def _heads(
    page: Page, i: int, columns: Mapping[str, int], keys: Mapping[str, AnswerKey], returned: Returned
) -> dict[int, Head]:
    """Column → head; what is no symbol of any problem is told, and a problem that there is not once."""
    found: dict[int, Head] = {}
    strange = set[object]()
    default = page.name if page.name in keys else None
    for j, cell in enumerate(page.rows[i]):
        if j in columns.values() or not cell.strip():
            continue
        try:
            one = head(cell, keys, default)
        except UnknownNameError as error:
            if error.numbers.get("problem") not in strange:
                returned.fault(page.place(i, j), "column", error.words)
            strange |= {error.numbers["problem"]} if error.code == NO_PROBLEM else set()
            continue
        before = next((k for k, other in found.items() if other.what == one.what), None)
        if before is None:
            found[j] = one
        else:
            returned.fault(page.place(i, j), "column-twice", _column_twice(page.rows[i][before], before + 1))
    return found


def _column_twice(head: str, column: int) -> Words:
    return Words(
        f"与第 {column} 列（{head}）是同一个量；此列未用，请只留一列",
        f"it holds what column {column} ({head}) holds; this column is not used, leave one of them",
    )


def _wide_rows(
    page: Page, i: int, student: int, heads: Mapping[int, Head], keys_of: KeysOf, returned: Returned, others: set[int]
) -> None:
    """One row a student; a row of units under the header is left out. others: rows that are not used."""
    for n, row in enumerate(page.rows[i + 1 :], i + 1):
        if n in others:
            continue
        number = numbered(row[student]) if student < len(row) else ""
        if not number:
            if any(cell.strip() for cell in row) and not (n == i + 1 and _is_of_units(row, heads)):
                returned.fault(
                    page.place(n, student),
                    "no-number",
                    Words("此行没有学号；请补上", "this row has no student number; add it"),
                )
            continue
        keys = keys_of(number)
        if keys is None:
            returned.fault(page.place(n, student), "stranger", _stranger(number))
            continue
        _of_merged(page, n, heads, number, returned)
        for problem, key in keys.items():
            parts = {one: row[j] for j, one in heads.items() if one.problem == problem and j < len(row)}
            if any(text.strip() for text in parts.values()):  # a row of blanks is nobody's work
                places = _places(page, n, {j: one for j, one in heads.items() if parts.get(one, "").strip()}, key)
                returned.add(Answers(student=number, problem=problem, cells=joined(key, parts), places=places))


def _places(page: Page, n: int, heads: Mapping[int, Head], key: AnswerKey) -> dict[str, Place]:
    """Where each answer of a row stands: its value, or what else there is of it."""
    found: dict[str, Place] = {}
    for part in Part:
        for j, one in heads.items():
            if one.part is part:
                found.setdefault(cell_of(key, one), page.place(n, j))
    return found


def _of_merged(page: Page, n: int, heads: Mapping[int, Head], number: str, returned: Returned) -> None:
    """Tell that an answer of this row was merged with one above, so that it has none: nobody knows whether it is
    meant for both."""
    lost = [j for j in heads if (n, j) in page.merged]
    if lost:
        said = Words(
            "单元格与上面的行合并了，此行没有答案；请取消合并，逐行填写",
            "a cell is merged with the row above, and this row has no answer in it; unmerge it and fill in each row",
        )
        returned.fault(page.place(n, lost[0]), "merged", said, number)


def _is_of_units(row: Sequence[str], heads: Mapping[int, Head]) -> bool:
    """Whether a row under the header tells units, so that no answer stands in it: N is newton there, not "no"."""
    cells = (row[j] for j in heads if j < len(row))
    return not any(written(cell).state is State.READ for cell in cells if unit(cell) is None)


def _long(row: Sequence[str]) -> dict[str, int]:
    bare = [cell.strip().lower() for cell in row]
    return {what: j for what, heads in _LONG.items() for j, cell in enumerate(bare) if cell in heads}


def _long_rows(
    page: Page, i: int, student: int, columns: Mapping[str, int], keys_of: KeysOf, returned: Returned
) -> None:
    """One row an answer: student, step, value, unit, sense, mm, deg."""
    parts: dict[tuple[str, str], dict[Head, str]] = {}
    places: dict[tuple[str, str], dict[str, Place]] = {}
    for n, row in enumerate(page.rows[i + 1 :], i + 1):
        cell = {what: row[j].strip() if j < len(row) else "" for what, j in {**columns, "student": student}.items()}
        cell["student"] = numbered(cell["student"])
        keys = keys_of(cell["student"])
        if keys is None:
            if cell["student"]:
                returned.fault(page.place(n, student), "stranger", _stranger(cell["student"]))
            continue
        symbol = f"{cell['problem']}:{cell['step']}" if cell.get("problem") else cell["step"]
        try:
            one = head(symbol, keys)
        except UnknownNameError as error:
            returned.fault(page.place(n, columns["step"]), "step", error.words)
            continue
        whose = cell["student"], one.problem
        mine, there = parts.setdefault(whose, {}), places.setdefault(whose, {})
        if twice(more := _parts(one, cell), mine):
            said = written_twice(one.symbol, there[one.symbol])
            returned.fault(page.place(n, columns["step"]), "twice", said, cell["student"])
            continue
        mine.update(more)
        there.setdefault(one.symbol, page.place(n, columns["value"]))
    for (number, problem), mine in parts.items():
        key = (keys_of(number) or {})[problem]
        returned.add(Answers(student=number, problem=problem, cells=joined(key, mine), places=places[number, problem]))


def _parts(one: Head, cell: Mapping[str, str]) -> dict[Head, str]:
    """What a row of a long table holds: the value, and each other part that is there."""
    found = {one: with_unit(cell["value"], cell["unit"]) if cell.get("unit") else cell["value"]}
    for what, part in (("sense", Part.SENSE), ("mm", Part.LENGTH), ("deg", Part.DIRECTION)):
        if cell.get(what):
            found[Head(one.problem, one.symbol, part)] = cell[what]
    return found


def _stranger(number: str) -> Words:
    return Words(
        f"名册中没有学号 {number}；请核对学号，或用这个班的作业文件夹",
        f"the register has no student {number}; check the number, or name the folder of this class",
    )


__all__ = ["Place", "read_answers"]
