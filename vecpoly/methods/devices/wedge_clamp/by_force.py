"""Self-locking of a clamping wedge by the force that holds it: none is needed where F' ≤ 0."""

from __future__ import annotations

from ....algebra.quantity import Of, Quantity, Times, magnitude
from ....board.construction import Pane, View
from ....devices.wedge_clamp import BY_SINES, CLAMP, HOLD, IDEAL, PRESSED, WedgeClamp
from ....names import Named
from ....plane import Line, Points, lines_meet, nominal
from ....words import Words
from ..bench import Bench
from ..equilibrium import ALONG_N, OFF_N, balance, frictionless, given, letter, signed, sought
from ..inclined import Press, angle, body, concur, leaned, press, pull
from .shape import LENGTH, OUT, corners

ALONG_BASE = Words("∥底面", "∥ base")


def by_force(bench: Bench, device: WedgeClamp, slope: Points, phi: Quantity) -> Quantity:
    """The force F' that keeps the wedge in, off the polygon and by the sine rule: self-locking where F' ≤ 0."""
    board = bench.board
    board.section(Words("方法二：由阻止退出所需的力", "Method 2: the force that holds the wedge"))
    along = leaned(-1j * slope, OUT * slope, phi.value), leaned(1j, OUT, phi.value)
    _wedge_apart(bench, slope, *along)
    polygon, b, c = wedge_polygon(bench, device, HOLD, along, Words.same(""))
    bench.measured(PRESSED, polygon, b, c, "b c")
    hold = signed(bench, HOLD, polygon, (c, 0j), 1 + 0j, "c a")
    board.step(
        Words(
            "用正弦定理核对：三角形 $abc$ 中 $∠b = α − 2φ$，$∠c = 90° + φ$。$F' ≤ 0$ 时不需外力，楔块自锁，"
            "由此也得 $α ≤ 2φ$。",
            "Check by the sine rule: in the triangle $abc$ the angles are $∠b = α − 2φ$ and $∠c = "
            "90° + φ$. Where $F' ≤ 0$ no force is needed and the wedge is self-locking: again $α "
            "≤ 2φ$.",
        )
    )
    bench.worked(
        BY_SINES,
        magnitude("R_23", device.R.si, "N") * Of("sin", angle("α", device.alpha.si) - Times(2, phi)) / Of("cos", phi),
    )
    _verdict(bench, float(nominal(hold.value)) <= 1e-9 * device.R.si)
    return hold


def _wedge_apart(bench: Bench, slope: Points, high: Points, low: Points) -> None:
    """Wedge 3 slipping out under its reactions, above and below."""
    place = bench.board.open_pane(View.BODY, "3", Words("楔块 3 受力图（退出）", "Free body of wedge 3, slipping out"))
    bench.board.step(
        Words(
            "设楔块向左退出，$F'$ 为阻止其退出所需的力。楔块相对 1、2 的速度 $v_31$、$v_32$ 均向左，故 $R_13$、"
            "$R_23$ 都自法线 $n$ 向右偏转 $φ$。$R_23$ 已知，$R_13$、$F'$ 只有大小未知；三力汇交于一点。",
            "Let the wedge slip out to the left, and let $F'$ be the force that stops it. It "
            "slides to the left on 1 and on 2 ($v_31$, $v_32$), so both reactions are turned to "
            "the right of the normals $n$ by $φ$. The reaction $R_23$ is known, of $R_13$ and $F'$ only the "
            "magnitudes are unknown; the three forces are concurrent.",
        ),
        place,
    )
    it = corners(slope)
    body(bench, place, "link 3", *it)
    over = it[2] - slope * LENGTH * 0.55
    back = complex(0, it[3].imag / 2)
    meeting = lines_meet(Line(over, high), Line(back, 1 + 0j))
    under = lines_meet(Line(meeting, low), Line(0j, 1 + 0j))
    press(
        bench,
        place,
        Press(symbol=CLAMP.symbol, at=over, normal=-1j * slope, along=high, slides=OUT * slope, speed="v_{32}"),
    )
    press(bench, place, Press(symbol=PRESSED.symbol, at=under, normal=1j, along=low, slides=OUT, speed="v_{31}"))
    pull(bench, place, back, 1 + 0j, HOLD.symbol)
    concur(bench, place, meeting, over, under, back)


def _verdict(bench: Bench, locked: bool) -> None:
    """Whether the wedge stays in by itself."""
    if locked:
        bench.board.remark(
            Words(
                "本题 $F' ≤ 0$，楔块自锁，须反向施力才能拔出。",
                " Here $F' ≤ 0$: the wedge is self-locking and must be pulled out.",
            )
        )
    else:
        bench.board.remark(
            Words(
                "本题 $F' > 0$，楔块不自锁，须加 $F'$ 才能保持夹紧。",
                " Here $F' > 0$: the wedge is not self-locking and $F'$ must hold it in.",
            )
        )


def wedge_polygon(
    bench: Bench, device: WedgeClamp, drive: Named, along: tuple[Points, Points], lead: Words
) -> tuple[Pane, Points, Points]:
    """R_23 = ab, R_13 = bc, F' = ca; without friction c_0."""
    smooth = drive is IDEAL
    pressed, c, lean = (frictionless(PRESSED), "c_0", ALONG_N) if smooth else (PRESSED, "c", OFF_N)
    title = Words("力多边形（无摩擦）", "Force polygon, no friction") if smooth else Words("力多边形", "Force polygon")
    place = bench.board.open_pane(View.FORCE, drive.key, title)
    bench.board.step(
        lead
        + Words(
            f"按 $μ_F$ 作力多边形：$ab$ 代表 $R_23$，过 $b$ 作 ${pressed.symbol}$ 的方向线，过 $a$ 作水平线，"
            f"交于 ${c}$。",
            "Draw the force polygon to the scale $μ_F$: $ab$ stands for $R_23$; the "
            f"direction of ${pressed.symbol}$ through $b$ and a horizontal line "
            f"through $a$ meet at ${c}$.",
        ),
        place,
    )
    terms = (
        given(bench, place, CLAMP, device.R.si, along[0], "b"),
        sought(pressed, along[1], lean),
        sought(drive, 1 + 0j, ALONG_BASE),
    )
    start, end = balance(bench, place, 0j, *terms).ends[pressed.key]
    letter(bench, place, {"a": 0j, c: end})
    return place, start, end
