"""What becomes of a damaged text: solved, refused, a traceback or a hang."""

from __future__ import annotations

import re
import traceback
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

from vecpoly.errors import VecpolyError


class End(StrEnum):
    """How it ended."""

    SOLVED = "solved"
    REFUSED = "refused"
    TRACEBACK = "traceback"
    HANG = "hang"


@dataclass(frozen=True, slots=True)
class Outcome:
    """How it ended, and the last words."""

    end: End
    said: str = ""


def of_file(path: Path, report: bool = False) -> Outcome:
    """Load and solve a damaged problem file, or an assignment; `report`: set its report too. A search is run."""
    from vecpoly.problem.assignment import is_assignment, load_assignment
    from vecpoly.problem.load import load
    from vecpoly.report.document import report_bytes
    from vecpoly.search.run import run
    from vecpoly.search.spec import load_search
    from vecpoly.solution import solve

    def act() -> None:
        if re.search(rb"(?m)^search:", path.read_bytes()):
            search, spec, _ = load_search(path)
            run(search, path.stem, spec.title, count=1000)
            return
        problems = load_assignment(path).problems if is_assignment(path) else (load(path),)
        for problem in problems[:2]:
            solution = solve(problem, repeats=20)
            solution.as_json()
            if report:
                report_bytes([solution], lang="en")

    return ended(act)


def of_table(problem: str, path: Path) -> Outcome:
    """Compare a damaged table with a problem of the library."""
    from vecpoly.check.table.whole import check_table
    from vecpoly.problem.load import load

    return ended(lambda: check_table(load(problem), path))


def ended(act: object) -> Outcome:
    """What becomes of an act."""
    try:
        act()  # type: ignore[operator]
    except VecpolyError as error:
        said = str(error)
        too_long = len(said) > 5000
        return Outcome(
            End.TRACEBACK if too_long or not said.strip() else End.REFUSED,
            f"message of {len(said)} characters" if too_long else said.splitlines()[0],
        )
    except OSError as error:
        return Outcome(End.REFUSED, str(error))
    except BaseException:
        last = traceback.format_exc().splitlines()
        return Outcome(End.TRACEBACK, f"{last[-1]} | {last[-3].strip() if len(last) > 3 else ''}")
    return Outcome(End.SOLVED)
