"""The shaking force of a slider-crank on its frame, and the counterweight on the crank.

data: {r: 50 mm, l: 200 mm, n: 1800 r/min, m1: 0.4 kg, m2: 1.2 kg, BS2: 60 mm, m3: 0.9 kg, r_c: 70 mm, c: 1/2}
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Annotated, Any, ClassVar

from pydantic import BeforeValidator, WithJsonSchema, model_validator

from ...errors import FaultError
from ...names import Named
from ...units.reading import Quantity, pure
from ...words import Words
from ..base import Angle, Device, Length, as_written
from .written import MassOrNone, MassSize, Turning

BEST = Quantity(0.0, "best")
MOST_C = 2.0


def _fraction(text: Any) -> Quantity:
    """The part of the reciprocating mass that the counterweight balances; `best`: it is sought."""
    if isinstance(text, Quantity):
        return text
    if str(text).strip() in ("best", "最佳"):
        return BEST
    above, _, below = str(text).partition("/")
    value = pure(above, "0.5") / (positive_number(below) if below else 1.0)
    if not 0 <= value <= MOST_C:
        raise FaultError(
            Words(
                f"c = {text}：平衡系数应在 0 与 {MOST_C:g} 之间，或写 best",
                f"c = {text}: the balanced fraction lies between 0 and {MOST_C:g}, or is 'best'",
            ),
            code="out-of-range",
        )
    return Quantity(value, str(text))


def positive_number(text: str) -> float:
    """The lower part of a fraction, 2/3."""
    value = pure(text, "2/3")
    if value <= 0:
        raise FaultError(
            Words(f"分母“{text}”应大于零", f"the denominator '{text}' must be above zero"), code="spelling"
        )
    return value


Fraction = Annotated[Quantity, BeforeValidator(_fraction), WithJsonSchema({"type": ["string", "number"]})]


class ShakingForce(Device):
    """m1: the crank's unbalance, thought at B; m2 with BS2, m3: rod and piston; r_c: of the counterweight; c: how much
    of the reciprocating mass it balances; at: φ of the crank, from the outer dead centre."""

    kind: ClassVar[str] = "shaking-force"
    r: Length
    l: Length  # noqa: E741 - the textbook's letter
    n: Turning
    m1: MassOrNone
    m2: MassSize
    BS2: Length
    m3: MassSize
    r_c: Length
    c: Fraction
    at: Angle = Quantity(0.0, "0 deg")

    @model_validator(mode="after")
    def _possible(self) -> ShakingForce:
        for name, least, greatest in (("r", self.r, self.l), ("BS2", self.BS2, self.l)):
            if least.si >= greatest.si:
                raise FaultError(
                    Words(
                        f"{name} = {least.text} 应小于连杆长 {greatest.text}",
                        f"{name} = {least.text} must be less than the length of the rod, {greatest.text}",
                    ),
                    code="contradiction",
                    numbers={name: least.si, "l": greatest.si},
                    keys=(name, "l"),
                )
        return self

    @property
    def seeks(self) -> bool:
        """Whether the best fraction is sought."""
        return self.c.text == BEST.text

    def task(self, asked: Collection[str]) -> Words:
        """A slider-crank with a counterweight."""
        balanced = (
            Words(
                "以及往复质量的 $c$ 倍，$c$ 取使一周内最大振动力最小的值",
                " and that fraction $c$ of the reciprocating one with which the "
                "largest shaking force of a turn is least",
            )
            if self.seeks
            else Words("以及往复质量的 $c$ 倍", " and the fraction $c$ of the reciprocating one")
        )
        return Words(
            "单缸机的曲柄 $AB$ 长 $r$，连杆 $BC$ 长 $l$，转速为 $n$；曲柄换算到 $B$ 的不平衡质量为 $m_1$，连杆质量为 "
            "$m_2$，其质心到 $B$ 的距离为 $l_{BS2}$，活塞质量为 $m_3$。连杆质量代换到 $B$、$C$ 两点，得回转质量 "
            f"$m_B$ 和往复质量 $m_C$；曲柄上半径 $r_c$ 处的配重 $m_c$ 平衡全部回转质量{balanced.zh}。$φ$ 为曲柄自外死"
            "点逆时针的转角，振动力 $F$ 为此位置机架所受的惯性力。",
            "In a single-cylinder engine the crank $AB$ is $r$ long, the rod $BC$ is $l$ long, and the speed is $n$. "
            "The crank's unbalance, thought at $B$, is $m_1$; the rod has the mass $m_2$, with its centre of mass at "
            "the distance $l_{BS2}$ from $B$; the piston has the mass $m_3$. The rod is replaced by masses at $B$ "
            "and $C$, whence the rotating mass $m_B$ and the reciprocating mass $m_C$. The counterweight $m_c$ at "
            f"the radius $r_c$ of the crank balances all of the rotating mass{balanced.en}. $φ$ is the crank's angle "
            "from the outer dead centre, counter-clockwise; the shaking force $F$ is what acts on the frame there.",
        )

    def quantities(self) -> tuple[Named, ...]:
        """The masses, λ, both orders, c if it is sought, the counterweight; the force at φ, the largest one."""
        found = (ROTATING, RECIPROCATING, RATIO, FIRST, SECOND)
        if self.seeks:  # with the best fraction the force is as large at several places
            return (*found, FRACTION, COUNTERWEIGHT, FORCE, LARGEST)
        return (*found, COUNTERWEIGHT, FORCE, LARGEST, WHERE)

    def given(self) -> tuple[tuple[str, str], ...]:
        """Lengths, speed, masses, counterweight."""
        rows = (("r", self.r), ("l", self.l), ("n", self.n), ("m_1", self.m1), ("m_2", self.m2))
        rest = (("l_{BS2}", self.BS2), ("m_3", self.m3), ("r_c", self.r_c), ("c", None if self.seeks else self.c))
        return as_written((*rows, *rest, ("φ", self.at)))

    @property
    def likely(self) -> Mapping[str, float]:
        """The first order of all masses."""
        return {"N": (self.m1.si + self.m2.si + self.m3.si) * self.r.si * self.n.si**2, "deg": 180.0}

    @property
    def size(self) -> float:
        """Crank and rod in line (m)."""
        return 2 * self.r.si + self.l.si


ROTATING, RECIPROCATING = Named("m_rot", "m_B", "kg"), Named("m_rec", "m_C", "kg")
RATIO, FRACTION = Named("lambda", "λ", ""), Named("c", "c", "")
FIRST, SECOND = Named("F_1", "F_{1}", "N"), Named("F_2", "F_{2}", "N")
COUNTERWEIGHT = Named("m_c", "m_c", "kg")
FORCE, LARGEST, WHERE = Named("F", "F", "N", True), Named("F_max", "F_{max}", "N"), Named("phi_max", "φ_{max}", "deg")
