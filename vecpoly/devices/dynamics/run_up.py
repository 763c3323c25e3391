"""A motor that runs a machine up, and a machine that runs down by itself or is braked.

data: {motor: [240 N*m, 1.5 N*m*s], load: 60 N*m, J: 4.2 kg*m^2, to: 95 %, at: 2 s}
data: {load: [4 N*m, 0.05 N*m*s], brake: 65 N*m, J: 3.6 kg*m^2, start: 600 r/min}
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from typing import Annotated, Any, ClassVar

from pydantic import BeforeValidator, WithJsonSchema, model_validator

from ...errors import FaultError
from ...names import Named
from ...units.reading import Dim, Quantity, positive
from ...words import Words
from ..base import Device, Duration, Inertia, Omega, Tabled, Torque, as_written
from ..defined import sentence
from .characteristic import Load, Measured, Motor, Polynomial, at_rest

STEADY, CONSTANT, START = Named("omega_s", "ω_s", "rad/s"), Named("T", "T", "s"), Named("M_d0", "M_{d0}", "N·m")
TIME, TURNS = Named("t", "t", "s"), Named("N", "N", "r")
TIME_BRAKED, TURNS_BRAKED = Named("t_b", "t_b", "s"), Named("N_b", "N_b", "r")
THEN = Named("omega_t", "ω_t", "rad/s")
USUAL = 0.95  # of the steady speed, where nothing else is said
_SHARE = re.compile(r"\s*([\d.]+)\s*[%％]\s*")


def _goal(value: Any) -> Quantity | float:
    """A share of the steady speed, or a speed."""
    if isinstance(value, Quantity | float):
        return value
    m = _SHARE.fullmatch(str(value))
    if m is None:
        return positive(value, Dim.OMEGA)
    share = float(m[1]) / 100
    if not 0 < share < 1:
        raise FaultError(
            Words(
                f"{value}：应小于 100 %，稳定转速要无穷长时间才能达到",
                f"{value} must be below 100 %: the steady speed is reached after an endless time",
            ),
            code="out-of-range",
        )
    return share


Goal = Annotated[Quantity | float, BeforeValidator(_goal), WithJsonSchema({"type": "string"})]


class RunUp(Device):
    """motor: none of a machine that runs down; to: where it ends, a speed or a share of the steady one; at: a time at
    which the speed is asked for."""

    kind: ClassVar[str] = "run-up"
    motor: Motor | None = None
    load: Load | None = None
    brake: Torque | None = None
    J: Inertia
    start: Omega = Quantity(0.0, "0")
    to: Goal | None = None
    at: Duration | None = None

    @model_validator(mode="after")
    def _moves(self) -> RunUp:
        if self.start.si < 0:
            raise FaultError(Words("start 不得为负", "'start' is not negative"), "start", code="out-of-range")
        return self._runs_down() if self.motor is None else self._starts(self.motor)

    def _starts(self, motor: Motor) -> RunUp:
        load = at_rest(self.load) if self.load is not None else 0.0
        if self.brake is not None:
            raise FaultError(
                Words("brake 用于没有 motor 的停车", "'brake' is for a machine without a motor that runs down"),
                "brake",
                code="contradiction",
            )
        if not self.start.si and at_rest(motor) <= load:
            raise FaultError(
                Words(
                    f"起动力矩 {at_rest(motor):.6g} N·m 不大于静止时的阻力矩 {load:.6g} N·m，机器不能起动；"
                    "请减小载荷或换用起动力矩更大的电动机",
                    f"the starting moment, {at_rest(motor):.6g} N·m, does not exceed that of the load at rest, "
                    f"{load:.6g} N·m: it does not start; take load off, or another motor",
                ),
                code="no-start",
                numbers={"M_start": at_rest(motor), "M_r": load},
                keys=("motor", "load"),
            )
        return self

    def _runs_down(self) -> RunUp:
        """Without a motor it needs a speed to lose, and something that takes it down to rest."""
        if not self.start.si:
            raise FaultError(
                Words(
                    "没有 motor 也没有初速度；如写 start: 600 r/min",
                    "there is neither a motor nor a speed; write e.g. start: 600 r/min",
                ),
                "start",
                code="missing",
            )
        rest = at_rest(self.load) if self.load is not None else 0.0
        if rest <= 0 and not isinstance(self.to, Quantity):
            raise FaultError(
                Words(
                    f"静止附近的阻力矩为 {rest:g} N·m，转速只会趋近于零而不会停住；请给出终了转速，如 to: 1 rad/s",
                    f"near rest {rest:g} N·m resist: the speed tends to zero and it never stands still; say where it "
                    "ends, e.g. to: 1 rad/s",
                ),
                "to",
                code="never-stops",
                numbers={"M_r": rest},
            )
        self._ends_below()
        return self

    def _ends_below(self) -> None:
        if isinstance(self.to, float) or (isinstance(self.to, Quantity) and self.to.si >= self.start.si):
            raise FaultError(
                Words("停车时 to 应为小于 start 的转速", "running down, 'to' is a speed below 'start'"),
                "to",
                code="out-of-range",
            )
        if self.at is not None:
            raise FaultError(Words("at 用于起动", "'at' is for a run-up"), "at", code="contradiction")

    @property
    def end(self) -> float:
        """Of a machine that runs down the last speed (rad/s)."""
        return self.to.si if isinstance(self.to, Quantity) else 0.0

    @property
    def goal(self) -> float | None:
        """The speed at which the run-up ends (rad/s); None where it is a share of the steady one."""
        return self.to.si if isinstance(self.to, Quantity) else None

    @property
    def share(self) -> float:
        """Of the steady speed."""
        return self.to if isinstance(self.to, float) else USUAL

    @property
    def linear(self) -> bool:
        """Whether ΔM is a straight line over the speed."""
        curves = [one for one in (self.motor, self.load) if one is not None]
        sloping = [one for one in curves if isinstance(one, Polynomial) and len(one.terms) > 1]
        return all(isinstance(one, Polynomial) and len(one.terms) < 3 for one in curves) and bool(sloping)

    @property
    def sensed(self) -> bool:
        """Only its speed is known."""
        return False

    def task(self, asked: Collection[str]) -> Words:
        """From which speed to which, driven and resisted by what."""
        drives = Words("电动机以驱动力矩 $M_d$ 带动机器", "a motor with the torque $M_d$ drives a machine")
        coasts = Words("断开动力后机器自行停车", "the power is cut off and a machine runs down")
        stops = Words("机器阻力矩为 $M_r$", "the load resists with $M_r$") if self.load is not None else Words.same("")
        brake = Words("用制动器时另加制动力矩 $M_b$", "a brake adds the moment $M_b$")
        curved = any("ω" in text for _, text in self.given())
        speed = Words("$ω$ 为等效构件的角速度", "$ω$ is the speed of the equivalent link")
        return sentence(
            coasts if self.motor is None else drives,
            stops,
            *([brake] if self.brake is not None else []),
            Words("等效转动惯量为 $J$", "the equivalent moment of inertia is $J$"),
            *([speed] if curved else []),
            *self._from_to(),
        )

    def _from_to(self) -> Iterator[Words]:
        """From which speed to which, and at which time it is asked."""
        first = f"${self._letter(self.start)}_0$" if self.start.si else ""
        start = Words(f"自 {first}", f"from {first}") if first else Words("由静止", "from rest")
        end = Words("停止", "rest")
        if isinstance(self.to, Quantity):
            end = Words.same(f"${self._letter(self.to)}_1$")
        elif self.motor is not None:
            share = f"{100 * self.share:g} %"
            end = Words(f"稳定角速度 $ω_s$ 的 {share}", f"{share} of the steady speed $ω_s$")
            if self.to is not None:
                end = Words("角速度 $ω_1$（$ω_s$ 为稳定角速度）", "the speed $ω_1$, $ω_s$ being the steady one")
        way = Words("减速", "runs down") if self.motor is None else Words("起动", "runs up")
        yield Words(f"{start.zh}{way.zh}到{end.zh}", f"it {way.en} {start.en} to {end.en}")
        if self.at is not None:
            yield Words("$ω_t$ 为时刻 $t_1$ 的角速度", "$ω_t$ is the speed at the time $t_1$")

    @staticmethod
    def _letter(speed: Quantity) -> str:
        """A speed in r/min is n."""
        return "n" if "r/min" in speed.text else "ω"

    def quantities(self) -> tuple[Named, ...]:
        """Steady speed and time constant; time and turns; the speed at a time."""
        if self.motor is None:
            return (TIME, TURNS, TIME_BRAKED, TURNS_BRAKED) if self.brake is not None else (TIME, TURNS)
        found = [START]
        if not isinstance(self.to, Quantity):
            found += [STEADY, CONSTANT] if self.linear else [STEADY]
        return (*found, TIME, TURNS, THEN) if self.at is not None else (*found, TIME, TURNS)

    def tabled(self) -> Mapping[str, Tabled | None]:
        """Characteristics of many places."""
        curves = (("M_d", self.motor), ("M_r", self.load), ("M_b", self.brake))
        return {symbol: one.tabled for symbol, one in curves if isinstance(one, Measured)}

    def given(self) -> tuple[tuple[str, str], ...]:
        """The characteristics, J, and from where to where."""
        goal = self.to if isinstance(self.to, Quantity) else None
        told = as_written(
            (
                ("M_d", self.motor),
                ("M_r", self.load),
                ("M_b", self.brake),
                ("J", self.J),
                ("ω_0", self.start if self.start.si else None),
                ("ω_1", goal),
                ("t_1", self.at),
            )
        )
        return (*told, ("ω_1/ω_s", f"{100 * self.to:g} %")) if isinstance(self.to, float) else told
