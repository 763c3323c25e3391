"""Chapter 7, the model checked: against an independent solver, and by differences of its own results;
and how it depends on the dimensions."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ....algebra.quantity import number
from ....findings.conditioning import determinant
from ....findings.study.study import Study
from ....typeset.runs import raised
from ....words import Words
from ..numbering import Press
from . import tolerances

_QUARTER = ("—", "3.99", "4.00", "4.01")  # ratio of the errors over two steps and one
_SINGULAR, _NEAR = 1e-9, 0.05  # of a group's largest determinant: it vanishes; it is not far from that
_NOTHING, _BESIDE = 1e-13, 1e-9  # no value at all; none beside the largest of its kind, as across a guide
_CHECKED = {
    "zh": ["量", "与独立求解结果之差", "差商误差（2 格）/%", "差商误差（1 格）/%", "两误差之比"],
    "en": [
        "Quantity",
        "Difference from the solver",
        "Error over 2\u00a0steps /%",
        "Error over 1\u00a0step /%",
        "Ratio of the errors",
    ],
}
Reals = NDArray[np.float64]


class _Checked(NamedTuple):
    """A rate: the model less the solver, and less the quotients over two steps and over one, as shares of its largest
    value; how many times the first of these is the other."""

    symbol: str
    gap: float
    wide: float | None
    narrow: float | None
    ratio: str


def chapter(study: Study, press: Press) -> dict[str, Any]:
    """The tables with what is said of them."""
    sound = _sound(study)
    gaps = [_most(np.broadcast_to(gap, sound.shape)[sound]) for _, gap in study.model.gaps(study.turn.phi)]
    step = study.turn.drive.factor * float(study.turn.phi[1] - study.turn.phi[0])
    unit = "°" if study.turn.drive.shown_unit == "°" else f" {study.turn.drive.shown_unit}"
    rows = _checked(study)
    plain = bool(rows) and (study.mech.drive.accel != 0 or all(row.ratio in _QUARTER for row in rows))
    return {
        "table": "" if plain else _table(study, press, rows),
        "told": _told(study, rows).of(press.lang) if plain else "",
        "residual": _power(max(gaps, default=0.0)),
        "step": f"{number(step, 3)}{unit}",
        "count": int(sound.sum()),
        "differences": not study.mech.drive.accel,
        "singular": not sound.all(),
    } | tolerances.section(study, press)


def _power(value: float) -> str:
    """3 × 10⁻¹⁵, or 0."""
    if not value:
        return "0"
    head, _, tail = f"{value:.0e}".partition("e")
    return raised(f"{head} × 10^{int(tail)}")


def _checked(study: Study) -> list[_Checked]:
    """Of every rate told: the model less the solver,
    and the model's rate less the difference quotient of what it is the rate of."""
    sound = _sound(study)
    rates = [(one, _most(one[2][sound])) for one in _rates(study)]
    largest: dict[str, float] = {}  # by the first letter of the symbol: v, a, ω, α
    for (symbol, *_), size in rates:
        largest[symbol[0]] = max(size, largest.get(symbol[0], 0.0))
    return [
        _Checked(
            symbol,
            _most((own - exact)[sound]) / size,
            *_by_quotients(study, None if study.mech.drive.accel else base, np.where(sound, own, np.nan), size),
        )
        for (symbol, own, exact, base), size in rates
        if size > max(_NOTHING, _BESIDE * largest[symbol[0]])
    ]


def _table(study: Study, press: Press, rows: list[_Checked]) -> str:
    """One line a rate, where half the step does not leave a quarter of every error."""
    title = Words("数学模型的校核（占该量最大值）", "The model checked (shares of each quantity's largest value)")
    cells = [(f"${one.symbol}$", _percent(one.gap), _share(one.wide), _share(one.narrow), one.ratio) for one in rows]
    return press.table(title, _CHECKED[press.lang], cells, "lcddd") if cells else ""


def _told(study: Study, rows: list[_Checked]) -> Words:
    """The largest of each, which is all that a table of them would show."""
    gap = _percent(max(one.gap for one in rows))
    told = Words(
        f"各速度、加速度与独立程序的结果之差都不超过该量最大值的 {gap}",
        f"No velocity or acceleration differs from the solver by more than {gap} of its largest value",
    )
    differing = [one for one in rows if one.wide is not None and one.narrow is not None]
    if study.mech.drive.accel or not differing:
        return told + Words("。", ".")
    worst = max(differing, key=lambda one: one.wide or 0.0)
    wide, narrow = (_percent(share or 0.0) for share in (worst.wide, worst.narrow))
    return told + Words(
        f"；与差商相差最大的是 ${worst.symbol}$，步长取 2 格时为其最大值的 {wide}，取 1 格时为 {narrow}。各量步长减半时"
        "误差都约为四分之一，可见差别只是差商的截断误差。",
        f"; ${worst.symbol}$ differs most from its difference quotients, by {wide} of its largest value over two steps "
        f"and {narrow} over one. For every quantity half the step leaves a quarter of the error, which is thus the "
        "truncation error of the differences.",
    )


