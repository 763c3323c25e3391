"""A function generator: three pairs of angles of both links on the frame, given or at Chebyshev's precision points."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from functools import partial
from math import cos, degrees, isclose
from typing import Any, ClassVar

import numpy as np
from pydantic import model_validator

from ...devices.base import Angle, Length
from ...errors import FaultError
from ...names import Named
from ...units.reading import Quantity
from ...words import Words
from ..base import Design
from ..inversion.built import posed_four_bar
from ..inversion.paired import of_pairs
from ..inversion.written import Corresponding, Pair
from ..quantities import FOUR_BAR
from ..ranged.datum import Datum, put, quantity
from .formula import Function, Number, Value
from .refusals import turns_alike

AHEAD_B, AHEAD_C = Named("delta_B", "δ_{B}", "deg"), Named("delta_C", "δ_{C}", "deg")
P0, P1, P2 = (Named(f"P_{n}", f"P_{n}", "") for n in range(3))  # of Freudenstein's equation
ERROR = Named("epsilon_max", "ε_{max}", "deg")  # greatest structural error over the range
LOOKED = 400  # parts of the range in none of which a function changes by more than over the whole of it
ALIKE = 1e-12  # of a cosine: angles that are one
_CURVE = ("x", "phi", "psi")


class FunctionGenerator(Design):
    """AD and three pairs φ of AB -> ψ of DC; or a function y = f(x), the range of x and those of φ and ψ.

    A is the origin, D on the x axis. AB is found on the line at φ, on either side of A (delta_B = 0 or 180°: a negative
    length in Freudenstein's equation), and so is DC.
    """

    kind: ClassVar[str] = "function-generator"
    AD: Length
    pairs: tuple[Corresponding, ...] | None = None
    function: Function | None = None
    x: tuple[Number, Number] | None = None
    phi: tuple[Angle, Angle] | None = None
    psi: tuple[Angle, Angle] | None = None

    @model_validator(mode="after")
    def _determined(self) -> FunctionGenerator:
        self.one_of("pairs", "function", example="[35 deg -> 50 deg, 80 deg -> 75 deg, 125 deg -> 105 deg]")
        given = [name for name in _CURVE if getattr(self, name) is not None]
        if (self.function is not None) != (len(given) == 3) or (self.function is None and given):
            raise FaultError(
                Words(
                    "函数须连同 x、phi、psi 的范围给定（三组对应角 pairs 则不要）；如写 x: [1, 2]、phi: [270 deg, 330 "
                    f"deg]、psi: [180 deg, 270 deg]；此处有：{'、'.join(given) or '无'}",
                    "a function needs the ranges x, phi and psi, three pairs have none; write e.g. x: [1, 2], "
                    f"phi: [270 deg, 330 deg], psi: [180 deg, 270 deg]; here are: {', '.join(given) or 'none'}",
                ),
                code="contradiction",
            )
        if self.function is None:
            self._three(self.pairs or ())
        else:
            self._ranges(self.function)
        found = [(pair.one, pair.two) for pair in self.pairs] if self.pairs else map(self.angles_at, (0.0, 0.3, 1.0))
        if all(isclose(cos(phi - psi), 1.0, rel_tol=ALIKE) for phi, psi in found):
            raise turns_alike()
        return self

    def _three(self, pairs: tuple[Pair, ...]) -> None:
        """Three pairs of angles, all different."""
        if len(pairs) != 3 or any(pair.slides for pair in pairs) or len({pair.one for pair in pairs}) < 3:
            raise FaultError(
                Words(
                    f"应给定三组不同的对应角，此处有 {len(pairs)} 组：{'、'.join(map(str, pairs))}",
                    f"three different pairs of angles are needed, and here are {len(pairs)}: "
                    f"{', '.join(map(str, pairs))}",
                ),
                "pairs",
                code="out-of-range",
            )

    def _ranges(self, function: Any) -> None:
        """Ranges of some extent, in which the function has a value."""
        assert self.x is not None and self.phi is not None and self.psi is not None
        ends = [self.y(at.si) for at in self.x]
        between = np.broadcast_to(self.y(self.x_at(np.arange(LOOKED + 1) / LOOKED)), LOOKED + 1)  # of a number, too
        jumps = float(np.abs(np.diff(between)).max()) > abs(ends[1] - ends[0])
        if not np.isfinite(between).all() or jumps or ends[0] == ends[1] or self.x[0].si == self.x[1].si:
            raise FaultError(
                Words(
                    f"函数 {function} 在 x = {self.x[0].text} 至 {self.x[1].text} 上应处处有值、没有跳跃，"
                    f"且两端的值不相等，此处两端为 {ends[0]:.6g} 和 {ends[1]:.6g}；请改动 x 或函数",
                    f"the function {function} must have values all the way from x = {self.x[0].text} to "
                    f"{self.x[1].text}, without a jump, different at both ends, and these are "
                    f"{ends[0]:.6g} and {ends[1]:.6g}; change x or the function",
                ),
                "x",
                code="out-of-range",
            )
        for name, (first, last) in (("phi", self.phi), ("psi", self.psi)):
            if not 0 < abs(degrees(last.si - first.si)) < 360:
                raise FaultError(
                    Words(
                        f"{name} 的范围 {first.text} 至 {last.text} 应大于 0 且小于 360°",
                        f"the range of {name}, {first.text} to {last.text}, must be above 0 and below 360 deg",
                    ),
                    name,
                    code="out-of-range",
                )

    # -- the function ----------------------------------------------------------------------------------------

    def y(self, x: Value) -> Value:
        """f(x)."""
        assert self.function is not None
        found = self.function(x)
        return float(found) if isinstance(found, float) else found

    def x_at(self, share: Value) -> Value:
        """x at this share of its range, 0 to 1."""
        assert self.x is not None
        return self.x[0].si + share * (self.x[1].si - self.x[0].si)

    def angles_at(self, share: Value) -> tuple[Value, Value]:
        """φ and the ψ that belongs to it (rad), at this share of the range."""
        assert self.x is not None and self.phi is not None and self.psi is not None
        low, high = (self.y(at.si) for at in self.x)
        of_y = (self.y(self.x_at(share)) - low) / (high - low)
        (phi, phi_end), (psi, psi_end) = self.phi, self.psi
        return phi.si + share * (phi_end.si - phi.si), psi.si + of_y * (psi_end.si - psi.si)

    # -- where the data had to lie ---------------------------------------------------------------------------

    def varied(self) -> Iterator[Datum[Design]]:
        """The angles of the output link; of a function the ends of both ranges."""
        if self.pairs is not None:
            yield from of_pairs(self, self.pairs)
        for name in ("psi", "phi"):
            if (ends := getattr(self, name)) is not None:
                yield Datum(
                    name=Words(f"{name} 的终值", f"the end of {name}"),
                    unit="deg",
                    value=ends[1].si,
                    put=partial(self._ending, name, ends[0]),
                )

    def _ending(self, name: str, start: Quantity, end: float) -> Design:
        return put(self, {name: (start, quantity(end))})

    # -- as every design ------------------------------------------------------------------------------------

    def task(self, asked: Collection[str]) -> Words:
        """Pairs of angles, or a function."""
        zeros = Words("", "")
        if {AHEAD_B.key, AHEAD_C.key} & {*asked}:
            zeros = Words(
                "；$δ_B$、$δ_C$ 为 $AB$、$DC$ 超前其标线（角 $φ$、$ψ$ 所指）的角，逆时针为正",
                "; $δ_B$ and $δ_C$ are the angles by which $AB$ and $DC$ are ahead of the lines at $φ$ and $ψ$, "
                "counter-clockwise positive",
            )
        checked = _FREUDENSTEIN if {P0.key, P1.key, P2.key} & {*asked} else Words("", "")
        what = _CORRESPONDING if self.pairs is not None else _APPROXIMATE
        return _LINKAGE + what + zeros + checked + Words("。", ".")

    def quantities(self) -> tuple[Named, ...]:
        """The lengths, on which side of the pivots the pins lie, Freudenstein's numbers; of a function the error."""
        return (*FOUR_BAR, AHEAD_B, AHEAD_C, P0, P1, P2, *((ERROR,) if self.function is not None else ()))

    def given(self) -> tuple[tuple[str, str], ...]:
        """The frame; the pairs, or the function and the ranges."""
        frame = (("l_{AD}", self.AD.text),)
        if self.pairs is not None:
            return (*frame, *((f"φ_{{{n}}}", pair.text) for n, pair in enumerate(self.pairs, 1)))
        ranges = (("x", self.x), ("φ", self.phi), ("ψ", self.psi))
        told = tuple((symbol, f"{ends[0].text} … {ends[1].text}") for symbol, ends in ranges if ends is not None)
        return (*frame, ("y", str(self.function)), *told)

    def built(self, values: Mapping[str, float]) -> dict[str, Any]:
        """The linkage in the position of the first pair, or at the beginning of the range."""
        phi, psi = (self.pairs[0].one, self.pairs[0].two) if self.pairs else self.angles_at(0.0)
        turned = degrees(phi) + values[AHEAD_B.key], degrees(psi) + values[AHEAD_C.key]
        return posed_four_bar(values, *turned, 0.0, self.omega)

    @property
    def size(self) -> float:
        """The frame."""
        return 2 * self.AD.si


_LINKAGE = Words(
    "设计铰链四杆机构 $ABCD$，$A$ 为原点，机架 $AD$ 在 $x$ 轴上；两连架杆 $AB$、$DC$ 的转角 $φ$、$ψ$ 自 $x$ 轴逆时针"
    "量起，",
    "Design a four-bar linkage $ABCD$ with $A$ in the origin and the frame $AD$ on the $x$ axis; the angles $φ$ of "
    "$AB$ and $ψ$ of $DC$ count counter-clockwise from the $x$ axis, ",
)
_CORRESPONDING = Words(
    "$φ_i$ 后为相应的 $ψ_i$，共三组对应角", "and behind each of the three $φ_i$ stands the $ψ_i$ that belongs to it"
)
_APPROXIMATE = Words(
    "在给定范围内，$φ$ 与 $x$、$ψ$ 与 $y$ 成正比，使机构近似地实现函数 $y$；取三个切比雪夫精确点",
    "and over the given ranges $φ$ goes with $x$ and $ψ$ with $y$, so that the linkage approximates the function "
    "$y$; take three Chebyshev precision points",
)
_FREUDENSTEIN = Words(
    "；以弗洛伊登斯坦方程 $cos φ$ = $P_0 cos ψ$ + $P_1 cos(ψ − φ)$ + $P_2$ 校核",
    "; check it by Freudenstein's equation $cos φ$ = $P_0 cos ψ$ + $P_1 cos(ψ − φ)$ + $P_2$",
)
