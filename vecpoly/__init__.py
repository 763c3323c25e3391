"""vecpoly: the graphical methods of planar mechanisms, drawn to scale.

    import vecpoly
    vecpoly.load("3-9").solve().report("3-9.pdf")

Names are imported when they are first used, so that `import vecpoly` costs nothing.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .answer import Answer
    from .board.otherwise.slip import Mistake, Slip
    from .check.printed.answers import PrintedCheck, check_problem
    from .check.table.whole import TableCheck, check_table
    from .door import Construction, Problem, Solution, from_json, load, load_assignment, loads, problem, solve
    from .errors import VecpolyError
    from .grading.student import check_answers
    from .live import Redrawn, redraw
    from .mechanism.model import Mechanism
    from .mistakes import slips
    from .problem.assignment import Assignment
    from .problem.values.made import build_mechanism
    from .record import to_json
    from .report.document import write_report

__version__ = "0.1.0"

_HOMES = {
    "Answer": ("answer", "Answer"),
    "Assignment": ("problem.assignment", "Assignment"),
    "Construction": ("door", "Construction"),
    "Mechanism": ("mechanism.model", "Mechanism"),
    "Mistake": ("board.slip", "Mistake"),
    "PrintedCheck": ("check.printed", "PrintedCheck"),
    "Problem": ("door", "Problem"),
    "Redrawn": ("live", "Redrawn"),
    "Slip": ("board.slip", "Slip"),
    "Solution": ("door", "Solution"),
    "TableCheck": ("check.table", "TableCheck"),
    "VecpolyError": ("errors", "VecpolyError"),
    "build_mechanism": ("problem.made", "build_mechanism"),
    "check_answers": ("grading.student", "check_answers"),
    "check_problem": ("check.printed", "check_problem"),
    "check_table": ("check.table", "check_table"),
    "from_json": ("door", "from_json"),
    "load": ("door", "load"),
    "load_assignment": ("door", "load_assignment"),
    "loads": ("door", "loads"),
    "problem": ("door", "problem"),
    "redraw": ("live", "redraw"),
    "slips": ("mistakes", "slips"),
    "solve": ("door", "solve"),
    "to_json": ("record", "to_json"),
    "write_report": ("report.document", "write_report"),
}

__all__ = [
    "Answer",
    "Assignment",
    "Construction",
    "Mechanism",
    "Mistake",
    "PrintedCheck",
    "Problem",
    "Redrawn",
    "Slip",
    "Solution",
    "TableCheck",
    "VecpolyError",
    "build_mechanism",
    "check_answers",
    "check_problem",
    "check_table",
    "from_json",
    "load",
    "load_assignment",
    "loads",
    "problem",
    "redraw",
    "slips",
    "solve",
    "to_json",
    "write_report",
]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'vecpoly' has no attribute '{name}'")
    module, inside = _HOMES[name]
    return getattr(import_module(f".{module}", __name__), inside)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
