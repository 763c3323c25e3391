"""A slide on a flat and a V guide: the load shared by the lever,
its share on the V resolved along the normals of the flanks."""

from __future__ import annotations

from math import degrees, pi

import numpy as np

from ...algebra.quantity import Of, Quantity, Times, magnitude
from ...board.construction import Pane, View
from ...board.paper.marks import Dot, Role
from ...devices.vee_guide import F_VEE, F_WHOLE, FLANK, FRICTION, FRICTION_FLAT, FRICTION_V, ON_FLAT, ON_V, VeeGuide
from ...diagram.single import number as number_of
from ...names import Named
from ...words import Words
from .bench import Bench
from .equilibrium import balance, given, letter, sought
from .inclined import Press, body, press, pull
from .registry import device_method
from .sketches.dimensions import dimension, millimetres

SPAN = 105.0  # mm: from guide to guide as sketched
PLATE, FLANK_LENGTH = 11.0, 18.0  # mm, as sketched: thickness of the slide, length of a flank
FOOT = 11.0  # mm, as sketched: half the width of the foot
APART = 42.0  # mm: length of a flank on the body drawn apart

_VEE = Words(
    "由 $2N sin θ = F_1$，V 形导轨 1 的摩擦力 $2f N = f F_1/sin θ$，故其当量摩擦系数为（楔形使法向反力增大"
    "，$f_{V1} > f$）：",
    "With $2N sin θ = F_1$ the friction on the V guide 1 is $2f N = f F_1/sin θ$, so that its equivalent "
    "coefficient is ($f_{V1} > f$: the wedge shape raises the normal reactions):",
)
_RUBBING = Words(
    "滑台移动时，V 形导轨两侧面、平导轨上的摩擦力及其总和为：",
    "While the slide moves, the friction on both flanks of the V, on the flat guide, and the total are:",
)
_WHOLE = Words(
    "把两导轨当作一个受载荷 $G$ 的平导轨，由 $F_f = f_V G$ 得整个导轨的当量摩擦系数；再用几何量表示，"
    "$θ$ 为 V 形的半角：",
    "Taken as one flat guide under the load $G$, both guides have $F_f = f_V G$, which "
    "gives the equivalent coefficient of the whole; then the same in terms of the "
    "dimensions, $θ$ being half the angle of the V:",
)


@device_method(
    VeeGuide,
    title=Words("平面与V形导轨的当量摩擦系数", "Flat and V guide: equivalent coefficient of friction"),
    source="机械原理, friction of flat and V guides",
    example="4-1",
)
def draw_vee_guide(bench: Bench, device: VeeGuide) -> None:
    """F_1 = G l_2/(l_1 + l_2); 2 N sin θ = F_1; F_f = 2 f N + f F_2 = f_V G."""
    board = bench.board
    board.section(Words("载荷在两导轨上的分配", "Distribution of the load"))
    _section(bench, device)
    on_v, on_flat = _shared(bench, device)
    board.section(Words("当量摩擦系数", "Equivalent coefficient of friction"))
    _coefficients(bench, device, _flanks(bench, device, on_v), on_flat)


def _data(device: VeeGuide) -> tuple[Quantity, Quantity, Quantity]:
    """G, l_1 and l_2 as factors of formulas."""
    return magnitude("G", device.G.si, "N"), millimetres("l_1", device.l1.si), millimetres("l_2", device.l2.si)


def _shared(bench: Bench, device: VeeGuide) -> tuple[Quantity, Quantity]:
    """F_1 on the V guide and F_2 on the flat one, from moments."""
    load, first, second = _data(device)
    bench.board.step(
        Words(
            "分别对导轨 2、导轨 1 取矩，由力矩平衡求两导轨所受的压力：",
            "Equilibrium of moments about guide 2 and about guide 1 gives the load on each guide:",
        )
    )
    on_v = bench.worked(ON_V, load * second / (first + second))
    on_flat = bench.worked(ON_FLAT, load * first / (first + second))
    return on_v, on_flat


def _coefficients(bench: Bench, device: VeeGuide, flank: Quantity, on_flat: Quantity) -> None:
    """f_V1 of the V guide, the friction on every face, and f_V of both guides together."""
    board, (load, first, second) = bench.board, _data(device)
    f, theta = magnitude("f", device.f.si, ""), magnitude("θ", degrees(device.theta.si), "deg")
    board.step(_VEE)
    bench.worked(F_VEE, f / Of("sin", theta))
    board.step(_RUBBING)
    rub_v, rub_flat = bench.worked(FRICTION_V, Times(2, f * flank)), bench.worked(FRICTION_FLAT, f * on_flat)
    rub = bench.worked(FRICTION, rub_v + rub_flat)
    board.step(_WHOLE)
    bench.worked(F_WHOLE, rub / load)
    whole = first + second
    board.compute(F_WHOLE.symbol, f * (second / (whole * Of("sin", theta)) + first / whole), "")


