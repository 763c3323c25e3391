"""A slide on a flat and a V guide: the load shared by the lever, its share on the V resolved along the normals of the flanks."""

from __future__ import annotations

from math import degrees, pi

import numpy as np

from ...board.construction import Pane, View
from ...board.marks import AngleMark, Dot, LinkNumber, Outline, Point, RightAngle, Role, Segment
from ...devices.vee_guide import (
    F_VEE,
    F_WHOLE,
    FLANK,
    FRICTION,
    FRICTION_FLAT,
    FRICTION_V,
    ON_FLAT,
    ON_V,
    VeeGuide,
)
from ...names import Named
from ...plane import nominal
from ...quantity import Of, Quantity, Times, magnitude
from ...words import Words
from .bench import Bench
from .dimensions import dimension
from .inclined import Press, balance, body, given, letter, press, pull, sought
from .registry import device_method

SPAN = 105.0  # mm: from guide to guide as sketched
PLATE, FLANK_LENGTH, FOOT = 11.0, 18.0, 11.0  # mm, as sketched: thickness of the slide, length of a flank, half width of the foot
APART = 42.0  # mm: length of a flank on the body drawn apart


@device_method(VeeGuide, title=Words("平面与V形导轨的当量摩擦系数", "Flat and V guide: equivalent coefficient of friction"),
               source="机械原理, friction of flat and V guides", example="4-1")
def draw_vee_guide(bench: Bench, device: VeeGuide) -> None:
    """F_1 = G l_2/(l_1 + l_2); 2 N sin θ = F_1; F_f = 2 f N + f F_2 = f_V G."""
    board = bench.board
    board.section(Words("载荷在两导轨上的分配", "How the guides share the load"))
    _section(bench, device)
    load, first, second = magnitude("G", device.G.si, "N"), _mm("l_1", device.l1.si), _mm("l_2", device.l2.si)
    board.step(Words("由对导轨 2、导轨 1 的力矩平衡求两导轨所受的压力：", "Moments about guide 2 and about guide 1 give what presses on each:"))
    on_v = bench.worked(ON_V, load * second / (first + second))
    on_flat = bench.worked(ON_FLAT, load * first / (first + second))
    board.section(Words("当量摩擦系数", "Equivalent coefficient of friction"))
    flank = _flanks(bench, device, on_v)
    f, theta = magnitude("f", device.f.si, ""), magnitude("θ", degrees(device.theta.si), "deg")
    board.step(Words("V 形导轨单独的当量摩擦系数（楔形使法向力增大，$f_v > f$）：", "Of the V guide alone the equivalent coefficient is ($f_v > f$: the wedge raises the normal forces):"))
    bench.worked(F_VEE, f / Of("sin", theta))
    board.step(Words("滑台移动时，V 形导轨两侧面与平导轨上的摩擦力及其总和：", "While the slide moves, friction on both flanks of the V, on the flat guide, and together:"))
    rub_v, rub_flat = bench.worked(FRICTION_V, Times(2, f * flank)), bench.worked(FRICTION_FLAT, f * on_flat)
    rub = bench.worked(FRICTION, rub_v + rub_flat)
    board.step(Words("把两导轨看作一个平导轨，$F_f = f_V G$：", "One flat guide in place of both would have $F_f = f_V G$:"))
    bench.worked(F_WHOLE, rub / load)
    board.remark(Words("以几何量表示即 $f_V$ = $f$ [ $l_2$ / (($l_1 + l_2$) sin $θ$) + $l_1$ / ($l_1 + l_2$) ]，其中 $θ$ 为 V 形的半角。",
                       " In terms of the dimensions: $f_V$ = $f$ [ $l_2$ / (($l_1 + l_2$) sin $θ$) + $l_1$ / ($l_1 + l_2$) ], where $θ$ is half the angle of the V."))


def _mm(symbol: str, metres: float) -> Quantity:
    return magnitude(symbol, metres * 1e3, "mm")


