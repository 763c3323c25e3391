"""A gear whose centre other links hold: only its turning is unknown, and pure rolling tells it.

Where it carries further letters (a crank pin) its angle is needed too: φ = θ + φ_H ± (r_p / r)(φ_H − φ_p), θ from the
given position. The angles on the right must not jump by a turn: those of the frame, of the drive, of gears on these.
"""

from __future__ import annotations

from ...errors import NoMethodError
from ...mechanism.groups.assur import Group, hinges
from ...mechanism.model import FRAME, Circle, Rolling
from ...words import Words
from ..equations import Equation, GroupModel, Part, Stage
from ..expr import Const, Expr, Var
from ..points import points
from ..stages import ACCELERATION, POSITION, VELOCITY
from ..variables import Scope


def held_gear(scope: Scope, group: Group) -> GroupModel:
    """ω = ω_H ± (r_p / r)(ω_H − ω_p), H the link that holds both centres, p the partner; α alike."""
    link = group.links[0]
    joint = next(out.joint for out in group.outer if isinstance(out.joint, Rolling))
    mine, other = _circles(scope, link, joint)
    holder = _holder(scope, mine, other)
    name, (velocity, acceleration) = scope.name(link), _turning(scope, joint, mine, other, holder)
    scope.anchors[link] = mine.centre
    standing = _standing(scope, joint, mine, other, holder) if len(scope.mech.link(link).points) > 1 else ()
    more = points(scope, group.links)
    held = Words("机架" if holder == FRAME else f"构件 {holder}", "the frame" if holder == FRAME else f"link {holder}")
    return GroupModel(
        title=Words(f"齿轮 {name}", f"Gear {name}"),
        links=group.links,
        opening=Words(
            f"齿轮 {name} 的中心 ${mine.centre}$ 已知，两轮中心由{held.zh}保持，节点 ${joint.point}$ 处作纯滚动。",
            f"The centre ${mine.centre}$ of gear {name} is known; {held.en} holds both centres, "
            f"and the gears roll on each other at ${joint.point}$.",
        ),
        stages=_with(
            more,
            *standing,
            Stage(
                VELOCITY,
                (Part(Words("两轮在节点处速度相同，故", "Both have one velocity at the pitch point:"), (velocity,)),),
            ),
            Stage(ACCELERATION, (Part(Words("求导得", "Differentiated,"), (acceleration,)),)),
        ),
    )


def _with(more: tuple[Stage, ...], *own: Stage) -> tuple[Stage, ...]:
    """The gear's own stages, each with the formulas of its further letters."""
    parts = {stage.title: stage.parts for stage in more}
    return tuple(Stage(stage.title, stage.parts + parts.get(stage.title, ())) for stage in own)


def _standing(scope: Scope, joint: Rolling, mine: Circle, other: Circle, holder: str) -> tuple[Stage, ...]:
    """The gear's angle: that of the given position, and what it has rolled since. Raises NoMethodError."""
    link, partner = mine.link, other.link
    if not {holder, partner} <= {FRAME, scope.mech.drive.link, *scope.rolled}:
        raise NoMethodError(
            Words(
                f"没有齿轮 {link} 的转角的解析式：构件 {partner}、{holder} 的转角由反三角函数给出，会跳变整周",
                f"no closed form on file for the angle of gear {link}: it rolls on link {partner}, held by {holder}, "
                "whose angles come from arctangents and jump by whole turns",
            )
        )
    scope.rolled.add(link)
    name, ratio = scope.name(link), _ratio(scope, mine, other)
    arm, mate = (
        scope.mech.drive.position if one == scope.mech.drive.link else scope.turned[one] for one in (holder, partner)
    )
    sign = -1 if joint.internal else 1
    start = scope.turned[link] - arm - sign * other.radius / mine.radius * (arm - mate)
    angle = Const(f"θ_{{{name}}}", start, "rad") + _rolled(
        scope.phi(holder), scope.phi(holder) - scope.phi(partner), ratio, joint.internal
    )
    said = Words(
        f"由给定位置（$θ_{name}$ 由此定出）起滚过的角度给出转角：",
        f"The angle follows from what the gear has rolled since the given position, which tells $θ_{name}$:",
    )
    return (Stage(POSITION, (Part(said, (Equation(Var(f"φ_{{{name}}}"), angle),)),)),)


def _circles(scope: Scope, link: str, joint: Rolling) -> tuple[Circle, Circle]:
    """The pitch circles of the gear and of its partner. Raises NoMethodError where either is none, or is stepped."""
    mine, other = (joint.gear, joint.on) if joint.gear.link == link else (joint.on, joint.gear)
    if not isinstance(mine, Circle) or not isinstance(other, Circle) or mine.mark or other.mark:
        raise NoMethodError(
            Words(
                f"没有齿轮 {link} 的解析式：它应在另一齿轮上滚动，且不是双联齿轮",
                f"no closed form on file for gear {link}: it must roll on a gear, and not be stepped",
            )
        )
    return mine, other


def _turning(scope: Scope, joint: Rolling, mine: Circle, other: Circle, holder: str) -> tuple[Equation, Equation]:
    """ω and α of the gear."""
    name, partner, ratio = scope.name(mine.link), other.link, _ratio(scope, mine, other)
    pairs = (
        (Var(f"ω_{{{name}}}"), scope.omega(holder), scope.omega(partner)),
        (Var(f"α_{{{name}}}"), scope.alpha(holder), scope.alpha(partner)),
    )
    velocity, acceleration = (
        Equation(own, _rolled(arm, arm - mate, ratio, joint.internal)) for own, arm, mate in pairs
    )
    return velocity, acceleration


def _ratio(scope: Scope, mine: Circle, other: Circle) -> Expr:
    """r_p / r."""
    partner = Const(f"r_{{{scope.mech.number(other.link)}}}", other.radius)
    return partner / Const(f"r_{{{scope.name(mine.link)}}}", mine.radius)


def _holder(scope: Scope, mine: Circle, other: Circle) -> str:
    """The link that is pinned at one centre and carries the other."""
    pins = hinges(scope.mech)
    carriers = [
        name
        for name in (*(li.name for li in scope.mech.links), FRAME)
        if {mine.centre, other.centre} <= {*scope.mech.link(name).points} and name in pins.get(mine.centre, ())
    ]
    if not carriers:
        raise NoMethodError(
            Words(
                f"没有齿轮 {mine.link} 的解析式：没有构件同时含有 {mine.centre} 和 {other.centre}",
                f"no closed form on file for gear {mine.link}: no link holds both {mine.centre} and {other.centre}",
            )
        )
    return carriers[0]


def _rolled(arm: Expr, relative: Expr, ratio: Expr, internal: bool) -> Expr:
    return arm - ratio * relative if internal else arm + ratio * relative
