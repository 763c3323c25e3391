"""The files of a class, damaged: rosters, profiles, registers, answers, rules, marks, drawings; and what becomes of
them. A task is the name of a file and a seed, from which the same damage is done again."""

from __future__ import annotations

import contextlib
import json
import re
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache
from io import BytesIO
from pathlib import Path

import numpy as np
from openpyxl import Workbook, load_workbook
from typer.testing import CliRunner

from tests.grading.drawings.made import as_dxf, as_ggb, as_pdf, as_svg, by, drawn, key_of, lying
from tests.marked.classes import NUMBERS, answers, graded, register, wide
from vecpoly.batch.forms.profile import read_profile, table_bytes
from vecpoly.batch.forms.workbooks import answers_bytes
from vecpoly.batch.register import NAME
from vecpoly.batch.roster import read_roster
from vecpoly.cli import app

from .commands import printed, spoilt, wrong_end
from .files import damaged_bytes
from .mutants import mutant
from .outcome import End, Outcome, ended

ROSTER = "学号,姓名,班级\n2023001,张三,机1\n2023002,李四,机1\n２０２３００３,王五,机2\n"
PROFILE = "file: xuexitong.csv\nmark: true\ncolumns: [{head: 学号, holds: number}, {head: AB, holds: '3-9:phi'}]\n"
RULES = """\
rules: {own: 1.0, close: 0.5, slip: 0.5, turned: 0.5, unit: 0.5, printed: true, open: false, compensatory: true}
rubric: {velocity: {scale: 1, drawn: 5, values: 1, rates: 1, equation: 2}, other: {values: 1}}
points: {3-9: {v_E: {method: 2, accuracy: 1.2}, omega_3: {accuracy: 1, sense: 1}}}
"""
_GRADED = "grade hw {answers} -o out --no-feedback -j 1 --lang en"
_ANSWERS = ("row.csv", "a.csv", "long.csv", "a.xlsx", "a.yaml", "a.json")
_DRAWINGS: Mapping[str, Callable[..., bytes]] = {"d.dxf": as_dxf, "d.svg": as_svg, "d.pdf": as_pdf, "d.ggb": as_ggb}
FILES = (
    "roster.csv", "roster.xlsx", "profile.yaml", "register.json", "rules.yaml", "marks.json", *_ANSWERS, *_DRAWINGS,
)  # fmt: skip


def damaged_classes(rng: np.random.Generator, count: int) -> Iterator[str]:
    """So many files in turn, each with the seed of its damage."""
    for n in range(count):
        yield f"{FILES[n % len(FILES)]} {int(rng.integers(10**9))}"


def of_class(task: str) -> Outcome:
    """Damage that file by that seed, and read it as its command does."""
    name, _, seed = task.partition(" ")
    rng = np.random.default_rng(int(seed))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / name
        path.write_bytes(_damaged(rng, name))
        if name.startswith("roster"):
            return ended(lambda: read_roster(path))
        if name.startswith("profile"):
            return ended(lambda: table_bytes(register(), read_profile(path)))
        return _marked(Path(folder), name)


def _damaged(rng: np.random.Generator, name: str) -> bytes:
    """Texts as problem files are damaged, in one student's row alone now and then; all others byte by byte."""
    good = good_files()[name]
    if name == "row.csv":
        return _one_row_damaged(rng, good)
    if name.endswith((".xlsx", ".pdf", ".ggb")):
        return damaged_bytes(rng, good)
    return mutant(rng, [good.decode()]).encode("utf-8", "surrogatepass")


def _one_row_damaged(rng: np.random.Generator, good: bytes) -> bytes:
    """What one student wrote is damaged, in one line as before."""
    head, units, first, second, third = good.decode().splitlines()
    damaged = re.sub(r'[\r\n"\0]', "", mutant(rng, [second.replace(",", ", ")]))
    return "\n".join([head, units, first, damaged, third]).encode("utf-8", "surrogatepass")


def _marked(folder: Path, name: str) -> Outcome:
    """What `grade` makes of a class one of whose files is damaged."""
    line = _furnished(folder, name)
    before = printed(folder)
    with contextlib.chdir(folder):
        result = CliRunner().invoke(app, line.split(), prog_name="vecpoly")
    said = wrong_end(result) or spoilt(folder, before, result.exit_code)
    if not said and (folder / "out" / "marks.json").exists():
        said = _lost(folder, name)
    return Outcome(End.TRACEBACK, said) if said else Outcome(End.REFUSED if result.exit_code else End.SOLVED)


