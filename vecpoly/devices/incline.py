"""A block on an inclined plane: a force drives it up, or holds it while its weight drives it down."""

from __future__ import annotations

from collections.abc import Collection
from math import atan, degrees, pi
from typing import ClassVar

from pydantic import model_validator

from ..errors import FaultError, LockedError
from ..names import Named, reaction
from ..words import Words
from .base import Angle, Device, ForceSize, Ratio, as_written


class Incline(Device):
    """α: slope of the plane (left out: the limit of self-locking, α = φ); β:
    of the force above the horizontal; Q: weight; f: friction."""

    kind: ClassVar[str] = "incline"
    f: Ratio
    beta: Angle
    Q: ForceSize
    alpha: Angle | None = None

    @model_validator(mode="after")
    def _possible(self) -> Incline:
        beta = degrees(self.beta.si)
        if self.alpha is not None and not 0 < self.alpha.si < pi / 2:
            raise FaultError(
                Words(
                    f"alpha = {self.alpha.text}：斜面倾角应在 0 与 90 deg 之间；求自锁极限时略去 alpha",
                    f"alpha = {self.alpha.text}: the slope must lie between 0 and 90 deg; leave it out for the "
                    "limit of self-locking",
                ),
                code="out-of-range",
                keys=("alpha",),
            )
        if self.alpha is None and self.f.si == 0:
            raise FaultError(
                Words(
                    "alpha：没有摩擦就没有自锁极限，不能由此得出倾角；如写 alpha: 24 deg",
                    "alpha: without friction there is no limit of self-locking to take the slope from; write "
                    "e.g. alpha: 24 deg",
                ),
                code="unknown-name",
                keys=("f", "alpha"),
            )
        if not -90 < beta < 90:
            raise FaultError(
                Words(
                    f"beta = {self.beta.text}：力应指向斜面，与水平方向成 −90 至 90 deg",
                    f"beta = {self.beta.text}: the force must point between −90 and 90 deg above the "
                    "horizontal, towards the slope",
                ),
                code="out-of-range",
                keys=("beta",),
            )
        return self

    def noted(self, asked: Collection[str]) -> tuple[Words, ...]:
        """That the slope is that of self-locking, where none is given and that limit is not asked."""
        if self.alpha is not None or LIMIT.key in asked:
            return ()
        slope = f"{degrees(self.slope):.4g}"
        return (
            Words(
                f"没有写倾角 alpha：斜面取自锁极限 α = φ = {slope}°；beta 是力与水平方向的夹角",
                f"no slope alpha is given: the plane stands at the limit of self-locking, α = φ = {slope}°; beta is "
                "the angle of the force above the horizontal",
            ),
        )

    @property
    def slope(self) -> float:
        """α in rad, as given or at the limit of self-locking."""
        return self.alpha.si if self.alpha is not None else atan(self.f.si)

    def task(self, asked: Collection[str]) -> Words:
        """A block that is driven up a plane."""
        slope = (
            Words("倾角为 $α$", "at the slope $α$")
            if self.alpha is not None
            else Words("倾角取自锁的极限角 $α_{lim}$", "at the limit $α_{lim}$ of self-locking")
        )
        return Words(
            f"重 $Q$ 的滑块 1 放在斜面 2 上，斜面{slope.zh}，摩擦系数为 $f$。力 $F$ 与水平方向成 $β$ 角（高于水平为"
            "正），使滑块等速上滑（正行程）；反行程中力 $F'$ 沿同一方向作用，滑块等速下滑。",
            f"Block 1 of weight $Q$ rests on the plane 2 {slope.en}; the coefficient of friction is $f$. A force $F$ "
            "at the angle $β$ above the horizontal drives it up steadily; on the return stroke a force $F'$ in the "
            "same line lets it slide down steadily.",
        )

    def quantities(self) -> tuple[Named, ...]:
        """φ, limit of α; up: F, F by formula, R_21, F without friction, η; down: F' that holds, η'."""
        return PHI, LIMIT, DRIVE, BY_SINES, REACTION, IDEAL, ETA, HOLD, ETA_BACK

    def given(self) -> tuple[tuple[str, str], ...]:
        """f, α where it is given, β, Q."""
        written = [("f", self.f), ("α", self.alpha), ("β", self.beta), ("Q", self.Q)]
        return as_written(written)

    @property
    def force(self) -> float:
        """The weight."""
        return self.Q.si

    def locked(self) -> LockedError:
        """What is said of a force that cannot drive the block up."""
        alpha, beta, phi = (degrees(angle) for angle in (self.slope, self.beta.si, atan(self.f.si)))
        return LockedError(
            Words(
                f"滑块自锁：力的方向 beta = {beta:g} deg，仅当 beta − alpha 在 phi − 90 = {phi - 90:.4g} deg 与 "
                f"phi + 90 = {phi + 90:.4g} deg 之间时才能使其上滑，而 alpha = {alpha:.4g} deg；请增大 beta，"
                "或减小 alpha 或摩擦",
                f"the block is self-locking: a force at beta = {beta:g} deg drives it up only where beta − "
                f"alpha lies between phi − 90 = {phi - 90:.4g} deg and phi + 90 = {phi + 90:.4g} deg, and alpha "
                f"= {alpha:.4g} deg; raise beta, or lower alpha or the friction",
            )
        )

    def stuck(self) -> LockedError:
        """What is said of a self-locking block that this force cannot even pull down."""
        alpha, beta, phi = (degrees(angle) for angle in (self.slope, self.beta.si, atan(self.f.si)))
        return LockedError(
            Words(
                f"滑块上下都自锁：phi = {phi:.4g} deg 时，沿 beta = {beta:g} deg 的力不能使其沿 alpha = "
                f"{alpha:.4g} deg 的斜面下滑，因为 beta − alpha 不小于 90 − phi = {90 - phi:.4g} deg；"
                "请减小 beta",
                f"the block is self-locking both ways: with phi = {phi:.4g} deg no force along beta = {beta:g} "
                f"deg moves it down a slope of alpha = {alpha:.4g} deg, for beta − alpha is not below 90 − phi "
                f"= {90 - phi:.4g} deg; choose a smaller beta",
            )
        )


PHI, LIMIT = Named("phi", "φ", "deg"), Named("alpha_limit", "α_{lim}", "deg")
DRIVE, BY_SINES, IDEAL, HOLD = (
    Named("F", "F", "N"),
    Named("F_sine", "F", "N"),
    Named("F_0", "F_{0}", "N"),
    Named("F_r", "F'", "N"),
)
REACTION = reaction("2", "1")
ETA, ETA_BACK = Named("eta", "η", ""), Named("eta_r", "η'", "")
