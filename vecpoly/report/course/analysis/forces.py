"""Chapters 8 and 9, the forces: jumps, self-locking, dead points and transmission of the load that drives;
the greatest values."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

from ....cycle.facts.duties import Cause, Duty, duties, idle
from ....findings.load_drive import Driven, driven
from ....findings.shown import shown, span
from ....findings.study.study import Study
from ....mechanism.asked.forces import load_symbol
from ....mechanism.loads import Loads
from ....words import Words
from .duties import best, listed, merged, ranges, told
from .force_words import jumps

_FEW = 4  # stretches that are told one by one
_LOCKS = (Cause.LOCKED, Cause.BOUND)


def forces(study: Study) -> Iterator[Words]:
    """The list of the section; nothing without loads."""
    loads = study.problem.loads
    if loads is None:
        return
    if loads.friction and any(d.cause in _LOCKS for d in duties(study.whole)):
        yield _locked(study, loads)
    yield from jumps(study)
    if (found := driven(study)) is not None:
        yield _driven(study, found)


def _locked(study: Study, loads: Loads) -> Words:
    """The self-locking stretches, how much of the cycle they are, and beside which dead points they lie."""
    locks = [d for d in duties(study.whole) if d.cause in _LOCKS]
    symbol, turn = study.whole.drive.symbol, study.whole.period
    where, share = ranges(study, locks), 100 * sum(d.high - d.low for d in locks) / (study.whole.high - study.whole.low)
    spots = [(load.name, phi) for load in loads.all for phi in idle(study.whole, load.name)]
    beside = [(name, phi) for name, phi in spots if any(d.holds(phi, turn, 1e-6) for d in locks)]
    zh = f"自锁区段：${symbol}$ = {where.zh}，共占运动范围的 {share:.1f} %。"
    en = f"The mechanism is self-locking at ${symbol}$ = {where.en}, {share:.1f} % of its range. "
    if all(any(d.holds(phi, turn, 1e-6) for _, phi in beside) for d in merged(locks, turn)):
        names = listed(list(dict.fromkeys(name for name, _ in beside)))
        places = "、".join(_angle(study, phi) for phi in sorted({round(phi, 9) for _, phi in beside}))
        zh += (
            f"这些区段都紧邻 {names} 的功率为零的位置（{places}）：在其附近有效功率趋于零，"
            "而反力及其摩擦功率并不减小，故驱动力克服不了摩擦。"
        )
        en += (
            f"All of it lies beside the positions where the power of {names.replace('、', ', ')} vanishes "
            f"({places.replace('、', ', ')}): near these the useful power goes to zero while the reactions, and "
            "the power lost in friction, do not."
        )
    return Words(zh, en)


def _angle(study: Study, phi: float) -> str:
    return study.place(phi)


def _driven(study: Study, found: Driven) -> Words:
    """The link that drives the forces is not the one whose position is the variable:
    its own dead points and transmission angle."""
    link, names = found.link, listed(found.names)
    dead = "、".join(_angle(study, phi) for phi in found.dead)
    drive = study.mech.drive.link
    zh = (
        f"位置和速度分析以构件 {drive} 的转角为自变量；就受力而言，题设位置由作用在构件 {link} 上的 {names} "
        f"驱动，构件 {link} 主动、构件 {drive} 从动。"
    )
    en = (
        f"Position and velocity are functions of the position of link {drive}; but at the given position "
        f"{names} on link {link} drives, link {link} is the driver and link {drive} is driven. "
    )
    if found.dead:
        zh += f"{names} 的功率为零的位置 ${study.whole.drive.symbol}$ = {dead} 是机构的死点，须靠惯性（飞轮）通过。"
        en += (
            f"Where the power of {names} vanishes, ${study.whole.drive.symbol}$ = {dead.replace('、', ', ')}, "
            "are the dead points, which only inertia (a flywheel) carries it through. "
        )
    if found.gamma is not None:
        low, high = degrees(found.gamma[0]), degrees(found.gamma[1])
        poor = ranges(study, [Duty(a, b, Cause.NONE, (), ()) for a, b in found.poor])
        zh += (
            f"此时传力的好坏应看构件 {found.pair[0]} 与构件 {found.pair[1]} 之间的传动角 "
            f"$γ_{{{''.join(found.pair)}}}$，它在 {low:.1f}°～{high:.1f}° 之间变化"
            + (f"，在 {poor.zh} 内小于 40°。" if found.poor else "。")
        )
        en += (
            f"The transmission angle that matters is then $γ_{{{''.join(found.pair)}}}$, between links "
            f"{found.pair[0]} and {found.pair[1]}: it varies between {low:.1f}° and {high:.1f}°"
            + (f" and is below 40° at {poor.en}." if found.poor else ".")
        )
    return Words(zh, en)


def conclusion(study: Study) -> Iterator[Words]:
    """The greatest values stretch by stretch, and where it locks."""
    loads = study.problem.loads
    if loads is None:
        return
    free = [d for d in duties(study.whole) if not d.cause]
    if free and not any((*d.drives, *d.resists) for d in free):
        yield _idle(study, loads)
        return
    parts = [_part(study, loads, d) for d in free]
    if len(parts) > _FEW:
        parts = [_overall(study, key) for key in told(study)]
    if parts:
        yield Words(
            f"{span(study).zh}内：{'；'.join(w.zh for w in parts)}。",
            f"Over the {span(study).en}: {'; '.join(w.en for w in parts)}.",
        )
    if locks := [d for d in duties(study.whole) if d.cause in _LOCKS]:
        where, symbol = ranges(study, locks), study.whole.drive.symbol
        yield Words(
            f"${symbol}$ = {where.zh} 为自锁区，机构不能在其中起动，只能靠惯性通过。",
            f"At ${symbol}$ = {where.en} the mechanism is self-locking: it cannot start there and passes only "
            "by its inertia.",
        )


def _idle(study: Study, loads: Loads) -> Words:
    """Of loads that do no work: the one that balances is nothing."""
    symbol = f"${load_symbol(loads.unknown.name)}$"
    return Words(
        f"{span(study).zh}内已知载荷都不作功，故各位置均有 {symbol} = 0。",
        f"The given loads do no work in any position of the {span(study).en}, so {symbol} = 0 throughout.",
    )


def _overall(study: Study, key: str) -> Words:
    """The greatest and the least value of a column; the one value of what does not change."""
    found, symbol = study.extremes(key), study.whole.info(key).symbol
    assert found.highest is not None and found.lowest is not None
    if not study.varies(key):
        value = shown(study, key, found.highest.value)
        return Words(f"各位置均有 ${symbol}$ = {value}", f"${symbol}$ is {value} in every position")
    (low, a), (high, b) = ((shown(study, key, s.value), study.where(s.phi)) for s in (found.lowest, found.highest))
    return Words(
        f"${symbol}$ 在 {low}（{a}）至 {high}（{b}）之间", f"${symbol}$ lies between {low} ({a}) and {high} ({b})"
    )


def _part(study: Study, loads: Loads, duty: Duty) -> Words:
    """φ_1 = 4.75°～162.60° F drives against M, |M| ≤ 70.07 N·m (70.4°), η ≤ 0.8077 (77.1°)."""
    dynamic = loads.dynamic
    drives, resists = listed(duty.drives), listed(duty.resists)
    some = drives.replace("、", " and ") or "inertia"
    who = Words(
        (f"{drives} 驱动" if drives else "惯性力驱动" if dynamic else "驱动")
        + (f"、{resists} 为阻力（矩）" if resists else ""),
        f"{some} {'drive' if ' and ' in some else 'drives'}"
        + (f" against {resists.replace('、', ' and ')}" if resists else ""),
    )
    values = []
    for key in told(study):
        spot = best(study, key, duty)
        if spot is not None:
            symbol, turn = study.whole.info(key).symbol, study.whole.period
            at = study.where(spot.phi % turn if turn else spot.phi).split(" = ")[1]
            at = at if study.varies(key) else ""
            values.append((f"$|{symbol}|$" if key != "eta" else f"${symbol}$", shown(study, key, abs(spot.value)), at))
    zh = "，".join(f"{s} " + _most(v, at).zh for s, v, at in values)
    en = ", ".join(f"{s} " + _most(v, at).en for s, v, at in values)
    where, symbol = ranges(study, [duty]), study.whole.drive.symbol
    return Words(
        f"${symbol}$ = {where.zh} 时{'' if who.zh[0] != '$' else ' '}{who.zh}，{zh}",
        f"at ${symbol}$ = {where.en} {who.en}, {en}",
    )


def _most(value: str, at: str) -> Words:
    """The greatest value of a stretch, and where; without a place what is the same in every position."""
    if not at:
        return Words(f"恒为 {value}", f"is {value} throughout")
    if value.partition(" ")[0] == "0":
        return Words("= 0", "= 0")
    if value == "∞":
        return Words(f"趋于 ∞（{at}）", f"grows beyond all bounds ({at})")
    return Words(f"最大 {value}（{at}）", f"up to {value} ({at})")
