"""An epicyclic train: a sun 1, planets 2 on the carrier H, and a ring 3 or a second sun 3.

data: {sun: 20, planet: 22, ring: 64, omega_1: 10 rad/s, omega_3: 0 rad/s}
data: {sun: 24, planet: [33, 21], ring: 78, omega_1: 20 rad/s, omega_3: 0 rad/s}       # stepped planets
data: {sun: 30, planet: [20, 25], sun_2: 25, omega_1: 10 rad/s, omega_H: 4 rad/s}
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Annotated, Any, ClassVar

from pydantic import BeforeValidator, Field, WithJsonSchema, model_validator

from ...errors import FaultError
from ...names import Named
from ...units.reading import Quantity
from ...words import Words
from ..base import Device, Length, Omega
from .told import train_task

FEWEST, MOST = 3, 2000  # teeth
ONE_TO_ONE = 1e-9  # how far i_13^H must be from 1, where neither central gear would know of the carrier


def _teeth(value: Any) -> int:
    text = str(value).strip()
    if not text.isdigit() or not FEWEST <= int(text) <= MOST:
        raise FaultError(
            Words(
                f"“{value}”不是齿数；应为 {FEWEST} 至 {MOST} 的整数，如 20",
                f"'{value}' is no number of teeth; write a whole number from {FEWEST} to {MOST}, e.g. 20",
            ),
            code="spelling",
        )
    return int(text)


def _several(value: Any) -> tuple[int, ...]:
    return tuple(_teeth(one) for one in (value if isinstance(value, list | tuple) else [value]))


Teeth = Annotated[int, BeforeValidator(_teeth), WithJsonSchema({"type": ["integer", "string"]})]
Planets = Annotated[
    tuple[int, ...],
    BeforeValidator(_several),
    Field(min_length=1, max_length=2),
    WithJsonSchema({"type": ["integer", "string", "array"]}),
]


def speed_of(point: str) -> Named:
    """The speed of a point of the line of centres; which way it goes no sign on the sheet tells."""
    return Named(f"v_{point}", f"v_{{{point}}}", "m/s", is_size=True)


class Epicyclic(Device):
    """Teeth, the module of the first pair, and two of the three angular velocities (counter-clockwise positive)."""

    kind: ClassVar[str] = "epicyclic"
    sun: Teeth
    planet: Planets
    ring: Teeth | None = None
    sun_2: Teeth | None = None
    m: Length = Quantity(1e-3, "1 mm")
    omega_1: Omega | None = None
    omega_3: Omega | None = None
    omega_H: Omega | None = None

    @model_validator(mode="after")
    def _is_a_train(self) -> Epicyclic:
        if (self.ring is None) == (self.sun_2 is None) or (self.sun_2 and len(self.planet) == 1):
            raise FaultError(
                Words(
                    "中心轮 3 应为内齿轮 ring，或（双联行星轮时）第二个太阳轮 sun_2，写其一；如写 ring: 64",
                    "the other central gear is a ring, or with stepped planets a second sun: write one of 'ring' and "
                    "'sun_2', e.g. ring: 64",
                ),
                code="missing",
                keys=("ring", "sun_2"),
            )
        self._meshes()
        self._turns()
        if abs(self.basic - 1) < ONE_TO_ONE and self.sought == "H":
            raise FaultError(
                Words(
                    "转化轮系的传动比为 1，两中心轮总是同速，系杆的转速不能由它们确定；请改变齿数或给出 omega_H",
                    "relative to the carrier the ratio is 1: both central gears always turn alike and say nothing of "
                    "the carrier; change the teeth, or give omega_H",
                ),
                code="contradiction",
                keys=("sun", "planet", "ring"),
            )
        return self

    def _turns(self) -> None:
        """FaultError where not two angular velocities are given, or both are nothing."""
        given = [key for key, omega in self.omegas.items() if omega is not None]
        if len(given) != 2:
            names = ", ".join(f"omega_{key}" for key in given) or "–"
            raise FaultError(
                Words(
                    f"差动轮系有两个自由度，应给出 omega_1、omega_3、omega_H 中的两个，这里有 {names}",
                    "the train has two degrees of freedom: give two of omega_1, omega_3 and omega_H; here stand "
                    f"{names}",
                ),
                code="missing",
                keys=tuple(f"omega_{key}" for key in given),
            )
        if not any(omega.si for omega in self.omegas.values() if omega is not None):
            raise FaultError(
                Words(
                    "给出的两个角速度都是零，轮系不动；如写 omega_1: 10 rad/s",
                    "both angular velocities are zero and nothing turns; write e.g. omega_1: 10 rad/s",
                ),
                code="out-of-range",
                keys=("omega_1", "omega_3", "omega_H"),
            )

    def _meshes(self) -> None:
        """Concentric: with plain planets z_3 = z_1 + 2 z_2; a stepped planet must leave room."""
        if len(self.planet) == 1 and self.ring != self.sun + 2 * self.planet[0]:
            right = self.sun + 2 * self.planet[0]
            raise FaultError(
                Words(
                    f"ring = {self.ring}：标准齿轮的同心条件要求 z_3 = z_1 + 2z_2 = {right}；请改正齿数",
                    f"ring = {self.ring}: for standard gears to be concentric z_3 = z_1 + 2 z_2 = {right}; mend the "
                    "teeth",
                ),
                code="contradiction",
                numbers={"ring": self.ring or 0, "needed": right},
                keys=("sun", "planet", "ring"),
            )
        if self.ring is not None and self.ring <= self.planet[-1]:
            raise FaultError(
                Words(
                    f"ring = {self.ring}：内齿轮的齿数应大于与之啮合的行星轮齿数 {self.planet[-1]}",
                    f"ring = {self.ring}: a ring has more teeth than the planet in it, {self.planet[-1]}",
                ),
                code="out-of-range",
                keys=("planet", "ring"),
            )

    @property
    def omegas(self) -> dict[str, Quantity | None]:
        """What is given, by the link."""
        return {"1": self.omega_1, "3": self.omega_3, "H": self.omega_H}

    @property
    def held(self) -> tuple[str, ...]:
        """The central gears that stand still."""
        return tuple(key for key, omega in self.omegas.items() if omega is not None and not omega.si and key != "H")

    @property
    def sought(self) -> str:
        """The central link whose speed is not given."""
        return next(key for key, omega in self.omegas.items() if omega is None)

    @property
    def other(self) -> int:
        """Teeth of gear 3."""
        return self.ring or self.sun_2 or 0

    @property
    def basic(self) -> float:
        """The ratio (ω_1 − ω_H) / (ω_3 − ω_H)."""
        size = self.planet[0] * self.other / (self.sun * self.planet[-1])
        return -size if self.ring else size

    @property
    def radii(self) -> dict[str, float]:
        """Pitch radii (m) of 1, 2, 2′ and 3, and the radius H of the planets' centres."""
        half = self.m.si / 2
        arm = half * (self.sun + self.planet[0])
        second = arm / (self.other - self.planet[-1] if self.ring else self.other + self.planet[-1])
        return {
            "1": half * self.sun,
            "2": half * self.planet[0],
            "H": arm,
            "2′": second * self.planet[-1],
            "3": second * self.other,
        }

    @property
    def driver(self) -> str | None:
        """Where just one of the given links is held, the other."""
        known = [(key, omega.si) for key, omega in self.omegas.items() if omega is not None]
        moving = [key for key, omega in known if omega]
        return moving[0] if len(moving) == 1 else None

    @property
    def ratio(self) -> Named | None:
        """i from the driver to the driven link; None of a differential."""
        if self.driver is None:
            return None
        return Named(f"i_{self.driver}{self.sought}", f"i_{{{self.driver}{self.sought}}}", "")

    def task(self, asked: Collection[str]) -> Words:
        """Which gears mesh on which carrier."""
        return train_task(asked, stepped=len(self.planet) > 1, ring=self.ring is not None)

    def quantities(self) -> tuple[Named, ...]:
        """Speeds of the pitch points and the planets' centres, ω of every link, the ratio where one link is held."""
        speeds = [speed_of(point) for point in ("A", "O2", "C")]
        turns = [Named(f"omega_{link}", f"ω_{link}", "rad/s") for link in ("1", "2", "3", "H")]
        return (*speeds, *turns, *([self.ratio] if self.ratio else []))

    def given(self) -> tuple[tuple[str, str], ...]:
        """Teeth, module, and the two angular velocities."""
        teeth = [("z_1", self.sun), ("z_2", self.planet[0])]
        teeth += [("z_{2′}", self.planet[1])] if len(self.planet) > 1 else []
        written = [(symbol, str(z)) for symbol, z in (*teeth, ("z_3", self.other))]
        known = [(f"ω_{key}", omega.text) for key, omega in self.omegas.items() if omega is not None]
        return (*written, ("m", self.m.text), *known)

    @property
    def size(self) -> float:
        """The largest radius (m)."""
        return max(self.radii["3"], self.radii["H"] + max(self.radii["2"], self.radii["2′"]))

    @property
    def likely(self) -> Mapping[str, float]:
        """The speeds that are given, and those of the largest radius with them: another may vanish."""
        fastest = max(abs(omega.si) for omega in self.omegas.values() if omega is not None)
        return {"rad/s": fastest, "m/s": fastest * self.size}
