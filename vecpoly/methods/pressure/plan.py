"""Pressure and transmission angles of the driven links, marked in the kinematic diagram and read by protractor."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import assert_never

import numpy as np

from ...algebra.formula import Node, Row, Txt, row
from ...board.construction import Reading, View
from ...board.paper.marks import Dot, Role
from ...board.strokes import amount
from ...errors import VecpolyError
from ...mechanism.asked.pressure import Driven, driven_links
from ...mechanism.model import Prismatic, Revolute
from ...names import Named
from ...plane import Points, Reals, nominal
from ...problem.asked.asks import AskNamed
from ...problem.problem import Problem
from ...words import Words
from ..desk import Desk
from ..positions.placed import placed
from ..registry import Stage
from .doors import LINES
from .told import bodily, force_key, moved_point, velocity_key

FORCE, SPEED = 26.0, 34.0  # mm: the arrows tell directions alone
OF_ALPHA, OF_GAMMA = 19.0, 12.0  # mm: radii of the angles' marks
SMALL = np.radians(3.0)  # an angle that cannot be marked
NO_ANGLE = np.radians(0.05)  # no protractor tells it from nothing
NUDGE = 1e-4  # rad, or of the mechanism's size: how far the drive goes to show which way the driven link moves
STILL = 1e-6  # mm: less is no motion


@dataclass(frozen=True, slots=True, kw_only=True)
class Marked:
    """Directions on paper at the point on which a force acts: of the force, of the velocity, across the velocity.

    They are turned so that each makes an acute angle with the force.
    """

    at: Points
    force: Points
    way: Points
    across: Points


def pressure_pass(desk: Desk, problem: Problem) -> None:
    """Every driven link of which an angle is asked."""
    keys = {ask.rel.key for ask in problem.asks if isinstance(ask, AskNamed)}
    for driven in driven_links(problem.mechanism):
        if keys & {driven.alpha.key, driven.gamma.key}:
            marked = _directions(desk, driven)
            _draw(desk, driven, marked)
            _mark(desk, driven, marked, _read(desk, driven, marked, keys))


def _directions(desk: Desk, driven: Driven) -> Marked:
    """The line of the force, that of the velocity, and which way both point."""
    board, at = desk.board, desk.at[driven.at]
    force = LINES.find(Stage.PRESSURE, driven.kind).draw(desk, driven)
    way = board.parallel(at, _way(desk, driven), key=velocity_key(driven)).along
    across = board.turn(1j * way)
    way = way * _sign(complex(nominal(way)), _shift(desk, driven))
    force = force * _sign(complex(nominal(force)), complex(nominal(way)))
    return Marked(at=at, force=force, way=way, across=across * _sign(nominal(across), complex(nominal(force))))


def _way(desk: Desk, driven: Driven) -> Points:
    """The direction in which the point can go: across the line to the pivot, or along the guide."""
    point, on = moved_point(driven), bodily(desk, driven.link)
    match driven.seat:
        case Revolute(point=pivot):
            arm, along = f"${pivot}{driven.at}$", 1j * desk.towards(pivot, driven.at)
            zh = f"绕 ${pivot}$ 转动，${point}$ 点的速度垂直于 {arm}"
            en = f"turns about ${pivot}$: the velocity of ${point}$ is perpendicular to {arm}"
        case Prismatic() as guide:
            along = desk.guide_line(guide).along
            base = bodily(desk, guide.guide if guide.block == driven.link else guide.block)
            zh = f"沿{base.zh}的导路移动，${point}$ 点的速度沿该导路"
            en = f"slides along the guide of {base.en}: the velocity of ${point}$ is along this guide"
        case _:
            assert_never(driven.seat)
    desk.board.remark(Words(f"从动件（{on.zh}）{zh}。", f" The driven {on.en} {en}."))
    return along


def _sign(one: complex, other: complex) -> int:
    """−1 where two directions make an obtuse angle."""
    return -1 if (one.conjugate() * other).real < 0 else 1


def _shift(desk: Desk, driven: Driven) -> complex:
    """How the point of the driven link moves while the drive goes on a little, on scratch paper; 0 where it cannot."""
    drive, at = desk.mech.drive, complex(nominal(desk.at[driven.at]))
    step = NUDGE * (desk.mech.scale if drive.slide else 1.0) * (-1.0 if drive.rate < 0 else 1.0)
    pose = desk.pose[driven.link]
    origin, along = complex(nominal(pose.origin)), complex(nominal(pose.along))
    local = (at - origin) / along
    try:
        moved = placed(desk, drive.position + step).pose[driven.link]
    except VecpolyError:
        return 0j
    shift = complex(nominal(moved.origin)) + complex(nominal(moved.along)) * local - at
    return shift if abs(shift) > STILL else 0j


def _draw(desk: Desk, driven: Driven, marked: Marked) -> None:
    """Both directions as arrows, and the line across the velocity."""
    board, at, view = desk.board, marked.at, View.MECHANISM
    speed, force = f"v_{{{driven.at}{driven.link if driven.thought else ''}}}", f"F{driven.symbol}"
    board.arrow(view, at, at + SPEED * marked.way, Role.GIVEN, key=velocity_key(driven), label=speed)
    board.arrow(view, at, at + FORCE * marked.force, Role.RESULT, key=force_key(driven), label=force)
    board.join(view, at, at + FORCE * marked.across, Role.CONSTRUCTION)


def _mark(desk: Desk, driven: Driven, marked: Marked, read: Mapping[str, Reals]) -> None:
    """Both angles with their letters, and with what was read of them."""
    alpha, gamma = (np.angle(marked.force / base) for base in (marked.way, marked.across))
    square = min(abs(amount(alpha)), abs(amount(gamma))) <= SMALL
    _arc(desk, marked, (marked.way, alpha, OF_ALPHA), driven.alpha, read, square=square)
    _arc(desk, marked, (marked.across, gamma, OF_GAMMA), driven.gamma, read, square=square)


def _arc(
    desk: Desk,
    marked: Marked,
    arc: tuple[Points, Reals, float],
    named: Named,
    read: Mapping[str, Reals],
    *,
    square: bool,
) -> None:
    """One angle from its ray; where both its sides all but coincide what was read stands at them without an arc, and
    the other is marked as the right angle that it is."""
    board, at, view = desk.board, marked.at, View.MECHANISM
    ray, turned, radius = arc
    if abs(amount(turned)) > SMALL:
        board.angle(view, at, ray, turned, radius, _told(named, read), key=named.key)
        if square:
            board.right_angle(view, at, marked.across, marked.way)
    elif named.key in read:
        board.plot(view, at + radius * ray, _told(named, read), Dot.NONE)


def _told(named: Named, read: Mapping[str, Reals]) -> str:
    """The symbol, with the value that was read."""
    return f"{named.symbol} = {amount(read[named.key]):.4g}°" if named.key in read else named.symbol


def _read(desk: Desk, driven: Driven, marked: Marked, keys: set[str]) -> dict[str, Reals]:
    """The acute angles that are asked for (deg): one by protractor; of the other it is the complement."""
    desk.board.remark(_both(driven, marked))
    found = dict[str, Reals]()
    for named, base in ((driven.alpha, marked.way), (driven.gamma, marked.across)):
        if named.key in keys and found:
            found[named.key] = _complement(desk, named, driven.alpha.symbol, found[driven.alpha.key])
        elif named.key in keys:
            turned = np.degrees(desk.board.gauge(0j, marked.force * np.conj(base)))
            value = 90.0 - np.abs(np.abs(turned) - 90.0)
            found[named.key] = _kept(desk, named, value, Txt(f" = {float(amount(value)):.4g}°"))
    return found


def _both(driven: Driven, marked: Marked) -> Words:
    """What both angles are. Across a sliding pair whose normal is the way of the driven link neither is measured."""
    alpha, gamma = driven.alpha.symbol, driven.gamma.symbol
    if not isinstance(driven.press, str) and abs(amount(np.angle(marked.force / marked.way))) < NO_ANGLE:
        return Words(
            f"力与速度方向重合，故压力角 ${alpha}$ 为零，传动角 ${gamma}$（力与速度垂线的夹角）为直角：",
            f" The force is along the velocity: the pressure angle ${alpha}$ is zero, and the transmission angle "
            f"${gamma}$, between the force and the normal to the velocity, is a right angle:",
        )
    return Words(
        f"力与速度方向所夹的锐角为压力角 ${alpha}$，其余角（力与速度垂线的夹角）为传动角 ${gamma}$。量得：",
        f" The acute angle between the force and the velocity is the pressure angle ${alpha}$; its complement, the "
        f"angle between the force and the normal to the velocity, is the transmission angle ${gamma}$. By protractor:",
    )


def _complement(desk: Desk, named: Named, other: str, read: Reals) -> Reals:
    """γ = 90° − α; where that is a right angle its way tells nothing more."""
    value, size = 90.0 - read, f"{float(amount(read)):.4g}°"
    end = Txt(f" = {float(amount(90.0 - read)):.4g}°")
    way = (Txt(" = 90° − "), *row(other).items, Txt(f" = 90° − {size}")) if amount(read) else ()
    return _kept(desk, named, value, *way, end)


def _kept(desk: Desk, named: Named, value: Reals, *way: Node) -> Reals:
    degrees = amount(value)
    text = Row((*row(named.symbol).items, *way))
    desk.board.write(text)
    desk.board.keep(Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=degrees, formula=text), value)
    return value
