"""All printed answers of a problem, checked; and whether, taken together, they can belong to the mechanism at all."""

from __future__ import annotations

from dataclasses import dataclass

from .. import oracle
from ..errors import UnknownNameError
from ..problem.problem import Printed, Problem
from ..words import Words
from .possible import BestFit, best_fit
from .verdict import SLIP, Checked, Verdict, check_printed


@dataclass(frozen=True, slots=True, kw_only=True)
class PrintedCheck:
    """The verdict on every printed answer, and on the whole (empty words where nothing is to be said)."""

    answers: tuple[Checked, ...]
    unchecked: tuple[Printed, ...]
    whole: Words | None = None
    fit: BestFit | None = None


def check_problem(problem: Problem) -> PrintedCheck:
    """Check every printed answer of the problem against the oracle."""
    motion = oracle.solve(problem.mechanism)
    checked, skipped = [], []
    for printed in problem.printed:
        exact = _exact(problem, motion, printed)
        if exact is None:
            skipped.append(printed)
        else:
            checked.append(check_printed(printed, exact))
    whole, fit = _together(problem, checked)
    return PrintedCheck(answers=tuple(checked), unchecked=tuple(skipped), whole=whole, fit=fit)


def _exact(problem: Problem, motion: oracle.Motion, printed: Printed) -> float | None:
    if printed.rel is None:
        letters = printed.symbol.removeprefix("l_")
        if len(letters) != 2:
            return None
        try:
            return float(abs(motion.position(letters[1]) - motion.position(letters[0])))
        except UnknownNameError:
            return None
    value = motion.value(printed.rel)
    return float(abs(value)) if printed.rel.kind.is_vector else float(value.real)


def _together(problem: Problem, checked: list[Checked]) -> tuple[Words | None, BestFit | None]:
    """Several numbers far off at once: is there any position or assembly to which they would belong?"""
    drawn = [c.printed for c in checked if c.printed.kind == "graphical"]
    wrong = [c for c in checked if c.verdict is Verdict.WRONG and c.printed.kind == "graphical"]
    if len(wrong) < 2:
        return None, None
    fit = best_fit(problem, drawn)
    if fit is None or fit.misfit <= SLIP:
        return None, fit
    percent = f"{100 * fit.misfit:.0f} %"
    return Words(f"按题给数据，所有曲柄转角与所有装配形式中，与这些印刷答案最接近者仍相差 {percent}：题给数据与印刷答案矛盾，这组答案不可能成立。",
                 f"With the data as given, the best of all crank angles and assemblies still misses these printed answers by {percent}: "
                 f"data and printed answers contradict each other, the printed solution is impossible."), fit
