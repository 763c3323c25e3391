"""A clamping wedge, self-locking shown three ways: two opposite reactions, the force that holds, the efficiency of
slipping out."""

from __future__ import annotations

import numpy as np

from ...algebra.formula import sym
from ...algebra.quantity import Of, Quantity, Times, magnitude, number
from ...board.construction import Pane, View
from ...board.paper.marks import LinkNumber, Role
from ...devices.wedge_clamp import BY_SINES, CLAMP, ETA_BACK, HOLD, IDEAL, LIMIT, PHI, PRESSED, WedgeClamp
from ...names import Named
from ...plane import Line, Points, lines_meet, nominal
from ...words import Words
from .bench import Bench
from .inclined import (
    ALONG_N,
    OFF_N,
    Press,
    angle,
    balance,
    between,
    body,
    concur,
    cone,
    friction_angle,
    frictionless,
    gauged,
    given,
    leaned,
    letter,
    press,
    pull,
    ray,
    row_of,
    signed,
    sought,
)
from .registry import device_method

LENGTH, TIP, DEEP = 46.0, 3.0, 11.0  # mm: of the wedge; its thin end; the bodies that it clamps
OUT = -1 + 0j  # the way on which the wedge slips out
CONE = 36.0
ALONG_BASE = Words("∥底面", "∥ base")


@device_method(
    WedgeClamp,
    title=Words("楔块夹具的自锁", "Self-locking of a wedge clamp"),
    source="机械原理, self-locking: by geometry of reactions, by force, by efficiency",
    example="5-2",
)
def draw_clamp(bench: Bench, device: WedgeClamp) -> None:
    """Sketch, friction angle, then the three ways."""
    board, slope = bench.board, np.exp(-1j * device.alpha.si)
    board.section(Words("简图与摩擦角", "Sketch and friction angle"))
    board.step(
        Words(
            "画出简图（长度不按比例）：楔块 3 在力 $F$ 作用下楔入工件 1 与构件 2 之间，夹紧后去掉 $F$，"
            "楔块可能向左退出。",
            "Sketch, lengths not to scale: $F$ drives wedge 3 in between the work 1 and body 2. "
            "After clamping $F$ is removed, and the wedge may slip out to the left.",
        ),
        View.MECHANISM,
    )
    _sketch(bench, slope)
    board.step(Words("求摩擦角：", "The friction angle:"))
    phi = friction_angle(bench, PHI, device.f)
    _by_geometry(bench, device, slope, phi)
    _by_efficiency(bench, device, slope, _by_force(bench, device, slope, phi), phi)


def _corners(slope: Points) -> tuple[Points, ...]:
    """The wedge: thick end at the left, below and above, thin end at the right."""
    thin = complex(LENGTH, 0)
    over = thin + TIP * 1j
    return 0j, thin, over, over - slope * (LENGTH / nominal(slope.real))


def _sketch(bench: Bench, slope: Points) -> None:
    view, it = View.MECHANISM, _corners(slope)
    body(bench, view, *it)
    body(bench, view, -6 + 0j, LENGTH + 6, complex(LENGTH + 6, -DEEP), complex(-6, -DEEP), fixed=True)
    above, low = it[3] + slope * 4, it[2] - slope * 4
    over = above + DEEP * 1j
    body(bench, view, above, low, complex(low.real, over.imag), over)
    pull(bench, view, it[3] / 2, 1 + 0j, "F")
    ray(bench, view, it[2], 1 + 0j, 22.0)
    ray(bench, view, it[2], slope, 22.0)
    between(bench, view, it[2], 1 + 0j, slope, 16.0, "α")
    places = ((LENGTH + 9 - 1j * (DEEP / 2), "1"), ((above + low) / 2 + 3 + DEEP * 0.62j, "2"), (sum(it) / 4, "3"))
    bench.board.mark(
        view, *(LinkNumber(a=complex(nominal(at)), b=complex(nominal(at)), number=name) for at, name in places)
    )


