"""Positions at which there is no answer: named, with the reason, in an error; or marked, to become NaN."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ...errors import EquilibriumError, LockedError, NoSlipSenseError
from ...words import Words
from ..run import Run
from ..state import Bodies, Reals
from .causes import Cause
from .system import ROUNDING, Balance, System

Flags = NDArray[np.bool_]
BEYOND = 1e11  # times the loads: reactions that only rounding keeps from being infinite
STILL = 1e-9  # of the mechanism's scale of rates: below it nothing moves


@dataclass(frozen=True, slots=True, eq=False)
class Judge:
    """The positions asked for; `causes` collects why some have no answer, where not strict."""

    run: Run
    causes: NDArray[np.int8] = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "causes", np.zeros(self.run.q.shape, np.int8))

    @property
    def lost(self) -> Flags:
        """Positions without an answer."""
        return np.asarray(self.causes != Cause.NONE)

    def bad(self, mask: Flags, cause: Cause | NDArray[np.int_]) -> int | None:
        """The first failing position where strict;
        None where none fails, or where they are only marked, each with its first cause."""
        if not mask.any():
            return None
        if self.run.strict:
            return self.run.first(mask)
        new = mask & ~self.lost
        self.causes[new] = np.broadcast_to(cause, new.shape)[new]
        return None

    def where(self, index: int) -> Words:
        """The drive's position as printed."""
        at = self.run.text(float(self.run.q[index]))
        return Words(f"原动件位于 {at} 时", f"where the drive stands at {at}")

    def idle(self, system: System, rates: Bodies) -> None:
        """EquilibriumError where the balancing load does no work."""
        free = system.free
        pace = _pace(system, rates)
        lever = free.power(rates)
        weak = np.abs(lever) <= STILL * (pace if free.force.any() else pace / system.scale)
        if (at := self.bad(np.broadcast_to(weak, self.run.q.shape), Cause.IDLE)) is not None:
            here, rest = self.where(at), Words(f"构件 {free.link} 不转动", f"link {free.link} does not turn")
            if free.force.any():
                rest = Words(
                    f"其在构件 {free.link} 上的作用点不沿其方向运动",
                    f"its point of link {free.link} does not move in its direction",
                )
            raise EquilibriumError(
                Words(
                    f"{here.zh}，{free.name} 不能平衡其余载荷：{rest.zh}，它不作功；请另选平衡载荷，或另取位置",
                    f"{free.name} cannot balance the other loads {here.en}: {rest.en} here, so it does no work; "
                    "let another load balance, or choose another position",
                )
            )

    def senseless(self, system: System, rates: Bodies, moving: bool) -> None:
        """NoSlipSenseError where a pair with friction has no relative motion."""
        pace = _pace(system, rates)
        for pair in system.pairs:
            if not pair.rubs or pair.rate is None:
                continue
            still = (
                np.abs(pair.rate) <= STILL * (pace / system.scale if pair.turns else pace)
                if moving
                else np.ones(1, bool)
            )
            if (at := self.bad(np.broadcast_to(still, self.run.q.shape), Cause.SENSELESS)) is not None:
                here = self.where(at)
                why = (
                    Words(f"{here.zh}无相对运动", f"there is no relative motion {here.en}")
                    if moving
                    else Words("原动件静止", "the drive stands still")
                )
                raise NoSlipSenseError(
                    pair.text
                    + Words(
                        f"：{why.zh}，构件 {'、'.join(pair.who)} 间的摩擦方向不定；"
                        f"请{'另取位置' if moving else '给出原动件的速度'}，或去掉此处摩擦",
                        f": friction between links {' and '.join(pair.who)} has no sense, for {why.en}; "
                        f"{'choose another position' if moving else 'give the drive a rate'}, or leave out "
                        "this friction",
                    )
                )

    def unsolved(self, system: System, dry: Balance) -> None:
        """EquilibriumError where the equations have no single solution, or one that is made of rounding alone."""
        if (at := self.bad(~np.isfinite(dry.load) | (dry.largest > BEYOND * system.given), Cause.UNSOLVED)) is not None:
            raise EquilibriumError(
                Words(
                    f"{self.where(at).zh}，各反力没有唯一解：有构件受重复约束，或机构处于死点（变点）位置；请另取位置",
                    f"the reactions have no single value {self.where(at).en}: a link is held twice, or the mechanism "
                    "is at a dead point (or change point); choose another position",
                )
            )

    def locked(
        self, system: System, balances: tuple[Balance, Balance], reached: Reals, helps: bool, rates: Bodies
    ) -> None:
        """LockedError where the driving loads cannot move the mechanism against its friction; helps: as of `Loads`."""
        dry, wet = balances
        free, lever = system.free, system.free.power(rates)
        before, after = dry.load * lever, wet.load * lever
        before = np.where(np.abs(before) <= ROUNDING * dry.largest * _pace(system, rates), 0.0, before)
        driven = before < 0
        if (at := self.bad(reached < 1.0, np.where(driven, Cause.LOCKED, Cause.BOUND))) is not None:
            raise LockedError(self._bound(free.name, at, float(reached[at]), bool(driven[at])))
        if not helps and (at := self.bad((before < 0) & (after >= 0), Cause.LOCKED)) is not None:
            powers = ((act.name, act.power(rates)) for act in system.known)
            names = ", ".join(name for name, power in powers if float(np.broadcast_to(power, self.run.q.shape)[at]) > 0)
            raise LockedError(self._consumed(names, free.name, at, float(before[at]), float(after[at])))

    def _bound(self, load: str, at: int, share: float, driven: bool) -> Words:
        """The friction binds at a share of its size; driven: by the other loads, against the balancing one."""
        here = self.where(at)
        needs = (
            Words(
                f"{here.zh}，无论 {load} 为何值，驱动载荷都不能驱动机构",
                f"the driving loads cannot move the mechanism {here.en}, whatever {load}",
            )
            if driven
            else Words(
                f"{here.zh}，{load} 无论多大都不能驱动机构", f"no {load}, however large, moves the mechanism {here.en}"
            )
        )
        return (
            Words("自锁：", "locked: ")
            + needs
            + Words(
                f"；摩擦达到给定值的 {100 * share:.3g} % 时即卡死。请减小摩擦，或另取位置",
                f"; the friction binds at {100 * share:.3g} % of its size. Reduce the friction, or choose "
                "another position",
            )
        )

    def _consumed(self, names: str, load: str, at: int, before: float, after: float) -> Words:
        """The friction takes more than the driving loads give. before, after:
        the balancing load's power (W), without friction and with it."""
        here = self.where(at)
        return Words(
            f"自锁：{here.zh}，{names} 不能驱动机构：无摩擦时 {load} 耗功 "
            f"{-before:.4g} W，而摩擦耗功 {after - before:.4g} W，"
            f"效率将为 {-after / abs(before):.3g}；请减小摩擦，或改由 {load} 驱动",
            f"locked: {names} cannot move the mechanism {here.en}: without friction "
            f"{load} would take {-before:.4g} W, the friction takes "
            f"{after - before:.4g} W, so the efficiency would be "
            f"{-after / abs(before):.3g}. Reduce the friction, or let {load} drive",
        )

    def parting(self, system: System, wet: Balance) -> None:
        """EquilibriumError where a contact would have to pull."""
        largest = np.max([np.abs(size) for units in wet.units for size in units], axis=0)
        for pair, units in zip(system.pairs, wet.units, strict=True):
            if pair.pushes and (at := self.bad(units[0] < -STILL * largest, Cause.PARTING)) is not None:
                raise EquilibriumError(
                    Words(
                        f"{self.where(at).zh}，构件 {'、'.join(pair.who)} 在{pair.text.zh} 处脱开："
                        f"平衡需要该处有 {-float(units[0][at]):.4g} N 的拉力，而接触只能受压；请改变载荷的方向",
                        f"links {' and '.join(pair.who)} part at their {pair.text.en} {self.where(at).en}: "
                        f"equilibrium would need a pull of {-float(units[0][at]):.4g} N there, and a contact "
                        "only presses; change the sense of a load",
                    )
                )


def _pace(system: System, rates: Bodies) -> Reals:
    """The mechanism's scale of rates (m/s): the fastest link's."""
    speeds = [
        np.abs(body.velocity) + np.abs(body.omega) * system.scale
        for name, body in rates.items()
        if name in system.names
    ]
    pace: Reals = np.max(np.broadcast_arrays(*speeds), axis=0)
    return pace
