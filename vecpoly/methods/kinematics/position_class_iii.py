"""A class III group of hinges located by trial (试凑法): one leg is let go, its end traces a path, and the leg's arc cuts the path."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ...board.construction import View
from ...board.marks import Role, Segment
from ...errors import AssemblyError, NoMethodError
from ...mechanism.assur import Group
from ...mechanism.model import Revolute
from ...plane import Points, Reals, circles_meet, nominal, similar, unit
from ...words import Words
from ..desk import Desk
from ..registry import Stage, method

SCAN, ROUNDS = 7200, 30  # trials a turn; rounds of the secant
SHOWN = np.linspace(-0.2, 0.2, 9)  # rad from the place found: trials that are drawn
CLOSE = 1e-9  # of a leg: what is open when a trial fits


@dataclass(frozen=True, slots=True)
class Leg:
    """A link with two hinges: `outer` on a known link, `inner` on the plate."""

    link: str
    outer: str
    inner: str


Legs = tuple[Leg, Leg, Leg]


@method(stage=Stage.POSITION, group="class III", source="机械原理, class III groups by trial", example="class-iii",
        title=Words("Ⅲ级杆组的位置（试凑法）", "Position of a class III group, by trial"))
def position_class_iii(desk: Desk, group: Group) -> None:
    """The first leg is turned until the plate, held by the second, reaches the third leg's circle."""
    plate, three = _legs(group)
    starts = [(legs, *start) for legs in _orders(three) for start in _scan(desk, plate, legs)]
    if not starts:
        raise AssemblyError(Words(
            f"构件 {plate}、{'、'.join(leg.link for leg in three)} 不能装配：无论一支杆如何转动，三副构件都到不了另外两支杆的圆弧",
            f"links {plate}, {', '.join(leg.link for leg in three)} cannot be joined: however one leg is turned, the plate does not reach the circles of both others"))
    legs, theta0, left = min(starts, key=lambda start: _off(desk, start[0], _trial(desk, plate, start[0], np.asarray(start[1]), start[2])))
    theta = _settled(desk, plate, legs, theta0, left)
    a, b, _ = legs
    desk.board.step(_words(plate, legs), View.MECHANISM)
    _draw_trials(desk, plate, legs, float(nominal(theta)), left)
    found = _trial(desk, plate, legs, theta, left)
    radius = desk.board.hand.carry(_reach(desk, a))
    desk.at[a.inner] = desk.at[a.outer] + radius * unit(found[0] - desk.at[a.outer])
    pair = desk.board.arcs(desk.at[a.inner], _side(desk, plate, a, b), desk.at[b.outer], _reach(desk, b), Words(f"构件 {plate} 与 {b.link} 在 {b.inner} 处", f"links {plate} and {b.link} at {b.inner}"))
    desk.at[b.inner] = min(pair, key=lambda at: abs(complex(nominal(at)) - complex(nominal(found[1]))))
    desk.settle(plate, (a.inner, b.inner))
    for leg in legs:
        desk.board.swing(View.MECHANISM, desk.at[leg.outer], _reach(desk, leg), desk.at[leg.inner])
        desk.settle(leg.link, (leg.outer, leg.inner))


def _legs(group: Group) -> tuple[str, Legs]:
    """The plate and its legs; raises NoMethodError where the group has slides, or is of another shape."""
    joints = (*group.inner, *(outer.joint for outer in group.outer))
    plates = [link for link in group.links if sum(isinstance(j, Revolute) and link in (j.a, j.b) for j in group.inner) == 3]
    legs = []
    for outer in group.outer:
        inner = next((j for j in group.inner if isinstance(j, Revolute) and outer.link in (j.a, j.b)), None)
        if isinstance(outer.joint, Revolute) and inner is not None:
            legs.append(Leg(outer.link, outer.joint.point, inner.point))
    if len(plates) != 1 or len(legs) != 3 or len(group.links) != 4 or not all(isinstance(j, Revolute) for j in joints):
        raise NoMethodError(Words(
            f"{group.name.zh}不是仅以铰链联接三支杆的三副构件，没有确定其位置的图解法；可用 vecpoly exact 求解析解",
            f"the {group.name.en} is not a plate on three legs with hinges alone, and no graphical method on file locates it; 'vecpoly exact' gives its analytic answers"))
    return plates[0], (legs[0], legs[1], legs[2])


def _reach(desk: Desk, leg: Leg) -> float:
    """A leg's length on paper (mm)."""
    points = desk.body(leg.link).points
    return desk.mm(abs(points[leg.inner] - points[leg.outer]))


def _side(desk: Desk, plate: str, one: Leg, two: Leg) -> float:
    points = desk.body(plate).points
    return desk.mm(abs(points[one.inner] - points[two.inner]))


def _trial(desk: Desk, plate: str, legs: Legs, theta: Reals, left: bool) -> tuple[Points, Points, Points]:
    """The plate's pins where the first leg has this direction."""
    one, two, three = legs
    at = desk.at[one.outer] + _reach(desk, one) * np.exp(1j * theta)
    second = circles_meet(at, _side(desk, plate, one, two), desk.at[two.outer], _reach(desk, two))[0 if left else 1]
    body = desk.body(plate).points
    return at, second, similar(body[one.inner], body[two.inner], body[three.inner], at, second)