def _section(bench: Bench, device: VeeGuide) -> None:
    """The cross-section as a sketch, the distances l1 and l2 in proportion."""
    board = bench.board
    place = board.open_pane(View.MECHANISM, "section", Words("导轨横截面", "Cross-section of the guides"))
    board.step(
        Words(
            "画出导轨横截面（长度不按比例）：载荷 $G$ 作用于 $S$，到 V 形导轨 1 和平导轨 2 的距离为 $l_1$ 和 $l_2$。",
            "Sketch the cross-section, lengths not to scale: the load $G$ acts at $S$, at the "
            "distance $l_1$ from the V guide 1 and $l_2$ from the flat guide 2.",
        ),
        place,
    )
    left, right = (SPAN * x / (device.l1.si + device.l2.si) for x in (-device.l1.si, device.l2.si))
    wide, deep = FLANK_LENGTH * np.sin(device.theta.si), FLANK_LENGTH * np.cos(device.theta.si)
    body(bench, place, "frame", *_bed(left, right, wide, deep), fixed=True)
    body(bench, place, "slide", *_slide(left, right, wide, deep))
    top = PLATE + 24.0
    board.join(place, complex(0, PLATE / 2), complex(0, top), Role.CENTRE)
    for x, guide, symbol in ((left, "1", "l_1"), (right, "2", "l_2")):
        board.join(place, complex(x, -deep), complex(x, top), Role.CENTRE)
        board.depict(place, number_of(guide, complex(x, -deep - 9), owner=f"guide {guide}"))
        dimension(bench, place, complex(0, top - 2), complex(x, top - 2), symbol)
    board.plot(place, PLATE / 2 * 1j, "S", Dot.MASS)
    pull(bench, place, complex(0, PLATE), -1j, "G")


def _bed(left: float, right: float, wide: float, deep: float) -> tuple[complex, ...]:
    """The frame below: a V under the left guide, wide and deep (mm) as sketched, a flat face under the right one."""
    low, under, near, far = -0.25 * deep, -deep - 9, left - wide - 6, right + FOOT + 6
    face = (near, low), (left - 0.75 * wide, low), (left, -deep), (left + 0.75 * wide, low), (far, low)
    return _points(*face, (far, under), (near, under))


def _slide(left: float, right: float, wide: float, deep: float) -> tuple[complex, ...]:
    """The slide upon it: a plate, a foot on the flat guide, a V on the other."""
    low, near, far = -0.25 * deep, left - wide, right + FOOT
    foot = (far, low), (right - FOOT, low), (right - FOOT, 0)
    return _points((near, PLATE), (far, PLATE), *foot, (left + wide, 0), (left, -deep), (near, 0))


def _points(*pairs: tuple[float, float]) -> tuple[complex, ...]:
    return tuple(complex(float(x), float(y)) for x, y in pairs)


def _flanks(bench: Bench, device: VeeGuide, on_v: Quantity) -> Quantity:
    """F_1 + N + N = 0 along the normals of the flanks; N is measured."""
    board = bench.board
    apart = board.open_pane(View.BODY, "vee", Words("V 形部分受力图（横截面内）", "Free body of the V (cross-section)"))
    plan = board.open_pane(
        View.FORCE, "vee", Words("$F_1$ 沿两侧面法线的分解", "$F_1$ resolved along the normals of the flanks")
    )
    board.step(
        Words(
            "取 V 形部分为分离体：横截面内受压力 $F_1$ 和两侧面的法向反力 $N$（滑台垂直于图面移动，"
            "摩擦力也垂直于图面）。$F_1$ 已知，两个 $N$ 的方向已知；由对称，二者大小相等。按 $μ_F$ 作力多边形。",
            "Take the V as a free body: in the cross-section the load $F_1$ and the normal "
            "reactions $N$ of both flanks act on it (the slide moves perpendicular to the paper, "
            "and so friction acts). The load $F_1$ is known, and so are both directions of $N$; by symmetry the "
            "two are equal. Draw the force polygon to the scale $μ_F$.",
        ),
        plan,
    )
    ways = _body(bench, device, apart)
    sides = (Named("N_right", "N", "N"), Named("N_left", "N", "N"))
    closed = balance(
        bench,
        plan,
        0j,
        given(bench, plan, ON_V, on_v.value, -1j),
        *(
            sought(side, way, Words("⊥右侧面" if i == 0 else "⊥左侧面", "⊥ right flank" if i == 0 else "⊥ left flank"))
            for i, (side, way) in enumerate(zip(sides, ways, strict=True))
        ),
    )
    ends = closed.ends[sides[0].key]
    letter(bench, plan, {"a": closed.ends[ON_V.key][0], "b": ends[0], "c": ends[1]})
    return bench.measured(FLANK, plan, *ends, "b c")


def _body(bench: Bench, device: VeeGuide, place: Pane) -> tuple[complex, complex]:
    """The V drawn apart; the normals of its right and its left flank, into it."""
    board, theta = bench.board, device.theta.si
    right = complex(np.exp(1j * (pi / 2 - theta)))  # from the edge up the right flank
    left = -right.conjugate()
    body(bench, place, "slide", 0j, APART * right, APART * left)
    top = APART * 1j * right.imag
    pull(bench, place, top, -1j, ON_V.symbol)
    board.join(place, -4j, top, Role.CENTRE)
    board.angle(place, 0j, right, theta, 0.45 * APART, "θ")
    for flank, normal in ((right, 1j * right), (left, -1j * left)):
        at = 0.6 * APART * flank
        press(bench, place, Press(symbol="N", at=at, normal=normal, along=normal))
        board.right_angle(place, at, flank, -normal)
    return 1j * right, -1j * left
