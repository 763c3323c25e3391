"""A coupler point traced station by station, and its distance from a straight line, enlarged."""

from __future__ import annotations

from math import degrees

import numpy as np

from ....algebra.columns import column
from ....algebra.quantity import magnitude
from ....board.paper.marks import Dot, Role
from ....designs.straight_line import BAND, L, StraightLine
from ....designs.verdict import Verdict
from ....diagram.single import plate, run_on
from ....plane import Points, nominal, unit
from ....plane.geometry import cross
from ....words import Words
from ...devices.sketches.dimensions import dimension
from ..chart import Axis, Chart, chart
from ..draft import SHEET, Draft
from ..linkage import Chain, bar, drawn, pin, pivot, point
from ..registry import design_method
from .path import Path

STATIONS, FINE = 9, 80
FLAT = 0.5  # mm: E nearer to BC lies on it
APART = 7.0  # mm from the curve to a dimension
ANGLE_PLACES = 2
LEGIBLE = 2.0  # mm: of a narrower band on the drawing a reading says nothing


@design_method(
    StraightLine,
    title=Words("连杆点的近似直线轨迹", "Approximate straight line of a coupler point"),
    source="Chebyshev, Hoecken, Roberts: symmetrical coupler curves with a straight part",
    sheet=Words("近似直线机构", "Straight-line linkage"),
    example="straight-chebyshev",
)
def draw_straight_line(draft: Draft, design: StraightLine) -> None:
    """The stations, the curve, its length and band."""
    path = Path(design)
    stations = path.stations(STATIONS - 1)
    ends = _traced(draft, design, [path.phi(share) for share in stations])
    _read(draft, path, stations)
    lengths = (draft.mm(one.si) for one in (design.AB, design.BC, design.AD))
    draft.candidate(Verdict.VALID, (*lengths, 0.0), **ends)


def _traced(draft: Draft, design: StraightLine, phis: list[float]) -> dict[str, Points]:
    """The linkage in its stations and the path of E; the pins that do not move, and E at both ends."""
    board = draft.board
    board.section(Words("连杆点的轨迹", "The path of the coupler point"))
    board.step(_positions(design, phis), SHEET)
    a = pivot(draft, "A", 0j)
    d = pivot(draft, "D", board.lay_off(a, 1 + 0j, draft.mm(design.AD.si), key="AD"))
    stations = [_station(draft, design, (a, d), phi) for phi in phis]
    middle = STATIONS // 2
    for n, (b, c, e) in enumerate(stations):
        if n in (0, STATIONS - 1, middle):
            drawn(draft, *(((a, b, c, d),) if n == middle else ((), (a, b, c, d))))
            _joined(draft, (b, c, e), thick=n == middle)
            if n == middle and _in_line((b, c, e)):
                _run_on(draft, (a, b, c, d), e)
            for letter, at in (("B", b), ("C", c)) if n != middle else ():
                pin(draft, f"{letter}_{n + 1}", at)
    for letter, at in zip("BC", stations[middle], strict=False):
        pin(draft, letter, at)
    lettered = [point(draft, f"E_{n}", e) for n, (_, _, e) in enumerate(stations, 1)]
    board.curve(SHEET, lettered, Role.RESULT)
    return {"A": a, "D": d, "E1": lettered[0], "E2": lettered[-1]}


def _positions(design: StraightLine, phis: list[float]) -> Words:
    """The first step: where AB is set, and how C is found."""
    angles = [f"{angle}°" for angle in column([degrees(phi) for phi in phis], ANGLE_PLACES)]
    dead = [f"$φ_{n}$" for n, phi in enumerate(phis, 1) if design.dead(phi)]
    told = Words(
        f"选 $μ_l$，画 $A$、$D$；在给定范围内取 $AB$ 的 {STATIONS} 个位置，使相邻两 $E$ 点的间距相等："
        f"$φ$ = {'、'.join(angles)}。以两弧求 $C$，作出各位置的 $E$，连成光滑曲线。",
        f"Choose $μ_l$, draw $A$ and $D$; set $AB$ to {STATIONS} positions over the range, so that the positions of "
        f"$E$ are equally spaced: $φ$ = {', '.join(angles)}. Find $C$ by two arcs and with it $E$, and draw a smooth "
        "curve through them.",
    )
    if not dead:
        return told
    return told + Words(
        f"{'、'.join(dead)} 为死点，$B$、$C$、$D$ 共线，两弧相切，$C$ 直接在直线 $BD$ 上量取。",
        f" There is a dead point at {' and '.join(dead)}: $B$, $C$ and $D$ are in line, the arcs only touch, and $C$ "
        "is laid off on the line $BD$.",
    )


def _in_line(coupler: tuple[Points, Points, Points]) -> bool:
    """Whether E lies on BC, produced or not."""
    b, c, e = coupler
    return abs(float(nominal(cross(unit(c - b), e - b)))) <= FLAT


def _joined(draft: Draft, coupler: tuple[Points, Points, Points], thick: bool) -> None:
    """The coupler BCE: a plate where its three points are not in line."""
    b, c, e = coupler
    if thick and not _in_line(coupler):
        draft.board.depict(SHEET, plate("coupler", b, c, e))
        return
    for one in (b, c):
        bar(draft, one, e, Role.LINK if thick else Role.OTHER)


