"""The mechanism as a machine, as written: ``machine: {n: 60 r/min, delta: 0.05}``, or ``{start: {phi, omega}, until}``.

Where its equivalent inertia, its flywheel or its motion is asked for, no load need be unknown.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from math import pi
from typing import TypeVar

from ...errors import FaultError
from ...foundation.patterns import pattern
from ...mechanism.asked.counterweights import HUNG
from ...mechanism.asked.machine import REDUCED, RUN_KEYS
from ...mechanism.loads import Loads
from ...mechanism.machine import Machine, Run, Started, Steady, known_of
from ...mechanism.model import Mechanism
from ...units.reading import Dim, not_negative, positive, pure, read
from ...words import Words
from ..problem import Datum
from ..schema.faults import Faults
from ..schema.models import ProblemSpec
from ..schema.running import MachineSpec
from .laws.lawful import CONSTANT

MOST_TURNS = 100.0
STEADILY = ("steady", "稳定", "稳定运转")
FORCES = pattern(r"[A-Z]\w*|eta|h(?:_\w+)?")  # how what an equilibrium gives is written
Found = TypeVar("Found")


def reduces(spec: ProblemSpec) -> bool:
    """Whether the file asks for anything of the mechanism as a machine."""
    asked = [*(one for one in spec.find if isinstance(one, str)), *(one.symbol for one in spec.printed)]
    return spec.machine is not None or any(REDUCED.fullmatch(key) or RUN_KEYS.fullmatch(key) for key in asked)


def needs_balance(spec: ProblemSpec) -> bool:
    """Whether the file asks for what an equilibrium gives as well: reactions, a balancing load, an efficiency."""
    constant = {name for name, load in spec.loads.items() if load.size in CONSTANT}
    asked = {one for one in spec.find if isinstance(one, str)} - constant
    others = (REDUCED, RUN_KEYS, HUNG)
    return any(FORCES.fullmatch(key) and not any(other.fullmatch(key) for other in others) for key in asked)


def read_machine(
    spec: ProblemSpec, mech: Mechanism, loads: Loads | None, faults: Faults
) -> tuple[Machine | None, tuple[Datum, ...]]:
    """The machine and its data for 已知; None where nothing is asked of it."""
    if faults.found or not reduces(spec):
        return None, ()
    run: Run | None = None
    told: tuple[Datum, ...] = ()
    with faults.at("find" if spec.machine is None else "machine"):
        _refuse(spec, mech, loads)
    if spec.machine is not None and not faults.found:
        with faults.at("machine"):
            run, told = _run(spec.machine, mech.drive.lead)
    return Machine(loads=known_of(loads or Loads()), run=run), told


def _refuse(spec: ProblemSpec, mech: Mechanism, loads: Loads | None) -> None:
    """Raise FaultError for a machine that has no energy, rubs, or is driven more than once."""
    if len(mech.drives) > 1 or mech.drive.between:
        raise FaultError(
            Words(
                "等效构件只用于单自由度、原动件与机架相连的机构",
                "an equivalent link stands for a mechanism of one degree of freedom that is driven against the frame",
            ),
            code="contradiction",
        )
    if spec.friction:
        raise FaultError(
            Words(
                "等效量按无摩擦计算；请去掉 friction，摩擦可作为阻力（矩）写在 loads 中",
                "equivalents know no friction; leave out 'friction', and write what it takes as a load",
            ),
            code="contradiction",
        )
    if loads is None:
        raise FaultError(
            Words(
                "没有质量也没有载荷，没有可等效的量；请在 masses 或 loads 中给出",
                "neither masses nor loads are given: there is nothing to reduce; write 'masses' or 'loads'",
            ),
            code="missing",
        )


def _run(spec: MachineSpec, lead: float) -> tuple[Run, tuple[Datum, ...]]:
    """lead: by how much the drive's angle is ahead of what is told of it (rad)."""
    beside = [key for key in ("n", "delta") if getattr(spec, key) is not None]
    if spec.start is None and (spec.until is not None or spec.at):
        raise FaultError(
            Words("until 和 at 属于 start", "'until' and 'at' belong to a 'start'"), "until", code="contradiction"
        )
    if spec.start is not None and beside:
        raise FaultError(
            Words(
                f"start 不能与 {'、'.join(beside)} 并用：或求稳定运转，或由初始状态求真实运动",
                f"'start' does not go with {', '.join(beside)}: ask for the steady motion, or for that from a state",
            ),
            "start",
            code="contradiction",
        )
    return _steady(spec) if spec.start is None else _started(spec, lead)


