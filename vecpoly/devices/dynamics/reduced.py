"""Gears, belts and a hoist reduced to one shaft: J_e, M_e, and how it runs up with constant moments.

data:
  shafts: {1: {J: 0.1 kg*m^2, drives: 80 N*m}, 2: {J: 0.225 kg*m^2}, 3: {J: 0.4 kg*m^2, resists: 100 N*m}}
  pairs: [1 to 2 by 20/30, 2 to 3 by 30/40]
  after: 0.5 s
"""

from __future__ import annotations

from collections.abc import Collection
from itertools import permutations
from math import inf, prod
from typing import Annotated, ClassVar

from pydantic import Field, model_validator

from ...errors import FaultError
from ...names import Named
from ...units.reading import Quantity
from ...words import Words
from ..base import Device, Duration, Omega, as_written
from .shafts import Meshing, Pair, Shaft, ways
from .told import reduced_task

J_E, M_E = Named("J_e", "J_e", "kg·m^2"), Named("M_e", "M_e", "N·m")
M_D, M_R = Named("M_d", "M_{ed}", "N·m"), Named("M_r", "M_{er}", "N·m", is_size=True)
TIME, TURNS = Named("t", "t", "s"), Named("N", "N", "r")
LIFT, ROPE = Named("lift", "s", "m"), Named("F_rope", "F", "N")


def ratio_of(name: str, to: str) -> Named:
    """i: ω of a shaft over that of the shaft to which all is reduced."""
    return Named(f"i_{name}_{to}", f"i_{{{both(name, to)}}}", "", is_size=True)


def both(one: str, other: str) -> str:
    """Two names as a subscript: 13, and II,I where one is longer."""
    return f"{one}{other}" if len(one + other) == 2 else f"{one},{other}"


def alpha_of(name: str) -> Named:
    """α of a shaft."""
    return Named(f"alpha_{name}", f"α_{{{name}}}", "rad/s^2")


def omega_of(name: str) -> Named:
    """ω of a shaft at the end."""
    return Named(f"omega_{name}", f"ω_{{{name}}}", "rad/s")


