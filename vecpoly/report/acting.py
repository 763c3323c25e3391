"""What acts on a mechanism, drawn on its sketch: forces and moments as arrows, friction circles;
nothing that has to be found."""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from math import pi

from ..board.construction import Figure
from ..board.paper.arrow_radius import clear_radius
from ..board.paper.marks import Block, Disc, Dot, FrictionCircle, Mark, Point, Role, Segment, TurnArrow, Vector
from ..board.paper.pulling import pulls
from ..diagram.single import pivot
from ..diagram.springs.straight import damper, spring_symbol
from ..diagram.springs.torsion import OUTER, coil_symbol
from ..foundation.slotted import replace
from ..mechanism.asked.forces import load_named, load_symbol
from ..mechanism.laws.springs import Coil, Spring
from ..mechanism.loads import Force, Load, Loads, Moment
from ..mechanism.model import FRAME, Mechanism

ARROW = 16.0  # mm, length of a force
TURN_RADIUS = 7.0  # mm, of a moment's arrow
BESIDE = 14.0  # mm, of a moment's arrow about a pivot that the driving arrow turns about
COILED = OUTER + 2.0  # mm, from a pin to the letter of the torsion spring about it
CLEAR = 1.5  # mm between a force's arrow and its point
LEAST = 2.2  # mm, the smallest friction circle that can be seen about a pin


def acting(mech: Mechanism, loads: Loads, figure: Figure, drawn: Sequence[Figure]) -> tuple[Mark, ...]:
    """Marks of the loads and of the friction circles for the mechanism as drawn; drawn: all figures of the solution,
    the mechanism to scale first: a load pulls at its point or presses on it as it does there."""
    spots = {m.label: m.at for m in figure.marks if isinstance(m, Point)}
    circles = tuple(
        FrictionCircle(centre=spots[pin], radius=max(rho / figure.scale.value, LEAST), step=1)
        for pin, rho in loads.friction.pins.items()
        if rho and pin in spots
    )
    arrows: list[Mark] = []
    for load in loads.all:
        if (mark := _arrow(mech, load, spots, figure, drawn, arrows)) is not None:
            arrows.append(mark)
    return circles + _springs(mech, loads, spots) + _coils(mech, loads, spots) + tuple(arrows)


def _springs(mech: Mechanism, loads: Loads, spots: dict[str, complex]) -> tuple[Mark, ...]:
    """Springs and dampers between the points that are drawn, each with its letter."""
    found: list[Mark] = []
    for spring in (one for one in loads.springs if isinstance(one, Spring) and {one.foot, one.point} <= set(spots)):
        foot, point = spots[spring.foot], spots[spring.point]
        if abs(point - foot) < 1e-6:
            continue
        draw = spring_symbol if spring.stiffness else damper
        aside = 5j * (point - foot) / abs(point - foot)
        symbols = (draw(foot, point), *((pivot(foot),) if mech.links_at(spring.foot) == (FRAME,) else ()))
        found += [replace(mark, step=1) for symbol in symbols for mark in symbol.marks]
        found.append(Point(at=(foot + point) / 2 + aside, label=load_symbol(spring.name), dot=Dot.NONE, step=1))
    return tuple(found)


def _coils(mech: Mechanism, loads: Loads, spots: dict[str, complex]) -> tuple[Mark, ...]:
    """Torsion springs about their pins, each with its letter."""
    found: list[Mark] = []
    for coil in (one for one in loads.springs if isinstance(one, Coil)):
        for pin in (one for one in mech.shared(coil.link, coil.against)[:1] if one in spots):
            found += [replace(mark, step=1) for mark in coil_symbol(spots[pin]).marks]
            found.append(Point(at=spots[pin] - COILED, label=load_symbol(coil.name), dot=Dot.NONE, step=1))
    return tuple(found)


def _arrow(
    mech: Mechanism, load: Load, spots: dict[str, complex], figure: Figure, drawn: Sequence[Figure],
    arrows: Sequence[Mark],
) -> Mark | None:  # fmt: skip
    """The arrow of one load, beside those that are there; none for a moment that is sought, unless told to drive or to
    resist: then its sense is known."""
    symbol = load_named(load).symbol
    if isinstance(load, Force) and load.against:
        return _thrust(load, spots, symbol)
    if isinstance(load, Force):
        return (
            _force(load, spots[load.point], symbol, figure, _pulls(load, symbol, drawn[0]))
            if load.point in spots
            else None
        )
    return _moment(mech, load, spots, symbol, figure, drawn, arrows)