def _sound(study: Study) -> NDArray[np.bool_]:
    """The positions that are compared: all of them; where a group is singular at a change point, at which rates are 0/0
    and the assembly is not determined, those of the given assembly, on this side of the change points and not near."""
    near = np.zeros(study.turn.phi.shape, np.bool_)
    for size in (determinant(study, one, study.turn.phi) for one in study.model.groups if one.determinant is not None):
        most = float(np.nanmax(size, initial=0.0))
        if not (size > _SINGULAR * most).all():
            near |= ~(size > _NEAR * most)
    if not near.any():
        return ~near
    start = int(np.argmin(np.abs(np.exp(1j * study.turn.phi) - np.exp(1j * study.mech.drive.position))))
    back, on = (until(near, start, way) for way in (-1, 1))
    return np.isin(np.arange(len(near)), np.arange(start - back, start + on + 1) % len(near))


def until(near: NDArray[np.bool_], start: int, way: int) -> int:
    """How many positions may be taken this way from a position before one that is not sound."""
    ahead = np.roll(near[::way], -start if way > 0 else start + 1 - len(near))
    return max(int(np.argmax(ahead)) - 1, 0)


def _most(values: Reals) -> float:
    """The largest of them, leaving out places at which a rate runs away: change points, dead points."""
    with np.errstate(invalid="ignore"):
        sizes = np.abs(values)
    return float(np.max(sizes[np.isfinite(sizes)], initial=0.0))


def _by_quotients(study: Study, base: Reals | None, rate: Reals, size: float) -> tuple[float | None, float | None, str]:
    """How far the rate is from the difference quotients of two steps and of one, and how many times as far."""
    if base is None:
        return None, None, "—"
    wide, narrow = (_quotient_gap(study, base, rate, steps) / size for steps in (2, 1))
    return wide, narrow, f"{wide / narrow:.2f}" if narrow > 1e-9 else "—"


def _percent(share: float) -> str:
    return _power(share) if share < 1e-6 else f"{100 * share:.4f} %"


def _share(part: float | None) -> str:
    """In per cent, without the sign."""
    return "—" if part is None else _percent(part).removesuffix(" %")


def _rates(study: Study) -> Iterator[tuple[str, Reals, Reals, Reals | None]]:
    """Symbol, model, solver, and the model's own antiderivative,
    of ω and α of the links and the parts of v and a of the points."""
    env = study.env
    for link in study.links[-2:] if study.dense else study.links:
        name = study.model_name(link)
        for stem, key, below in (("ω", "omega", f"φ_{{{name}}}"), ("α", "alpha", f"ω_{{{name}}}")):
            symbol = f"{stem}_{{{name}}}"
            if symbol in env:
                base = np.unwrap(np.asarray(env[below])) if below in env and stem == "ω" else env.get(below)
                yield (
                    symbol,
                    np.asarray(env[symbol]),
                    study.turn.real(f"{key}_{link}"),
                    None if base is None else np.asarray(base),
                )
    for letter in study.points:
        for stem, below in (("v", "xy"), ("a", "v")):
            for axis in "xy":
                symbol = f"{stem}_{{{letter}{axis}}}"
                base_symbol = f"{axis}_{{{letter}}}" if below == "xy" else f"v_{{{letter}{axis}}}"
                if symbol in env and np.ndim(env[symbol]):
                    yield (
                        symbol,
                        np.asarray(env[symbol]),
                        study.turn.real(f"{stem}_{letter}.{axis}"),
                        np.asarray(env[base_symbol]) if np.ndim(env.get(base_symbol, 0.0)) else None,
                    )


def _quotient_gap(study: Study, base: Reals, rate: Reals, steps: int) -> float:
    """The largest |central difference quotient − rate| within the range."""
    phi = study.turn.phi
    base, rate = (np.broadcast_to(one, phi.shape) for one in (base, rate))  # of a gear ω may be one number
    inner = np.arange(2, len(phi) - 2)  # the same positions for both steps
    found = (
        (base[inner + steps] - base[inner - steps]) / (phi[inner + steps] - phi[inner - steps]) * study.mech.drive.rate
    )
    return _most(found - rate[inner])
