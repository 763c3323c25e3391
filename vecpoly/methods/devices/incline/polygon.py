"""The force polygon of a block on an inclined plane: up, without friction and down, on the common side Q."""

from __future__ import annotations

from dataclasses import dataclass

from ....algebra.quantity import Of, Quantity, magnitude
from ....board.construction import Pane, View
from ....devices.incline import BY_SINES, DRIVE, ETA, ETA_BACK, HOLD, IDEAL, REACTION, Incline
from ....names import Named
from ....plane import Points, nominal
from ....vector.equation import Term
from ....words import Words
from ..bench import Bench
from ..equilibrium import (
    ALONG_N,
    OFF_N,
    drawn,
    driven,
    frictionless,
    given,
    letter,
    points_along,
    reversed_way,
    signed,
    sought,
)
from ..inclined import angle, between, leaned

WEIGHT = Named("Q", "Q", "N")
ALONG_F = Words("与水平成 $β$", "$β$ to horizontal")


@dataclass(frozen=True, slots=True, kw_only=True)
class Slope:
    """The plane: its angle and the friction angle (deg), unit vectors up the plane and along F."""

    alpha: Quantity
    phi: Quantity
    along: Points
    force: Points

    @property
    def normal(self) -> Points:
        """Into the block."""
        return 1j * self.along

    @property
    def up(self) -> Points:
        """The reaction while the block is driven up."""
        return leaned(self.normal, self.along, self.phi.value)

    @property
    def down(self) -> Points:
        """The reaction while the block slides down."""
        return leaned(self.normal, -self.along, self.phi.value)


def draw_polygon(bench: Bench, device: Incline, it: Slope) -> None:
    """Q = ab for all three; F, F_0, F' from b on one line, and the reactions back to a."""
    place = bench.board.open_pane(View.FORCE, "", Words("力多边形", "Force polygon"))
    b, drive = _up(bench, device, place, it)
    ideal = _ideal(bench, device, place, it, b, drive)
    _back(bench, device, place, it, b, ideal)


def _up(bench: Bench, device: Incline, place: Pane, it: Slope) -> tuple[Points, Quantity]:
    """Q + F + R = 0 with friction; gives the corner b and F."""
    bench.board.step(
        Words(
            "按 $μ_F$ 作力多边形：$ab$ 代表 $Q$，过 $b$ 作 $F$ 的方向线，过 $a$ 作 $R_21$ 的方向线，交于 $c$。",
            "Draw the force polygon to the scale $μ_F$: $ab$ stands for $Q$; the direction of $F$ "
            "through $b$ and that of $R_21$ through $a$ meet at $c$.",
        ),
        place,
    )
    weight = given(bench, place, WEIGHT, device.Q.si, -1j, "b")
    b, c = _closed(bench, device, place, weight, (DRIVE, it.force), (REACTION, it.up), "c")
    drive = bench.measured(DRIVE, place, b, c, "b c")
    bench.measured(REACTION, place, c, 0j, "c a")
    _by_sines(bench, device, it)
    return b, drive


def _ideal(bench: Bench, device: Incline, place: Pane, it: Slope, b: Points, drive: Quantity) -> Quantity:
    """The same without friction, and η = F_0 / F."""
    bench.board.step(
        Words(
            "设无摩擦，反力沿法线：过 $a$ 作平行于 $n$ 的直线，交 $F$ 的方向线于 $c_0$。正行程效率等于理想驱动力与"
            "实际驱动力之比。",
            "Without friction the reaction is normal: the parallel to $n$ through $a$ meets the "
            "line of $F$ at $c_0$. The efficiency is the ratio of the ideal to the actual driving "
            "force.",
        ),
        place,
    )
    normal = frictionless(REACTION), it.normal
    _, c = _closed(bench, device, place, drawn(WEIGHT, b), (IDEAL, it.force), normal, "c_0")
    ideal = bench.measured(IDEAL, place, b, c, "b c_0")
    bench.worked(ETA, ideal / drive)
    _eta_by_formula(bench, device, it)
    return ideal