class ReducedTrain(Device):
    """to: the shaft (the first by default); start: its speed; until: the speed, or after: the time, at the end."""

    kind: ClassVar[str] = "reduced-train"
    shafts: Annotated[dict[str, Shaft], Field(min_length=2)]
    pairs: Annotated[tuple[Meshing, ...], Field(min_length=1)]
    to: str = ""
    start: Omega = Quantity(0.0, "0")
    until: Omega | None = None
    after: Duration | None = None

    @model_validator(mode="after")
    def _is_joined(self) -> ReducedTrain:
        if self.main not in self.shafts:
            raise FaultError(
                Words(
                    f"没有轴“{self.main}”；有 {'、'.join(self.shafts)}",
                    f"there is no shaft '{self.main}'; there are {', '.join(self.shafts)}",
                ),
                "to",
                code="unknown-name",
            )
        assert self.ways
        if not any(shaft.J or shaft.lifts for shaft in self.shafts.values()):
            raise FaultError(
                Words("没有任何转动惯量；如写 J: 0.1 kg*m^2", "nothing has a moment of inertia; write J: 0.1 kg*m^2"),
                "shafts",
                code="missing",
            )
        if sum(shaft.lifts is not None for shaft in self.shafts.values()) > 1:
            raise FaultError(Words("只能有一个卷筒", "one drum only"), "shafts", code="contradiction")
        self._runs()
        return self

    def _runs(self) -> None:
        """FaultError for a motion that ends twice, or never."""
        if self.until is not None and self.after is not None:
            raise FaultError(
                Words("until 与 after 只写其一", "write one of 'until' and 'after'"), "after", code="contradiction"
            )
        moment = self.moment
        if self.moves and not self.start.si and moment <= 0:
            raise FaultError(
                Words(
                    f"等效驱动力矩不大于等效阻力矩（相差 {moment:.6g} N·m），不能起动；请增大驱动力矩",
                    f"the driving moment does not exceed the resisting one (by {moment:.6g} N·m): it stays at rest; "
                    "drive it harder",
                ),
                code="no-start",
                numbers={"M_e": moment},
                keys=("shafts",),
            )
        if self.until is not None and (self.until.si - self.start.si) * moment <= 0:
            raise FaultError(
                Words(
                    f"由 {self.start.text} 以等效力矩 {moment:.6g} N·m 不能达到 {self.until.text}",
                    f"from {self.start.text} it never comes to {self.until.text} with M_e = {moment:.6g} N·m",
                ),
                "until",
                code="out-of-range",
                numbers={"M_e": moment},
            )
        self._keeps_its_sense(moment)

    def _keeps_its_sense(self, moment: float) -> None:
        """FaultError where what resists would have to drive: the train stands still on its way, or begins backwards."""
        if not self.moves or not any(shaft.resists for shaft in self.shafts.values()):
            return
        rest = -self.start.si * self.inertia / moment if moment < 0 else inf
        late = self.after is not None and self.after.si > rest * (1 + 1e-9)
        if self.start.si < 0:
            why = Words("start 不得为负：阻力矩将变成驱动", "'start' is not negative: what resists would drive")
            raise FaultError(why, "start", code="out-of-range")
        if late or (self.until is not None and self.until.si < 0):
            raise FaultError(
                Words(
                    f"机器在 {rest:.4g} s 后停住，阻力矩不会使它反转；请写 until: 0 r/min，或更短的 after",
                    f"after {rest:.4g} s it stands still, and what resists drives nothing back; write until: 0 r/min, "
                    "or a shorter 'after'",
                ),
                "after" if late else "until",
                code="out-of-range",
                numbers={"t": rest},
            )

    @property
    def main(self) -> str:
        """The shaft to which all is reduced."""
        return self.to or next(iter(self.shafts))

    @property
    def ways(self) -> dict[str, tuple[tuple[Pair, bool], ...]]:
        """How every shaft is reached from it."""
        return ways(self.pairs, self.main, self.shafts)

    def wheel(self, pair: Pair, one: str, other: str) -> str:
        """The symbol of a wheel: z_1, or z_{12} of the one that meets shaft 2 where shaft 1 has unlike wheels."""
        sizes = {
            size
            for each in self.pairs
            if each.belt is pair.belt
            for name, size in zip((each.first, each.second), each.sizes, strict=True)
            if name == one
        }
        return f"{pair.letter}_{{{one if len(sizes) == 1 else both(one, other)}}}"

    @property
    def moves(self) -> bool:
        """Whether its motion is asked for."""
        return self.until is not None or self.after is not None

    @property
    def driven(self) -> bool:
        """Whether anything drives it: else it does not run, and is only reduced."""
        return any(shaft.drives is not None for shaft in self.shafts.values())

    @property
    def resisted(self) -> bool:
        """Whether anything resists."""
        return any(shaft.resists is not None or shaft.lifts is not None for shaft in self.shafts.values())

    @property
    def hoist(self) -> tuple[str, Shaft] | None:
        """The shaft that lifts something."""
        return next(((name, shaft) for name, shaft in self.shafts.items() if shaft.lifts is not None), None)

    @property
    def turns(self) -> dict[str, float]:
        """ω of every shaft over that of the main one."""
        return {name: prod(one.ratio if on else 1 / one.ratio for one, on in way) for name, way in self.ways.items()}

    @property
    def moment(self) -> float:
        """M_e (N·m), by which it is judged whether anything moves."""
        return sum(ratio * self.shafts[name].moment for name, ratio in self.turns.items())

    @property
    def inertia(self) -> float:
        """J_e (kg·m²), by which it is judged when it stands still."""
        return sum(ratio**2 * self.shafts[name].inertia for name, ratio in self.turns.items())

    def task(self, asked: Collection[str]) -> Words:
        """Which wheels mesh, what drives and what resists, from which speed."""
        wheels = [
            (pair, self.wheel(pair, pair.first, pair.second), self.wheel(pair, pair.second, pair.first))
            for pair in self.pairs
        ]
        return reduced_task(self.shafts, wheels, self.main, [symbol for symbol, _ in self._run], asked)

    @property
    def _run(self) -> tuple[tuple[str, str], ...]:
        """From which speed it runs to which, or how long; a speed in r/min is n."""
        ends = (("ω_0", self.start if self.start.si else None), (f"ω_{{{self.main}}}", self.until), ("t", self.after))
        written = as_written(ends)
        return tuple((f"n{s[1:]}" if "r/min" in text else s, text) for s, text in written)

    def quantities(self) -> tuple[Named, ...]:
        """The ratios, the equivalents, the angular accelerations; how it runs."""
        others = [name for name in self.shafts if name != self.main]
        found = [*(ratio_of(name, self.main) for name in others), J_E]
        found += [M_D] * self.driven + [M_R] * self.resisted
        if self.driven or self.moves:
            found += [M_E, *(alpha_of(name) for name in self.shafts)]
            found += [ROPE] if self.hoist is not None else []
        if self.moves:
            found += [TIME, *(omega_of(name) for name in self.shafts), TURNS]
            found += [LIFT] if self.hoist is not None else []
        return tuple(found)

    def given(self) -> tuple[tuple[str, str], ...]:
        """Shaft by shaft, then the pairs, and the run."""
        told: list[tuple[str, str]] = []
        for name, shaft in self.shafts.items():
            told += [(f"J_{{{name}}}", " + ".join(one.text for one in shaft.J))] if shaft.J else []
            told += as_written(
                (
                    (f"M_{{d{name}}}", shaft.drives),
                    (f"M_{{r{name}}}", shaft.resists),
                    (f"D_{{{name}}}", shaft.drum),
                    ("m", shaft.lifts),
                )
            )
        sizes = {
            self.wheel(pair, *ends): size
            for pair in self.pairs
            for ends, size in zip(permutations((pair.first, pair.second)), pair.sizes_written, strict=True)
        }
        tidy = [(symbol, text.replace("*", "·").replace("^2", "²")) for symbol, text in told]
        return (*tidy, *sizes.items(), *self._run)
