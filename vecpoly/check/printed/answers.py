"""All printed answers of a problem, checked; and whether, taken together, they can belong to the mechanism at all."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from statistics import median

from ...designs.base import Design
from ...foundation.arguments import of_kind
from ...mechanism.asked.forces import quantities
from ...names import Kind, Rel, parse_rel
from ...problem.problem import Printed, Problem
from ...words import Words
from ..truth import truth_of
from .among import among
from .direction import with_directions
from .follow import follow
from .misprint import with_misprints
from .possible import BestFit, best_fit
from .verdict import FACTORS, GRAPHICAL, SLIP, Checked, Verdict, check_printed

_RATES = (Kind.V, Kind.OMEGA)


@dataclass(frozen=True, slots=True, kw_only=True)
class PrintedCheck:
    """The verdict on every printed answer, and on the whole (None where nothing is to be said)."""

    answers: tuple[Checked, ...]
    unchecked: tuple[Printed, ...]
    whole: Words | None = None
    fit: BestFit | None = None


def check_problem(problem: Problem) -> PrintedCheck:
    """Check every printed answer of the problem against the oracle."""
    of_kind(problem, Problem, Words("题目（load 或 loads 的结果）", "a problem, as load and loads give it,"))
    checked: list[Checked] = []
    skipped: list[Printed] = []
    known = truth_of(problem)
    truth = known.behind()
    for printed in problem.printed:
        exact = None if printed.lost else truth(printed)
        if exact is None:
            skipped.append(printed)
        else:
            checked.append(check_printed(printed, exact, GRAPHICAL if isinstance(problem.subject, Design) else SLIP))
    if problem.loads:
        checked = follow(checked, problem.loads, _by_key(problem, truth))
    checked = with_directions(known, checked)
    if isinstance(problem.subject, Design):
        checked = with_misprints(checked)
    whole, fit = _together(problem, checked)
    whole = whole or among(problem, skipped)
    return PrintedCheck(answers=tuple(checked), unchecked=tuple(skipped), whole=whole, fit=fit)


def _by_key(problem: Problem, truth: Callable[[Printed], float | None]) -> Callable[[str], float | None]:
    """The exact value by key, of what is not printed itself."""
    assert problem.loads
    named = quantities(problem.mechanism, problem.loads)

    def value(key: str) -> float | None:
        rel = named.get(key) or parse_rel(key)
        return truth(Printed(symbol=key, rel=rel, value=0.0, text=""))

    return value


def _together(problem: Problem, checked: list[Checked]) -> tuple[Words | None, BestFit | None]:
    """Several velocities far off at once: one common factor, another position or assembly, or no position at all?

    Only velocities and angular velocities are tried: accelerations magnify a drawing error too much to tell.
    """
    rates = [c for c in checked if isinstance(c.printed.rel, Rel) and c.printed.rel.kind in _RATES and c.exact]
    far = [c for c in rates if c.verdict is Verdict.WRONG]
    if len(far) < 2:
        return None, None
    if (common := _common_factor(rates)) is not None:
        return common, None
    fit = best_fit(problem, [c.printed for c in rates])
    if fit is None or fit.misfit <= SLIP:
        return None, fit
    percent = f"{100 * fit.misfit:.0f} %"
    return Words(
        f"按题给数据，对任意曲柄转角和装配形式，原书所给速度中至少有一项相差 {percent} 以上："
        "题给数据与原书答案矛盾，这组答案不可能成立。",
        "With the data as given, the best of all crank angles and assemblies still misses one of "
        f"these printed velocities by {percent}: data and printed answers contradict each other, "
        "the printed solution is impossible.",
    ), fit


def _common_factor(rates: list[Checked]) -> Words | None:
    """Most velocities differ from the exact ones by one and the same known factor."""
    ratios = [abs(c.printed.value / c.exact) for c in rates]
    middle = median(ratios)
    alike = sum(abs(r / middle - 1) < GRAPHICAL for r in ratios)
    words = next((w for factor, w in FACTORS if abs(middle / factor - 1) < GRAPHICAL), None)
    if words is None or 2 * alike <= len(ratios):
        return None
    return Words(
        f"{len(ratios)} 个所给速度中有 {alike} 个约为精确值的 {middle:.2g} 倍：{words.zh}。",
        f"{alike} of {len(ratios)} printed velocities are about {middle:.2g} times the exact ones: {words.en}.",
    )
