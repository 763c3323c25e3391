"""Positions of the crank in which the led point stands still:
P falls on it where crank and rod are in one line (极限位置)."""

from __future__ import annotations

import numpy as np

from ....algebra.formula import Row, Txt, row
from ....board.construction import Pane, Reading, View
from ....board.paper.marks import Dot, Role
from ....diagram.single import pivot
from ....diagram.single import rod as rod_of
from ....errors import NoMethodError
from ....mechanism.asked.centres import crank_groups, limits
from ....mechanism.groups.assur import decompose
from ....mechanism.model import FRAME, Prismatic, Revolute
from ....names import Named
from ....plane import Points, ahead, cross, nominal, unit
from ....words import Words
from ...desk import Desk
from ...registry import Stage, method

PANE = Words("极限位置", "Limit positions")
NAME = "centre limits"
RADIUS = 14.0  # mm of the angle's mark


@method(
    stage=Stage.CENTRES,
    group="limit positions",
    source="机械原理, 极限位置",
    example="3-2",
    title=Words("从动件的极限位置", "Limit positions of a follower"),
)
def find_limit(desk: Desk, named: Named) -> None:
    """AC = BC ± AB: the arc about A meets the path of C."""
    pin, led, rod = next(group for group in crank_groups(desk.mech) if named in limits(desk.mech, group[1]))
    extended = named == limits(desk.mech, led)[0]
    crank, rod_length = (
        _length(desk, link, *ends) for link, ends in ((desk.mech.drive.link, (_pivot(desk), pin)), (rod, (pin, led)))
    )
    board, a = desk.board, desk.at[_pivot(desk)]
    pane = board.open_pane(View.MECHANISM, NAME, PANE, aside=True)
    board.step(_lead(led, rod), pane, again=_SECOND)
    board.remark(_words(_pivot(desk), pin, led, extended, crank > rod_length) + _counted(desk))
    reach = crank + rod_length if extended else abs(rod_length - crank)
    ends = [
        (c, ahead(a, unit(c - a), crank if extended or crank > rod_length else -crank))
        for c in _meetings(desk, rod, led, reach)
    ]
    sense = _sense(desk, led, rod, desk.at[led], desk.at[pin])
    fitting = [(c, b) for c, b in ends if _sense(desk, led, rod, c, b) == sense]
    if not fitting:
        raise NoMethodError(
            Words(
                f"{named.key}：曲柄与连杆共线的位置不属于此装配方式",
                f"{named.key}: crank and rod in one line do not belong to this assembly",
            )
        )
    c, b = fitting[0]
    angle = np.degrees(board.gauge(a, b) - desk.mech.drive.zero)
    degrees = float(nominal(angle)) % 360.0
    _draw(desk, pane, (pin, led, rod), (b, c), "′" if extended else "″", degrees)
    board.write(Row((*row(named.symbol).items, Txt(f" = {degrees:.4g}°"))))
    board.keep(
        Reading(
            key=named.key,
            symbol=named.symbol,
            unit="deg",
            scalar=degrees,
            formula=Row((*row(named.symbol).items, Txt(f" = {degrees:.4g}°"))),
        ),
        degrees + (angle - float(nominal(angle)) + 180.0) % 360.0 - 180.0,
    )


def _meetings(desk: Desk, rod: str, led: str, reach: float) -> tuple[Points, Points]:
    """Where the arc about the crank's pivot meets the circle or line on which the led point runs."""
    joint, other = _path(desk, rod, led)
    a, what = desk.at[_pivot(desk)], f"the limit position of {led}"
    if isinstance(joint, Prismatic):
        return desk.board.arc_on_line(desk.locus(joint, other, led), a, reach, what)
    return desk.board.arcs(a, reach, desk.at[joint.point], _length(desk, other, joint.point, led), what)


def _path(desk: Desk, rod: str, led: str) -> tuple[Revolute | Prismatic, str]:
    """The fixed pin or guide of the link that leads the point, and this link."""
    for group in decompose(desk.mech):
        d = group.dyad
        if d is not None and isinstance(d.inner, Revolute) and d.inner.point == led and rod in group.links:
            joint, link, parent = (
                (d.outer_k, d.link_k, d.parent_k) if d.link_j == rod else (d.outer_j, d.link_j, d.parent_j)
            )
            if parent == FRAME and isinstance(joint, Revolute | Prismatic):
                return joint, link
    raise NoMethodError(Words(f"{led} 的轨迹既不是定圆也不是定直线", f"{led} runs on no fixed circle or line"))


