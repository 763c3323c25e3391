"""python -m tests.grader_proof [--count 1000] [PROBLEM ...]: the table of the grader against itself."""

from __future__ import annotations

import argparse
import re
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import suppress

from tests.grader_proof.judge import Tally, Trial
from tests.grader_proof.students import drawn_class
from tests.grader_proof.trials import blanks, foreign, misread, right_work, single_slips, two_slips, uncatalogued
from tests.grader_proof.writing import TRIALS
from vecpoly import Problem, load
from vecpoly.errors import VecpolyError

PROBLEMS = (
    "3-9",
    "3-12",
    "3-11",
    "A-27",
    "3-8",
    "3-14",
    "3-2",
    "4-3a",
    "4-4",
    "4-5",
    "slider-crank-dynamic",
    "whitworth-quick-return",
    "tipper",
    "5-2",
    "8-4",
    "8-15",
    "cam-roller-load",
    "curv-1",
)
_SIZE = re.compile(r"(-?[\d.]+) (mm|N|deg)")
BARS = {
    "pencil: whole sheets accepted": (">=", 0.95), "pencil: quantities accepted": (">=", 0.99),
    "pencil: accused of a slip": ("<=", 0.01),
    "single slips caught": (">=", 0.99), "single slips named rightly": (">=", 0.95),
    "uncatalogued errors named as a slip": ("<=", 0.05), "another student's sheet accepted": ("<=", 0.0),
    "follow-through lowered a mark": ("<=", 0.0), "one misreading costs once": (">=", 1.0),
    "zeros taken as right": ("<=", 0.0), "zeros accused of a slip": ("<=", 0.01),
    "another direction or sense caught": (">=", 0.99), "another direction or sense named as a slip": ("<=", 0.05),
    "one direction or sense costs once": (">=", 0.99),
    "names exchanged: caught": (">=", 0.99), "names exchanged: named as a slip": ("<=", 0.05),
    "everything by a factor: named as a slip": ("<=", 0.05),
}  # fmt: skip


def others(problem: Problem) -> list[Problem]:
    """The problem with other values, as other students have it: other places of the drive, and one other length or
    force each."""
    found: list[Problem] = []
    for name, text in _changes(problem):
        with suppress(VecpolyError, ValueError):
            found.append(problem.vary(**{name: text}))
    return found


def _changes(problem: Problem) -> Iterator[tuple[str, str]]:
    phi = _SIZE.fullmatch(problem.parameters.get("phi", ""))
    if phi:
        yield from (("phi", f"{float(phi[1]) + change:g} deg") for change in (12.0, -9.0, 24.0))
    sizes = ((name, _SIZE.fullmatch(text)) for name, text in problem.parameters.items() if name.isidentifier())
    known = [(name, size) for name, size in sizes if size and size[2] in ("mm", "N") and float(size[1])]
    yield from ((name, f"{1.25 * float(size[1]):g} {size[2]}") for name, size in known[:6])


def prove(name: str, count: int, seed: int = 1) -> tuple[Tally, Counter[str]]:
    """All trials of one problem; and which slips were not named rightly."""
    trial, total, missed = Trial.of(load(name)), Tally(), Counter[str]()
    group = drawn_class(trial.problem, trial.key, "pencil", count, seed + 7)
    for part in (
        right_work(trial, "pencil", count, seed), right_work(trial, "student", count, seed),
        right_work(trial, "sloppy", count // 2, seed), two_slips(trial, count // 10, seed),
        uncatalogued(trial, group, count // 2, seed), misread(trial, group, count // 20, seed),
        blanks(trial, group, count // 4, seed),
        foreign(trial, others(load(name)), count // 10, seed),
        *(sort(trial, group, count // 10, seed) for sort in TRIALS),
    ):  # fmt: skip
        for tally in part:
            total += tally
    for slip, tally in single_slips(trial, count, seed):
        total += tally
        if tally.hits.get("single slips named rightly", 1) == 0:
            missed[f"{name}: {slip}"] += 1
    return total, missed


def table(total: Tally) -> str:
    """A line for each claim, with its bar."""
    lines = []
    for name in total.of:
        bar = BARS.get(name)
        share = total.share(name)
        held = (
            ""
            if bar is None
            else f"  {bar[0]} {bar[1]:.0%}  "
            + ("ok" if (share >= bar[1] if bar[0] == ">=" else share <= bar[1]) else "MISSED")
        )
        lines.append(f"{name:58s} {100 * share:7.2f} %  ({total.hits.get(name, 0)} of {total.of[name]}){held}")
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("problems", nargs="*", default=PROBLEMS)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--each", action="store_true", help="a table for each problem")
    options = parser.parse_args()
    whole, missed = Tally(), Counter[str]()
    for name in options.problems:
        start = time.process_time()
        tally, unnamed = prove(name, options.count)
        whole += tally
        missed += unnamed
        print(f"{name}: {time.process_time() - start:.1f} s CPU")
        if options.each:
            print(table(tally), flush=True)
    print(table(whole))
    print("least often named rightly:", *(f"  {slip}: {n}" for slip, n in missed.most_common(15)), sep="\n")


if __name__ == "__main__":
    main()
