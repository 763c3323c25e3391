"""1,000 unsteady hands on 3-9 in one pass, against one exact hand."""

from __future__ import annotations

from vecpoly.board.hand import hand
from vecpoly.methods.plan import construct
from vecpoly.problem.load import load

from .timing import best


def run() -> str:
    """One line of the report."""
    problem = load("3-9")
    one, many = best(
        lambda: construct(problem, hand("exact")), lambda: construct(problem, hand("pencil", repeats=1000))
    )
    return (
        f"1,000 pencil hands on 3-9: {many * 1e3:.1f} ms = {many / one:.2f} × one exact hand ({one * 1e3:.1f} "
        "ms); aim < 1 s"
    )


if __name__ == "__main__":
    print(run())
