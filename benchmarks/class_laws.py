"""What a class costs as it grows: processor time, memory and disk of several sizes, a law fitted to them, and what the
law says of a hundred thousand sheets. `python -m benchmarks.class_laws 50 100 200`: longer than the other benchmarks.

Every size is a process of its own, so that its memory is its own. All laws are a + b n: values need not be apart here
(`gate: {apart: 0}`), for no grid holds so many that are.
"""

from __future__ import annotations

import json
import subprocess
import sys
import time
from pathlib import Path
from resource import RUSAGE_SELF, getrusage
from tempfile import TemporaryDirectory

import numpy as np

from vecpoly.batch.classwork import Order, make_class
from vecpoly.batch.run.runners import Here
from vecpoly.batch.student import Student
from vecpoly.problem.assignment import load_assignment
from vecpoly.words import Words

MANY = 100_000
SIZES = (50, 100, 200, 400)
TEXT = """\
title: {zh: 作业, en: Homework}
id: laws
problems:
  - problem: 3-9
    scales: null
    find: [v_C2B, v_C2C3, omega_3, v_E, at_C2B, alpha_3, a_E]
    gate: {apart: 0}
    vary: {AB: 24 mm .. 40 mm by 2 mm, x_C: -120 mm .. -80 mm by 5 mm, phi: 0 deg .. 355 deg by 5 deg,
           omega: 5 rad/s cw .. 25 rad/s cw by 0.5 rad/s}
"""


def measured(count: int, of: int = 1) -> dict[str, float]:
    """One class, or the first of so many shards of it: CPU seconds (values; sheets), MB of memory at its highest, MB on
    disk, for one student; run in a process of its own."""
    with TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "laws.yaml").write_text(TEXT, encoding="utf-8")
        students = tuple(Student(number=f"{n:06}", name="王小明", team="1") for n in range(count))
        order = Order(
            assignment=load_assignment(folder / "laws.yaml"), students=students, out=folder / "hw", lang="zh",
            version="bench",
        )  # fmt: skip
        stamps: list[tuple[str, float]] = []

        def told(doing: Words, done: int, of: int) -> None:
            stamps.append((doing.en, time.process_time()))

        make_class(order, Here(), told, None if of == 1 else (0, of))
        first, printing = stamps[0][1], next(when for what, when in stamps if what == "writing sheets")
        disk = sum(file.stat().st_size for file in (folder / "hw").rglob("*") if file.is_file())
        return {
            "count": count, "values": printing - first, "sheets": stamps[-1][1] - printing,
            "memory": getrusage(RUSAGE_SELF).ru_maxrss / 1024, "disk": disk / 1e6,
        }  # fmt: skip


def law(counts: list[float], found: list[float]) -> np.ndarray:
    """The coefficients of a + b n, none of them below zero."""
    from scipy.optimize import nnls

    n = np.array(counts)
    return np.asarray(nnls(np.stack([n**k for k in range(2)], axis=1), np.array(found))[0])


def run(sizes: tuple[int, ...] = SIZES) -> str:
    """The table, the laws, and what they say of MANY sheets."""
    rows = [json.loads(_alone(size)) for size in sizes]
    counts = [float(row["count"]) for row in rows]
    lines = [
        "students " + "".join(f"{row['count']:>9}" for row in rows),
        *(
            f"{name:9s}" + "".join(f"{row[name]:9.1f}" for row in rows)
            for name in ("values", "sheets", "memory", "disk")
        ),
    ]
    for name, unit in (("values", "s"), ("sheets", "s"), ("memory", "MB"), ("disk", "MB")):
        fitted = law(counts, [row[name] for row in rows])
        many = float(sum(one * MANY**k for k, one in enumerate(fitted)))
        terms = " + ".join(f"{one:.3g}" + ("", " n")[k] for k, one in enumerate(fitted))
        off = max(
            abs(sum(one * n**k for k, one in enumerate(fitted)) / row[name] - 1)
            for n, row in zip(counts, rows, strict=True)
        )
        lines.append(
            f"{name} = {terms} {unit} (within {off:.0%}); {MANY:,} sheets: {many:,.0f} {unit}" + _hours(many, unit)
        )
    return "\n".join(lines)


def _hours(many: float, unit: str) -> str:
    return f" = {many / 3600:.1f} h of one processor" if unit == "s" else ""


def _alone(size: int) -> str:
    command = [
        sys.executable,
        "-c",
        f"import json; from benchmarks.class_laws import measured; print(json.dumps(measured({size})))",
    ]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


if __name__ == "__main__":
    print(run(tuple(map(int, sys.argv[1:])) or SIZES))
