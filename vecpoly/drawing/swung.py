"""Arcs of angles and curved arrows are swung where they cross no link, no hatching and no force: with another radius,
or, an arrow, begun elsewhere about its point. What they tell stays: vertex, rays and sense."""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Iterator, Sequence
from math import pi
from typing import Any

import numpy as np
import shapely

from ..board.paper.marks import AngleMark, FixedGuide, Ground, Mark, Role, Segment, TurnArrow, Vector
from ..foundation.slotted import replace
from .symbols.angles import TAIL, Arc, narrow, sweep_of
from .symbols.bodies import FOOT_HEIGHT, GROUND_HALF
from .symbols.outlines import outlines
from .symbols.shapes import NEAR

RADII = (1.0, 0.85, 0.7, 1.25, 0.6, 0.5)  # of what it has: the first that is clear
TURNS = tuple(sign * n * pi / 12 for n in range(13) for sign in ((1, -1) if n else (1,)))  # from where it begins
LEAST, CLEAR, APART = 5.0, 0.6, 1.6  # mm: radius; from a line; from another arc about the same point
HATCH = 1.4  # mm: depth of hatching that counts
FINE = 16  # chords of an arc
SAME = 0.01  # rad between two rays that are one
ARROW, ALONG = 0.9, 0.2  # what a curved arrow pays for a force that it crosses, or for its line, where a link costs 1

Acting = tuple[Any, float]  # a line, and what it costs


def swung(marks: tuple[Mark, ...]) -> tuple[Mark, ...]:
    """The marks of a figure, the arcs among them clear of lines where they can be."""
    arcs = [mark for mark in marks if isinstance(mark, Arc) and mark.radius > NEAR]
    if not arcs:
        return marks
    lines, grounds, acting = _lines(marks), shapely.union_all([*_grounds(marks)]), _acting(marks)
    found: dict[int, Arc] = {}
    for arc in arcs:
        others = [found.get(id(one), one) for one in arcs if one is not arc and abs(one.at - arc.at) < NEAR]
        found[id(arc)] = _clear(arc, lines, grounds, others, acting if isinstance(arc, TurnArrow) else ())
    return tuple(found.get(id(mark), mark) for mark in marks)


def marked_once(marks: tuple[Mark, ...]) -> tuple[Mark, ...]:
    """The marks without angles that are marked already, by the same symbol between the same rays."""
    seen, kept = list[AngleMark](), list[Mark]()
    for mark in marks:
        if isinstance(mark, AngleMark):
            if any(_is_one(mark, other) for other in seen):
                continue
            seen.append(mark)
        kept.append(mark)
    return tuple(kept)


def _is_one(one: AngleMark, other: AngleMark) -> bool:
    """Whether two marks are of one angle."""
    if one.label != other.label or abs(one.at - other.at) > NEAR:
        return False
    ways = [(arc.start, arc.start + arc.sweep)[:: 1 if arc.sweep > 0 else -1] for arc in (one, other)]
    return all(abs(cmath.rect(1.0, a) - cmath.rect(1.0, b)) < SAME for a, b in zip(*ways, strict=True))


def _clear(arc: Arc, lines: Any, grounds: Any, others: Iterable[Arc], acting: Sequence[Acting]) -> Arc:
    """The first of the ways to swing it that touches least; acting: arrows and lines that count, too."""
    reach = max(RADII) * arc.radius + CLEAR
    about = shapely.Point(arc.at.real, arc.at.imag)
    near = lines[shapely.dwithin(lines, about, reach)] if len(lines) else lines
    through = shapely.dwithin(near, about, NEAR) if len(near) else np.zeros(0, dtype=bool)
    hatched = shapely.intersection(grounds, about.buffer(reach))
    if not isinstance(arc, TurnArrow):
        near = near[~through]  # the rays of an angle end at its arc
    forces = [(line, much) for line, much in acting if shapely.dwithin(line, about, reach)]
    if not len(near) and hatched.is_empty and not forces:
        return arc
    best, least = arc, float("inf")
    for trial in _ways(arc):
        bow = _bow(trial)
        cost = float(shapely.dwithin(near, bow, CLEAR).sum()) + (shapely.distance(hatched, bow) < CLEAR / 3)
        cost += sum(_meets(trial, other) for other in others)
        cost += sum(much for line, much in forces if shapely.dwithin(line, bow, CLEAR))
        if cost < least - 1e-9:
            best, least = trial, cost
        if not cost:
            break
    return best


