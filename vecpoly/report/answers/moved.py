"""By how much the cycle of a linkage that was found misses the exact values, with the lengths read."""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite

from ...check.candidates import exact
from ...designs.base import Design
from ...solution import Solution
from ...words import Lang, Words, joined

_PLACES = 2  # decimals
_SWING, _STROKE = Words("摆角", "the swing"), Words("行程", "the stroke")
_K, _GAMMA = Words.same("$K$"), Words.same("$γ_{min}$")


def moved_verdict(solution: Solution, lang: Lang) -> str:
    """The largest deviations of all solutions, each of its kind; nothing where no exact value stands beside."""
    most = dict[tuple[Words, str], float]()
    for kind, off in _offs(solution):
        most[kind] = max(off, most.get(kind, 0.0))
    seen = {kind: f"{off:.{_PLACES}f}" for kind, off in most.items()}
    if not seen:
        return ""
    if not any(float(off) for off in seen.values()):
        return Words("其运动与精确值一致。", "Its motion equals the exact one.").of(lang)
    told = joined([name + Words.same(f" {off}{unit or ' %'}") for (name, unit), off in seen.items()])
    return Words(f"与精确值的最大偏差：{told.zh}。", f"Largest deviations from the exact values: {told.en}.").of(lang)


def _offs(solution: Solution) -> Iterator[tuple[tuple[Words, str], float]]:
    """Kind and size of every deviation: of K in per cent."""
    design = solution.problem.subject
    true = dict(enumerate(exact(design), 1)) if isinstance(design, Design) and solution.verification else {}
    for one in solution.verification:
        values = true.get(one.number, {})
        swings = one.unit == "°"
        kinds = (
            ("K", _K, "", one.ratio),
            ("psi" if swings else "H", _SWING if swings else _STROKE, "°" if swings else " mm", one.stroke),
            ("gamma_min", _GAMMA, "°", one.gamma if one.full else float("nan")),
        )
        for key, name, unit, value in kinds if one.broken is None else ():
            if key in values and isfinite(value):
                gap = abs(value - values[key])
                yield (name, unit), gap if unit else 100.0 * gap / abs(values[key])