def _by_geometry(bench: Bench, device: WedgeClamp, slope: Points, phi: Quantity) -> None:
    """Without F the wedge is a two-force body: both reactions lie in one line, inside both friction cones."""
    board = bench.board
    board.section(Words("方法一：由二力平衡", "Method 1: equilibrium of two forces"))
    place = board.open_pane(View.BODY, "cones", Words("两摩擦锥", "The two friction cones"))
    board.step(
        Words(
            "去掉 $F$ 后楔块 3 为二力构件，$R_13$ 与 $R_23$ 须等值、反向、共线。两工作面的法线 $n_13$、"
            "$n_23$ 夹角为 $α$，而两反力偏离各自法线都不能超过 $φ$。只有公共作用线同时落在两个摩擦锥内时楔块才不会"
            "退出，故自锁条件为 $α ≤ 2φ$。",
            "Without $F$ wedge 3 is a two-force body: $R_13$ and $R_23$ are equal, opposite and "
            "collinear. The normals $n_13$ and $n_23$ of the faces make the angle $α$, and "
            "neither reaction can deviate from its normal by more than $φ$. The wedge stays in "
            "only where the common line of action lies within both friction cones; so the "
            "condition of self-locking is $α ≤ 2φ$.",
        ),
        place,
    )
    _cones(bench, place, slope, phi)
    steep, twice = (number(float(nominal(z))) for z in (np.degrees(device.alpha.si), 2 * phi.value))
    if device.alpha.si <= np.radians(2 * phi.value):
        board.remark(
            Words(
                f"本题 $α$ = {steep}° ≤ $2φ$ = {twice}°，两锥有公共的作用线，楔块自锁。",
                f" Here $α$ = {steep}° ≤ $2φ$ = {twice}°: the cones share a line and the wedge is self-locking.",
            )
        )
    else:
        board.remark(
            Words(
                f"本题 $α$ = {steep}° > $2φ$ = {twice}°，任何连线都不能同时落在两锥内，楔块不自锁。",
                f" Here $α$ = {steep}° > $2φ$ = {twice}°: no line lies within both cones and the "
                "wedge is not self-locking.",
            )
        )
    limit = board.open_pane(View.BODY, "limit", Words("自锁极限", "Limit of self-locking"))
    board.step(
        Words(
            "作极限位置：两反力各偏 $φ$ 而恰好共线。自公共作用线向两侧各量 $φ$ 得两法线，作其垂线为两工作面，"
            "量其夹角：",
            "The limit: both reactions are inclined by $φ$ and just collinear. Set off $φ$ to "
            "either side of the common line to get the normals; the faces are perpendicular to "
            "them. Read the angle between the faces:",
        ),
        limit,
    )
    turn = np.exp(1j * np.radians(phi.value))
    one, other = board.turn(1j * turn), board.turn(1j / turn)
    for along, length, label in ((1j, 46.0, "R_{13} = −R_{23}"), (one, 38.0, "n_{13}"), (other, 38.0, "−n_{23}")):
        ray(bench, limit, 0j, along, length, label)
    for face in (one, other):
        body(bench, limit, 0j, -1j * face * 34.0)
    between(bench, limit, 0j, 1j, one, 28.0, "φ")
    between(bench, limit, 0j, other, 1j, 28.0, "φ")
    between(bench, limit, 0j, -1j * other, -1j * one, 24.0, LIMIT.symbol)
    found = gauged(bench, other, one)
    bench.stated(LIMIT, found, row_of(sym(LIMIT.symbol), f" = 2$φ$ = {number(float(nominal(found)))}°"))


def _cones(bench: Bench, place: Pane, slope: Points, phi: Quantity) -> None:
    it = _corners(slope)
    body(bench, place, *it)
    under = complex(LENGTH * 0.42, 0)
    over = lines_meet(Line(under, 1j), Line(it[2], slope))
    for at, outward, label in ((under, -1j, "n_{13}"), (over, 1j * slope, "n_{23}")):
        cone(bench, place, at, outward, phi.value, CONE, label)
    bench.board.join(place, under, over, Role.HIDDEN)


def _by_force(bench: Bench, device: WedgeClamp, slope: Points, phi: Quantity) -> Quantity:
    board = bench.board
    board.section(Words("方法二：由阻止退出所需的力", "Method 2: the force that holds the wedge"))
    place = board.open_pane(View.BODY, "3", Words("楔块 3 受力图（退出）", "Free body of wedge 3, slipping out"))
    board.step(
        Words(
            "设楔块向左退出，$F'$ 为阻止其退出所需的力。楔块相对 1、2 的速度 $v_31$、$v_32$ 均向左，故 $R_13$、"
            "$R_23$ 都自法线 $n$ 向右偏转 $φ$。$R_23$ 全知，$R_13$、$F'$ 只有大小未知；三力汇交于一点。",
            "Let the wedge slip out to the left, and let $F'$ be the force that stops it. It "
            "slides to the left on 1 and on 2 ($v_31$, $v_32$), so both reactions are turned to "
            "the right of the normals $n$ by $φ$. $R_23$ is known, of $R_13$ and $F'$ only the "
            "magnitudes are unknown; the three forces meet in one point.",
        ),
        place,
    )
    low, high = leaned(1j, OUT, phi.value), leaned(-1j * slope, OUT * slope, phi.value)
    it = _corners(slope)
    body(bench, place, *it)
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
    polygon, b, c = _polygon(bench, device, HOLD, (high, low), Words.same(""))
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


def _polygon(
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


def _by_efficiency(bench: Bench, device: WedgeClamp, slope: Points, hold: Quantity, phi: Quantity) -> None:
    board = bench.board
    board.section(Words("方法三：由效率", "Method 3: the efficiency"))
    lead = Words(
        "设各面无摩擦，两反力都沿法线，求同一 $R_23$ 下的理想阻力 $F'_0$。",
        "Without friction both reactions lie along the normals; find the ideal resistance $F'_0$ for the same $R_23$. ",
    )
    place, _, c = _polygon(bench, device, IDEAL, (-1j * slope, 1j), lead)
    board.step(
        Words(
            "楔块退出时 $R_23$ 为驱动力，$F'$ 为阻力，效率等于实际阻力与理想阻力之比。三角形 $abc_0$ 中 $F'_0 = "
            "R_23 sin α$，故 $η'$ 也可用公式核对；$η' ≤ 0$ 时自锁，仍得 $α ≤ 2φ$。",
            "While the wedge slips out $R_23$ drives and $F'$ resists; the efficiency is the "
            "ratio of the actual to the ideal resistance. In the triangle $abc_0$ $F'_0 = R_23 "
            "sin α$, which gives a formula for $η'$; $η' ≤ 0$ means self-locking: once more $α ≤ "
            "2φ$.",
        ),
        place,
    )
    ideal = bench.measured(IDEAL, place, c, 0j, "c_0 a")
    bench.worked(ETA_BACK, hold / ideal)
    alpha = angle("α", device.alpha.si)
    board.compute("η'", Of("sin", alpha - Times(2, phi)) / (Of("cos", phi) * Of("sin", alpha)), "")
