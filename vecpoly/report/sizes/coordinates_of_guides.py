"""On the sketch of a mechanism: how far the line of a fixed guide is from the axes, and how far a driving block."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import isclose

from ...board.construction import Figure
from ...board.paper.extent import bounds
from ...board.paper.marks import Ground, Mark, Point, Role, Segment, TurnArrow
from ...foundation.patterns import pattern
from ...mechanism.model import FRAME, Mechanism, Prismatic
from ...problem.problem import Problem
from ...problem.values.seen import Counted
from .lines import span

_GUIDE = r"([xy])_(\w)"  # the symbol of a datum
_AXES = {"x": 1 + 0j, "y": 1j}
_LEAST, _NEAR, _AWAY = 1e-6, 0.5, 7.0  # m; mm: from the place that is told; beyond all that is drawn
_GROUND = 5.0  # mm: of a support, to its side


def coordinates_of_guides(problem: Problem, figure: Figure) -> Iterator[Mark]:
    """y_C from the x axis to the line of the guide, s_1 from the y axis to the block: beside all that is drawn."""
    spots = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label}
    mech, mm = problem.mechanism, figure.scale.value
    known = {spots[name]: at for name, at in mech.frame.items() if name in spots}
    if not known:
        return
    origin = next(spot - at / mm for spot, at in known.items())
    slid, drawn = _slid(problem), [*figure.marks]
    for datum in problem.given.data:
        if (found := pattern(_GUIDE).fullmatch(datum.symbol)) is not None:
            axis, pin = found[1], found[2]
        elif datum.symbol in slid:
            axis, pin = slid[datum.symbol]
        else:
            continue
        if abs(datum.si) > _LEAST and pin in spots:
            way = _AXES[axis]
            past = datum.si / mm - (way.conjugate() * (spots[pin] - origin)).real
            if any(abs(abs(past) - off / mm) < _NEAR for off in _offsets(mech, pin)):
                drawn += _measured(drawn, _from(known, way, origin), spots[pin] + past * way, way, datum.symbol)
    yield from drawn[len(figure.marks) :]


def _offsets(mech: Mechanism, pin: str) -> Iterator[float]:
    """How far (m) a pin is from the fixed guides along which its block slides."""
    yield 0.0
    yield from (abs(j.offset) for j in mech.joints if isinstance(j, Prismatic) and j.guide == FRAME and j.pin == pin)


def _slid(problem: Problem) -> Mapping[str, tuple[str, str]]:
    """Of each driving block its coordinate's symbol, with the axis along which it counts and its pin."""
    told = [datum.seen for datum in problem.given.data if isinstance(datum.seen, Counted)]
    pins = {j.block: j.pin for j in problem.mechanism.joints if isinstance(j, Prismatic) and j.guide == FRAME}
    return {f"s_{one.link}": ("y" if one.upright else "x", pins[one.link]) for one in told if one.link in pins}


def _from(known: Mapping[complex, complex], way: complex, origin: complex) -> complex:
    """A fixed pivot on the axis, or the origin."""
    on_axis = (spot for spot, at in known.items() if isclose((way.conjugate() * at).real, 0.0, abs_tol=_LEAST))
    return next(on_axis, origin)


def _measured(drawn: Sequence[Mark], start: complex, pin: complex, way: complex, symbol: str) -> tuple[Mark, ...]:
    """The distance along `way` on that side of all that is drawn from which its lines are shorter."""
    across = way * 1j if way.real else -1j * way

    def at(place: complex) -> float:
        return (across.conjugate() * place).real

    taken = [at(place) for place in _taken(drawn)]
    sides = (min(taken) - _AWAY, max(taken) + _AWAY)
    side = min(sides, key=lambda away: abs(away - at(start)) + abs(away - at(pin)))
    a, b = start + (side - at(start)) * across, pin + (side - at(pin)) * across
    role = Role.CENTRE if symbol[0] != "s" else Role.CONSTRUCTION
    beyond = 1.5 * across * (1 if side == sides[1] else -1)
    return (
        Segment(a=start, b=a + beyond, role=Role.CONSTRUCTION, step=1),
        Segment(a=pin, b=b + beyond, role=role, step=1),
        *span(a, b, symbol),
    )


def _taken(marks: Sequence[Mark]) -> Iterator[complex]:
    """The corners of all that is drawn, curved arrows and supports included."""
    yield from bounds(marks)
    for mark in marks:
        if isinstance(mark, TurnArrow | Ground):
            size = mark.radius if isinstance(mark, TurnArrow) else _GROUND
            yield from (mark.at - size * (1 + 1j), mark.at + size * (1 + 1j))
