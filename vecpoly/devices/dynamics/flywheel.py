"""A machine in steady motion, and the flywheel with which it is as uneven as is allowed.

data: {M_d: [[0 deg, 0 N*m], [30 deg, 420 N*m], [360 deg, 0 N*m]], n: 900 r/min, delta: 0.025}     # M_r: constant
data: {areas: [320, -410, 250, -380, 430, -210], mu_A: 12 J/mm^2, n: 300 r/min, delta: 0.02}
data: {powers: [[120 deg, 368 W], [240 deg, 3677 W]], n: 100 r/min, delta: 0.05}
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from math import degrees
from typing import Annotated, Any, ClassVar, Literal

from pydantic import BeforeValidator, WithJsonSchema, model_validator

from ...errors import FaultError
from ...names import Named
from ...units.reading import Dim, not_negative, positive, pure, read
from ...words import Words
from ..base import Angle, Device, Inertia, Omega, Positive, Tabled, WorkScale, as_written
from . import asked
from .asked import letter, level, place, work
from .curve import Moments
from .given import Areas, Torques, areas, of_powers, torques
from .rim import Rim
from .steady import check_it_goes_on, check_it_has_room, check_it_varies, ties
from .told import flywheel_task

COUNT = 40  # areas, or powers, at most
GRAVITY = 9.81  # m/s²: in GD²


def _areas(value: Any) -> tuple[float, ...]:
    if not isinstance(value, list | tuple) or len(value) > COUNT:
        raise FaultError(
            Words(
                f"应为不多于 {COUNT} 块面积的列表，如 [320, -410, 90]",
                f"a list of at most {COUNT} areas, [320, -410, 90]",
            ),
            code="spelling",
        )
    return tuple(one if isinstance(one, float) else _area(str(one)) for one in value)


def _area(text: str) -> float:
    """mm², with the unit or without."""
    size = read(text, Dim.AREA).si * 1e6 if "m" in text else pure(text, "-410")
    if not size:
        raise FaultError(Words("面积不得为零；请删去该项", "an area is not zero; leave it out"), code="out-of-range")
    return size


def _powers(value: Any) -> tuple[Any, ...]:
    if not isinstance(value, list | tuple) or not 2 <= len(value) <= COUNT:
        raise FaultError(
            Words(
                "应为若干段转角及其功率，如 [[120 deg, 368 W], [240 deg, 3.68 kW]]",
                "angles with their powers, [[120 deg, 368 W], [240 deg, 3.68 kW]]",
            ),
            code="spelling",
        )
    return tuple(_stretch(number, pair) for number, pair in enumerate(value))


def _stretch(number: int, pair: Any) -> Any:
    if not isinstance(pair, list | tuple) or len(pair) != 2:
        raise FaultError(
            Words(
                f"第 {number + 1} 项应为转角和功率，如 [120 deg, 368 W]",
                f"entry {number + 1} must be an angle and a power, e.g. [120 deg, 368 W]",
            ),
            number,
            code="spelling",
        )
    if not isinstance(pair[0], str):
        return tuple(pair)
    return positive(pair[0], Dim.ANGLE), not_negative(pair[1], Dim.POWER)


_LIST = WithJsonSchema({"type": "array"})


class Flywheel(Device):
    """n: mean speed; delta: what is allowed, or J: all that turns, of which delta follows; with delta J is there
    already and the flywheel comes to it. shaft: the speed of another shaft on which the flywheel may sit."""

    kind: ClassVar[str] = "flywheel"
    M_d: Moments | None = None
    M_r: Moments | None = None
    period: Angle | None = None
    areas: Annotated[tuple[float, ...], BeforeValidator(_areas), _LIST] | None = None
    mu_A: WorkScale | None = None
    powers: Annotated[tuple[Any, ...], BeforeValidator(_powers), _LIST] | None = None
    n: Omega
    delta: Positive | None = None
    J: Inertia | None = None
    shaft: Omega | None = None
    rim: Rim | None = None
    measured: Literal["squares", "planimeter"] = "squares"

    @model_validator(mode="after")
    def _is_steady(self) -> Flywheel:
        moments = self.M_d is not None or self.M_r is not None
        if [moments, self.areas is not None, self.powers is not None].count(True) != 1:
            raise FaultError(
                Words(
                    "请给出且只给出一种：力矩 M_d、M_r（或其一），面积 areas，或功率 powers",
                    "give one of these and only one: moments M_d and M_r (or one of them), areas, or powers",
                ),
                code="contradiction",
                keys=("M_d", "M_r", "areas", "powers"),
            )
        if (self.areas is None) != (self.mu_A is None):
            raise FaultError(
                Words("areas 与 mu_A 应一并给出，如 mu_A: 12 J/mm^2", "areas go with their scale, mu_A: 12 J/mm^2"),
                code="missing",
                keys=("areas", "mu_A"),
            )
        if not self.n.si or (self.shaft is not None and not self.shaft.si):
            raise FaultError(Words("转速不得为零", "the speed is not zero"), "n", code="out-of-range")
        if self.delta is None and self.J is None:
            raise FaultError(
                Words(
                    "缺少 delta 或 J：给出许用 δ 求飞轮，或给出转动惯量 J 求 δ",
                    "delta or J is missing: of the allowed delta follows the flywheel, of J the delta",
                ),
                code="missing",
            )
        if self.delta is not None and not 0 < self.delta.si < 1:
            raise FaultError(
                Words(f"δ = {self.delta.text} 应在 0 与 1 之间", f"delta = {self.delta.text} must lie between 0 and 1"),
                "delta",
                code="out-of-range",
            )
        self._refuse_idle()
        self._refuse_impossible(self.load)
        return self

    def _refuse_impossible(self, load: Torques | Areas) -> None:
        """FaultError for a speed that does not vary, a machine that stops, a rim that is none."""
        check_it_varies(load)
        if self.delta is None and self.J is not None:
            check_it_goes_on(load.swing, self.J, self.speed)
        if self.delta is not None and self.rim is not None:
            has = self.J.si if self.J is not None else 0.0
            check_it_has_room(self.rim, load.swing / (self.delta.si * self.speed**2) - has)

    def _refuse_idle(self) -> None:
        """FaultError for a period without areas, and for a rim where no flywheel is sought."""
        if self.period is not None and self.M_d is None and self.M_r is None:
            raise FaultError(
                Words("period 属于 M_d 和 M_r；请删去", "'period' belongs to M_d and M_r; leave it out"),
                "period",
                code="contradiction",
            )
        if self.delta is None and (self.rim is not None or self.shaft is not None):
            raise FaultError(
                Words(
                    "rim 和 shaft 属于所求的飞轮，须给出 delta",
                    "'rim' and 'shaft' belong to a flywheel that is sought: give delta",
                ),
                code="missing",
                keys=("delta", "shaft", "rim"),
            )

    def noted(self, asked: Collection[str]) -> tuple[Words, ...]:
        """Extreme speeds that stand at several places."""
        return ties(self.load, asked) if isinstance(self.load, Torques) else ()

    @property
    def load(self) -> Torques | Areas:
        """What drives, and what is overcome."""
        if self.areas is not None and self.mu_A is not None:
            return areas(self.areas, self.mu_A.si)
        if self.powers is not None:
            return of_powers(self.powers, abs(self.n.si))
        return torques(self.M_d, self.M_r, self.period)

    @property
    def speed(self) -> float:
        """ω_m (rad/s)."""
        return abs(self.n.si)

    @property
    def extremes(self) -> bool:
        """Whether δ follows from J."""
        return self.delta is None

    @property
    def sensed(self) -> bool:
        """Only its speed is known."""
        return False

    def task(self, asked: Collection[str]) -> Words:
        """What drives and what resists over the period, and what of the flywheel is given."""
        return flywheel_task([symbol for symbol, _ in self.given()], asked)

    def quantities(self) -> tuple[Named, ...]:
        """The constant moment, the areas and energies, ΔW_max, the flywheel, or δ; the extreme speeds; the rim."""
        count, load = self.load.count, self.load
        found: list[Named] = []
        if isinstance(load, Torques):
            found += [asked.M_D if load.sought == "d" else asked.M_R] if load.sought else []
            found += [asked.POWER] if load.sought else []
            found += [place(i) for i in range(1, count)]
        found += [work(i) for i in range(1, count + 1)]
        found += [level(i) for i in range(1, count)]
        found.append(asked.DW)
        if isinstance(load, Torques):
            found += [asked.PHI_MAX, asked.PHI_MIN]
        if self.delta is not None:
            found += [asked.J_NEED, asked.J_F, asked.GD2] + [asked.J_SHAFT] * (self.shaft is not None)
        found += [asked.DELTA, asked.OMEGA_MAX, asked.OMEGA_MIN, asked.N_MAX, asked.N_MIN]
        if self.rim is not None:
            found += [asked.RIM_MASS, asked.RIM_H, asked.RIM_B, asked.RIM_SPEED, asked.RIM_J]
            found += [asked.RIM_SAFE] * (self.rim.v_max is not None)
        return tuple(found)

    def tabled(self) -> Mapping[str, Tabled | None]:
        """Moments of many places."""
        return {symbol: one.tabled for symbol, one in (("M_d", self.M_d), ("M_r", self.M_r)) if one is not None}

    def given(self) -> tuple[tuple[str, str], ...]:
        """The load, then speed, unevenness and inertia."""
        told: list[tuple[str, str]] = [*as_written((("M_d", self.M_d), ("M_r", self.M_r)))]
        if self.areas is not None and self.mu_A is not None:
            signed = ", ".join(f"{size:+g}" for size in self.areas)
            told += [("A", f"{signed} mm²".replace("-", "−")), ("μ_A", self.mu_A.text)]
        told += [(f"P_{n}", f"{power.text} ({angle.text})") for n, (angle, power) in enumerate(self.powers or (), 1)]
        if isinstance(self.load, Torques) and self.powers is None:
            told.append(("φ_T", f"{degrees(self.load.period):g}°"))
        rim = self.rim
        return (
            *told,
            *as_written((("n", self.n), ("[δ]", self.delta), ("J", self.J), ("n_2", self.shaft))),
            *(as_written((("D", rim.D), ("b/h", rim.ratio), ("ρ", rim.density), ("[v]", rim.v_max))) if rim else ()),
        )

    def letters(self) -> tuple[str, ...]:
        """The places where the curves meet, from a on."""
        return tuple(letter(i) for i in range(self.load.count))