def _open(desk: Desk, plate: str, legs: Legs, theta: Reals, left: bool) -> Reals:
    """By how much the third pin misses its leg's circle (mm)."""
    gap: Reals = np.abs(_trial(desk, plate, legs, theta, left)[2] - desk.at[legs[2].outer]) - _reach(desk, legs[2])
    return gap


def _off(desk: Desk, legs: Legs, found: tuple[Points, Points, Points]) -> float:
    """How far the pins lie from where the problem says they are about (mm)."""
    guesses = desk.mech.guesses
    return sum(abs(complex(nominal(at)) - desk.mm(1.0) * guesses[leg.inner]) for leg, at in zip(legs, found, strict=True) if leg.inner in guesses)


def _orders(three: Legs) -> tuple[Legs, ...]:
    """Each leg first once: where one stands at the end of its range another does not."""
    a, b, c = three
    return (a, b, c), (b, c, a), (c, a, b)


def _scan(desk: Desk, plate: str, legs: Legs) -> list[tuple[float, bool]]:
    """Assemblies: directions of the first leg between which the gap changes sign, and the side on which the second pin lies.

    Raises AssemblyError where nothing says which is meant.
    """
    if not any(leg.inner in desk.mech.guesses for leg in legs):
        pins = ", ".join(leg.inner for leg in legs)
        raise AssemblyError(Words(
            f"构件 {plate}、{'、'.join(leg.link for leg in legs)}：请用 guesses 给出 {pins} 的大致位置",
            f"links {plate}, {', '.join(leg.link for leg in legs)}: say roughly where their points are: guesses for {pins}"))
    plain = Desk(board=desk.board, mech=desk.mech, at={leg.outer: complex(nominal(desk.at[leg.outer])) for leg in legs})
    grid, found = np.linspace(-np.pi, np.pi, SCAN + 1), []
    for left in (True, False):
        gaps = np.asarray(_open(plain, plate, legs, grid, left))
        for k in np.flatnonzero(gaps[1:] * gaps[:-1] <= 0):
            found.append((float(grid[k] - gaps[k] * (grid[k + 1] - grid[k]) / (gaps[k + 1] - gaps[k] or 1.0)), left))
    return found


def _settled(desk: Desk, plate: str, legs: Legs, theta: float, left: bool) -> Reals:
    """The direction at which nothing is open, for every repeated hand (secant)."""
    before: Reals = np.asarray(theta - 1e-4)
    now: Reals = np.asarray(theta) + 0.0 * np.real(np.asarray(desk.at[legs[0].outer] + desk.at[legs[1].outer] + desk.at[legs[2].outer]))
    gap_before = _open(desk, plate, legs, before, left)
    for _ in range(ROUNDS):
        gap = _open(desk, plate, legs, now, left)
        slope = (gap - gap_before) / np.where(now == before, 1.0, now - before)
        step = np.where((now == before) | (slope == 0), 0.0, gap / np.where(slope == 0, 1.0, slope))
        before, gap_before, now = now, gap, now - np.clip(step, -0.05, 0.05)
    if not abs(float(nominal(_open(desk, plate, legs, now, left)))) < CLOSE * _reach(desk, legs[2]):
        raise AssemblyError(Words(
            f"构件 {plate}、{'、'.join(leg.link for leg in legs)}：{legs[2].inner} 的轨迹仅与构件 {legs[2].link} 的圆弧相切",
            f"links {plate}, {', '.join(leg.link for leg in legs)}: the path of {legs[2].inner} only grazes the circle of link {legs[2].link}"))
    return now


def _words(plate: str, legs: Legs) -> Words:
    a, b, c = legs
    return Words(f"Ⅲ级杆组用试凑法定位：暂时拆开铰链 ${c.inner}$，在以 ${a.outer}$ 为圆心的弧上取 ${a.inner}$ 的几个试位置，由 ${a.inner}{b.inner}$ 和 ${b.outer}{b.inner}$ 定出构件 {plate}，描出 ${c.inner}$ 的轨迹；"
                 f"它与以 ${c.outer}$ 为圆心、${c.outer}{c.inner}$ 为半径的弧的交点即为 ${c.inner}$。",
                 f"The class III group is found by trial: let go of the hinge ${c.inner}$; for several places of ${a.inner}$ on its arc about ${a.outer}$ find link {plate} from ${a.inner}{b.inner}$ and "
                 f"${b.outer}{b.inner}$, and trace the path of ${c.inner}$. Where it cuts the arc about ${c.outer}$ with the radius ${c.outer}{c.inner}$ is ${c.inner}$.")


def _draw_trials(desk: Desk, plate: str, legs: Legs, theta: float, left: bool) -> None:
    """The third pin's path through some trials."""
    tried = [_trial(desk, plate, legs, np.asarray(theta + turn), left)[2] for turn in SHOWN]
    path = [complex(nominal(at)) for at in tried if np.isfinite(complex(nominal(at)))]
    desk.board.mark(View.MECHANISM, *(Segment(a=p, b=q, role=Role.CONSTRUCTION) for p, q in pairwise(path)))
