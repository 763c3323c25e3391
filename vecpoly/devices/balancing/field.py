"""A rotor balanced where it runs, by trial weights: with phases by the influence coefficient, without by arcs.

data: {initial: 8.6 um at 63 deg, correct: {r: 120 mm},
       trials: [{m: 10 g, r: 120 mm, at: 0 deg, reading: 5.9 um at 123 deg}]}
"""

from __future__ import annotations

from collections.abc import Collection
from math import degrees, tau
from typing import ClassVar, Literal

from pydantic import model_validator

from ...errors import FaultError
from ...names import Named
from ...words import Words
from ..base import Angle, Device, Length
from .several import of_solution
from .vibration import Reading, Vibration
from .written import Entry, MassSize

MOST = 3  # trial runs
UNCLEAR = 2.0  # last digits of a reading: an effect so small may be none


class Trial(Entry):
    """A trial weight at a radius and an angle, and the vibration with it."""

    m: MassSize
    r: Length
    at: Angle
    reading: Reading


class FieldCorrection(Entry):
    """At which radius the correction sits, and whether the trial weight stays on the rotor."""

    r: Length
    trial: Literal["removed", "left"] = "removed"


class FieldBalancing(Device):
    """The vibration before, with one trial weight (phases), or with two or three at different angles (no phases)."""

    kind: ClassVar[str] = "field-balancing"
    initial: Reading
    trials: tuple[Trial, ...]
    correct: FieldCorrection

    @model_validator(mode="after")
    def _possible(self) -> FieldBalancing:
        shown = [self.initial, *(trial.reading for trial in self.trials)]
        self._of_one_kind(shown)
        if self.phased:
            self._one_trial()
        else:
            self._several()
        return self

    def _of_one_kind(self, shown: list[Vibration]) -> None:
        """FaultError where readings differ in kind: in units, or some with a phase and some without."""
        if len({one.unit for one in shown}) > 1:
            raise FaultError(
                Words(
                    f"各次读数的单位不同类：{'、'.join(one.text for one in shown)}；应全为位移或全为速度",
                    f"the readings are of different kinds, {', '.join(one.text for one in shown)}: write displacements "
                    "only, or velocities only",
                ),
                code="wrong-unit",
                keys=("initial", "trials"),
            )
        if len({one.phase is None for one in shown}) > 1:
            raise FaultError(
                Words(
                    f"有的读数有相位，有的没有：{'、'.join(one.text for one in shown)}；请全写或全不写",
                    f"some readings have a phase and some have none, {', '.join(one.text for one in shown)}: write all "
                    "phases, or none",
                ),
                code="contradiction",
                keys=("initial", "trials"),
            )

    def _one_trial(self) -> None:
        if len(self.trials) != 1:
            raise FaultError(
                Words(
                    f"有相位时一次试重即可，这里有 {len(self.trials)} 次；请只留一次，或去掉相位用三圆法",
                    f"with phases one trial run is enough, here are {len(self.trials)}: keep one, or leave out the "
                    "phases and use the four-run method",
                ),
                code="contradiction",
                numbers={"trials": len(self.trials)},
                keys=("trials",),
            )

    def _several(self) -> None:
        if not 2 <= len(self.trials) <= MOST:
            raise FaultError(
                Words(
                    f"无相位时须两次（两个解）或三次试重，这里有 {len(self.trials)} 次",
                    f"without phases two trial runs (two answers) or three are needed, here are {len(self.trials)}",
                ),
                code="missing",
                numbers={"trials": len(self.trials)},
                keys=("trials",),
            )
        if len({(trial.m.si, trial.r.si) for trial in self.trials}) > 1:
            raise FaultError(
                Words(
                    "三圆法要求每次试重的质量和半径相同，只改变方位",
                    "the four-run method needs the same trial weight at the same radius in every run, at different "
                    "angles",
                ),
                code="contradiction",
                keys=("trials",),
            )
        turns = sorted(degrees(trial.at.si % tau) for trial in self.trials)
        if min((b - a) % 360.0 for a, b in zip(turns, turns[1:] + turns[:1], strict=True)) < 1.0:
            raise FaultError(
                Words(
                    "两次试重的方位相同（相差不到 1°）", "two trial weights sit at the same angle (less than 1° apart)"
                ),
                code="contradiction",
                keys=("trials",),
            )

    @property
    def phased(self) -> bool:
        """Whether phases were read."""
        return self.initial.phase is not None

    @property
    def unit(self) -> str:
        """μm, or mm/s."""
        return self.initial.unit

    @property
    def unclear(self) -> float:
        """An effect as small as what the last digits of two readings leave open."""
        return UNCLEAR * max(self.initial.step, *(trial.reading.step for trial in self.trials))

    def task(self, asked: Collection[str]) -> Words:
        """What vibrates, with which trial weights."""
        left = self.correct.trial == "left"
        stays = (
            Words("试重保留", "the trial weight stays") if left else Words("取下试重", "the trial weight is taken off")
        )
        if self.phased:
            return Words(
                "转子在工作转速下的振动（幅值和相位）为 $V_0$。在半径 $r_t$、方位 $θ_t$ 处装试重 $m_t$ 后，同转速下振"
                f"动变为 $V_1$。{stays.zh}，校正质量装在半径 $r_b$ 处。",
                "A rotor vibrates with $V_0$ (amplitude and phase) at its working speed; with a trial weight $m_t$ "
                "at the radius $r_t$, in the direction $θ_t$, it vibrates with $V_1$ at the same speed. "
                f"{stays.en[0].upper()}{stays.en[1:]}; the correction sits at the radius $r_b$.",
            )
        runs = len(self.trials)
        two = Words(
            "；第二个下标为解的序号，按方位角排列",
            "; the second subscript is the number of the solution, by their angles",
        )
        which = two if runs < MOST else Words("", "")
        return Words(
            f"只测振幅。转子的初始振幅为 $V_0$；把试重 $m_t$ 装在半径 $r_t$ 处，方位依次为 $θ_{{ti}}$，测得振幅 $V_i$"
            f"（$i$ = 1～{runs}）。{stays.zh}，校正质量装在半径 $r_b$ 处{which.zh}。",
            "Only amplitudes are measured. The rotor first shows $V_0$; with the trial weight $m_t$ at the radius "
            f"$r_t$ in the directions $θ_{{ti}}$ in turn it shows $V_i$ ($i$ = 1 to {runs}). "
            f"{stays.en[0].upper()}{stays.en[1:]}; the correction sits at the radius $r_b${which.en}.",
        )

    def told(self) -> tuple[Words, ...]:
        """From where its angles count."""
        angles = (
            Words("方位角和相位均逆时针为正", "angles and phases count counter-clockwise")
            if self.phased
            else Words("方位角逆时针为正", "angles count counter-clockwise")
        )
        return (angles,)

    def quantities(self) -> tuple[Named, ...]:
        """The effect of the trial weight, the coefficient, the correction; of two arcs both answers."""
        if self.phased:
            return (effect(self.unit), EFFECT_PHASE, coefficient(self.unit), TURN, weight(""), bearing(""))
        if len(self.trials) == MOST:
            return (effect(self.unit), weight(""), bearing(""), spread(self.unit))
        ways = ("_1", "_2")
        return tuple(one for way in ways for one in (effect(self.unit, way), weight(way), bearing(way)))

    def given(self) -> tuple[tuple[str, str], ...]:
        """The readings and the trial weights, as written."""
        rows = [("V_0", self.initial.text)]
        for i, trial in enumerate(self.trials, 1):
            rows += [(f"θ_{{t{i}}}" if len(self.trials) > 1 else "θ_t", trial.at.text), (f"V_{i}", trial.reading.text)]
        first = self.trials[0]
        return (*rows, ("m_t", first.m.text), ("r_t", first.r.text), ("r_b", self.correct.r.text))


def effect(unit: str, way: str = "") -> Named:
    """V_t: how much the trial weight moves the vibration."""
    return of_solution("V", "V", "t", way, unit)


def coefficient(unit: str) -> Named:
    """alpha: the effect for one g·mm."""
    return Named("alpha", "α", f"{unit}/(g·mm)")


def weight(way: str) -> Named:
    """m_b: the weight that balances, g."""
    return of_solution("m", "m", "b", way, "g")


def bearing(way: str) -> Named:
    """theta_b: where it sits."""
    return of_solution("theta", "θ", "b", way, "deg")


def spread(unit: str) -> Named:
    """spread: the longest side of the triangle in which three arcs meet."""
    return Named("spread", "Δ", unit)


EFFECT_PHASE, TURN = Named("phi_t", "φ_t", "deg"), Named("beta", "β", "deg")
