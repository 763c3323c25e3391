"""A screw jack: a thread lifts the load, a ring-shaped collar under the head rubs as it turns, a lever turns it."""

from __future__ import annotations

from collections.abc import Collection
from math import atan, cos, degrees, pi
from typing import ClassVar

from pydantic import Field, model_validator

from ..errors import FaultError
from ..names import Named
from ..words import Words
from .base import Angle, Device, ForceSize, Length, Ratio, as_written


class ScrewJack(Device):
    """d, d1: outer and root diameter of the thread; p: pitch; starts:
    number of threads; D, d0: diameters of the collar's ring; l: lever.

    f: one coefficient of friction, or f_thread and f_collar; beta: half the flank angle of a V-thread (square thread:
    left out). Q the load, or F the force on the lever: the other is sought.
    """

    kind: ClassVar[str] = "screw-jack"
    d: Length
    d1: Length
    p: Length
    starts: int = Field(default=1, ge=1, le=12)
    D: Length
    d0: Length
    lever: Length = Field(alias="l")
    f: Ratio | None = None
    f_thread: Ratio | None = None
    f_collar: Ratio | None = None
    beta: Angle | None = None
    Q: ForceSize | None = None
    F: ForceSize | None = None

    @model_validator(mode="after")
    def _possible(self) -> ScrewJack:
        self._check_sizes()
        self._check_given()
        self._check_slope()
        return self

    def _check_sizes(self) -> None:
        """Outer diameters are greater than inner ones."""
        if self.d.si <= self.d1.si:
            raise FaultError(
                Words(
                    f"d = {self.d.text} 是螺纹大径，必须大于小径 d1 = {self.d1.text}",
                    f"d = {self.d.text} is the outer diameter of the thread and must be greater than the root "
                    f"diameter d1 = {self.d1.text}",
                ),
                code="out-of-range",
                keys=("d", "d1"),
            )
        if self.D.si <= self.d0.si:
            raise FaultError(
                Words(
                    f"D = {self.D.text} 是支承环面外径，必须大于内径 d0 = {self.d0.text}",
                    f"D = {self.D.text} is the outer diameter of the collar and must be greater than the inner "
                    f"diameter d0 = {self.d0.text}",
                ),
                code="out-of-range",
                keys=("D", "d0"),
            )

    def _check_given(self) -> None:
        """Neither too little nor too much is given: coefficients of friction, load or force."""
        if (self.f is None) != (self.f_thread is not None and self.f_collar is not None) or (
            self.f and (self.f_thread or self.f_collar)
        ):
            raise FaultError(
                Words(
                    "螺纹与支承面的摩擦系数相同时写 f: 0.1，否则 f_thread 和 f_collar 都要写",
                    "write f: 0.1 for thread and collar, or both f_thread and f_collar",
                ),
                code="spelling",
                keys=("f", "f_thread", "f_collar"),
            )
        if (self.Q is None) == (self.F is None):
            raise FaultError(
                Words(
                    "载荷 Q 与手柄力 F 只给一个，另一个为所求",
                    "give the load Q or the force F on the lever, and not both: the other one is sought",
                ),
                code="contradiction",
                keys=("Q", "F"),
            )

    def _check_slope(self) -> None:
        """The flanks are those of a V-thread, and the thread can be turned at all."""
        if self.beta is not None and not 0 < self.beta.si < pi / 3:
            raise FaultError(
                Words(
                    f"beta = {self.beta.text}：三角形螺纹的牙侧角（半牙型角）应在 0 与 60 deg 之间；矩形螺纹略去 beta",
                    f"beta = {self.beta.text}: half the flank angle of a V-thread lies between 0 and 60 deg; "
                    "leave it out for a square thread",
                ),
                code="out-of-range",
                keys=("beta",),
            )
        if self.alpha + self.phi >= pi / 2 - 1e-9:
            raise FaultError(
                Words(
                    f"螺纹升角 {degrees(self.alpha):.4g} deg 与摩擦角 {degrees(self.phi):.4g} deg 之和达到或超过"
                    " 90 deg，任何力矩都不能转动此螺旋；请减小螺距 p 或摩擦系数 f",
                    f"the lead angle {degrees(self.alpha):.4g} deg and the friction angle "
                    f"{degrees(self.phi):.4g} deg of the thread add up to 90 deg or more: no moment turns this "
                    "screw; take a smaller pitch p or a lower f",
                ),
                keys=("p", "d", "d1", "f", "f_thread"),
            )

    @property
    def thread(self) -> Ratio:
        """The coefficient of friction of the thread."""
        chosen = self.f or self.f_thread
        assert chosen is not None
        return chosen

    @property
    def collar(self) -> Ratio:
        """The coefficient of friction of the collar."""
        chosen = self.f or self.f_collar
        assert chosen is not None
        return chosen

    @property
    def alpha(self) -> float:
        """The lead angle at the mean diameter (rad), for checking the data."""
        return atan(self.starts * self.p.si / (pi * (self.d.si + self.d1.si) / 2))

    @property
    def phi(self) -> float:
        """The friction angle of the thread (rad), for checking the data."""
        return atan(self.thread.si / (cos(self.beta.si) if self.beta else 1.0))

    @property
    def trial(self) -> float:
        """The load (N) for which the force polygon is drawn:
        the load itself, or where it is sought a round one, all forces being proportional."""
        return self.Q.si if self.Q else 1000.0

    def task(self, asked: Collection[str]) -> Words:
        """A screw under a load on a collar."""
        return Words(
            f"螺旋千斤顶采用{_THREADS[self.beta is not None].zh}，{_starts(self.starts).zh}，大径 $d$，小径 $d_1$，螺"
            f"距 $p$；载荷 $Q$ 由外径 $D$、内径 $d_0$ 的环面支承，手柄长 $l$，端部作用力 $F$；{self._friction.zh}。螺"
            "纹按平均直径 $d_2$ 计算。",
            f"A screw jack has {_THREADS[self.beta is not None].en}, {_starts(self.starts).en}, outer diameter $d$, "
            "root diameter $d_1$ and pitch $p$. The load $Q$ rests on a ring with the diameters $D$ and $d_0$; the "
            f"lever is $l$ long, and $F$ acts at its end; {self._friction.en}. The thread is reckoned at its mean "
            "diameter $d_2$.",
        )

    def told(self) -> tuple[Words, ...]:
        """The load for which the force polygon is drawn, where the load itself is sought."""
        if self.Q is not None:
            return ()
        trial = f"$Q_1$ = {self.trial:g} N"
        return (Words(f"力多边形按试取的载荷 {trial} 作出", f"the force polygon is drawn for a trial load {trial}"),)

    @property
    def _friction(self) -> Words:
        if self.f is not None:
            return Words(
                "螺纹与环面的摩擦系数均为 $f$", "the coefficient of friction of the thread and of the ring is $f$"
            )
        return Words(
            "螺纹的摩擦系数为 $f_s$，环面的摩擦系数为 $f_c$",
            "the coefficient of friction is $f_s$ in the thread and $f_c$ on the ring",
        )

    def quantities(self) -> tuple[Named, ...]:
        """Angles; moments over Q; efficiencies; F or Q; moments; the return stroke."""
        sought = LOAD if self.Q is None else DRIVE
        return (
            PHI_V if self.beta else PHI,
            TAN_ALPHA,
            ALPHA,
            *RATIOS,
            ETA,
            ETA_THREAD,
            sought,
            *MOMENTS,
            SELF_LOCKING,
            BACK,
            ETA_BACK,
        )

    def given(self) -> tuple[tuple[str, str], ...]:
        """Diameters, pitch, lever, friction and the load or the force."""
        written = [
            ("d", self.d),
            ("d_1", self.d1),
            ("p", self.p),
            ("β", self.beta),
            ("D", self.D),
            ("d_0", self.d0),
            ("l", self.lever),
            ("f", self.f),
            ("f_s", self.f_thread),
            ("f_c", self.f_collar),
            ("Q", self.Q),
            ("F", self.F),
        ]
        found = as_written(written)
        return (*found[:3], *((("n", str(self.starts)),) if self.starts > 1 else ()), *found[3:])

    @property
    def size(self) -> float:
        """The unrolled thread."""
        return pi * self.d.si

    @property
    def force(self) -> float:
        """The load of the polygon."""
        return self.trial


