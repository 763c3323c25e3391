"""What a report calls itself where nobody says: by what its problems are about."""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum

from ..designs.base import Design
from ..mechanism.model import Mechanism
from ..problem.problem import Problem
from ..solution import YES_NO, Solution
from ..words import Words
from .values import is_efficiency


class Kind(Enum):
    """What a problem is about."""

    KINEMATICS = Words("平面机构运动分析图解作业", "Graphical kinematics of planar mechanisms")
    TRANSMISSION = Words("机构压力角与传动角图解作业", "Graphical determination of pressure and transmission angles")
    FORCES = Words("平面机构力分析图解作业", "Graphical force analysis of planar mechanisms")
    STRUCTURE = Words("平面机构结构分析作业", "Structure of planar mechanisms")
    SYNTHESIS = Words("平面连杆机构综合图解作业", "Graphical synthesis of planar linkages")
    CAMS = Words("凸轮机构设计作业", "Design of cam mechanisms")
    GEARS = Words("齿轮机构与轮系作业", "Gears and gear trains")
    MOTION = Words("机械的运转及其速度波动作业", "Machine dynamics: motion and speed fluctuation")
    BALANCE = Words("转子与机械的平衡作业", "Balance of rotors and machines")
    EFFICIENCY = Words("机械的效率和自锁作业", "Efficiency and self-locking of machines")


PRESSURE = frozenset({"alpha", "gamma"})  # keys of the pressure angle and the transmission angle
_OF_DEVICE = {
    "structure": Kind.STRUCTURE,
    "cam": Kind.CAMS,
    "epicyclic": Kind.GEARS,
    "gear-generation": Kind.GEARS,
    "flywheel": Kind.MOTION,
    "reduced-train": Kind.MOTION,
    "run-up": Kind.MOTION,
    "rotor": Kind.BALANCE,
    "field-balancing": Kind.BALANCE,
    "in-line-engine": Kind.BALANCE,
    "shaking-force": Kind.BALANCE,
}
_FORCES_AND_EFFICIENCY = Words("机构力分析、效率和自锁作业", "Forces, efficiency and self-locking of mechanisms")
_MIXED = Words("机械原理图解作业", "Graphical exercises in the theory of machines")


def subject(solutions: Sequence[Solution]) -> Words:
    """The title that covers all these problems."""
    found = {kind_of(solution.problem) for solution in solutions}
    if len(found) > 1:
        return _MIXED if found - {Kind.FORCES, Kind.EFFICIENCY} else _FORCES_AND_EFFICIENCY
    words: Words = found.pop().value
    return words


def kind_of(problem: Problem) -> Kind:
    """Kinematics, pressure and transmission angles, forces, structure, cams, gears, motion of machines, balance, or
    efficiency and self-locking."""
    if isinstance(problem.subject, Mechanism):
        if problem.counterweights is not None and problem.loads is None:
            return Kind.BALANCE
        if problem.machine is not None and problem.loads is None:
            return Kind.MOTION
        if problem.loads is not None:
            return Kind.FORCES
        angles = problem.asks and all(ask.rel.key in PRESSURE for ask in problem.asks)
        return Kind.TRANSMISSION if angles else Kind.KINEMATICS
    if isinstance(problem.subject, Design):
        return Kind.SYNTHESIS
    if (kind := _OF_DEVICE.get(problem.subject.kind)) is not None:
        return kind
    efficiency = any(is_efficiency(ask.rel.key, ask.rel.unit) or ask.rel.unit == YES_NO for ask in problem.asks)
    return Kind.EFFICIENCY if efficiency else Kind.FORCES