def _ways(arc: Arc) -> Iterator[Arc]:
    """As it is, then others."""
    turns = TURNS if isinstance(arc, TurnArrow) else (0.0,)
    for turn in turns:
        for share in RADII if isinstance(arc, AngleMark) else (1.0,):
            if share == 1.0 or share * arc.radius >= LEAST:
                yield replace(arc, radius=arc.radius * share, start=arc.start + turn)


def _bow(arc: Arc) -> Any:
    """The arc between its ends, which may touch the rays."""
    sweep = sweep_of(arc)
    low, high = (0.08, 0.92) if isinstance(arc, AngleMark) else (-0.05, 1.05)
    if isinstance(arc, AngleMark) and narrow(arc):  # with what is drawn of it beyond its rays
        beyond = TAIL / (arc.radius * abs(sweep))
        low, high = -beyond, 1.0 + beyond
    shares = np.linspace(low, high, FINE)
    points = arc.at + arc.radius * np.exp(1j * (arc.start + sweep * shares))
    return shapely.LineString(np.stack([points.real, points.imag], axis=1))


def _meets(arc: Arc, other: Arc) -> bool:
    """Whether two arcs about one point run nearly one over the other."""
    if abs(arc.radius - other.radius) > APART:
        return False
    ways = [other.start + sweep_of(other) * k / FINE for k in range(FINE + 1)]
    start, sweep = arc.start, sweep_of(arc)
    turned = ((way - start) * (1 if sweep > 0 else -1) % (2 * pi) for way in ways)
    return any(0.05 < turn < abs(sweep) - 0.05 for turn in turned)


def _lines(marks: Iterable[Mark]) -> Any:
    """The outlines of links and bodies."""
    ends = np.array([*outlines(marks)], dtype=complex).reshape(-1, 2)
    return shapely.linestrings(np.stack([ends.real, ends.imag], axis=-1)) if len(ends) else np.zeros(0, dtype=object)


def _acting(marks: Iterable[Mark]) -> list[Acting]:
    """The arrows of forces, and the lines along which they act."""
    vectors = [(mark.a, mark.b, ARROW) for mark in marks if isinstance(mark, Vector)]
    segments = (mark for mark in marks if isinstance(mark, Segment) and mark.role in (Role.DIRECTION, Role.IDEAL))
    ends = (one for one in (*vectors, *((m.a, m.b, ALONG) for m in segments)) if abs(one[1] - one[0]) > NEAR)
    return [(shapely.LineString([(a.real, a.imag), (b.real, b.imag)]), much) for a, b, much in ends]


def _grounds(marks: Iterable[Mark]) -> Iterator[Any]:
    """The hatched pieces under pivots and along guides."""
    for mark in marks:
        match mark:
            case Ground(at=at, down=down):
                u = down / abs(down)
                foot, side = at + FOOT_HEIGHT * u, 1j * GROUND_HALF * u
                yield _area(foot - side, foot + side, HATCH * u)
            case FixedGuide(a=a, b=b) if abs(b - a) > NEAR:
                yield _area(a, b, HATCH * (b - a) / abs(b - a) * cmath.exp(-0.5j * pi))
            case _:
                pass


def _area(a: complex, b: complex, deep: complex) -> Any:
    return shapely.Polygon([(z.real, z.imag) for z in (a, b, b + deep, a + deep)])