PHI, PHI_V = Named("phi", "φ", "deg"), Named("phi", "φ_v", "deg")
ALPHA, TAN_ALPHA = Named("alpha", "α", "deg"), Named("tan_alpha", "tan α", "")
RATIOS = (
    Named("M1_over_Q", "M_1/Q", "mm"),
    Named("M2_over_Q", "M_2/Q", "mm"),
    Named("M_over_Q", "M/Q", "mm"),
    Named("M0_over_Q", "M_0/Q", "mm"),
)
MOMENTS = (Named("M1", "M_1", "N·m"), Named("M2", "M_2", "N·m"), Named("M", "M", "N·m"), Named("M0", "M_0", "N·m"))
LOAD, DRIVE = Named("Q", "Q", "N"), Named("F", "F", "N")
ETA, ETA_THREAD, ETA_BACK = Named("eta", "η", ""), Named("eta_thread", "η_s", ""), Named("eta_r", "η′", "")
SELF_LOCKING = Named("self_locking", "α ≤ φ", "yes/no")
BACK = Named("M_r_over_Q", "M′/Q", "mm")


_THREADS = {
    False: Words("矩形螺纹", "a square thread"),
    True: Words("牙侧角为 $β$ 的三角形螺纹", "a V-thread with flanks at $β$ to the plane across the axis"),
}


def _starts(count: int) -> Words:
    return Words("单线", "one start") if count == 1 else Words("$n$ 线", "$n$ starts")
