"""Two wedges: wedge 1, pushed along an inclined guide, lifts wedge 2 in a vertical guide of the frame 3."""

from __future__ import annotations

from collections.abc import Collection
from math import degrees
from typing import ClassVar

from pydantic import model_validator

from ..errors import FaultError, LockedError
from ..names import Named, reaction
from ..words import Words
from .base import Angle, Device, ForceSize, Ratio, as_written

FACES = ("12", "13", "23")  # who presses on whom


class Wedges(Device):
    """α: guide of wedge 1 (and F, along it) from the vertical; β:
    face between the wedges from the vertical; Q: load on wedge 2.

    f: one coefficient of friction for all faces, or f12, f13, f23 for each.
    Motion: F pushes 1 up its guide, 2 rises against Q.
    """

    kind: ClassVar[str] = "wedges"
    alpha: Angle
    beta: Angle
    Q: ForceSize
    f: Ratio | None = None
    f12: Ratio | None = None
    f13: Ratio | None = None
    f23: Ratio | None = None

    @model_validator(mode="after")
    def _possible(self) -> Wedges:
        alpha, beta = degrees(self.alpha.si), degrees(self.beta.si)
        if not 0 < beta < 90:
            raise FaultError(
                Words(
                    f"beta = {self.beta.text}：两楔块的接触面与竖直方向的夹角应在 0 与 90 deg 之间",
                    f"beta = {self.beta.text}: the face between the wedges must lie between 0 and 90 deg from "
                    "the vertical",
                ),
                code="out-of-range",
                keys=("beta",),
            )
        if alpha <= 0 or alpha + beta >= 180 - 1e-9:
            raise FaultError(
                Words(
                    f"alpha = {self.alpha.text}，beta = {self.beta.text}：alpha 应大于 0，"
                    "且 alpha + beta 应小于 180 deg，否则楔块 1 没有楔角，不能顶起楔块 2",
                    f"alpha = {self.alpha.text}, beta = {self.beta.text}: alpha must be above 0 and alpha + "
                    "beta below 180 deg, or wedge 1 has no taper and cannot lift wedge 2",
                ),
                code="out-of-range",
                keys=("alpha", "beta"),
            )
        each = (self.f12, self.f13, self.f23)
        if (self.f is None) == (None in each) or (self.f is not None and any(each)):
            raise FaultError(
                Words(
                    "各接触面摩擦系数相同时写 f: 0.15，否则 f12、f13、f23 都要写",
                    "write f: 0.15 for all faces, or each of f12, f13 and f23",
                ),
                code="spelling",
                keys=("f", "f12", "f13", "f23"),
            )
        return self

    def friction(self, face: str) -> Ratio:
        """The coefficient of friction of a face: '12', '13' or '23'."""
        own: Ratio = self.f or getattr(self, f"f{face}")
        return own

    def angle(self, face: str) -> Named:
        """The friction angle of a face as a quantity."""
        return Named("phi", "φ", "deg") if self.f else Named(f"phi_{face}", f"φ_{{{face}}}", "deg")

    def task(self, asked: Collection[str]) -> Words:
        """A wedge that lifts another."""
        friction = (
            Words("各接触面的摩擦系数均为 $f$", "the coefficient of friction of all faces is $f$")
            if self.f
            else Words(
                "$f_{12}$、$f_{13}$、$f_{23}$ 为下标所指两构件间的摩擦系数",
                "$f_{12}$, $f_{13}$ and $f_{23}$ are the coefficients of friction between the links of the subscripts",
            )
        )
        return Words(
            "楔块 1 在力 $F$ 推动下沿与铅垂线成 $α$ 角的导路前进，把竖直导路中的楔块 2 顶起，2 上作用载荷 $Q$，3 为机"
            f"架；1、2 的接触面与铅垂线成 $β$ 角，{friction.zh}。反行程中 $Q$ 使 2 下降，$F'$ 为作用在 1 上的阻力。",
            "Pushed by $F$ along a guide at $α$ to the vertical, wedge 1 lifts wedge 2, which runs in a vertical guide "
            "and carries the load $Q$; 3 is the frame. The face between the wedges lies at $β$ to the vertical; "
            f"{friction.en}. On the return stroke $Q$ lowers wedge 2 against a force $F'$ on wedge 1.",
        )

    def quantities(self) -> tuple[Named, ...]:
        """φ, F measured and by the sine rule, F without friction, η, reactions;
        F' that holds, η' of the return stroke; limits of φ."""
        angles = dict.fromkeys(self.angle(face) for face in FACES)
        return (*angles, DRIVE, BY_SINES, IDEAL, ETA, *REACTIONS, HOLD, ETA_BACK, LOCK_DIRECT, LOCK_REVERSE)

    def given(self) -> tuple[tuple[str, str], ...]:
        """α, β, Q and the coefficients of friction."""
        fs = [("f", self.f)] if self.f else [(f"f_{{{face}}}", self.friction(face)) for face in FACES]
        written = [("α", self.alpha), ("β", self.beta), ("Q", self.Q), *fs]
        return as_written(written)

    @property
    def force(self) -> float:
        """The load."""
        return self.Q.si

    def locked(self, limit: float) -> LockedError:
        """What is said of a drive that cannot move; limit: the sum of friction angles that β must exceed (deg)."""
        return LockedError(
            Words(
                f"楔块机构自锁：beta = {degrees(self.beta.si):g} deg 应大于两摩擦角之和 phi_12 + phi_23 = "
                f"{limit:.4g} deg，否则 F 不能顶起 Q；请减小摩擦或增大 beta",
                f"the wedges are self-locking: beta = {degrees(self.beta.si):g} deg must be greater than the "
                f"friction angles phi_12 + phi_23 = {limit:.4g} deg, or no force F lifts Q; lower the friction "
                "or choose a larger beta",
            )
        )


DRIVE, BY_SINES, IDEAL = Named("F", "F", "N"), Named("F_sine", "F", "N"), Named("F_0", "F_{0}", "N")
HOLD, ETA, ETA_BACK = Named("F_r", "F'", "N"), Named("eta", "η", ""), Named("eta_r", "η'", "")
REACTIONS = (reaction("1", "2"), reaction("3", "2"), reaction("3", "1"))
LOCK_DIRECT, LOCK_REVERSE = Named("lock_direct", "φ_{lim}", "deg"), Named("lock_reverse", "φ'_{lim}", "deg")
