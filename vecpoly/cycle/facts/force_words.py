"""What the loads do over a cycle, in words: where they drive and resist,
where friction locks, where it changes its side."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...mechanism.asked.forces import load_symbol
from ...oracle.forces import Cause
from ...oracle.forces.laws.period import constant_size
from ...oracle.forces.laws.returning import turns_of
from ...words import Words
from ..cycle import Cycle
from .duties import Duty, Still, duties, stills, within
from .shown import shown

_CAUSES = {
    Cause.IDLE: Words("平衡载荷不作功", "the balancing load does no work"),
    Cause.SENSELESS: Words(
        "有摩擦的运动副无相对运动，摩擦的方向不定", "a pair with friction does not move, so that friction has no sense"
    ),
    Cause.UNSOLVED: Words("受力无唯一解", "the forces have no single solution"),
    Cause.LOCKED: Words("自锁，驱动载荷不能克服摩擦", "self-locking, the driving loads do not overcome the friction"),
    Cause.BOUND: Words(
        "自锁，平衡载荷无论多大都不能克服摩擦",
        "self-locking, the balancing load, however large, does not overcome the friction",
    ),
    Cause.PARTING: Words("高副接触面将脱开", "a contact would have to pull"),
}


def force_sentences(cycle: Cycle) -> tuple[Words, ...]:
    """Sentences on the loads; () without loads."""
    if cycle.loads is None:
        return ()
    found = duties(cycle)
    return (*_parts(cycle, found), *constant_words(cycle), *_gaps(cycle, found), *_sides(cycle, stills(cycle)))


def constant_words(cycle: Cycle) -> Iterator[Words]:
    """The moment that is constant over the period, where one is sought."""
    one = cycle.loads.constant if cycle.loads is not None else None
    if cycle.loads is None or one is None:
        return
    size, turns = constant_size(cycle.mech, cycle.loads), turns_of(cycle.mech, cycle.loads, cycle.low)
    told = f"{size:.6g}".replace("-", "−")
    over = Words("一周", "one turn") if turns == 1 else Words(f"{turns} 周", f"{turns} turns")
    yield Words(
        f"一个运动周期（{over.zh}）内其余载荷所作的功由常力矩 ${load_symbol(one.name)}$ = {told} N·m 平衡；"
        f"各位置所需的 ${cycle.loads.unknown.name}$ 与它之差由飞轮吸收或放出。",
        f"Over the period ({over.en}) the constant moment ${load_symbol(one.name)}$ = {told} N·m does the work of "
        f"all other loads; what it differs by from ${cycle.loads.unknown.name}$ of each position a flywheel takes, or "
        "gives.",
    )


def _stretch(cycle: Cycle, duty: Duty) -> str:
    return " … ".join(shown(cycle, cycle.drive.key, q, 5) for q in within(cycle, duty))


def _parts(cycle: Cycle, found: Sequence[Duty]) -> Iterator[Words]:
    """Which loads drive, and which resist, and where."""
    told: dict[tuple[tuple[str, ...], tuple[str, ...]], list[str]] = {}
    for duty in found:
        if duty.cause is Cause.NONE and duty.drives and duty.resists:
            told.setdefault((duty.drives, duty.resists), []).append(_stretch(cycle, duty))
    for (drives, resists), places in told.items():
        drive, resist = (tuple(f"${name}$" for name in names) for names in (drives, resists))
        where = (
            f"（${cycle.drive.symbol}$ = {'、'.join(places)}）",
            f" while ${cycle.drive.symbol}$ = {', '.join(places)}",
        )
        yield Words(
            f"{'、'.join(drive)} 驱动，{'、'.join(resist)} 为阻力{where[0]}。",
            f"{', '.join(drive)} {'drives' if len(drive) == 1 else 'drive'} and {', '.join(resist)} "
            f"{'resists' if len(resist) == 1 else 'resist'}{where[1]}.",
        )


def _gaps(cycle: Cycle, found: Sequence[Duty]) -> Iterator[Words]:
    """Where there is no equilibrium, and why."""
    for cause, why in _CAUSES.items():
        places = [_stretch(cycle, duty) for duty in found if duty.cause is cause]
        if places:
            yield Words(
                f"${cycle.drive.symbol}$ = {'、'.join(places)} 范围内无解：{why.zh}；表中这些行空缺。",
                f"There is no equilibrium in motion while ${cycle.drive.symbol}$ = "
                f"{', '.join(places)}: {why.en}. Rows of the table there are empty.",
            )


def _sides(cycle: Cycle, found: Sequence[Still]) -> Iterator[Words]:
    """Where friction changes its side."""
    pairs: dict[tuple[tuple[str, str], str], list[str]] = {}
    for still in found:
        pairs.setdefault((still.who, still.letter), []).append(shown(cycle, cycle.drive.key, still.phi, 5))
    if not pairs:
        return
    names = [
        (
            Words(f"运动副 ${letter}$", f"joint ${letter}$") if letter else Words(f"移动副 {a}—{b}", f"slide {a}–{b}"),
            places,
        )
        for ((a, b), letter), places in pairs.items()
    ]
    zh = "；".join(f"{name.zh}：{'、'.join(places)}" for name, places in names)
    en = "; ".join(f"{name.en}: {', '.join(places)}" for name, places in names)
    yield Words(
        f"相对运动在下列位置改变方向，摩擦随之换侧，反力在此有突变（${cycle.drive.symbol}$）：{zh}。",
        "The relative motion changes its sense, friction its side, and the reactions jump where "
        f"${cycle.drive.symbol}$ is — {en}.",
    )
