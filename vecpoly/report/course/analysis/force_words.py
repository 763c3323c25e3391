"""The forces over the cycle in words: loads that change their part, gaps and jumps with their reasons."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from ....cycle import Spot
from ....cycle.facts.duties import Cause, Still, duties, stills
from ....cycle.facts.force_words import constant_words
from ....findings.shown import shown, span
from ....findings.study.reactions import are_alike, reactions
from ....findings.study.study import Study
from ....mechanism.asked.forces import load_symbol
from ....mechanism.loads import Load, Loads
from ....words import Words
from .duties import listed, ranges, reason, two_loads

_BESIDE = (1e-7, 1e-6, 1e-5, 1e-4, 1e-3)  # rad, or m: to either side of a jump, the first at which there is equilibrium
_JUMP = 1e-3  # of the value: a smaller change is none
_ROLES = {"driving": Words("驱动", "driving"), "resisting": Words("阻碍", "resisting")}


def joined(parts: Iterable[Words]) -> Words:
    """Sentences one after the other."""
    found = tuple(parts)
    return Words("".join(w.zh for w in found), " ".join(w.en.strip() for w in found))


def results(study: Study) -> Words:
    """What stands before the tables of the reactions."""
    loads = study.problem.loads
    if loads is None:
        return Words.same("")
    return joined(
        [*_steady(study, loads), *constant_words(study.whole), *roles(study, loads), *_missing(study), *_equal(study)]
    )


def _steady(study: Study, loads: Loads) -> Iterator[Words]:
    given = [load.name for load in loads.all if load.size is not None and load.law is None]
    if given:
        yield Words(
            f"计算中 {listed(given)} 的大小和方向在{span(study).zh}内不变。",
            f"The load{'s' * (len(given) > 1)} {listed(given).replace('、', ', ')} "
            f"{'keeps' if len(given) == 1 else 'keep'} size and direction throughout the {span(study).en}.",
        )


def roles(study: Study, loads: Loads) -> Iterator[Words]:
    """Where a load that is called driving resists, and the other way round."""
    for load in loads.all:
        if (
            other := [
                d for d in duties(study.whole) if load.name in (d.resists if load.role == "driving" else d.drives)
            ]
        ) and load.role:
            where = ranges(study, other)
            symbol, kind = f"${load_symbol(load.name)}$", _other(load)
            yield Words(
                f"题中称 {symbol} 为{_ROLES[load.role].zh}载荷，但在 ${study.whole.drive.symbol}$ = {where.zh} "
                f"内 {symbol} 作{'负' if load.role == 'driving' else '正'}功，实为{kind.zh}。",
                f"The load {symbol} is called {_ROLES[load.role].en}, but at ${study.whole.drive.symbol}$ = "
                f"{where.en} its power is {'negative' if load.role == 'driving' else 'positive'}: "
                f"there it is {kind.en}.",
            )
    free = loads.unknown
    if (
        two_loads(study)
        and loads.friction
        and len({free.name in d.drives for d in duties(study.whole) if not d.cause}) > 1
    ):
        symbol = load_symbol(free.name)
        stem, _, sub = symbol.partition("_")
        zero = f"{stem}_{{{sub.strip('{}')}0}}"
        yield Words(
            f"因此 ${symbol}$ 为阻力的区段 $η$ = ${symbol}/{zero}$，为驱动力的区段 $η$ = ${zero}/{symbol}$。",
            f"So $η$ = ${symbol}/{zero}$ where ${symbol}$ resists, and ${zero}/{symbol}$ where it drives.",
        )


def _other(load: Load) -> Words:
    return Words("阻力", "resisting") if load.role == "driving" else Words("驱动力", "driving")


def _missing(study: Study) -> Iterator[Words]:
    """Why there are dashes in the table."""
    symbol, told = study.whole.drive.symbol, list[Words]()
    for cause in Cause:
        gaps = [duty for duty in duties(study.whole) if duty.cause is cause]
        if cause and gaps:
            where, why = ranges(study, gaps), reason(gaps[0])
            told.append(Words(f"${symbol}$ = {where.zh}：{why.zh}", f"at ${symbol}$ = {where.en} ({why.en})"))
    for still in each_still(study):
        told.append(
            Words(
                f"{still[1]}：{_no_slip(still[0]).zh}，摩擦力的指向不定",
                f"at {still[1].replace('、', ', ')} ({_no_slip(still[0]).en}, so friction has no sense)",
            )
        )
    if told:
        yield Words(
            "表中“—”和曲线的间断处没有确定的平衡解，原因是：" + "；".join(w.zh for w in told) + "。",
            "Where the table has a dash and a curve is broken there is no definite equilibrium: "
            + "; ".join(w.en for w in told)
            + ".",
        )


def each_still(study: Study) -> Iterator[tuple[Still, str]]:
    """The pairs whose relative motion changes its sense, each with all its positions as text: $φ_1$ =
    90°、270°."""
    found = stills(study.whole)
    for who in dict.fromkeys((s.who, s.turns) for s in found):
        own = [s for s in found if (s.who, s.turns) == who]
        yield (own[0], f"${study.whole.drive.symbol}$ = " + "、".join(study.place(s.phi) for s in own))


def _no_slip(still: Still) -> Words:
    """ω_{23} = 0 at C."""
    symbol = f"{'ω' if still.turns else 'v'}_{{{still.who[0]}{still.who[1]}}}"
    at = Words(f"${still.letter}$ 处 ", f" at ${still.letter}$") if still.letter else Words.same("")
    return Words(f"{at.zh}${symbol}$ = 0", f"${symbol}$ = 0{at.en}")


def _equal(study: Study) -> Iterator[Words]:
    """Reactions asked for, or all where none is, that are not tabled because another has the same size everywhere."""
    asked = [ask.rel.key for ask in study.given.problem.asks if ask.rel.key.startswith("R_")]
    twins: dict[str, list[str]] = {}
    for key in (k for k in asked or reactions(study.whole) if k not in study.forces):
        twin = next((other for other in study.forces if are_alike(study.turn, key, other)), None)
        if twin is not None:
            twins.setdefault(twin, []).append(key)
    for twin, keys in twins.items():
        names, one = [f"${study.whole.info(k).symbol}$" for k in keys], f"${study.whole.info(twin).symbol}$"
        yield Words(
            f"{'、'.join(names)} 与 {one} 处处等值，不另列出。",
            f"The reaction{'s' * (len(names) > 1)} {' and '.join(names)} {'is' if len(names) == 1 else 'are'} "
            f"everywhere as large as {one} and not listed apart.",
        )


def jumps(study: Study) -> Iterator[Words]:
    """How far the reactions and the balancing load jump where friction changes its side."""
    keys = [key for key in study.forces if key != "eta"]
    for still, where in each_still(study):
        own = [s.phi for s in stills(study.whole) if (s.who, s.turns) == (still.who, still.turns)]
        changes = [text for key in keys for text in _jumped(study, key, own)]
        side = (
            Words("反力换到摩擦圆的另一侧与之相切", "the reaction passes to the other side of the friction circle")
            if still.turns
            else Words("反力偏到法线的另一侧", "the reaction is inclined to the other side of the normal")
        )
        zh, en = "；".join(changes), "; ".join(changes).replace("、", ", ")
        yield Words(
            f"{where} 处 {_no_slip(still).zh}，其两侧相对运动反向，{side.zh}，各力随之突变"
            + (f"（左、右极限：{zh}）。" if zh else "。"),
            f"At {where.replace('、', ', ')} {_no_slip(still).en}; the relative motion changes its "
            f"sense, {side.en}, and the forces jump" + (f" (limits from the left and the right: {en})." if en else "."),
        )


def _jumped(study: Study, key: str, places: list[float]) -> Iterator[str]:
    """$|R_{43}|$ 400.6 N → 425.9 N、320.1 N → 357.2 N."""
    info, told = study.whole.info(key), list[str]()
    for phi in places:
        near = np.array([phi + sign * step for step in _BESIDE for sign in (-1, 1)])
        sides = np.asarray(study.whole.at(f"{key}.abs" if info.is_vector else key, near), np.float64).reshape(-1, 2)
        left, right = next((pair for pair in sides if np.isfinite(pair).all()), sides[-1])
        if np.isfinite(left + right) and abs(right - left) > _JUMP * abs(left):
            told.append(f"{shown(study, key, float(left))} → {shown(study, key, float(right))}")
    if told:
        yield (f"$|{info.symbol}|$ " if info.is_vector else f"${info.symbol}$ ") + "、".join(told)


def is_limit(study: Study, key: str, spot: Spot) -> bool:
    """Whether the extreme value of a force is a limit, at the end of a stretch with equilibrium or at a jump."""
    return key in study.forces and spot.end and bool(study.problem.loads and study.problem.loads.friction)


def one_sided(study: Study) -> Words:
    """What the star in the table of extreme values means; nothing where there is none."""
    extremes = ((key, study.extremes(key)) for key in study.forces)
    if not any(
        is_limit(study, key, spot)
        for key, found in extremes
        for spot in (found.highest, found.lowest)
        if spot is not None
    ):
        return Words.same("")
    return Words(
        "带 * 的极值是单侧极限：该处为自锁区的边界，或摩擦力换向、曲线突变。",
        " An asterisk marks a limit from one side: there self-locking begins, or friction changes "
        "its sense and the curve jumps.",
    )


def role_note(study: Study, phi: float) -> Words:
    """For a sheet which loads drive and which resist, where the parts are not those that the problem tells; nothing
    else."""
    loads = study.problem.loads
    if loads is None:
        return Words.same("")
    turn = study.whole.period
    here = next((d for d in duties(study.whole) if not d.cause and d.holds(phi, turn)), None)
    if here is None or not any(
        (load.role == "driving" and load.name in here.resists)
        or (load.role == "resisting" and load.name in here.drives)
        for load in loads.all
    ):
        return Words.same("")
    return Words(
        f"{listed(here.drives)} 为驱动力（矩），{listed(here.resists)} 为阻力（矩）",
        f"{listed(here.drives).replace('、', ', ')} drives, {listed(here.resists).replace('、', ', ')} resists",
    )


def refusals(study: Study, refused: tuple[tuple[float, Words], ...]) -> Words:
    """Positions that cannot be drawn, each with what was refused there, by reason: 0°、165°（自锁……）; 90°（……）."""
    turn, groups = study.whole.period, dict[Words, list[str]]()
    for phi, other in refused:
        gap = next((d for d in duties(study.whole) if d.cause and d.holds(phi, turn, 1e-6)), None)
        still = next((s for s in stills(study.whole) if abs(s.phi - phi) < 1e-6), None)
        why = (
            reason(gap)
            if gap
            else _no_slip(still) + Words("，摩擦力指向不定", ": friction has no sense")
            if still
            else other
        )
        groups.setdefault(why, []).append(study.where(phi).split(" = ")[1])
    return Words(
        "；".join(f"{'、'.join(at)}（{why.zh}）" for why, at in groups.items()),
        "; ".join(f"{', '.join(at)} ({why.en})" for why, at in groups.items()),
    )
