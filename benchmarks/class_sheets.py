"""A class of two problems, everybody with own values: CPU seconds of question and solution, beside the same pages
written raw.

The floor draws what was read back from the finished sheets, as that of `report_pages` does. It draws no values, weighs
nothing, solves nothing.
"""

from __future__ import annotations

import time
from pathlib import Path
from tempfile import TemporaryDirectory

from vecpoly.batch.classwork import Made, Order, Told, make_class
from vecpoly.batch.run.runners import Here
from vecpoly.batch.student import Student
from vecpoly.foundation.running.rubbish import seldom_looked_for
from vecpoly.problem.assignment import load_assignment
from vecpoly.words import Words

from .report_pages import _raw, _read

STUDENTS, CLASS, PROCESSORS = 20, 300, 2
TEXT = """\
title: {zh: 作业, en: Homework}
id: bench
problems:
  - problem: 3-9
    scales: null
    find: [v_C2B, v_C2C3, omega_3, v_E, at_C2B, alpha_3, a_E]
    vary: {AB: 24 mm .. 40 mm by 2 mm, x_C: -120 mm .. -80 mm by 5 mm, phi: 0 deg .. 355 deg by 5 deg,
           omega: 5 rad/s cw .. 25 rad/s cw by 0.5 rad/s}
  - problem: 3-7a
    scales: null
    vary: {AB: 40 mm .. 60 mm by 2 mm, phi: 0 deg .. 355 deg by 5 deg, omega: 5 rad/s ccw .. 25 rad/s ccw by 0.5 rad/s}
"""


def run() -> str:
    """One line of the report."""
    seldom_looked_for()  # as the workers of a class do
    with TemporaryDirectory() as folder:
        pilots, drawn, printed = _timed(Path(folder))
        pages = [page for file in sorted(Path(folder).glob("hw/*/*.pdf")) for page in _read(file)]
        start = time.process_time()
        _raw(Path(folder) / "raw.pdf", tuple(pages))
        floor = time.process_time() - start
    each = (drawn + printed) / STUDENTS
    whole = (pilots + each * CLASS) / PROCESSORS
    return (
        f"a class, two problems each with own values: {1e3 * each:.0f} ms of a processor a student "
        f"(values {1e3 * drawn / STUDENTS:.0f}, question and solution {1e3 * printed / STUDENTS:.0f}), "
        f"{(drawn + printed) / floor:.1f} × the same {len(pages)} pages written raw; pilots {pilots:.1f} s once; "
        f"so {CLASS} students on {PROCESSORS} processors: {whole:.0f} s; aim ≤ 60"
    )


def _timed(folder: Path) -> tuple[float, float, float]:
    """CPU seconds of the pilots, of drawing the values, of writing the sheets."""
    file = folder / "bench.yaml"
    file.write_text(TEXT, encoding="utf-8")
    students = tuple(Student(number=f"{n:05}", name="王小明", team="1") for n in range(STUDENTS + 1))
    stamps: list[tuple[str, float]] = []

    def told(doing: Words, done: int, of: int) -> None:
        stamps.append((doing.en, time.process_time()))

    _made(file, folder / "warm", students[:1], lambda *_: None)
    start = time.process_time()
    _made(file, folder / "hw", students[1:], told)
    first = stamps[0][1]
    printing = next(when for what, when in stamps if what == "writing sheets")
    return first - start, printing - first, stamps[-1][1] - printing


def _made(file: Path, out: Path, students: tuple[Student, ...], told: Told) -> Made:
    order = Order(assignment=load_assignment(file), students=students, out=out, lang="zh", version="bench")
    return make_class(order, Here(), told)


if __name__ == "__main__":
    print(run())
