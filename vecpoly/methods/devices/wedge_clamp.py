"""A clamping wedge, self-locking shown three ways: two opposite reactions, the force that holds, the efficiency of slipping out."""

from __future__ import annotations

import numpy as np

from ...board.construction import Pane, View
from ...board.marks import LinkNumber, Role
from ...devices.wedge_clamp import BY_SINES, CLAMP, ETA_BACK, HOLD, IDEAL, LIMIT, PHI, PRESSED, WedgeClamp
from ...formula import sym
from ...names import Named
from ...plane import Line, Points, lines_meet, nominal
from ...quantity import Of, Quantity, Times, magnitude, number
from ...words import Words
from .bench import Bench
from .inclined import (
    Press,
    angle,
    balance,
    between,
    body,
    concur,
    friction_angle,
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
CONE = 24.0
OFF_N, ALONG_N, LEVEL = Words("与 $n$ 成 $φ$", "$φ$ off $n$"), Words("沿 $n$", "along $n$"), Words("∥底面", "∥base")


@device_method(WedgeClamp, title=Words("楔块夹具的自锁", "Self-locking of a wedge clamp"),
               source="机械原理, self-locking: by geometry of reactions, by force, by efficiency", example="5-2")
def draw_clamp(bench: Bench, device: WedgeClamp) -> None:
    """Sketch, friction angle, then the three ways."""
    board, slope = bench.board, np.exp(-1j * device.alpha.si)
    board.section(Words("准备", "Preparation"))
    board.step(Words("画出简图：楔块 3 夹在工件 1 与构件 2 之间，夹紧后去掉推力；设想它向左退出。不按比例。",
                     "Sketch, to no scale: wedge 3 between the work 1 and body 2. Once it clamps the push is taken away; think of it slipping out to the left."),
               View.MECHANISM)
    _sketch(bench, slope)
    board.step(Words("求摩擦角。", "Find the friction angle."))
    phi = friction_angle(bench, PHI, device.f)
    _by_geometry(bench, slope, phi)
    _by_efficiency(bench, device, slope, _by_force(bench, device, slope, phi))


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
    places = ((LENGTH / 2 - 1j * (DEEP + 3), "1"), ((above + low) / 2 + 3 + DEEP * 0.62j, "2"), (sum(it) / 4, "3"))
    bench.board.mark(view, *(LinkNumber(a=complex(nominal(at)), b=complex(nominal(at)), number=name) for at, name in places))


def _by_geometry(bench: Bench, slope: Points, phi: Quantity) -> None:
    """Without F the wedge is a two-force body: both reactions lie in one line, inside both friction cones."""
    board = bench.board
    board.section(Words("方法一：由两反力共线", "First way: two opposite reactions"))
    place = board.open_pane(View.BODY, "cones", Words("两摩擦锥", "The two friction cones"))
    board.step(Words("去掉 $F$ 后楔块 3 只受 $R_13$、$R_23$，二力平衡须共线反向。两面法线夹角为 $α$，每个反力偏离各自法线不超过 $φ$：两摩擦锥有公共线时自锁，"
                     "即 $α ≤ 2φ$。",
                     "Without $F$ only $R_13$ and $R_23$ act on wedge 3; they balance only in one line. The normals of the faces make the angle $α$, and either "
                     "reaction leans by $φ$ at most: the wedge stays where the two friction cones share a line, that is where $α ≤ 2φ$."), place)
    _cones(bench, place, slope, phi)
    limit = board.open_pane(View.BODY, "limit", Words("极限位置", "The limit"))
    board.step(Words("极限：自公共线向两侧各量 $φ$ 得两法线，作其垂线为两工作面，量夹角。",
                     "The limit: from the common line set off $φ$ to either side for the normals; the faces are perpendicular to them. Read their angle."), limit)
    turn = np.exp(1j * np.radians(phi.value))
    one, other = board.hand.tilt(1j * turn), board.hand.tilt(1j / turn)
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
    it, turn = _corners(slope), np.exp(1j * np.radians(phi.value))
    body(bench, place, *it)
    under = complex(LENGTH * 0.42, 0)
    over = lines_meet(Line(under, 1j), Line(it[2], slope))
    for at, outward, label in ((under, -1j, "n_{13}"), (over, 1j * slope, "n_{23}")):
        ray(bench, place, at, outward, CONE + 6, label)
        for side in (turn, 1 / turn):
            bench.board.join(place, at, at + outward * side * CONE, Role.CONSTRUCTION)
            between(bench, place, at, outward, outward * side, CONE - 6, "φ")
    bench.board.join(place, under, over, Role.HIDDEN)


def _by_force(bench: Bench, device: WedgeClamp, slope: Points, phi: Quantity) -> Quantity:
    board = bench.board
    board.section(Words("方法二：由所需的力", "Second way: the force that is needed"))
    place = board.open_pane(View.BODY, "3", Words("楔块 3 受力图（退出）", "Wedge 3 apart, slipping out"))
    board.step(Words("设楔块向左退出，$F'$ 为阻止其退出所需的力。它相对 1、2 均向左滑，$R_13$、$R_23$ 都自法线向右偏 $φ$；$R_23$ 已知。",
                     "Let the wedge slip out to the left, and let $F'$ be the force that stops it. It slides to the left on 1 and on 2, so both reactions lean to "
                     "the right by $φ$; $R_23$ is known."), place)
    low, high = leaned(1j, OUT, phi.value), leaned(-1j * slope, OUT * slope, phi.value)
    it = _corners(slope)
    body(bench, place, *it)
    over = it[2] - slope * LENGTH * 0.55
    back = complex(0, it[3].imag / 2)
    meeting = lines_meet(Line(over, high), Line(back, 1 + 0j))
    under = lines_meet(Line(meeting, low), Line(0j, 1 + 0j))
    press(bench, place, Press(symbol=CLAMP.symbol, at=over, normal=-1j * slope, along=high, slides=OUT * slope, speed="v_{32}"))
    press(bench, place, Press(symbol=PRESSED.symbol, at=under, normal=1j, along=low, slides=OUT, speed="v_{31}"))
    pull(bench, place, back, 1 + 0j, HOLD.symbol)
    concur(bench, place, meeting, over, under, back)
    polygon, b, c = _polygon(bench, device, "F", Words("力多边形", "Force polygon"), (high, low), HOLD)
    bench.measured(PRESSED, polygon, b, c, "b c")
    hold = signed(bench, HOLD, polygon, (c, 0j), 1 + 0j, "c a")
    board.step(Words("用正弦定理核对；$F' ≤ 0$ 时不需外力，楔块自锁。", "Check by the sine rule; where $F' ≤ 0$ no force is needed and the wedge locks itself."))
    bench.worked(BY_SINES, magnitude("R_23", device.R.si, "N") * Of("sin", angle("α", device.alpha.si) - Times(2, phi)) / Of("cos", phi))
    _verdict(bench, float(nominal(hold.value)) <= 1e-9 * device.R.si)
    return hold


def _verdict(bench: Bench, locked: bool) -> None:
    """Whether the wedge stays in by itself."""
    if locked:
        bench.board.remark(Words("本题 $F' ≤ 0$：自锁，须反向拉出。", " Here $F' ≤ 0$: the wedge is self-locking and must be pulled out."))
    else:
        bench.board.remark(Words("本题 $F' > 0$：不自锁，须有 $F'$ 才能保持夹紧。", " Here $F' > 0$: it does not lock itself; $F'$ must hold it in."))


def _polygon(bench: Bench, device: WedgeClamp, name: str, title: Words, along: tuple[Points, Points], drive: Named) -> tuple[Pane, Points, Points]:
    """R_23 = ab, R_13 = bc, F' = ca."""
    board, place = bench.board, bench.board.open_pane(View.FORCE, name, title)
    board.step(Words("按 $μ_F$ 作力多边形：$ab$ 代表 $R_23$，过 $b$ 作 $R_13$ 的方向线，过 $a$ 作水平线，交于 $c$。",
                     "To the scale $μ_F$: $ab$ is $R_23$; the direction of $R_13$ through $b$ and a level line through $a$ meet at $c$."), place)
    terms = (given(bench, place, CLAMP, device.R.si, along[0], "b"), sought(PRESSED, along[1], ALONG_N if drive is IDEAL else OFF_N),
             sought(drive, 1 + 0j, LEVEL))
    closed = balance(bench, place, 0j, *terms)
    b, c = closed.ends[PRESSED.key]
    letter(bench, place, {"a": 0j, "c": c})
    return place, b, c


def _by_efficiency(bench: Bench, device: WedgeClamp, slope: Points, hold: Quantity) -> None:
    board = bench.board
    board.section(Words("方法三：由效率", "Third way: the efficiency"))
    place, _, c = _polygon(bench, device, "F_0", Words("力多边形（无摩擦）", "Force polygon, no friction"), (-1j * slope, 1j), IDEAL)
    board.step(Words("退出时 $R_23$ 为驱动力，$F'$ 为阻力；同一夹紧力下无摩擦时阻力为 $F'_0$，效率为两者之比。$η' ≤ 0$ 即自锁。",
                     "Slipping out, $R_23$ drives and $F'$ resists; with the same clamping force and no friction the resistance is $F'_0$. The efficiency is their "
                     "ratio; $η' ≤ 0$ means self-locking."), place)
    ideal = bench.measured(IDEAL, place, c, 0j, "c a")
    bench.worked(ETA_BACK, hold / ideal)
    board.write(row_of(sym("η'"), " = sin($α$ − 2$φ$) / (cos $φ$ sin $α$) ≤ 0  ⇔  $α$ ≤ 2$φ$"))
