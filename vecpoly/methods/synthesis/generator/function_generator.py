"""A function generator: the crank by two trials, C by inversion; Freudenstein's numbers; the error curve."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ....algebra.quantity import Quantity, Sum, magnitude
from ....algebra.worked import stated
from ....board.paper.marks import Dot, Role
from ....designs.generator.function_generator import P0, P1, P2, FunctionGenerator
from ....designs.inversion.loops import Hinged
from ....designs.inversion.plan import FRAME, Body, Find, On, Pin, Plan, Position
from ....designs.quantities import AB, AD, BC, CD
from ....designs.verdict import Verdict
from ....foundation.frozen import FrozenMap
from ....foundation.slotted import replace
from ....names import Named
from ....plane import Points, Reals, nominal
from ....plane.geometry import dot
from ....words import Words
from ..angles import marked
from ..draft import SHEET, TWO, Draft
from ..inversion.find import find
from ..inversion.finish import closed, joined
from ..inversion.judged import judged
from ..inversion.sheet import Sheet, Stands
from ..linkage import pin, pivot
from ..registry import design_method
from .chebyshev import Pair, precision_pairs
from .error import error_curve, passes
from .trials import crank_length
from .trying import kept_position

REACH = 0.4  # of the frame: to the point that marks the line of a link
_B = Find(pin="B", on="AM", known="C", lies=On())
_C = Find(pin="C", on="DN", known="B", lies=On())


@design_method(
    FunctionGenerator,
    title=Words("按三个精确点设计函数发生机构", "Function generator with three precision points"),
    source="机械原理, synthesis by inversion for three pairs of angles; Chebyshev's spacing; Freudenstein's equation",
    example="8-18",
)
def draw_function_generator(draft: Draft, design: FunctionGenerator) -> None:
    """Precision points, the crank, C, the linkage, its error."""
    pairs = precision_pairs(draft, design) if design.pairs is None else _angles(draft, design)
    sheet = _laid_out(draft, design, pairs)
    angles = tuple((float(nominal(phi)), float(nominal(psi))) for phi, psi in pairs)
    kept = kept_position(angles)
    sheet = find(_with_crank(sheet, crank_length(sheet, angles, kept)), replace(_C, kept=kept))
    verdict = judged(sheet)
    if verdict is Verdict.VALID and design.function is not None and not passes(sheet, design):
        verdict = Verdict.RANGE
    joined(sheet, verdict)
    _freudenstein(sheet)
    if design.function is not None and verdict is Verdict.VALID:
        error_curve(sheet, design)
    closed(sheet, verdict)


def _angles(draft: Draft, design: FunctionGenerator) -> tuple[Pair, ...]:
    given = draft.board.given
    return tuple((given(one.one, f"phi_{n}"), given(one.two, f"psi_{n}")) for n, one in enumerate(design.pairs or ()))


def _laid_out(draft: Draft, design: FunctionGenerator, pairs: tuple[Pair, ...]) -> Sheet:
    """The pivots, and the lines of both links in the three positions."""
    board = draft.board
    board.section(Words("对应位置", "The corresponding positions"))
    board.step(
        Words(
            "选 $μ_l$，画出固定铰链 $A$、$D$，按三组对应角作两连架杆的标线 $AM_1$、$AM_2$、$AM_3$ 和 $DN_1$、$DN_2$、"
            "$DN_3$。"
            "$B$ 在标线 $AM$ 上，$C$ 在标线 $DN$ 上（或其反向延长线上）。",
            "Choose $μ_l$, draw the pivots $A$ and $D$, and at the three pairs of angles the lines $AM_1$, $AM_2$, "
            "$AM_3$ and $DN_1$, $DN_2$, $DN_3$ of both links. Point $B$ lies on $AM$ and $C$ on $DN$, or on these "
            "lines produced backwards.",
        ),
        SHEET,
    )
    frame = draft.mm(design.AD.si)
    a = pivot(draft, "A", 0j)
    d = pivot(draft, "D", board.lay_off(a, 1 + 0j, frame, key="AD"))
    bodies = {
        name: tuple(_ray(draft, name, centre, pair[which], REACH * frame, n) for n, pair in enumerate(pairs, 1))
        for name, centre, which in (("AM", a, 0), ("DN", d, 1))
    }
    _angles_marked(draft, (a, d), bodies, frame, pairs)
    pins = {letter: (at,) * 3 for letter, at in (("A", a), ("D", d))}
    return Sheet(draft=draft, plan=_plan(design, pairs), pins=FrozenMap(pins), bodies=FrozenMap(bodies))


def _angles_marked(
    draft: Draft,
    ends: tuple[Points, Points],
    bodies: Mapping[str, tuple[Stands, ...]],
    frame: Reals,
    pairs: tuple[Pair, ...],
) -> None:
    """φ and ψ of each position, from the line AD, as they are given: 274° is no 86° the other way."""
    axes = ends[1], ends[1] + REACH * frame
    draft.board.join(SHEET, ends[0], axes[1], Role.CENTRE)
    names = ("φ", "phi"), ("ψ", "psi")
    for which, (at, axis, body) in enumerate(zip(ends, axes, ("AM", "DN"), strict=True)):
        symbol, key = names[which]
        for n, stands in enumerate(bodies[body]):
            rays, told = (axis, stands.end), f"{symbol}_{n + 1}"
            marked(draft, at, rays, told, key=f"{key}_{n + 1}", nth=n, turn=pairs[n][which])


def _ray(draft: Draft, name: str, centre: Points, angle: Reals, reach: float, n: int) -> Stands:
    """The line of a link in position n, and the point that marks it."""
    board = draft.board
    along = board.ray(centre, 1 + 0j, angle, key=f"{name}{n}").along
    end = board.lay_off(centre, along, reach)
    board.join(SHEET, centre, end, Role.GIVEN)
    return Stands(start=centre, end=pin(draft, f"{name[1]}_{n}", end, Dot.POINT))


def _plan(design: FunctionGenerator, pairs: tuple[Pair, ...]) -> Plan:
    """As a chain of pins: what is judged, and what is read."""
    bodies = tuple(
        Body(
            name=name,
            pivot=name[0],
            positions=tuple(Position(at=at, angle=float(nominal(pair[which]))) for pair in pairs),
        )
        for name, at, which in (("AM", 0j, 0), ("DN", complex(design.AD.si), 1))
    )
    pins = Pin(letter="A", on=FRAME, at=0j), Pin(letter="D", on=FRAME, at=complex(design.AD.si))
    return Plan(count=3, bodies=bodies, pins=pins, stages=(_C, _B), loops=(Hinged(a="A", b="B", c="C", d="D"),))


def _with_crank(sheet: Sheet, crank: Reals) -> Sheet:
    """B in all positions, with the dividers."""
    draft, stands = sheet.draft, sheet.bodies["AM"]
    side = 1 if float(nominal(crank)) > 0 else -1
    draft.board.step(
        Words(
            "在三条标线 $AM$ 上截取 $AB$，得 $B_1$、$B_2$、$B_3$。",
            "Lay off $AB$ on all three lines $AM$: $B_1$, $B_2$, $B_3$.",
        )
        + (
            Words("", "")
            if side > 0
            else Words("（负值：量在反向延长线上。）", " (Negative lengths lie on the lines produced backwards.)")
        ),
        SHEET,
    )
    laid = [draft.board.lay_off(at.start, side * at.along, np.abs(crank)) for at in stands]
    return sheet.with_pin("B", tuple(pin(draft, f"B_{n}", at) for n, at in enumerate(laid, 1)))


def _freudenstein(sheet: Sheet) -> None:
    """P0 = c/a, P1 = −c/d, P2 = (a² + c² + d² − b²) / (2 a d), a and c with their signs; b = l_BC, d = l_AD."""
    draft = sheet.draft
    told = Words(
        "代入弗洛伊登斯坦方程 $cos φ = P_0 cos ψ + P_1 cos(ψ − φ) + P_2$ 校核；$a$、$c$ 即 $l_{AB}$、"
        "$l_{CD}$，与标线方向相反时取负值：",
        "Check by Freudenstein's equation $cos φ = P_0 cos ψ + P_1 cos(ψ − φ) + P_2$; $a$ and $c$ are "
        "$l_{AB}$ and $l_{CD}$, negative where the link points against its line:",
    )
    draft.board.step(told, SHEET)
    a, c = (_signed(sheet, key, *at) for key, at in (("a", (AB, "AM", "B")), ("c", (CD, "DN", "C"))))
    b, d = (magnitude(key, draft.own(named), "mm") for key, named in (("l_{BC}", BC), ("l_{AD}", AD)))
    draft.worked(draft.of_this(P0), c / a)
    draft.worked(draft.of_this(P1), Sum((c / d,), (-1,)))
    draft.worked(draft.of_this(P2), (a.squared() + c.squared() + d.squared() - b.squared()) / (TWO * a * d))


def _signed(sheet: Sheet, symbol: str, length: Named, body: str, letter: str) -> Quantity:
    """A length with the sign that tells whether it points along the line of its link."""
    draft, stands = sheet.draft, sheet.bodies[body][0]
    way = 1 if float(nominal(dot(stands.along, sheet.pins[letter][0] - stands.start))) > 0 else -1
    found = magnitude(symbol, way * draft.own(length), "mm")
    draft.board.write(stated(found))
    return found
