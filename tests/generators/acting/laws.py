"""Loads that depend on place and speed on random mechanisms; a third party finds their sizes from positions alone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from vecpoly import oracle
from vecpoly.errors import VecpolyError
from vecpoly.mechanism.laws.sizes import Motor, Table
from vecpoly.mechanism.laws.springs import Coil, Elastic
from vecpoly.mechanism.laws.windows import During, Moving, Turning, Window
from vecpoly.mechanism.loads import Force, Load, Loads, Moment
from vecpoly.mechanism.model import FRAME, Mechanism
from vecpoly.solution import Solution

from .. import moving
from ..equilibrium import in_equilibrium
from ..family import family
from ..forces import free, friction, masses, moment, simple, some, written
from ..loaded import Chain

NEAR = 1e-4  # of the stroke, or of the largest rate: so near to an edge differences cannot tell on which side it is
NEARER = 2e-4  # rad: the step of the differences for rates alone


class Unsure(Exception):
    """The position is so near to an edge that the third party cannot judge."""


def balanced_by_hand(solution: Solution) -> str:
    """Σ F and Σ M of every body, with sizes found from central differences of positions."""
    problem = solution.problem
    assert problem.loads is not None
    try:
        at = moving.Moving.of(problem.mechanism)
        plain = _plain(at, problem.loads)
    except (VecpolyError, Unsure):
        return ""
    return in_equilibrium(replace(solution, problem=replace(problem, loads=plain)))


def _plain(at: moving.Moving, loads: Loads) -> Loads:
    """The same loads, each of constant size."""
    found: list[Load] = [_sized(at, load) for load in loads.all]
    for spring in loads.springs:
        found += _ends(at, spring)
    forces = tuple(one for one in found if isinstance(one, Force))
    moments = tuple(one for one in found if isinstance(one, Moment))
    return replace(loads, forces=forces, moments=moments, springs=())


def _sized(at: moving.Moving, load: Load) -> Load:
    if load.law is None:
        return load
    acts = all(_within(at, window) for window in load.law.windows)
    size = load.size
    match load.law.size:
        case Motor(stall=stall, slope=slope):
            size = stall - slope * at.mech.drive.rate
        case Table(over=None, period=0.0) as table:
            size = float(np.interp(at.mech.drive.position, table.places, table.sizes))
        case Table(over=None) as table:
            size = float(np.interp(at.mech.drive.position % table.period, table.places, table.sizes))
        case Table() as table:
            assert table.over is not None
            gone, _ = _travel(at, table.over.link, table.over.point, table.over.direction)
            size = float(np.interp(gone, table.places, table.sizes))
        case None:
            pass
    return replace(load, law=None, size=size if acts else 0.0)


def _within(at: moving.Moving, window: Window) -> bool:
    match window:
        case During(low=low, high=high, period=period):
            return bool((at.mech.drive.position - low) % period < (high - low) % period)
        case Turning(link=link, sense=sense):
            return bool(_sure(sense * at.omega(link) / at.mech.drive.rate) * np.sign(at.mech.drive.rate) > 0)
        case Moving(link=link, point=point, direction=way):
            velocity = at.velocity(link, at.mech.link(link).points[point]) * np.exp(-1j * way)
            if _sure(velocity.real / at.mech.drive.rate / at.mech.scale) * at.mech.drive.rate <= 0:
                return False
            if not window.is_part:
                return True
            gone, whole = _travel(at, link, point, way)
            return _sure(gone / whole - window.low) > 0 and _sure(window.high - gone / whole) > 0


def _sure(value: float) -> float:
    if abs(value) < NEAR:
        raise Unsure
    return value


def _travel(at: moving.Moving, link: str, point: str, way: float) -> tuple[float, float]:
    """How far the point has gone, and its stroke, from twenty thousand positions, and again about both ends."""
    local = at.mech.link(link).points[point]

    def path(q: np.ndarray) -> np.ndarray:
        motion = oracle.solve(at.mech, q, order=0, strict=False)
        return np.real((motion.origin(link) + np.exp(1j * motion.angle(link)) * local) * np.exp(-1j * way))

    q = _range(at.mech)
    there = path(q)
    high, low = _highest(path, q, there), -_highest(lambda at: -path(at), q, -there)
    here = (at.place(link, local) * np.exp(-1j * way)).real
    return here - low, high - low


def _highest(path: Callable[[np.ndarray], np.ndarray], q: np.ndarray, there: np.ndarray) -> float:
    """The greatest value between the neighbours of the highest place of the grid."""
    i = int(np.nanargmax(there))
    return float(np.nanmax(path(np.linspace(q[max(i - 1, 0)], q[min(i + 1, q.size - 1)], 2001))))


def _range(mech: Mechanism) -> np.ndarray:
    own = mech.drive.position
    for low, high in oracle.spans(mech):
        turn = 2 * np.pi * np.floor((own - low) / (2 * np.pi) + 1e-9)
        if low + turn - 1e-9 <= own <= high + turn + 1e-9:
            share = (1 - np.cos(np.linspace(0, np.pi, 20001))) / 2  # crowding at the ends
            return np.asarray(low + turn + (high - low) * share)
    return np.array([own])


def _ends(at: moving.Moving, spring: Elastic) -> list[Load]:
    """What a spring does to the links at its ends; its rate by differences nearer than those of accelerations."""
    at = moving.Moving.of(at.mech, NEARER)
    if isinstance(spring, Coil):
        turn = _angle(at, spring.link) - _angle(at, spring.against) - spring.free
        turn = (turn + np.pi) % (2 * np.pi) - np.pi
        rate = at.omega(spring.link) - at.omega(spring.against)
        size = -(spring.preload + spring.stiffness * turn + spring.damping * rate)
        pair = ((spring.link, size), (spring.against, -size))
        return [Moment(name=f"{spring.name}{i}", link=one, size=m) for i, (one, m) in enumerate(pair) if one != FRAME]
    ends = ((spring.link, spring.point), (spring.against, spring.foot))
    paths = [at.path(link, at.mech.link(link).points[letter]) for link, letter in ends]
    lengths = np.abs(paths[0] - paths[1])
    rate = float(lengths @ np.array([1.0, -8.0, 0.0, 8.0, -1.0])) / 12 / at.step * at.mech.drive.rate
    size = spring.preload + spring.stiffness * (float(lengths[2]) - spring.free) + spring.damping * rate
    way = float(np.angle(paths[1][2] - paths[0][2]))
    return [
        Force(name=f"{spring.name}{i}", link=link, point=letter, direction=way + i * np.pi, size=size)
        for i, (link, letter) in enumerate(ends)
        if link != FRAME
    ]


def _angle(at: moving.Moving, link: str) -> float:
    return 0.0 if link == FRAME else float(at.motion.angle(link)[2])


def windowed(c: Chain, name: str, link: str, letter: str) -> str:
    """A force on a link that acts in part of the motion, or by a table."""
    rng, way = c.rng, int(c.rng.integers(-179, 180))
    size = f"{rng.integers(50, 900)} N"
    match int(rng.integers(5 if letter not in c.frame else 3)) + (2 if letter in c.frame else 0):
        case 0:
            when = f"while: {letter} moves {rng.choice(['left', 'right', 'up', 'down'])}"
        case 1:
            low, high = sorted(int(x) for x in rng.choice(101, 2, replace=False))
            when = f"while: {letter} moves along {rng.integers(-179, 180)} deg, between: [{low} %, {high} %]"
        case 2:
            when = f"during: [{rng.integers(0, 360)} deg, {rng.integers(0, 360)} deg]"
        case 3:
            when = f"while: @{rng.choice(list(c.links))} turns {rng.choice(['ccw', 'cw'])}"
        case _:
            rows = ", ".join(f"[{x}, {rng.integers(-500, 500)}]" for x in range(0, 361, 45))
            size, when = f"{{columns: [phi (deg), F (N)], rows: [{rows}]}}", ""
    tail = f", {when}" if when else ""
    return f"  {name}: {{on: @{link}, at: {letter}, size: {size}, direction: {way} deg{tail}}}\n"


def sprung(c: Chain, name: str) -> str:
    """A spring or a damper between two links, or a link and the frame."""
    rng = c.rng
    one, other = (str(x) for x in rng.choice(list(c.links), 2, replace=False))
    if rng.random() < 0.3:
        other = "frame"
    more = f", c: {rng.integers(1, 60)} " if rng.random() < 0.5 else ""
    if rng.random() < 0.35:
        damped = f"{more}N*m*s" if more else ""
        return f"  M_{name}: {{spring: @{one}-@{other}, k: {rng.integers(1, 40)} N*m/rad, phi_0: 20 deg{damped}}}\n"
    damped = f"{more}N*s/m" if more else ""
    foot = f"{rng.choice(c.links[other])}@{other}" if other != "frame" else str(rng.choice(c.frame))
    ends = f"{rng.choice(c.links[one])}@{one}-{foot}"
    preload = f", preload: {rng.integers(-200, 200)} N" if rng.random() < 0.4 else ""
    free = f"k: {rng.integers(1, 8)} N/mm, l_0: {rng.integers(20, 300)} mm"
    return f"  F_{name}: {{spring: {ends}, {free}{preload}{damped}}}\n"


def lawful(c: Chain) -> str:
    """One to three loads by laws."""
    text = ""
    for i in range(int(c.rng.integers(1, 4))):
        link = str(c.rng.choice(list(c.links)))
        own = c.rng.random() < 0.5
        text += sprung(c, f"s{i}") if own else windowed(c, f"F_w{i}", link, str(c.rng.choice(c.links[link])))
    return text


@family("forces-laws", also=balanced_by_hand, often=1, first=1)
def laws(rng: np.random.Generator) -> str:
    """Windows, tables, springs and dampers beside plain loads, with masses in some."""
    c = simple(rng)
    plain = some(c, 1) if rng.random() < 0.5 else moment(c, "M_q", str(rng.choice(list(c.links))))
    return written(c, lawful(c) + plain + free(c, "L0"), masses(c) if rng.random() < 0.3 else "")


@family("forces-laws-friction", also=balanced_by_hand, often=1)
def with_friction(rng: np.random.Generator) -> str:
    """The same with friction."""
    c = simple(rng)
    return written(c, lawful(c) + some(c, 1) + free(c, "L0"), friction(c))