def _pulls(load: Force, symbol: str, sheet: Figure) -> bool | None:
    """Whether the load begins at its point on the sheet; None where it is not drawn there."""
    at = next((m.at for m in sheet.marks if isinstance(m, Point) and m.label == load.point), None)
    return None if at is None else pulls(sheet.marks, symbol, at)


def _force(load: Force, at: complex, symbol: str, figure: Figure, pulls: bool | None) -> Vector:
    """Pulling away from its point or pushing at it: as on the sheet, else whichever side is clearer of lines."""
    along = cmath.rect(1.0, load.direction)
    pull, push = (at + CLEAR * along, at + ARROW * along), (at - ARROW * along, at - CLEAR * along)
    ways = (pull, push) if pulls is None else (pull,) if pulls else (push,)
    a, b = max(ways, key=lambda ends: _room(ends, figure))
    return Vector(a=a, b=b, role=Role.GIVEN, label=symbol, step=1)


def _thrust(load: Force, spots: dict[str, complex], symbol: str) -> Vector | None:
    """The arrow of a cylinder's thrust, beside its rod."""
    if not {load.foot, load.point} <= set(spots) or spots[load.foot] == spots[load.point]:
        return None
    ray = spots[load.point] - spots[load.foot]
    along = ray / abs(ray)
    start = spots[load.foot] + 0.55 * ray + 5j * along
    return Vector(a=start, b=start + ARROW * along, role=Role.GIVEN, label=symbol, step=1)


def _room(ends: tuple[complex, complex], figure: Figure) -> float:
    """How far the outer two thirds of an arrow stay from the lines of the figure (mm)."""
    points = [ends[0] + (ends[1] - ends[0]) * t / 12 for t in range(13)]
    lines = [(m.a, m.b) for m in figure.marks if isinstance(m, Segment)]
    lines += [(m.at - 5 * m.along, m.at + 5 * m.along) for m in figure.marks if isinstance(m, Block)]
    discs = [min(abs(p - m.centre) - m.radius for p in points) for m in figure.marks if isinstance(m, Disc)]
    gaps = sorted(min((_gap(p, a, b) for a, b in lines), default=ARROW) for p in points)
    return min(sum(gaps) / len(gaps), *discs, ARROW)


def _gap(p: complex, a: complex, b: complex) -> float:
    """Distance of a point from a segment."""
    span = b - a
    along = 0.0 if span == 0 else max(0.0, min(1.0, ((p - a) * span.conjugate()).real / abs(span) ** 2))
    return abs(p - a - along * span)


def _moment(
    mech: Mechanism, load: Moment, spots: dict[str, complex], symbol: str, figure: Figure, drawn: Sequence[Figure],
    arrows: Sequence[Mark],
) -> TurnArrow | None:  # fmt: skip
    """About the link's fixed pivot, or its first lettered point; opposite the driving arrow where both turn about one
    pivot, farther out where a circle or another arrow is in its way."""
    letters = [p for p in mech.link(load.link).points if p in spots]
    centre = next((p for p in letters if p in mech.frame), letters[0] if letters else None)
    if centre is None:
        return None
    at = spots[centre]
    driving = next((m for m in figure.marks if isinstance(m, TurnArrow) and abs(m.at - at) < 1e-6), None)
    ccw = _sense(load, driving, symbol, drawn)
    start = pi / 4 if driving is None else driving.start + pi
    least = TURN_RADIUS if driving is None else BESIDE
    size = clear_radius([mark for mark in (*figure.marks, *arrows) if mark is not driving], at, least)
    return None if ccw is None else TurnArrow(at=at, radius=size, start=start, ccw=ccw, label=symbol, step=1)


def _sense(load: Moment, driving: TurnArrow | None, symbol: str, drawn: Sequence[Figure]) -> bool | None:
    """Whether it turns counter-clockwise: as given; as the input is told to turn, or against that; on another link as
    on its free body, for a resistance acts against the motion of its link."""
    if load.size is not None:
        return load.size > 0
    if not load.role:
        return None
    if driving is not None:
        return driving.ccw is (load.role == "driving")
    turns = (mark for figure in drawn for mark in figure.marks if isinstance(mark, TurnArrow))
    return next((mark.ccw for mark in turns if mark.label == symbol), None)
