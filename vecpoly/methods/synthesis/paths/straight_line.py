"""A coupler point traced station by station, and its distance from a straight line, enlarged."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ....algebra.quantity import magnitude
from ....board.paper.marks import Dot, Role
from ....designs.straight_line import BAND, L, StraightLine
from ....designs.verdict import Verdict
from ....diagram.single import plate
from ....plane import Points, circles_meet, nominal, unit
from ....plane.geometry import cross
from ....words import Words
from ..chart import Axis, Chart, chart
from ..draft import SHEET, Draft
from ..generator.greatest import place_of_greatest
from ..linkage import drawn, pin, pivot
from ..registry import design_method

STATIONS, FINE = 9, 120
FLAT = 0.5  # mm: E nearer to BC lies on it
Path = Callable[[float], complex]


@design_method(
    StraightLine,
    title=Words("连杆点的近似直线轨迹", "Approximate straight line of a coupler point"),
    source="Chebyshev, Hoecken, Roberts: symmetrical coupler curves with a straight part",
    sheet=Words("近似直线机构", "Straight-line linkage"),
    example="straight-chebyshev",
)
def draw_straight_line(draft: Draft, design: StraightLine) -> None:
    """The stations, the curve, its length and band."""
    ends = _traced(draft, design)
    path = _path(design)
    places = [_furthest(path, way) for way in (1, -1, 1j, -1j)]
    _read(draft, path, places)
    lengths = (draft.mm(one.si) for one in (design.AB, design.BC, design.AD))
    draft.candidate(Verdict.VALID, (*lengths, 0.0), **ends)


def _traced(draft: Draft, design: StraightLine) -> dict[str, Points]:
    """The linkage in its stations and the path of E; the pins that do not move, and E at both ends."""
    board = draft.board
    board.section(Words("连杆点的轨迹", "The path of the coupler point"))
    board.step(
        Words(
            f"选 $μ_l$，画 $A$、$D$；将 $AB$ 在给定范围内等分为 {STATIONS} 个位置，以两弧求 $C$，作出各位置的 $E$，"
            "连成光滑曲线。",
            f"Choose $μ_l$, draw $A$ and $D$; set $AB$ to {STATIONS} equally spaced positions over the range, find $C$ "
            "by two arcs and with it $E$, and lead a smooth curve through these.",
        ),
        SHEET,
    )
    a = pivot(draft, "A", 0j)
    d = pivot(draft, "D", board.lay_off(a, 1 + 0j, draft.mm(design.AD.si), key="AD"))
    first, last = (end.si for end in design.phi)
    stations = [_station(draft, design, (a, d), float(phi)) for phi in np.linspace(first, last, STATIONS)]
    middle = STATIONS // 2
    for n, (b, c, e) in enumerate(stations):
        if n in (0, STATIONS - 1, middle):
            drawn(draft, *(((a, b, c, d),) if n == middle else ((), (a, b, c, d))))
            _joined(draft, (b, c, e), thick=n == middle)
    for letter, at in zip("BC", stations[middle], strict=False):
        pin(draft, letter, at)
    lettered = [pin(draft, f"E_{n}", e) for n, (_, _, e) in enumerate(stations, 1)]
    board.curve(SHEET, lettered, Role.RESULT)
    return {"A": a, "D": d, "E1": lettered[0], "E2": lettered[-1]}


def _joined(draft: Draft, coupler: tuple[Points, Points, Points], thick: bool) -> None:
    """The coupler BCE: a plate where its three points are not in line."""
    b, c, e = coupler
    if thick and abs(float(nominal(cross(unit(c - b), e - b)))) > FLAT:
        draft.board.depict(SHEET, plate("coupler", b, c, e))
        return
    for one in (b, c):
        draft.board.join(SHEET, one, e, Role.LINK if thick else Role.OTHER)


def _station(
    draft: Draft, design: StraightLine, pivots: tuple[Points, Points], phi: float
) -> tuple[Points, Points, Points]:
    """B, C and E with AB at an angle."""
    board, (a, d) = draft.board, pivots
    b = board.lay_off(a, board.ray(a, 1 + 0j, phi).along, draft.mm(design.AB.si))
    met = board.arcs(b, draft.mm(design.BC.si), d, draft.mm(design.CD.si), Words("求 $C$", "finding $C$"))
    c = met[0 if design.side == "left" else 1]
    return b, c, board.image((np.complex128(0), np.complex128(design.BC.si), np.complex128(design.E.at)), (b, c))


def _path(design: StraightLine) -> Path:
    """E (m) at a share of the range, on scratch paper."""
    first, last = (end.si for end in design.phi)

    def at(share: float) -> complex:
        b = design.AB.si * np.exp(1j * (first + share * (last - first)))
        met = circles_meet(b, design.BC.si, complex(design.AD.si), design.CD.si)
        c = complex(nominal(met[0 if design.side == "left" else 1]))
        return complex(b + design.E.at / design.BC.si * (c - b))

    return at


def _furthest(path: Path, way: complex) -> complex:
    """The point of the path that lies furthest in this direction."""
    return path(place_of_greatest(lambda share: (complex(way).conjugate() * path(share)).real))


def _read(draft: Draft, path: Path, places: list[complex]) -> None:
    """The path with its height enlarged, between two parallels to AD: length and width of the band."""
    board, (right, left, high, low) = draft.board, places
    spots = [1e3 * path(n / FINE) for n in range(FINE + 1)]
    base = 1e3 * low.imag
    over = Axis(symbol="x", unit="mm", low=1e3 * left.real, high=1e3 * right.real)
    up = Axis(symbol="y", unit="mm", low=0.0, high=1e3 * high.imag - base)
    curve = chart(draft, "band", Words("轨迹的偏差（高度放大）", "The path, its height enlarged"), over, up)
    board.step(
        Words(
            "以放大的比例画出轨迹的高度（自最低点量起），作平行于 $AD$ 的两直线夹住曲线，量出近似直线段的长度 $L$ "
            "和这段轨迹偏离直线的宽度 $δ$（两平行线的距离）：",
            "Plot the height of the path, counted from its lowest point, to an enlarged scale; two parallels to $AD$ "
            "enclose it. Read the length $L$ of the straight part and the width $δ$ of its band:",
        ),
        curve.place,
    )
    curve.ruled()
    curve.curve([at.real for at in spots], [at.imag - base for at in spots])
    _measured(draft, curve, places, base)


def _measured(draft: Draft, curve: Chart, places: list[complex], base: float) -> None:
    board, scale = draft.board, draft.board.scale_of(curve.place)
    right, left, high, low = (np.complex128(curve.at(1e3 * at.real, 1e3 * at.imag - base)) for at in places)
    for level in (high, low):
        board.join(curve.place, 1j * level.imag, right.real + 1j * level.imag, Role.CENTRE)
    for named, one, other, letters, mu in (
        (L, left.real + 0j, right.real + 0j, "L", scale.right),
        (BAND, 1j * low.imag, 1j * high.imag, "δ", scale),
    ):
        on_paper = board.measure(np.complex128(one), np.complex128(other), letters)
        board.plot(curve.place, (np.complex128(one) + np.complex128(other)) / 2, letters, Dot.NONE)
        size = magnitude(mu.symbol, mu.value, "mm/mm") * on_paper
        draft.worked(draft.of_this(named), size)
        draft.read_off(draft.of_this(named), curve.place, on_paper, letters, mu)