def _section(bench: Bench, device: VeeGuide) -> None:
    """The cross-section as a sketch, the distances l1 and l2 in proportion."""
    board = bench.board
    place = board.open_pane(View.MECHANISM, "section", Words("导轨横截面", "Cross-section of the guides"))
    board.step(Words("作横截面图：载荷 $G$ 作用于 $S$，到 V 形导轨 1 和平导轨 2 的距离为 $l_1$ 和 $l_2$。",
                     "Draw the cross-section: the load $G$ acts at $S$, at the distance $l_1$ from the V guide 1 and $l_2$ from the flat guide 2."), place)
    left, right = (SPAN * x / (device.l1.si + device.l2.si) for x in (-device.l1.si, device.l2.si))
    wide, deep = FLANK_LENGTH * np.sin(device.theta.si), FLANK_LENGTH * np.cos(device.theta.si)
    low = -0.25 * deep
    board.mark(place, Outline(points=_points((left - wide - 6, low), (left - 0.75 * wide, low), (left, -deep), (left + 0.75 * wide, low), (right + FOOT + 6, low),
                                             (right + FOOT + 6, -deep - 9), (left - wide - 6, -deep - 9)), fixed=True))
    body(bench, place, *_points((left - wide, PLATE), (right + FOOT, PLATE), (right + FOOT, low), (right - FOOT, low), (right - FOOT, 0),
                                (left + wide, 0), (left, -deep), (left - wide, 0)))
    top = PLATE + 24.0
    board.mark(place, Segment(a=complex(0, PLATE / 2), b=complex(0, top), role=Role.CENTRE))
    for x, guide, symbol in ((left, "1", "l_1"), (right, "2", "l_2")):
        board.mark(place, Segment(a=complex(x, -deep), b=complex(x, top), role=Role.CENTRE), LinkNumber(a=complex(x, -deep - 9), b=complex(x, -deep - 9), number=guide),
                   *dimension(complex(0, top - 2), complex(x, top - 2), symbol))
    board.mark(place, Point(at=PLATE / 2 * 1j, label="S", dot=Dot.POINT))
    pull(bench, place, complex(0, PLATE), -1j, "G")


def _points(*pairs: tuple[float, float]) -> tuple[complex, ...]:
    return tuple(complex(float(x), float(y)) for x, y in pairs)


def _flanks(bench: Bench, device: VeeGuide, on_v: Quantity) -> Quantity:
    """F_1 + N + N = 0 along the normals of the flanks; N is measured."""
    board = bench.board
    apart = board.open_pane(View.BODY, "vee", Words("V 形导轨的受力（横截面内）", "Forces on the V, in its cross-section"))
    plan = board.open_pane(View.FORCE, "vee", Words("$F_1$ 沿两侧面法线的分解", "$F_1$ resolved along the normals of the flanks"))
    board.step(Words("V 形部分受压力 $F_1$ 和两侧面的法向反力 $N$（摩擦力垂直于图面）。$F_1$ 大小、方向已知，两个 $N$ 方向已知，作力多边形。",
                     "On the V act the load $F_1$ and the normal reactions $N$ of both flanks (friction is perpendicular to the paper). $F_1$ is known, both lines of $N$ are: draw the polygon."), plan)
    ways = _body(bench, device, apart)
    sides = (Named("N_right", "N", "N"), Named("N_left", "N", "N"))
    closed = balance(bench, plan, 0j, given(bench, plan, ON_V, float(nominal(on_v.value)), -1j),
                     *(sought(side, way, Words("⊥右侧面" if i == 0 else "⊥左侧面", "⊥ right flank" if i == 0 else "⊥ left flank"))
                       for i, (side, way) in enumerate(zip(sides, ways, strict=True))))
    ends = closed.ends[sides[0].key]
    letter(bench, plan, {"a": closed.ends[ON_V.key][0], "b": ends[0], "c": ends[1]})
    return bench.measured(FLANK, plan, *ends, "b c")


def _body(bench: Bench, device: VeeGuide, place: Pane) -> tuple[complex, complex]:
    """The V drawn apart; the normals of its right and its left flank, into it."""
    board, theta = bench.board, device.theta.si
    right = complex(np.exp(1j * (pi / 2 - theta)))  # from the edge up the right flank
    left = -right.conjugate()
    body(bench, place, 0j, APART * right, APART * left)
    top = APART * 1j * right.imag
    pull(bench, place, top, -1j, ON_V.symbol)
    board.mark(place, Segment(a=-4j, b=top, role=Role.CENTRE), AngleMark(at=0j, radius=0.45 * APART, start=pi / 2 - theta, sweep=theta, label="θ"))
    for flank, normal in ((right, 1j * right), (left, -1j * left)):
        at = 0.6 * APART * flank
        press(bench, place, Press(symbol="N", at=at, normal=normal, along=normal))
        board.mark(place, RightAngle(at=at, u=flank, v=-normal))
    return 1j * right, -1j * left
