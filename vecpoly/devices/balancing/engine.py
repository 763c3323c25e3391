"""An in-line engine, cylinders at equal distances: inertia forces and couples of first and second order.

data: {cranks: [0 deg, 240 deg, 120 deg], pitch: 100 mm, m: 0.7 kg, r: 42 mm, l: 140 mm, n: 3600 r/min}
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Annotated, Any, ClassVar

from pydantic import BeforeValidator, WithJsonSchema, model_validator

from ...errors import FaultError
from ...names import Named
from ...words import Words
from ..base import Angle, Device, Length, as_written
from .written import MassSize, Turning

MOST = 12  # cylinders
ORDERS = ("I", "II")


def _numbers(value: Any) -> tuple[int, ...]:
    """The cylinders in the order in which they fire."""
    given = value if isinstance(value, list | tuple) else str(value).replace("-", " ").split()
    if not all(str(one).strip().isdigit() for one in given):
        raise FaultError(
            Words(
                f"“{value}”不是发火顺序；如写 [1, 3, 4, 2]", f"'{value}' is no firing order; write e.g. [1, 3, 4, 2]"
            ),
            code="spelling",
        )
    return tuple(int(one) for one in given)


Order = Annotated[
    tuple[int, ...], BeforeValidator(_numbers), WithJsonSchema({"type": ["array", "string"], "items": {}})
]


class InlineEngine(Device):
    """cranks: their directions when crank 1 stands at its own; m: the reciprocating mass of a cylinder."""

    kind: ClassVar[str] = "in-line-engine"
    cranks: tuple[Angle, ...]
    pitch: Length
    m: MassSize
    r: Length
    l: Length  # noqa: E741 - the textbook's letter
    n: Turning
    order: Order | None = None

    @model_validator(mode="after")
    def _possible(self) -> InlineEngine:
        if not 1 <= len(self.cranks) <= MOST:
            raise FaultError(
                Words(
                    f"cranks 有 {len(self.cranks)} 个曲柄，应为 1 至 {MOST} 个",
                    f"there are {len(self.cranks)} cranks; 1 to {MOST} are drawn",
                ),
                code="out-of-range",
                numbers={"cranks": len(self.cranks)},
                keys=("cranks",),
            )
        if self.l.si <= self.r.si:
            raise FaultError(
                Words(
                    f"连杆长 {self.l.text} 不大于曲柄长 {self.r.text}，曲柄不能整周转动",
                    f"a rod of {self.l.text} is not longer than the crank, {self.r.text}: it cannot turn round",
                ),
                code="contradiction",
                numbers={"l": self.l.si, "r": self.r.si},
                keys=("r", "l"),
            )
        if self.order is not None and sorted(self.order) != list(range(1, len(self.cranks) + 1)):
            raise FaultError(
                Words(
                    f"发火顺序 {list(self.order)} 应把 1 至 {len(self.cranks)} 各列一次",
                    f"the firing order {list(self.order)} must name each of 1 to {len(self.cranks)} once",
                ),
                code="contradiction",
                keys=("order",),
            )
        return self

    @property
    def z(self) -> tuple[float, ...]:
        """Distances of the cylinders from the middle plane (m)."""
        middle = (len(self.cranks) - 1) / 2
        return tuple((i - middle) * self.pitch.si for i in range(len(self.cranks)))

    @property
    def firing(self) -> tuple[int, ...]:
        """The cylinders in firing order, else as they are numbered (from 0)."""
        return tuple(i - 1 for i in self.order) if self.order is not None else tuple(range(len(self.cranks)))

    def task(self, asked: Collection[str]) -> Words:
        """So many cylinders, in one row."""
        fires = "–".join(map(str, self.order or ()))
        order = Words(f"，发火顺序 {fires}", f", firing in the order {fires}") if fires else Words("", "")
        count = len(self.cranks)
        return Words(
            f"直列 {count} 缸机的缸距为 $a$，曲柄半径为 $r$，连杆长为 $l$，转速为 $n$，各缸的往复质量均为 $m$，各曲柄"
            f"的方位角为 $α_i${order.zh}。由各缸质径积 $m r$ 的矢量和 $W$ 及其对中间平面之矩的矢量和 $C$ 得惯性力 $F$ "
            "和惯性力偶 $M$ 的幅值；下标 I、II 为阶数，二阶各矢量的方位角为 $2α_i$。",
            f"An in-line engine has {count} cylinders at the distance $a$, the crank radius $r$, rods of length $l$, "
            "the speed $n$, the same reciprocating mass $m$ in each cylinder and its cranks at the angles "
            f"$α_i${order.en}. From the vector sum $W$ of the products $m r$ of all cylinders and from that of their "
            "moments about the middle plane, $C$, follow the amplitudes of the inertia force $F$ and of the inertia "
            "couple $M$. The subscripts I and II are the order; in the second the vectors stand at $2α_i$.",
        )

    def told(self) -> tuple[Words, ...]:
        """From where the cranks' angles and the cylinders' places count."""
        return (
            Words(
                "$α_i$ 自 $x$ 轴（气缸轴线）起逆时针量",
                "$α_i$ counter-clockwise from the $x$ axis, that of the cylinders",
            ),
            Words(
                "$z_i$ 自中间平面量起，缸号大的一侧为正，力偶矢 $W z$ 转过 90° 沿 $W$ 画",
                "$z_i$ from the middle plane, positive towards the last cylinder; the couples $W z$, turned by 90°, "
                "lie along $W$",
            ),
        )

    def quantities(self) -> tuple[Named, ...]:
        """λ; of both orders the sums, the force and the couple, with the direction of each sum."""
        return (RATIO, *(one for order in ORDERS for one in of_order(order)))

    def given(self) -> tuple[tuple[str, str], ...]:
        """Cranks, pitch, mass, lengths, speed."""
        rows = [(f"α_{{{i}}}", one) for i, one in enumerate(self.cranks, 1)]
        return as_written([*rows, ("a", self.pitch), ("m", self.m), ("r", self.r), ("l", self.l), ("n", self.n)])

    @property
    def directions(self) -> frozenset[str]:
        """Those of the sums: a polygon that closes has none."""
        return frozenset(f"theta_{letter}{order}" for letter in ("", "M") for order in ORDERS)

    @property
    def likely(self) -> Mapping[str, float]:
        """All products together: of a balanced engine the sums vanish."""
        whole, far = len(self.cranks) * self.m.si * self.r.si, max(self.pitch.si * len(self.cranks), self.r.si)
        rate = self.n.si**2
        return {"kg·m": whole, "N": whole * rate, "kg·m^2": whole * far, "N·m": whole * far * rate}

    @property
    def size(self) -> float:
        """The length of the crankshaft (m)."""
        return max(self.pitch.si * (len(self.cranks) - 1), 2 * self.r.si)


RATIO = Named("lambda", "λ", "")


def of_order(order: str) -> tuple[Named, ...]:
    """ΣW, its direction, the force F; ΣW z, its direction, the couple M."""
    return (
        sum_of(order),
        Named(f"theta_{order}", f"θ_{{{order}}}", "deg"),
        Named(f"F_{order}", f"F_{{{order}}}", "N"),
        couple_sum(order),
        Named(f"theta_M{order}", f"θ_{{M{order}}}", "deg"),
        Named(f"M_{order}", f"M_{{{order}}}", "N·m"),
    )


def sum_of(order: str) -> Named:
    """W_I: the sum of all m r, at α or at 2α."""
    return Named(f"W_{order}", f"W_{{{order}}}", "kg·m")


def couple_sum(order: str) -> Named:
    """C_I: the sum of all m r z about the middle plane."""
    return Named(f"C_{order}", f"C_{{{order}}}", "kg·m^2")