def _run_on(draft: Draft, chain: Chain, e: Points) -> None:
    """Where BC is produced to E, the joining half about the pin past which the bar runs on."""
    a, b, c, d = chain
    draft.board.depict(SHEET, run_on("coupler", c, d, b, e), run_on("coupler", b, a, c, e))


def _station(
    draft: Draft, design: StraightLine, pivots: tuple[Points, Points], phi: float
) -> tuple[Points, Points, Points]:
    """B, C and E with AB at an angle."""
    board, (a, d) = draft.board, pivots
    b = board.lay_off(a, board.ray(a, 1 + 0j, phi).along, draft.mm(design.AB.si))
    bc, cd = draft.mm(design.BC.si), draft.mm(design.CD.si)
    if design.dead(phi):
        folded = abs(nominal(d - b)) < cd  # the rocker reaches over B
        c = board.lay_off(b, unit(b - d) if folded and cd > bc else unit(d - b), bc)
    else:
        c = board.arcs(b, bc, d, cd, Words("求 $C$", "finding $C$"))[0 if design.side == "left" else 1]
    return b, c, board.image((np.complex128(0), np.complex128(design.BC.si), np.complex128(design.E.at)), (b, c))


def _read(draft: Draft, path: Path, stations: list[float]) -> None:
    """The path with its height enlarged, between two parallels to AD: length and width of the band."""
    shares = [path.furthest(way) for way in (1, -1, 1j, -1j)]
    places = path.seen(shares)
    right, left, high, low = places
    base = low.imag
    over = Axis(symbol="x", unit="mm", low=left.real, high=right.real)
    up = Axis(symbol="h", unit="mm", low=0.0, high=high.imag - base)
    curve = chart(draft, "band", Words("轨迹的偏差（高度放大）", "Coupler curve, height magnified"), over, up)
    marked = [at - 1j * base for at in path.seen(stations)]
    draft.board.step(_computed(draft, up.high, [at.imag for at in marked]), curve.place)
    curve.ruled()
    spots = path.seen(sorted({*path.stations(FINE), *shares}))
    curve.curve([at.real for at in spots], [at.imag - base for at in spots])
    for at in marked:
        draft.board.plot(curve.place, np.complex128(curve.at(at.real, at.imag)), "", Dot.POINT)
    _measured(draft, curve, places, base)


def _computed(draft: Draft, band: float, heights: list[float]) -> Words:
    """The second step: whence the heights are known."""
    on_paper = draft.mm(1e-3 * band)
    places = max(0, 2 - int(np.floor(np.log10(band)))) if band > 0 else 0
    rows = column(heights, min(places, 6))
    narrow = Words(
        f"轨迹在上图中的高度差仅 {on_paper:.2g} mm，难以量准，故由计算求得：",
        f"On the drawing the heights of the path differ by {on_paper:.2g} mm only, too little to be read well; they "
        "are computed: ",
    )
    wide = Words("轨迹的高度由计算求得：", "The heights of the path are computed: ")
    return (narrow if on_paper < LEGIBLE else wide) + Words(
        "在 $△BCD$ 中由余弦定理求 $∠CBD$，得 $C$、$E$ 的坐标。$x$ 自 $A$ 沿 $AD$ 量起，高度 $h$ "
        f"自轨迹的最低点量起，$E_1$ 至 $E_{STATIONS}$ 的 $h$ 为 {'、'.join(rows)} mm；"
        "其间再算若干点，以放大的比例画出曲线（故校核只检验画图和读数）。作平行于 $AD$ 的两直线夹住曲线，"
        "量出长度 $L$ 和宽度 $δ$（两平行线的距离）：",
        "the law of cosines gives $∠CBD$ in $△BCD$, and so the coordinates of $C$ and $E$: $x$ from $A$ along "
        f"$AD$, the height $h$ from the lowest point of the path. At $E_1$ to $E_{STATIONS}$ $h$ is {', '.join(rows)} "
        "mm; compute more between them, and plot the curve to an enlarged scale (the check tests plotting and reading "
        "alone). Two parallels to $AD$ enclose it. "
        "Read the length $L$ and the width $δ$:",
    )


def _measured(draft: Draft, curve: Chart, places: list[complex], base: float) -> None:
    board, scale = draft.board, draft.board.scale_of(curve.place)
    right, _, high, _ = (curve.at(at.real, at.imag - base) for at in places)
    end, top = board.lay_off(np.complex128(0), 1 + 0j, right.real), board.lay_off(np.complex128(0), 1j, high.imag)
    for level in (top, np.complex128(0)):
        board.join(curve.place, level, level + right.real, Role.CENTRE)
    over, beside = complex(nominal(top)) + 1j * APART, complex(nominal(end)) + APART
    for named, other, letters, mu, away in ((L, end, "L", scale.right, over), (BAND, top, "δ", scale, beside)):
        on_paper = board.measure(np.complex128(0), other, letters)
        dimension(draft, curve.place, away, away + complex(nominal(other)), letters)
        size = magnitude(mu.symbol, mu.value, "mm/mm") * on_paper
        draft.worked(draft.of_this(named), size)
        draft.read_off(draft.of_this(named), curve.place, on_paper, letters, mu)