def _sense(desk: Desk, led: str, rod: str, c: Points, b: Points) -> bool:
    """On which side of the rod the rocker's pin lies, or to which side along the guide the led point:
    what tells one assembly from the other."""
    joint, _ = _path(desk, rod, led)
    if isinstance(joint, Prismatic):
        return bool(nominal((np.conj(desk.guide_line(joint).along) * (c - b)).real) > 0)
    return bool(nominal(cross(desk.at[joint.point] - b, c - b)) > 0)


def _draw(
    desk: Desk, pane: Pane, links: tuple[str, str, str], found: tuple[Points, Points], prime: str, degrees: float
) -> None:
    """Crank and rod in one line, the rocker, the arcs, the angle."""
    pin, led, rod = links
    a, b, c = (complex(nominal(z)) for z in (desk.at[_pivot(desk)], *found))
    joint, other = _path(desk, rod, led)
    board, reach = desk.board, abs(c - a)
    board.depict(pane, rod_of(f"link {desk.mech.drive.link}", a, b), rod_of(f"link {rod}", b, c))
    board.swing(pane, a, abs(c - a), c)
    grounds = [pivot(a, _pivot(desk))]
    if isinstance(joint, Revolute):
        d = complex(nominal(desk.at[joint.point]))
        grounds.append(pivot(d, joint.point))
        board.depict(pane, rod_of(f"link {other}", c, d))
        board.swing(pane, d, abs(c - d), c)
    else:
        way = complex(nominal(desk.guide_line(joint).along))
        board.join(pane, c - way * 25, c + way * 25, Role.CENTRE)
    board.depict(pane, *grounds)
    level = complex(np.exp(1j * desk.mech.drive.zero))
    board.join(pane, a, a + max(reach * 0.3, RADIUS + 6) * level, Role.CENTRE)
    radius, label = RADIUS if prime == "′" else RADIUS * 0.65, f"φ_{led}^{{{prime.replace('″', '′′')}}}"
    board.angle(pane, a, level, float(np.radians(degrees)), radius, label)
    board.plot(pane, b, f"{pin}{prime}", Dot.JOINT)
    board.plot(pane, c, f"{led}{prime}", Dot.JOINT)


def _pivot(desk: Desk) -> str:
    return desk.crank(desk.mech.drive.link)[0]


def _length(desk: Desk, link: str, p: str, q: str) -> float:
    """A length of a link on paper (mm)."""
    points = desk.mech.link(link).points
    return desk.mm(abs(points[p] - points[q]))


_SECOND = Words("曲柄与连杆还有另一个共线位置。", "There is a second position in which crank and rod are in one line.")


def _lead(c: str, rod: str) -> Words:
    return Words(
        f"$v_{c}$ = 0 时，构件 {rod} 的绝对瞬心与 ${c}$ 重合，曲柄与连杆共线。",
        f"Where $v_{c}$ = 0 the absolute centre of link {rod} falls on ${c}$: crank and rod are in one line.",
    )


def _words(a: str, b: str, c: str, extended: bool, long_crank: bool) -> Words:
    how, how_en = ("拉直", "extended") if extended else ("重叠", "overlapped")
    sum_up = f"{b}{c} + {a}{b}" if extended else (f"{a}{b} − {b}{c}" if long_crank else f"{b}{c} − {a}{b}")
    return Words(
        f"{how}共线：以 ${a}$ 为圆心、${sum_up}$ 为半径画弧，交 ${c}$ 的轨迹于极限位置，量得曲柄的位置角",
        f" {how_en.capitalize()}: the arc about ${a}$ with the radius ${sum_up}$ cuts the path of ${c}$ in a limit "
        "position; the angle of the crank is read off there",
    )


def _counted(desk: Desk) -> Words:
    """From which line that angle counts, where the problem names one."""
    ray = desk.mech.drive.ray
    line = f"${ray.line}$" if ray is not None and ray.line else ""
    return Words(f"（由 {line} 量起）：", f", from {line}:") if line else Words("：", ":")