def _furnished(folder: Path, name: str) -> str:
    """Lay the other files beside the damaged one; and the command."""
    (folder / "hw").mkdir()
    taken = folder / name
    if name == "register.json":
        taken.rename(folder / "hw" / NAME)
    else:
        (folder / "hw" / NAME).write_bytes(good_files()["register.json"])
    if name not in _ANSWERS:
        (folder / "a.csv").write_bytes(good_files()["a.csv"])
    line = _GRADED.format(answers=name if name in _ANSWERS else "a.csv")
    if name == "rules.yaml":
        return f"{line} --rules {name}"
    if name == "marks.json":
        (folder / "before").mkdir()
        taken.rename(folder / "before" / name)
        return f"{line} --diff before"
    if name in _DRAWINGS:
        (folder / "drawings").mkdir()
        taken.rename(folder / "drawings" / f"{NUMBERS[0]}_3-9{taken.suffix}")
        return f"{line} --drawings drawings"
    return line


def _lost(folder: Path, name: str) -> str:
    """Nobody is missing from the marks, and nobody has more than the sheet is worth, or what is no number."""
    marks = json.loads((folder / "out" / "marks.json").read_bytes())["students"]
    missing = [one for one in NUMBERS if one not in [student["number"] for student in marks]]
    if missing and name != "register.json":
        return f"{missing[0]} is not among the marks"
    if name == "row.csv" and (other := [one for one in (marks[0], marks[2]) if one["total"] != one["worth"]]):
        return f"{other[0]['number']} has {other[0]['total']} for another's row"
    odd = [one for one in marks if not 0 <= one["total"] <= one["worth"] + 1e-6 < 1e6]
    return f"{odd[0]['total']} points of {odd[0]['worth']}" if odd else ""


@cache
def good_files() -> Mapping[str, bytes]:
    """All of them as they should be."""
    rows = {number: answers(number) for number in NUMBERS}
    with tempfile.TemporaryDirectory() as folder:
        table = wide(Path(folder) / "a.csv", rows)
        graded(Path(folder) / "out", table)
        marks, cells = (Path(folder) / "out" / "marks.json").read_bytes(), table.read_bytes()
    documents = {"students": [{"student": number, "answers": {"3-9": own}} for number, own in rows.items()]}
    long = [
        ("学号", "题号", "量", "答案"),
        *((n, "3-9", key, said) for n, own in rows.items() for key, said in own.items()),
    ]
    key = key_of("3-9")
    drawing = lying(key.exact, drawn(key.exact), velocity=by(10))
    return {
        "roster.csv": ROSTER.encode(),
        "roster.xlsx": _workbook([line.split(",") for line in ROSTER.splitlines()]),
        "profile.yaml": PROFILE.encode(),
        "register.json": register().as_bytes(),
        "rules.yaml": RULES.encode(),
        "marks.json": marks,
        "a.csv": cells,
        "row.csv": cells,
        "long.csv": "\n".join(map(",".join, [("学号", "题号", "量", "答案"), *long])).encode(),
        "a.xlsx": _filled_in(rows),
        "a.yaml": json.dumps(documents, ensure_ascii=False, indent=1).encode(),
        "a.json": json.dumps(documents, ensure_ascii=False).encode(),
        **{name: made(drawing) for name, made in _DRAWINGS.items()},
    }


def _workbook(rows: Sequence[Sequence[str]]) -> bytes:
    book, out = Workbook(), BytesIO()
    page = book.active
    assert page is not None
    for row in rows:
        page.append(list(row))
    book.save(out)
    return out.getvalue()


def _filled_in(rows: Mapping[str, Mapping[str, str]]) -> bytes:
    """The form of the class with what these students answer."""
    book, out = load_workbook(BytesIO(answers_bytes(register()))), BytesIO()
    page = book.worksheets[0]
    heads = [str(cell.value) for cell in page[1]]
    for row in page.iter_rows(min_row=3):
        own = rows[str(row[0].value)]
        for head, cell in zip(heads, row, strict=True):
            cell.value = own.get(head.rpartition(":")[2], cell.value)
    book.save(out)
    return out.getvalue()
