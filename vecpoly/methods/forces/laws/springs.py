"""Springs and dampers: the length off the diagram, its rate off the velocity polygon, the force along the line."""

from __future__ import annotations

import numpy as np

from ....algebra.quantity import Expr, Sum, magnitude
from ....board.board import NO_LENGTH
from ....board.construction import Reading, View
from ....board.paper.marks import Dot, Role
from ....diagram.single import pivot
from ....diagram.springs.straight import damper, spring_symbol
from ....errors import EquilibriumError
from ....mechanism.asked.forces import spring_named
from ....mechanism.laws.springs import Spring
from ....mechanism.laws.told import no_direction
from ....mechanism.loads import Force
from ....mechanism.model import FRAME
from ....plane import Points, Reals, ahead, dot, nominal, unit
from ....words import Words
from ..acting import OTHER_END
from .off_paper import OffPaper
from .pull import Pull

LENGTH = Words("在图上量其长度", "measure its length on the diagram")
RATE = Words(
    "在速度多边形上将两端的相对速度投影到该方向，量得伸长的速度",
    "on the velocity polygon project the velocity of one end relative to the other on this direction, and measure how "
    "fast it grows",
)
ASIDE = 1.0  # mm: a tip this near to the line on which it is projected needs no perpendicular


def pulled(at: OffPaper, spring: Spring) -> tuple[tuple[Force, ...], dict[str, Pull]]:
    """The force of a spring on its link, and the opposite one on the other if that moves.

    Raises EquilibriumError where its ends are at one place.
    """
    _say(at, spring)
    foot, point = at.ends(spring)
    if abs(complex(nominal(point - foot))) < NO_LENGTH:
        raise EquilibriumError(no_direction(spring), code="no-direction", numbers={"spring": spring.name})
    size = _size(at, spring)
    way = np.sign(float(nominal(size)))
    if not way:
        at.desk.board.remark(Words("此时不受力。", " It does nothing here."))
        return (), {}
    says = Words("受拉", "it is in tension") if way > 0 else Words("受压", "it is compressed")
    at.desk.board.remark(Words(f"{'弹簧' if spring.stiffness else '阻尼器'}{says.zh}。", f" Here {says.en}."))
    along = -way * unit(point - foot)
    force = _force(spring.name, spring.link, spring.point, along, size)
    found = {force.name: Pull(size=way * size, along=along)}
    if spring.against == FRAME:
        return (force,), found
    back = _force(f"{spring.name}{OTHER_END}", spring.against, spring.foot, -along, size)
    board = at.desk.board
    board.remark(
        Words(
            f"构件 {spring.against} 受反向的力 ${back.name} = {spring.name}$。",
            f" On link {spring.against} acts the opposite force, ${back.name} = {spring.name}$.",
        )
    )
    return (force, back), found | {back.name: Pull(size=way * size, along=-along)}


def _force(name: str, link: str, point: str, along: Points, size: Reals) -> Force:
    way = float(np.angle(complex(nominal(along))))
    return Force(name=name, link=link, point=point, direction=way, size=abs(float(nominal(size))))


def _say(at: OffPaper, spring: Spring) -> None:
    """The step: the spring is drawn, and what is to be read."""
    board, ends = at.desk.board, f"{spring.foot}{spring.point}"
    what = Words("弹簧", "spring") if spring.stiffness else Words("阻尼器", "damper")
    read = [one for one, is_read in ((LENGTH, spring.stiffness), (RATE, spring.damping)) if is_read]
    zh, en = "；".join(one.zh for one in read), ", and ".join(one.en for one in read)
    board.step(
        Words(
            f"{what.zh} ${spring.name}$ 连接 ${spring.foot}$、${spring.point}$ 两点，其力沿 ${ends}$："
            f"{zh or '大小不变'}。",
            f"The {what.en} ${spring.name}$ joins ${spring.foot}$ and ${spring.point}$; its force acts along "
            f"${ends}$: {en or 'it is constant'}.",
        ),
        View.MECHANISM,
    )
    foot, point = at.ends(spring)
    board.depict(View.MECHANISM, (spring_symbol if spring.stiffness else damper)(foot, point))
    if at.desk.mech.links_at(spring.foot) == (FRAME,):
        board.depict(View.MECHANISM, pivot(foot, spring.foot))


def _size(at: OffPaper, spring: Spring) -> Reals:
    """T = F_0 + k (l - l_0) + c v, positive where it pulls."""
    board, named = at.desk.board, spring_named(spring)
    terms: list[tuple[Expr, int]] = []
    foot, point = at.ends(spring)
    if spring.preload:
        terms.append((magnitude("F_{0}", abs(spring.preload), "N"), 1 if spring.preload > 0 else -1))
    if spring.stiffness:
        on_paper = board.measure(foot, point, f"{spring.foot} {spring.point}")
        length = board.compute(f"l_{{{spring.foot}{spring.point}}}", board.mu(View.MECHANISM) * on_paper, "m")
        stretch = length - magnitude("l_{0}", spring.free, "m")
        terms.append((magnitude("k", spring.stiffness, "N/m") * stretch, 1))
    if spring.damping:
        terms += _damped(at, spring)
    total = Sum(tuple(one for one, _ in terms), tuple(sign for _, sign in terms))
    size: Reals = board.compute(named.symbol, total, "N").value if terms else 0.0
    board.keep(Reading(key=named.key, symbol=named.symbol, unit="N", scalar=float(nominal(size))), size)
    return size


def _damped(at: OffPaper, spring: Spring) -> list[tuple[Expr, int]]:
    """c v, v the component along the line of the one end's velocity against the other's."""
    board = at.desk.board
    foot, point = at.ends(spring)
    along = unit(point - foot)
    base, head = at.tip(spring.against, spring.foot), at.tip(spring.link, spring.point)
    part = dot(along, head - base)
    if abs(float(nominal(part))) < NO_LENGTH:
        board.remark(Words("此时长度不变，无阻尼力。", " Its length does not change here, so nothing is damped."))
        return []
    end = ahead(base, along, part)
    letter = f"v_{{{spring.foot}{spring.point}}}"
    board.join(View.VELOCITY, base, end, Role.CONSTRUCTION)
    board.plot(View.VELOCITY, (base + end) / 2, letter, Dot.NONE)
    if abs(float(nominal(np.abs(head - end)))) > ASIDE:
        board.join(View.VELOCITY, head, end, Role.CONSTRUCTION)
        board.right_angle(View.VELOCITY, end, unit(base - end), unit(head - end))
    on_paper = board.measure(base, end, letter)
    rate = board.compute(f"v_{{{spring.name.replace('_', '')}}}", board.mu(View.VELOCITY) * on_paper, "m/s")
    return [(magnitude("c", spring.damping, "N·s/m") * rate, 1 if float(nominal(part)) > 0 else -1)]
