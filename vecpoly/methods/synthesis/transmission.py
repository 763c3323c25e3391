"""The minimum transmission angle of a crank-rocker: drawn with the crank on the line of the frame, both ways."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np

from ...algebra.formula import Row, Txt, named
from ...algebra.quantity import Quantity
from ...board.construction import Scale, View
from ...board.paper.marks import Dot, Role
from ...board.paper.scales import finer
from ...board.place import Pane
from ...designs.quantities import AD, CD, GAMMA_MIN
from ...diagram.single import pivot as ground
from ...foundation.slotted import replace
from ...names import Named
from ...plane import Points, Reals, nominal, unit
from ...words import Words
from .angles import marked, valued
from .draft import Draft
from .linkage import crank_circle
from .touching import third

NAME = "gamma"  # of the figure, before the number of the solution
RIGHT = 90.0  # deg
BEYOND = 14.0  # mm of the coupler's line beyond C
SHORT, LONG = 50.0, 70.0  # mm: links so short have a scale of their own, at which they are no longer than this


@dataclass(frozen=True, slots=True, kw_only=True)
class Extreme:
    """A position with the crank on the line of the frame: its letters' primes, B and C, and the transmission angle: its
    symbol, with the number of the solution, and its size."""

    marks: str
    symbol: str
    b: Points
    c: Points
    gamma: Reals


def least_angle(draft: Draft, crank: Quantity, coupler: Quantity) -> None:
    """γ = ∠BCD, or 180° − ∠BCD where that is obtuse, at B′ on AD and at B″ on DA produced; the lesser is γ_min."""
    board, n = draft.board, draft.number
    which = Words.same("") if draft.alone else Words(f"（解 {n}）", f" (solution {n})")
    title = Words("最小传动角", "Minimum transmission angle") + which
    place = board.open_pane(View.MECHANISM, f"{NAME} {n}", title, _scale(draft, crank, coupler))
    to = _told(draft, place)
    board.step(
        Words(
            f"最小传动角出现在曲柄与机架共线的两位置之一。按各杆长度{to.zh}作此两位置 $AB′C′D$、$AB′′C′′D$，"
            "量 $∠BCD$；若为钝角，取其补角。",
            "The transmission angle is least in one of the two positions in which the crank is in line with the "
            f"frame. Draw both, $AB′C′D$ and $AB′′C′′D$, with the lengths of the links{to.en} and read $∠BCD$; if it "
            "is obtuse, take its supplement.",
        ),
        place,
        again=Words(
            f"同样按解 {n} 的长度作出这两个位置，量得最小传动角：",
            f"Likewise draw these two positions with the lengths of solution {n} and read the transmission angles:",
        ),
    )
    frame = _mm(draft, place, AD)
    a = board.locate(place, "A", 0j)
    d = board.locate(place, "D", board.lay_off(a, 1 + 0j, frame))
    both = [_extreme(draft, place, (a, d), crank, coupler, side) for side in (1, -1)]
    _linkages(draft, place, (a, d), both)
    crank_circle(draft, a, np.abs(both[0].b - a), place, sweep=pi)
    draft.stated(draft.of_this(GAMMA_MIN), np.minimum(both[0].gamma, both[1].gamma))
    for one in both:
        _marked(draft, place, d, one)


def _scale(draft: Draft, crank: Quantity, coupler: Quantity) -> Scale | None:
    """A finer scale of its own where links drawn to that of the sheet are short, which a large circle may tell; None:
    that of the sheet. Another solution has the scale of the first."""
    board, mu = draft.board, draft.board.scale_of(View.MECHANISM)
    earlier = (Pane(View.MECHANISM, f"{NAME} {one.number}") for one in draft.found)
    if (first := next((board.scales[one] for one in earlier if one in board.scales), None)) is not None:
        return first
    long = max(float(nominal(one)) * 1e-3 for one in (draft.own(AD) + crank.value, coupler.value, draft.own(CD)))
    if long / mu.value >= SHORT:
        return None
    value = mu.value
    for _ in range(draft.steps):
        value = finer(value) if long / finer(value) <= LONG else value
    return None if value == mu.value else replace(mu, value=value)


def _told(draft: Draft, place: Pane) -> Words:
    """By which scale the figure is drawn, where it is one of its own."""
    mu, own = draft.board.scale_of(View.MECHANISM), draft.board.scale_of(place)
    if own.value == mu.value:
        return Words.same("")
    told = f"${own.symbol} = {own.value:g}$ m/mm"
    return Words(f"（另取比例尺 {told}）", f" to the scale {told}")


def _mm(draft: Draft, place: Pane, named: Named) -> Reals:
    """A length found, or given, on paper."""
    return draft.own(named) * 1e-3 / draft.board.scale_of(place).value


def _extreme(
    draft: Draft, place: Pane, ends: tuple[Points, Points], crank: Quantity, coupler: Quantity, side: int
) -> Extreme:
    """The position with the crank along AD (side 1), or along DA produced (−1)."""
    board, (a, d), marks = draft.board, ends, "′" if side > 0 else "″"
    per_mm = 1e-3 / board.scale_of(place).value
    b = board.locate(place, f"B{marks}", board.lay_off(a, side + 0j, crank.value * per_mm))
    c = third(board, b, coupler.value * per_mm, d, _mm(draft, place, CD), f"C{marks}")
    c = board.locate(place, f"C{marks}", board.either(c))
    angle = draft.angle(c, b, d)
    gamma = np.minimum(angle, 180.0 - angle)
    primed = "γ" + marks.replace("″", "′′")  # as a symbol has them, which may have a number behind
    symbol = draft.of_this(Named(primed, primed, "deg")).symbol
    board.write(Row((named(symbol), Txt(f" = {float(nominal(gamma)):.1f}°"))))  # as the protractor is read
    return Extreme(marks=marks, symbol=symbol, b=b, c=c, gamma=gamma)


def _marked(draft: Draft, place: Pane, d: Points, one: Extreme) -> None:
    """γ at C: between CB and CD, or between BC produced and CD."""
    acute = float(nominal(draft.angle(one.c, one.b, d))) <= RIGHT
    beyond = one.c + BEYOND * unit(one.c - one.b)
    if not acute:
        draft.board.join(place, one.c, beyond, Role.CONSTRUCTION)
    marked(draft, one.c, (one.b if acute else beyond, d), valued(draft, one.symbol, one.gamma), place=place)


def _linkages(draft: Draft, place: Pane, ends: tuple[Points, Points], both: list[Extreme]) -> None:
    """Both positions, that of the lesser angle thick."""
    board, (a, d) = draft.board, ends
    for one in sorted(both, key=lambda one: -float(nominal(one.gamma))):
        role = Role.LINK if one.gamma is min(both, key=lambda e: float(nominal(e.gamma))).gamma else Role.OTHER
        for start, end in ((a, one.b), (one.b, one.c), (one.c, d)):
            board.join(place, start, end, role)
        board.plot(place, one.b, f"B{one.marks}", Dot.JOINT)
        board.plot(place, one.c, f"C{one.marks}", Dot.JOINT)
    for letter, at in (("A", a), ("D", d)):
        board.plot(place, at, letter, Dot.JOINT)
        board.depict(place, ground(at))