def _steady(spec: MachineSpec) -> tuple[Steady, tuple[Datum, ...]]:
    if spec.n is None:
        raise FaultError(
            Words("缺少平均转速；如写 n: 60 r/min", "the mean speed is missing; write e.g. n: 60 r/min"), code="missing"
        )
    if spec.delta is not None and spec.J_F is not None:
        raise FaultError(
            Words(
                "δ 与 J_F 只给其一：由 δ 求飞轮，或由飞轮求 δ",
                "give delta or J_F: the flywheel follows from delta, or delta from the flywheel",
            ),
            "J_F",
            code="contradiction",
        )
    n = _at("n", partial(positive, spec.n, Dim.OMEGA))
    told = [Datum(symbol="n", si=n.si, text=n.text)]
    delta = flywheel = None
    if spec.delta is not None:
        delta = _at("delta", partial(_share, spec.delta))
        told.append(Datum(symbol="[δ]", si=delta, text=spec.delta))
    if spec.J_F is not None:
        wheel = _at("J_F", lambda: not_negative(spec.J_F, Dim.INERTIA))
        flywheel = wheel.si
        told.append(Datum(symbol="J_F", si=wheel.si, text=wheel.text.replace("*", "·").replace("^2", "²")))
    return Steady(speed=abs(n.si), delta=delta, flywheel=flywheel), tuple(told)


def _started(spec: MachineSpec, lead: float) -> tuple[Started, tuple[Datum, ...]]:
    assert spec.start is not None
    phi = _at("start", lambda: read(spec.start.phi, Dim.ANGLE))  # type: ignore[union-attr]
    omega = _at("start", lambda: read(spec.start.omega, Dim.OMEGA))  # type: ignore[union-attr]
    turned = None if spec.until in STEADILY else _at("until", lambda: _way(spec.until or "360 deg"))
    wheel = 0.0 if spec.J_F is None else _at("J_F", lambda: not_negative(spec.J_F, Dim.INERTIA)).si
    stations = tuple(_at("at", partial(positive, text, Dim.ANGLE)).si for text in spec.at)
    told = (Datum(symbol="φ_0", si=phi.si, text=phi.text), Datum(symbol="ω_0", si=omega.si, text=omega.text))
    return Started(phi=phi.si + lead, omega=omega.si, turned=turned, stations=stations, flywheel=wheel), told


def _way(text: str) -> float:
    way = positive(text, Dim.ANGLE).si
    if way > MOST_TURNS * 2 * pi:
        raise FaultError(
            Words(
                f"until 为 {way / (2 * pi):.4g} 转，最多 {MOST_TURNS:g} 转",
                f"'until' is {way / (2 * pi):.4g} turns; {MOST_TURNS:g} are the most",
            ),
            code="out-of-range",
        )
    return way


def _share(text: str) -> float:
    value = pure(text, "0.05")
    if not 0 < value < 1:
        raise FaultError(
            Words(f"δ = {value:g} 应在 0 与 1 之间", f"delta = {value:g} must lie between 0 and 1"), code="out-of-range"
        )
    return value


def _at(key: str, act: Callable[[], Found]) -> Found:
    try:
        return act()
    except FaultError as fault:
        raise fault.under(key) from None