def _back(bench: Bench, device: Incline, place: Pane, it: Slope, b: Points, ideal: Quantity) -> None:
    """The same on the return stroke, with the friction angle on either side, and η' = F' / F_0."""
    bench.board.step(
        Words(
            "反行程：$Q$ 为驱动力，滑块下滑，$R'_21$ 偏到法线的另一侧，过 $a$ 作其方向线，交 $F$ 的方向线于 $c'$；"
            "$F'$ 为使滑块匀速下滑所需的阻力。反行程效率等于实际阻力与理想阻力之比。",
            "Return stroke: $Q$ drives and $R'_21$ is turned to the other side of the normal; its "
            "direction through $a$ meets the line of $F$ at $c'$. The force $F'$ is the resistance with "
            "which the block slides down uniformly; the efficiency is the ratio of the actual to "
            "the ideal resistance.",
        ),
        place,
    )
    leaning = reversed_way(REACTION), it.down
    _, c = _closed(bench, device, place, drawn(WEIGHT, b), (HOLD, it.force), leaning, "c'")
    between(bench, place, 0j, -it.normal, -it.up, 30.0, "φ")
    between(bench, place, 0j, -it.normal, -it.down, 30.0, "φ")
    hold = signed(bench, HOLD, place, (b, c), it.force, "b c'")
    bench.worked(ETA_BACK, hold / ideal)
    _told_back(bench, device, float(nominal(hold.value)))


def _closed(
    bench: Bench,
    device: Incline,
    place: Pane,
    weight: Term,
    drive: tuple[Named, Points],
    reaction: tuple[Named, Points],
    corner: str,
) -> tuple[Points, Points]:
    """Q + F + R = 0; gives the corners b and c.
    Raises LockedError where the reaction, or a driving force, would have to pull."""
    named, drives = drive[0], drive[0] is not HOLD
    terms = weight, sought(*drive, ALONG_F), sought(*reaction, ALONG_N if named is IDEAL else OFF_N)
    refusal = device.locked if drives else device.stuck
    closed = driven(bench, place, 0j, terms, refusal, must_press=drives)
    if not points_along(closed, terms[2]):
        raise refusal()
    b, c = closed.ends[named.key]
    letter(bench, place, {"a": 0j, corner: c})
    return b, c


def _by_sines(bench: Bench, device: Incline, it: Slope) -> None:
    alpha, phi, beta = it.alpha, it.phi, angle("β", device.beta.si)
    bench.board.step(
        Words(
            "用正弦定理核对：三角形 $abc$ 中，$∠a = α + φ$，$∠c = 90° + β − α − φ$，故：",
            "Check by the sine rule: in the triangle $abc$ the angles are $∠a = α + φ$ and "
            "$∠c = 90° + β − α − φ$, so that:",
        )
    )
    bench.worked(BY_SINES, magnitude("Q", device.Q.si, "N") * Of("sin", alpha + phi) / Of("cos", beta - alpha - phi))


def _eta_by_formula(bench: Bench, device: Incline, it: Slope) -> None:
    """F_0 is F at φ = 0: η = sin α cos(β − α − φ) / (sin(α + φ) cos(β − α))."""
    alpha, phi, beta = it.alpha, it.phi, angle("β", device.beta.si)
    bench.board.remark(
        Words(
            "在 $F$ 的公式中令 $φ$ = 0 得 $F_0$，用公式核对。",
            " The formula for $F$ gives $F_0$ at $φ$ = 0, and so a check:",
        )
    )
    bench.board.compute(
        "η", Of("sin", alpha) * Of("cos", beta - alpha - phi) / (Of("sin", alpha + phi) * Of("cos", beta - alpha)), ""
    )


def _told_back(bench: Bench, device: Incline, hold: float) -> None:
    """Whether the return stroke is self-locking, from the sign of F'."""
    nothing = 1e-9 * device.Q.si
    if abs(hold) <= nothing:
        bench.board.remark(
            Words("本题 $F'$ = 0，$η'$ = 0，恰为自锁的极限。", " Here $F'$ = $η'$ = 0: the limit of self-locking.")
        )
    elif hold < 0:
        bench.board.remark(
            Words(
                "本题 $F'$ < 0，$η'$ < 0：反行程自锁，须反向施力才能使滑块下滑，与 $α < φ$ 一致。",
                " Here $F'$ < 0 and $η'$ < 0: the return stroke is self-locking, the block "
                "must be pulled down, as $α < φ$ says.",
            )
        )
    else:
        bench.board.remark(
            Words(
                "本题 $F'$ > 0，$η'$ > 0：反行程不自锁，与 $α > φ$ 一致。",
                " Here $F'$ > 0 and $η'$ > 0: the return stroke is not self-locking, as $α > φ$ says.",
            )
        )
