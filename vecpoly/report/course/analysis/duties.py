"""What drives and what resists round the cycle, and where friction locks: one table, one line a stretch."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ....cycle import Spot
from ....cycle.facts.duties import Cause, Duty, duties, within
from ....findings.shown import shown, span
from ....findings.study.study import Study
from ....mechanism.asked.forces import load_named, load_symbol, without_friction
from ....words import Lang, Words
from ..numbering import SMALL, Press

_HEADER = {"zh": ["驱动", "阻碍", "效率算式"], "en": ["Drives", "Resists", "Efficiency"]}
_EDGE = 1e-9  # rad, or m
_CAUSES = {
    Cause.IDLE: Words("平衡载荷不作功", "the balancing load does no work"),
    Cause.SENSELESS: Words("无相对运动，摩擦力指向不定", "no relative motion: friction has no sense"),
    Cause.UNSOLVED: Words("死点", "dead point"),
    Cause.LOCKED: Words("自锁（驱动力克服不了摩擦）", "self-locking: the input does not overcome friction"),
    Cause.BOUND: Words("自锁（平衡载荷再大也推不动）", "self-locking: no balancing load, however large, drives"),
    Cause.PARTING: Words("高副脱离接触", "the contact parts"),
}


def listed(names: Sequence[str]) -> str:
    """$F$、$M_{1}$."""
    return "、".join(f"${load_symbol(name)}$" for name in names)


def stretch(study: Study, duty: Duty) -> str:
    """174.3°～357.2°; over the end of the turn 357.2°～4.8°, every position as all tables name it."""
    low, high = (study.place(q) for q in within(study.whole, duty))
    if study.whole.period and low == study.place(study.whole.period):  # where the turn ends, the next begins
        low = study.place(0.0)
    unit = study.whole.drive.shown_unit
    return f"{low}～{high}" if unit == "°" else f"{low.removesuffix(f' {unit}')}～{high}"


def ranges(study: Study, found: Sequence[Duty]) -> Words:
    """Several stretches, those that lie against each other as one."""
    texts = [stretch(study, duty) for duty in merged(found, study.whole.period)]
    return Words("、".join(texts), ", ".join(texts).replace("～", " to "))


def merged(found: Sequence[Duty], turn: float) -> list[Duty]:
    """Stretches that lie against each other as one; turn: 2π where the drive turns right round, else 0."""
    joined: list[Duty] = []
    for one in found:
        if joined and abs(joined[-1].high - one.low) < _EDGE:
            joined[-1] = Duty(joined[-1].low, one.high, one.cause, (), ())
        else:
            joined.append(one)
    if turn and len(joined) > 1 and abs(joined[0].low + turn - joined[-1].high) < _EDGE:
        joined[0] = Duty(joined.pop().low - turn, joined[0].high, joined[0].cause, (), ())
    return joined


def reason(duty: Duty) -> Words:
    """Why there is no equilibrium, in two words."""
    return _CAUSES[duty.cause]


def two_loads(study: Study) -> bool:
    """Whether there are only the balancing load and one other, so that η is the quotient of balancing loads."""
    loads = study.problem.loads
    return loads is not None and len(loads.all) == 2 and not loads.dynamic and not (loads.weight and loads.masses)


def quotient(study: Study, duty: Duty) -> str:
    """The quotient by which η is computed there."""
    loads = study.problem.loads
    assert loads is not None
    free = load_named(loads.unknown)
    zero = without_friction(free).symbol
    return f"${zero}/{free.symbol}$" if loads.unknown.name in duty.drives else f"${free.symbol}/{zero}$"


def best(study: Study, key: str, duty: Duty) -> Spot | None:
    """The greatest magnitude of a column in a stretch; ±∞ where it runs away."""
    found, turn = study.extremes(key), study.whole.period
    spots = [
        s
        for s in (*found.maxima, *found.minima, found.highest, found.lowest)
        if s is not None and duty.holds(s.phi, turn, 1e-9)
    ]
    phi, values = study.turn.phi, study.turn.real(key)
    if duty.high - duty.low > 4 * _EDGE:
        edges = np.array([duty.low + _EDGE, duty.high - _EDGE])
        spots += [
            Spot(float(q), float(v) * (1 - 1e-12), True)
            for q, v in zip(edges, np.abs(study.whole.at(key, edges)), strict=True)
            if np.isfinite(v)
        ]
    inside = [i for i in range(len(phi)) if np.isfinite(values[i]) and duty.holds(float(phi[i]), turn)]
    spots += [Spot(float(phi[i]), float(values[i]) * (1 - 1e-12)) for i in inside]
    return max(spots, key=lambda s: abs(s.value), default=None)


def rows(study: Study) -> Iterator[tuple[Duty, tuple[Spot | None, ...]]]:
    """Every stretch with the greatest magnitudes of the balancing load and of η."""
    keys = told(study)
    for duty in duties(study.whole):
        yield duty, tuple(None if duty.cause else best(study, key, duty) for key in keys)


def told(study: Study) -> list[str]:
    """The columns whose maximum values are told stretch by stretch."""
    loads = study.problem.loads
    assert loads is not None
    return [loads.unknown.name, *(["eta"] if loads.friction and study.varies("eta") else [])]


def table(study: Study, press: Press) -> str:
    """The stretches; nothing where every load plays one part throughout."""
    if study.problem.loads is None or len(duties(study.whole)) < 2:
        return ""
    keys, made = told(study), list(rows(study))
    quotients = "eta" in keys and two_loads(study)  # else η is P_out/P_in throughout, as its formula says
    header = [f"${study.whole.drive.symbol}$", *_HEADER[press.lang][: 3 if quotients else 2]]
    symbols = [f"$|{study.whole.info(key).symbol}|$" if key != "eta" else "$η$" for key in keys]
    header += [f"{symbol} 最大" if press.lang == "zh" else f"Maximum {symbol}" for symbol in symbols]
    lines = [
        (ranges(study, [duty]).of(press.lang), *_line(study, duty, spots, press.lang, quotients))
        for duty, spots in made
    ]
    return press.table(
        Words(f"各载荷在{span(study).zh}内的作用", f"The parts of the loads over the {span(study).en}"),
        header,
        lines,
        "l" + "c" * (len(header) - 1),
        style=SMALL,
    )


def _line(study: Study, duty: Duty, spots: tuple[Spot | None, ...], lang: Lang, quotients: bool) -> tuple[str, ...]:
    if duty.cause:
        return (reason(duty).of(lang), *(["—"] * (1 + quotients + len(spots))))
    none = Words("惯性力", "inertia forces").of(lang) if study.problem.loads and study.problem.loads.dynamic else "—"
    names = [listed(duty.drives) or none, listed(duty.resists) or none]
    names = names if lang == "zh" else [name.replace("、", ", ") for name in names]
    cells = [
        _most(shown(study, key, abs(spot.value)), _at(study, spot, lang)) if spot else "—"
        for key, spot in zip(told(study), spots, strict=True)
    ]
    return (*names, *([quotient(study, duty)] if quotients else []), *cells)


def _most(value: str, at: str) -> str:
    """A greatest value and where it is; zero is so everywhere."""
    return value if value.partition(" ")[0] == "0" else f"{value}{at}"


def _at(study: Study, spot: Spot, lang: Lang) -> str:
    """（285.2°）; a whole angle with its tenth, as its neighbours have."""
    turn, drive = study.whole.period, study.whole.drive
    phi = spot.phi % turn if turn else spot.phi
    where = study.where(phi).split(" = ")[1]
    if drive.shown_unit == "°":
        where = f"{drive.told(phi):.1f}°".replace("-", "−")
    return f"（{where}）" if lang == "zh" else f" ({where})"
