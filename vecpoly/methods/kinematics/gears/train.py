"""A gear train solved as one group:
every gear turns about its pitch points as about hinges, so the train is a linkage at this instant.

Link after link: a link of which two points are known has the others by its image; two links that share a point, of
which one point each is known, are closed by two perpendiculars. Pitch points count as points; the accelerations of the
two bodies at one differ by ω² ρ along the common normal (see `pitch`).
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from ....board.board import NO_LENGTH
from ....board.construction import View
from ....errors import NoMethodError
from ....mechanism.groups.assur import Group, ends
from ....mechanism.model import Revolute, Rolling
from ....names import At, Kind, Rel
from ....plane import cross, nominal
from ....vector.close import close
from ....vector.equation import Equation, Term
from ....words import Words
from ...desk import Desk
from ...registry import Stage, method
from ..chains import letters, solve, turning_chain
from ..dyads.rrr import hinge_polygon, opening, total, turn_of_link
from ..image import images_of_link, known_tips
from ..terms import across, known
from ..turning import angular_acceleration, angular_velocity
from .pitch import rolling_in, rolling_term
from .rrg import imaged_wheel, seat

_SOURCE = "机械原理, planetary gear trains; pure rolling: the pitch point is the relative instant centre"
STEEP = 1e-6  # sine between two links seen from their common point, below which their perpendiculars do not meet


@method(
    stage=Stage.VELOCITY,
    group="gear train",
    source=_SOURCE,
    example="planetary-sun-drives",
    title=Words("轮系杆组的速度", "Velocity of a gear train"),
)
def velocity_train(desk: Desk, group: Group) -> None:
    """v_B of a planet from its two pitch points: b lies on h k as B on HK; ω = v_HK / HK."""
    _solved(desk, View.VELOCITY, group)
    joints = rolling_in((*group.inner, *(outer.joint for outer in group.outer)))
    for link in group.links:
        joint = next((one for one in joints if link in (one.gear.link, one.on.link)), None)
        if joint is not None:
            imaged_wheel(desk, joint, link)


@method(
    stage=Stage.ACCELERATION,
    group="gear train",
    source=_SOURCE,
    example="planetary-sun-drives",
    title=Words("轮系杆组的加速度", "Acceleration of a gear train"),
)
def acceleration_train(desk: Desk, group: Group) -> None:
    """a_B of a planet from the accelerations of its two pitch points, found from the bodies on which it rolls."""
    _solved(desk, View.ACCELERATION, group)


def _solved(desk: Desk, view: View, group: Group) -> None:
    waiting = list(group.links)
    while waiting:
        for link in waiting:
            _seats(desk, view, group, link, waiting)
        found = next((one for one in waiting if len(_held(desk, view, one)) > 1), None)
        if found is not None:
            _from_two(desk, view, found)
            waiting.remove(found)
            continue
        pair = next(_pairs(desk, view, group, waiting), None)
        if pair is None:
            raise NoMethodError(
                Words(
                    f"{group.name.zh}：没有相应的图解法能求构件 {'、'.join(waiting)} 的运动；可用 vecpoly exact "
                    "求解析值",
                    f"the {group.name.en}: no graphical method on file gives the motion "
                    f"of links {', '.join(waiting)}; 'vecpoly exact' gives the analytic "
                    "answers",
                )
            )
        _closed(desk, view, *pair)
        waiting = [one for one in waiting if one not in pair[:2]]


def _seats(desk: Desk, view: View, group: Group, link: str, waiting: list[str]) -> None:
    """The vectors of the link's pitch points on bodies whose motion is known;
    of accelerations only once the link's ω is."""
    for joint in rolling_in((*group.inner, *(outer.joint for outer in group.outer))):
        both = {joint.gear.link, joint.on.link}
        if link in both and not (both - {link}) & set(waiting):
            seat(desk, view, joint, link)


def _held(desk: Desk, view: View, link: str) -> list[tuple[str, At]]:
    return known_tips(desk, view, link)


