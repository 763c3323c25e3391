"""The key of a problem: every quantity that may be graded, with its exact value,
its tolerance, what it needs, its points.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from functools import cache
from typing import Any

from pydantic import TypeAdapter, ValidationError

from ..errors import UnknownNameError, VecpolyError
from ..words import Words
from .allowance import STUDENT, Allowance
from .equations.row import EquationRow

VERSION = 1


class Kind(StrEnum):
    """What is written down of a quantity, and so how it is compared."""

    READING = "reading"  # a length on paper, mm
    VECTOR = "vector"  # a size and a direction
    SIGNED = "signed"  # a size and a sense of turning
    SCALAR = "scalar"  # a number, with its sign
    PLACE = "place"  # two coordinates
    LINE = "line"  # the direction of a line, without a sense: of a centre at infinity (deg)
    YES_NO = "yes/no"


def beside(degrees: Any, other: float) -> Any:
    """The direction of a line, or of many, written so that it is nearest to another: 181° beside 179°, for 1°."""
    return other + (degrees - other + 90.0) % 180.0 - 90.0


def come_round(degrees: Any, other: float) -> Any:
    """An angle, or many, written so that it is nearest to another: 361° beside 359°, for 1°; beyond a turn, as in the
    cycle of a four-stroke engine, it is as it is."""
    return degrees if abs(other) > 360.0 else other + (degrees - other + 180.0) % 360.0 - 180.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Points:
    """What a quantity is worth: for the way (M), for the number (A), for the sense of turning (B)."""

    method: float = 0.0
    accuracy: float = 0.0
    sense: float = 0.0

    @property
    def total(self) -> float:
        """All of them."""
        return self.method + self.accuracy + self.sense


NOTHING = Points()


def spot_letters(key: str) -> str:
    """The letters by which the construction knows the place of this key: p_C → C, P_13 → P13."""
    return key.removeprefix("p_").replace("_", "")


@dataclass(frozen=True, slots=True, kw_only=True)
class Graded:
    """One quantity of a key.

    key, symbol: ``v_C2B``, ``v_{C2B}``; a reading has its letters (``bc2``, with its figure where two have them).
    exact: SI, a reading in mm; a size for vectors, signed for the rest. mm, degrees: of the exact vector on paper,
    from +x. mu: the scale it is drawn with (``mu_v``); line: the reading that it is computed from. needs: the graded
    quantities that it rests on directly. sigma: what a student's hand scatters by; allowed: T, both in the unit of
    `exact`; turned: what it scatters by in direction (deg). demoted: too badly conditioned to be held against the
    exact value; it is graded by what it was computed from. origin: of a place the fixed point from which its
    coordinates are read, right and up; leans: the direction (deg) in which it scatters far more than across that, as
    where two lines meet flatly; across: T across it. unsigned: a size, whose sign is a convention. points: nothing for
    a step on the way.
    """

    key: str
    symbol: str
    kind: Kind
    unit: str
    block: str
    exact: float
    mm: float | None = None
    degrees: float | None = None
    at: tuple[float, float] | None = None
    mu: str = ""
    line: str = ""
    needs: tuple[str, ...] = ()
    sigma: float = 0.0
    allowed: float = 0.0
    turned: float = 0.0
    demoted: bool = False
    asked: bool = False
    origin: str = ""
    leans: float | None = None
    across: float = 0.0
    unsigned: bool = False
    points: Points = NOTHING

    @property
    def is_counted(self) -> bool:
        """Whether it is asked, or a step on the way to which the lecturer gives points."""
        return self.asked or self.points.total > 0

    @property
    def written_in(self) -> str:
        """The unit in which it is asked and written down: of a place mm, as the rule tells them."""
        return "mm" if self.kind is Kind.PLACE else self.unit

    @property
    def one(self) -> float:
        """One of these, in the unit of `exact`."""
        return 1e-3 if self.kind is Kind.PLACE else 1.0

    @property
    def letters(self) -> str:
        """Of a reading: the letters by which the construction knows it, with the figure where two have them."""
        return self.key.removesuffix(" mm")

    @property
    def allowed_mm(self) -> float | None:
        """T in mm on paper; None for what is not drawn as a length."""
        return self.allowed * self.mm / abs(self.exact) if self.mm and self.exact else None


def is_count(one: Graded) -> bool:
    """Whether it is a whole number of links, pairs, freedoms: nothing that is drawn."""
    return one.unit == "" and not one.sigma and one.kind is Kind.SCALAR and one.exact == round(one.exact)


@dataclass(frozen=True, slots=True, kw_only=True)
class AnswerKey:
    """The key of one problem, or of one student's variant of it.

    scales: ``mu_v`` → SI per mm. stated: points for a scale that is stated with its unit.
    equations: the rows in which directions and magnitudes are ticked. allowance: the σ's behind the tolerances.
    solutions: the numbers of the solutions of a synthesis (AB_1, AB_2), of which no one is the first.
    """

    problem: str
    quantities: tuple[Graded, ...]
    scales: Mapping[str, float] = field(default_factory=dict)
    stated: Mapping[str, float] = field(default_factory=dict)
    equations: tuple[EquationRow, ...] = ()
    allowance: Allowance = STUDENT
    version: int = VERSION
    solutions: tuple[int, ...] = ()

    def __getitem__(self, key: str) -> Graded:
        """The quantity of this key. Raises UnknownNameError."""
        if (found := self.find(key)) is not None:
            return found
        raise UnknownNameError(
            Words(f"题 {self.problem} 的答案中没有 {key}", f"the key of {self.problem} has no {key}")
        )

    def find(self, key: str) -> Graded | None:
        """The quantity of this key; None where there is none."""
        return next((one for one in self.quantities if one.key == key), None)

    def below(self, one: Graded) -> set[str]:
        """All that a quantity rests on."""
        found, todo = set[str](), list(one.needs)
        while todo:
            name = todo.pop()
            if name not in found:
                found.add(name)
                todo += self[name].needs
        return found

    @property
    def worth(self) -> float:
        """All points."""
        return sum(one.points.total for one in self.quantities) + sum(self.stated.values())

    def as_json(self) -> dict[str, Any]:
        """Plain data, to be read back by `from_json`."""
        data: dict[str, Any] = _adapter().dump_python(self, mode="json")
        return data

    @classmethod
    def from_json(cls, data: object) -> AnswerKey:
        """The key of such data. Raises VecpolyError where they are none."""
        try:
            return _adapter().validate_python(data)
        except ValidationError as error:
            where = ".".join(map(str, error.errors()[0]["loc"]))
            raise VecpolyError(
                Words(
                    f"这不是答案键：{where} 缺失或有误；请用 vecpoly 重新生成",
                    f"this is no answer key: {where} is missing or wrong; have vecpoly write it again",
                ),
                code="no-key",
                numbers={"path": where},
            ) from None


@cache
def _adapter() -> TypeAdapter[AnswerKey]:
    return TypeAdapter(AnswerKey)
