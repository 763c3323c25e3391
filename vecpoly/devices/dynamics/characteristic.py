"""A moment over the speed, as it is written.

motor: 120 N*m                                          # the same at every speed
motor: [240 N*m, 1.5 N*m*s]                             # M = a − b ω; of a load M = a + b ω + c ω²
motor: {M_k: 150 N*m, s_k: 0.2, n_s: 1500 r/min}        # asynchronous, by Kloss: M = 2 M_k / (s/s_k + s_k/s)
motor: [[0 rad/s, 100 N*m], [80 rad/s, 140 N*m], [157 rad/s, 0 N*m]]
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Annotated, Any

from pydantic import BeforeValidator, WithJsonSchema

from ...errors import FaultError
from ...units.reading import Dim, positive, pure, read
from ...words import Words
from ..base import Tabled

SHOWN = 2  # places that are told in a line; more of them stand in a table
_TERMS = (Dim.MOMENT, Dim.DRAG, Dim.INERTIA)  # N·m, N·m·s, N·m·s² (as kg·m²)


@dataclass(frozen=True, slots=True, kw_only=True)
class Polynomial:
    """c_0 + c_1 ω + c_2 ω²."""

    terms: tuple[float, ...]
    text: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Kloss:
    """2 M_k / (s/s_k + s_k/s), with the slip s = 1 − ω/ω_s."""

    greatest: float
    slip: float
    synchronous: float
    text: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Measured:
    """Speeds (rad/s) in rising order, and moments; straight between them."""

    speeds: tuple[float, ...]
    sizes: tuple[float, ...]
    text: str

    @property
    def tabled(self) -> Tabled | None:
        """Its places, where they are too many for a line."""
        rows = tuple((f"{a:.5g}", f"{b:.5g}") for a, b in zip(self.speeds, self.sizes, strict=True))
        return Tabled(over="ω", unit="(rad/s)", rows=rows) if len(rows) > SHOWN else None


Characteristic = Polynomial | Kloss | Measured


def read_motor(value: Any) -> Characteristic:
    """A motor: its moment falls with the speed, M = a − b ω."""
    return _read(value, falling=True)


def read_load(value: Any) -> Characteristic:
    """A load: its moment rises, M = a + b ω + c ω²."""
    return _read(value, falling=False)


def _read(value: Any, *, falling: bool) -> Characteristic:
    match value:
        case Polynomial() | Kloss() | Measured():
            return value
        case str():
            return Polynomial(terms=(positive(value, Dim.MOMENT).si,), text=value)
        case {"M_k": greatest, "s_k": slip, "n_s": speed} if len(value) == 3:
            return _kloss(str(greatest), str(slip), str(speed))
        case [str(), *_] if 2 <= len(value) <= 3 and all(isinstance(term, str) for term in value):
            return _polynomial([str(term) for term in value], falling=falling)
        case [[_, _], *_] if len(value) > 1 and all(len(pair) == 2 for pair in value):
            return _measured(value)
    raise FaultError(
        Words(
            "力矩特性应写成一个值（60 N*m）、系数（[240 N*m, 1.5 N*m*s]）、若干点（[[0 rad/s, 100 N*m], …]）或 "
            "{M_k: 150 N*m, s_k: 0.2, n_s: 1500 r/min}",
            "a characteristic is one value (60 N*m), coefficients ([240 N*m, 1.5 N*m*s]), points ([[0 rad/s, 100 N*m], "
            "...]) or {M_k: 150 N*m, s_k: 0.2, n_s: 1500 r/min}",
        ),
        code="spelling",
    )


def _kloss(greatest: str, slip: str, speed: str) -> Kloss:
    share = pure(slip, "0.2")
    if not 0 < share < 1:
        raise FaultError(
            Words(f"临界转差率 s_k = {share:g} 应在 0 与 1 之间", f"the slip s_k = {share:g} lies between 0 and 1"),
            "s_k",
            code="out-of-range",
        )
    return Kloss(
        greatest=positive(greatest, Dim.MOMENT).si,
        slip=share,
        synchronous=positive(speed, Dim.OMEGA).si,
        text=f"M_k = {greatest}, s_k = {slip}, n_s = {speed}",
    )


def _polynomial(terms: Sequence[str], *, falling: bool) -> Polynomial:
    sizes = [read(term, dim).si for term, dim in zip(terms, _TERMS, strict=False)]
    signed = [sizes[0], *(-size if falling else size for size in sizes[1:])]
    sign = " − " if falling else " + "
    told = [terms[0], *(f"({term}) {power}" for term, power in zip(terms[1:], ("ω", "ω²"), strict=False))]
    return Polynomial(terms=tuple(signed), text=sign.join(told))


def _measured(rows: Sequence[Sequence[Any]]) -> Measured:
    pairs = [(read(str(a), Dim.OMEGA).si, read(str(b), Dim.MOMENT).si) for a, b in rows]
    for number, ((a, _), (b, _)) in enumerate(pairwise(pairs), 2):
        if b <= a:
            raise FaultError(
                Words(
                    f"第 {number} 点的角速度 {b:g} rad/s 不大于前一点的 {a:g}；请按由小到大排列",
                    f"place {number}, {b:g} rad/s, is not above the one before, {a:g}; put them in rising order",
                ),
                number - 1,
                code="contradiction",
            )
    if pairs[0][0]:
        raise FaultError(
            Words(f"第一点为 {pairs[0][0]:g} rad/s，应从 0 开始", f"the first place, {pairs[0][0]:g} rad/s, must be 0"),
            0,
            code="out-of-range",
        )
    speeds, sizes = zip(*pairs, strict=True)
    text = ", ".join(f"{a:.5g} rad/s: {b:.5g} N·m" for a, b in pairs)
    return Measured(speeds=speeds, sizes=sizes, text=text)


_ANY = WithJsonSchema({"type": ["string", "array", "object"]})
Motor = Annotated[Characteristic, BeforeValidator(read_motor), _ANY]
Load = Annotated[Characteristic, BeforeValidator(read_load), _ANY]


def highest(curve: Characteristic) -> float:
    """The speed up to which it is known (rad/s); infinite where at every speed."""
    match curve:
        case Polynomial():
            return float("inf")
        case Kloss(synchronous=speed):
            return speed
        case Measured(speeds=speeds):
            return speeds[-1]


def at_rest(curve: Characteristic) -> float:
    """The moment at ω = 0."""
    match curve:
        case Polynomial(terms=terms):
            return terms[0]
        case Kloss(greatest=greatest, slip=slip):
            return 2 * greatest / (1 / slip + slip)
        case Measured(sizes=sizes):
            return sizes[0]