def _from_two(desk: Desk, view: View, link: str) -> None:
    """ω or α of a link from two of its points, then its image."""
    (p, p_at), (q, q_at) = sorted(_held(desk, view, link), key=lambda one: not desk.at_rest(view, one[1]))[:2]
    if view is View.VELOCITY:
        ref = None if desk.at_rest(view, p_at) else p_at
        rel = Rel(Kind.V, q_at, ref)
        both = desk.tip(view, p_at), desk.tip(view, q_at)
        desk.board.arrow_once(view, *both, key=desk.key(rel))
        angular_velocity(desk, link, p, q, both, letters(desk, view, ref, q_at), desk.symbol(rel))
    else:
        _alpha_from_two(desk, link, (p, p_at), (q, q_at))
    images_of_link(desk, view, link)


def _alpha_from_two(desk: Desk, link: str, one: tuple[str, At], two: tuple[str, At]) -> None:
    """a_Q = a_P + a^n_QP + a^t_QP: what is across PQ in the difference of the two accelerations is α PQ."""
    (p, p_at), (q, q_at) = one, two
    view, board, rest = View.ACCELERATION, desk.board, desk.at_rest(View.ACCELERATION, p_at)
    normal, tangential = (Rel(kind, q_at, None if rest else p_at) for kind in (Kind.AN, Kind.AT))
    board.step(
        Words(
            f"将 ${p}$、${q}$ 两点加速度之差分解为沿 ${p}{q}$ 和垂直于 ${p}{q}$ 的分量。",
            f"Resolve the difference of the accelerations of ${p}$ and ${q}$ along ${p}{q}$ and across it.",
        ),
        view,
    )
    parts = (
        Term(
            rel=normal,
            symbol=desk.symbol(normal),
            direction=Words.same(f"∥$ {p}{q}$"),
            magnitude="?",
            along=desk.towards(p, q),
        ),
        across(desk, tangential, p, q),
    )
    eq = Equation(left=(known(desk, view, q_at),), right=parts if rest else (known(desk, view, p_at), *parts))
    board.equate(eq.table())
    closed = close(board, view, 0j, eq)
    board.plot(view, closed.ends[tangential.key][0], desk.n_tip(link))
    angular_acceleration(
        desk,
        link,
        p,
        q,
        closed.ends[tangential.key],
        f"{desk.n_tip(link)} {desk.tip_label(view, q_at)}",
        desk.symbol(tangential),
    )


Pair = tuple[
    str, str, str, Rolling | None, str, str
]  # two links, their common point, the rolling pair there if it is one, a known point of each


def _pairs(desk: Desk, view: View, group: Group, waiting: list[str]) -> Iterator[Pair]:
    """Two links with a common unknown point and one known point each, not in one line with it."""
    for one, two in combinations(waiting, 2):
        held = [_held(desk, view, link) for link in (one, two)]
        if not all(held):
            continue
        p, q = held[0][0][0], held[1][0][0]
        for joint in group.inner:
            if (
                isinstance(joint, Revolute | Rolling)
                and set(ends(joint)) == {one, two}
                and _steep(desk, joint.point, p, q)
            ):
                yield one, two, joint.point, joint if isinstance(joint, Rolling) else None, p, q


def _steep(desk: Desk, x: str, p: str, q: str) -> bool:
    """Whether XP and XQ are not in one line."""
    rays = [desk.at[o] - desk.at[x] for o in (p, q)]
    size = abs(nominal(rays[0])) * abs(nominal(rays[1]))
    return bool(size > NO_LENGTH and abs(nominal(cross(*rays))) > STEEP * size)


def _closed(desk: Desk, view: View, one: str, two: str, x: str, joint: Rolling | None, p: str, q: str) -> None:
    desk.board.step(opening(view, x, one, two), view)
    if joint is None or view is View.VELOCITY:
        hinge_polygon(desk, view, x, (p, one), (q, two))
        return
    near, far = At(x, one), At(x, two)
    left = (*turning_chain(desk, view, near, p, one), rolling_term(desk, joint, two, tip="r′"))
    right = turning_chain(desk, view, far, q, two)
    closed = solve(desk, view, Equation(left=left, right=right, total=total(desk, view, far, 2)), far)
    rel = next(term.rel for term in left if isinstance(term.rel, Rel) and term.rel.kind is Kind.AT)
    angular_acceleration(desk, one, p, x, closed.ends[rel.key], f"r′ {desk.tip_label(view, far)}", desk.symbol(rel))
    turn_of_link(desk, view, closed.ends, far, q, two)
    for link in (one, two):
        images_of_link(desk, view, link)
