"""The warm course report of A-27: cycle, model, four drawn positions, 24 drawings compared, curves, tables, pages."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

from pypdf import PdfReader

from vecpoly.problem.load import load
from vecpoly.report.document import write_report
from vecpoly.solution import solve

from .timing import best


def run() -> str:
    """One line of the report."""
    problem = load("A-27")
    with TemporaryDirectory() as folder:
        path = Path(folder) / "course.pdf"

        def build() -> object:
            return write_report([solve(problem)], path, style="course")

        start = perf_counter()
        build()
        cold = perf_counter() - start
        (warm,) = best(build, runs=5)
        pages = len(PdfReader(path).pages)
    return (
        f"course report of A-27, {pages} pages: warm {warm:.2f} s of CPU time; the first in a process "
        f"{cold:.2f} s; aim below 5 s"
    )


if __name__ == "__main__":
    print(run())
