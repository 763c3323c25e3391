"""A ring-spring buffer: wedge 1, pushed towards wedge 4, spreads the side wedges 2 and 3 against the springs Q."""

from __future__ import annotations

from collections.abc import Collection
from math import atan, degrees
from typing import ClassVar

from pydantic import model_validator

from ..errors import FaultError, LockedError
from ..names import Named, reaction
from ..words import Words
from .base import Angle, Device, ForceSize, Ratio


class RingSpring(Device):
    """α: of the normals of all faces from the line of F (the faces from the direction of Q);
    f: friction; Q: on each side wedge."""

    kind: ClassVar[str] = "ring-spring"
    alpha: Angle
    f: Ratio
    Q: ForceSize

    @model_validator(mode="after")
    def _possible(self) -> RingSpring:
        if not 0 < degrees(self.alpha.si) < 90:
            raise FaultError(
                Words(
                    f"alpha = {self.alpha.text}：应在 0 与 90 deg 之间",
                    f"alpha = {self.alpha.text}: it must lie between 0 and 90 deg",
                ),
                code="out-of-range",
                keys=("alpha",),
            )
        return self

    def task(self, asked: Collection[str]) -> Words:
        """A wedge that spreads two others."""
        return Words(
            "缓冲器中，力 $F$ 压下楔块 1，把两侧楔块 2、3 撑开，弹簧以力 $Q$ 压住每个侧楔块，4 为机架。各斜面法线与 "
            "$F$ 的夹角为 $α$，摩擦系数为 $f$。压缩为正行程；回弹为反行程，此时 1 上的力为 $F'$。",
            "In a buffer the force $F$ pushes wedge 1 down and so spreads the side wedges 2 and 3, on each of which a "
            "spring presses with $Q$; 4 is the frame. The normals of all faces make the angle $α$ with $F$, the "
            "coefficient of friction is $f$. On the return stroke, the release, the force on wedge 1 is $F'$.",
        )

    def quantities(self) -> tuple[Named, ...]:
        """φ; pushing: R_21, R_42, F, F by formula, F without friction, η, least α;
        releasing: F', by formula, η', greatest α."""
        return PHI, *REACTIONS, DRIVE, BY_SINES, IDEAL, ETA, LEAST, HOLD, HOLD_BY_SINES, ETA_BACK, GREATEST

    def given(self) -> tuple[tuple[str, str], ...]:
        """α, f, Q."""
        return ("α", self.alpha.text), ("f", self.f.text), ("Q", self.Q.text)

    @property
    def force(self) -> float:
        """The springs' force."""
        return self.Q.si

    def locked(self) -> LockedError:
        """What is said of a buffer that cannot be pushed in."""
        return LockedError(
            Words(
                f"缓冲器自锁：alpha = {degrees(self.alpha.si):g} deg 应大于摩擦角 phi = "
                f"{degrees(atan(self.f.si)):.4g} deg，否则 F 不能撑开两侧楔块；请减小摩擦或增大 alpha",
                f"the buffer is self-locking: alpha = {degrees(self.alpha.si):g} deg must be greater than the "
                f"friction angle phi = {degrees(atan(self.f.si)):.4g} deg, or no force F spreads the side "
                "wedges; lower the friction or choose a larger alpha",
            )
        )


PHI = Named("phi", "φ", "deg")
REACTIONS = (reaction("2", "1"), reaction("4", "2"))
DRIVE, BY_SINES, IDEAL = Named("F", "F", "N"), Named("F_sine", "F", "N"), Named("F_0", "F_{0}", "N")
HOLD, HOLD_BY_SINES = Named("F_r", "F'", "N"), Named("F_r_sine", "F'", "N")
ETA, ETA_BACK = Named("eta", "η", ""), Named("eta_r", "η'", "")
LEAST, GREATEST = Named("alpha_min", "α_{min}", "deg"), Named("alpha_max", "α_{max}", "deg")
