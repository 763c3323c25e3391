"""A crank-rocker from its time ratio K, its rocker, and one datum more."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from math import degrees, isclose, pi, radians
from typing import Any, ClassVar, Literal

from pydantic import model_validator

from ..devices.base import Angle, Length, as_written
from ..devices.defined import sentence
from ..errors import FaultError
from ..foundation.bounds import ROUNDED
from ..names import Named
from ..words import Words
from .base import Advance, Design, between_limits
from .inversion.written import said
from .linkages import four_bar
from .place import Carried, carried
from .quantities import AB, AD, BC, FOUR_BAR, GAMMA_MIN, RETURN, SWING, THETA
from .quantities import K as ADVANCE

_ONE_MORE = ("AD", "AB", "BC", "gamma_min", "A", "best")

LEAST = radians(0.5)  # a given γ_min: where it is less, A all but coincides with C₁, and force is hardly transmitted
NEAREST = 2e-6  # of C₁C₂: no A nearer to C₁ is sought by trial; γ_min is less than LEAST there, as AC₁ > γ² C₁C₂/16
_VARIED = (AD, AB, BC, GAMMA_MIN, Named("A", "A", "mm"), Named("ADC", "∠ADC", "deg"), ADVANCE)


class CrankRocker(Design):
    """K and CD; then the swing and one of AD, AB, BC, gamma_min, A (a line), best; or ADC in a limit position, and AD.

    With the swing D is the origin and the limit positions lie evenly beside the y axis; with ADC A is the origin, D
    lies on the x axis.
    """

    ranged: ClassVar[tuple[Named, ...]] = _VARIED
    kind: ClassVar[str] = "crank-rocker"
    K: Advance
    CD: Length
    swing: Angle | None = None
    ADC: Angle | None = None
    AD: Length | None = None
    AB: Length | None = None
    BC: Length | None = None
    gamma_min: Angle | None = None
    A: Carried | None = None
    best: Literal["gamma_min"] | None = None

    @model_validator(mode="after")
    def _determined(self) -> CrankRocker:
        if (self.swing is None) == (self.ADC is None):
            raise FaultError(
                Words(
                    "摇杆的极限位置应由 swing（摆角）或 ADC（一个极限位置的 ∠ADC）之一给定；如写 swing: 50 deg",
                    "the limit positions of the rocker follow from either swing, or ADC in one of them; "
                    "write e.g. swing: 50 deg",
                ),
                code="contradiction",
            )
        wanted = len(_ONE_MORE) if self.swing is not None else 1  # with ADC only AD
        self.one_of(*_ONE_MORE[:wanted], never=_ONE_MORE[wanted:])
        self._angles()
        self._one_pivot()
        return self

    def _one_pivot(self) -> None:
        """AD tells where A is: not so where the circle of A lies about D, ψ = 2θ, and AD is its radius."""
        if self.swing is None or self.AD is None or not isclose(self.AD.si, self.CD.si, rel_tol=ROUNDED):
            return
        if isclose(self.swing.si, 2 * self.theta, rel_tol=ROUNDED):
            raise FaultError(
                Words(
                    "ψ = 2θ，A 所在的圆以 D 为圆心、CD 为半径；AD = CD 时圆上各点都合适，AD 不能确定 A，"
                    "请改为给定 AB、BC 或 gamma_min",
                    "ψ = 2θ, so the circle of A lies about D with the radius CD: with AD = CD every A on it will do, "
                    "and AD does not tell which; give AB, BC or gamma_min instead",
                ),
                code="undetermined",
            )

    def _angles(self) -> None:
        """Each angle in the range in which there is a rocker."""
        for name, angle, least, most in (
            ("swing", self.swing, 0.0, pi),
            ("ADC", self.ADC, 0.0, pi),
            ("gamma_min", self.gamma_min, LEAST, pi / 2),
        ):
            if angle is not None and not (0 < angle.si < most and angle.si >= least):
                raise FaultError(
                    Words(
                        f"{name} = {angle.text}：应在 {degrees(least):g} 与 {degrees(most):g}° 之间",
                        f"{name} = {angle.text} must lie between {degrees(least):g} and {degrees(most):g} deg",
                    ),
                    code="out-of-range",
                    numbers={name: angle.si},
                )

    def task(self, asked: Collection[str]) -> Words:
        """A crank-rocker from its time ratio."""
        return sentence(
            Words(
                "设计曲柄摇杆机构 $ABCD$：曲柄 $AB$ 为原动件，$BC$ 为连杆，$CD$ 为摇杆，$AD$ 为机架",
                "design a crank-rocker $ABCD$ with the driving crank $AB$, the coupler $BC$, the rocker $CD$ and the "
                "frame $AD$",
            ),
            RETURN + Words("已知", " is given"),
            *self._more(),
        )

    def _more(self) -> Iterator[Words]:
        """What is given of the rocker's limits, and beside."""
        if self.swing is not None:
            yield Words("摇杆的摆角为 $ψ$", "the rocker swings by $ψ$")
        if self.ADC is not None:
            yield Words(
                "$∠ADC$ 为摇杆在一个极限位置与机架的夹角",
                "$∠ADC$ is the angle of frame and rocker in one limit position",
            )
        if self.gamma_min is not None:
            yield Words("最小传动角为 $γ_{min}$", "the minimum transmission angle is $γ_{min}$")
        if self.best is not None:
            yield Words("使最小传动角 $γ_{min}$ 最大", "its minimum transmission angle $γ_{min}$ is to be greatest")
        if self.A is not None:
            yield _ORIGIN + carried("A", self.A)

    def quantities(self) -> tuple[Named, ...]:
        """θ, the four lengths, swing and least transmission angle, K."""
        return (THETA, *FOUR_BAR, SWING, GAMMA_MIN, ADVANCE)

    def given(self) -> tuple[tuple[str, str], ...]:
        """K, the rocker, its limits, and what is given beside."""
        written = (
            ("K", self.K),
            ("l_{CD}", self.CD),
            ("ψ", self.swing),
            ("∠ADC", self.ADC),
            ("l_{AD}", self.AD),
            ("l_{AB}", self.AB),
            ("l_{BC}", self.BC),
            ("γ_{min}", self.gamma_min),
        )
        return (*as_written(written), *((said("A", self.A),) if self.A is not None else ()))

    def built(self, values: Mapping[str, float]) -> dict[str, Any]:
        """The four-bar with A in the origin and D on the x axis."""
        return four_bar(values, self.omega)

    @property
    def theta(self) -> float:
        """θ = π (K − 1) / (K + 1), rad."""
        return between_limits(self.K)

    @property
    def size(self) -> float:
        """The rocker."""
        return 2 * self.CD.si


_ORIGIN = Words(
    "$D$ 为坐标原点，摇杆的两极限位置对称于 $y$ 轴，",
    "$D$ is the origin, the limit positions lie evenly beside the $y$ axis, and ",
)
