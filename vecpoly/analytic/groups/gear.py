"""A gear whose centre other links hold: only its turning is unknown, and pure rolling tells it.

Where it carries further letters (a crank pin), or others roll on it, its angle is needed too:
φ = θ + φ_H ± (r_p / r)(φ_H − φ_p), θ from the given position. The angles on the right must not jump by a turn: those
that arctangents give are counted on from there (`Model.followed`).
"""

from __future__ import annotations

from ...mechanism.groups.assur import Group
from ...mechanism.model import FRAME, Circle, Rolling
from ...words import Words
from ..drive import given_angles
from ..equations import Equation, GroupModel, Part, Stage
from ..expr import Const, Expr, Var
from ..points import points
from ..stages import ACCELERATION, POSITION, VELOCITY
from ..variables import Scope
from .rolled import angle_needed, carriers, radius


def held_gear(scope: Scope, group: Group) -> GroupModel:
    """ω = ω_H ± (r_p / r)(ω_H − ω_p), H the link that holds both centres, p the partner; α alike."""
    link = group.links[0]
    joint = next(out.joint for out in group.outer if isinstance(out.joint, Rolling))
    mine, other = _circles(link, joint)
    holder = carriers(scope.mech, joint)[0]
    name, (velocity, acceleration) = scope.name(link), _turning(scope, joint, mine, other, holder)
    scope.anchors[link] = mine.centre
    standing = _standing(scope, joint, mine, other, holder) if angle_needed(scope.mech, link) else ()
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
            Stage(ACCELERATION, (Part(Words("求导得", "Differentiating gives"), (acceleration,)),)),
        ),
    )


def _with(more: tuple[Stage, ...], *own: Stage) -> tuple[Stage, ...]:
    """The gear's own stages, each with the formulas of its further letters."""
    parts = {stage.title: stage.parts for stage in more}
    return tuple(Stage(stage.title, stage.parts + parts.get(stage.title, ())) for stage in own)


def _standing(scope: Scope, joint: Rolling, mine: Circle, other: Circle, holder: str) -> tuple[Stage, ...]:
    """The gear's angle: that of the given position, and what it has rolled since."""
    link, name, ratio, given = mine.link, scope.name(mine.link), _ratio(scope, mine, other), given_angles(scope)
    own, arm, mate = (float(scope.phi(one).value(given)) for one in (link, holder, other.link))
    sign = -1 if joint.internal else 1
    start = own - arm - sign * other.radius / mine.radius * (arm - mate)
    angle = Const(f"θ_{{{name}}}", start, "rad") + _rolled(
        scope.phi(holder), scope.phi(holder) - scope.phi(other.link), ratio, joint.internal
    )
    said = Words(
        f"由给定位置（$θ_{name}$ 由此定出）起滚过的角度给出转角{_counted(scope, holder, other.link).zh}：",
        f"The angle follows from what the gear has rolled since the given position, which tells $θ_{name}$"
        f"{_counted(scope, holder, other.link).en}:",
    )
    return (Stage(POSITION, (Part(said, (Equation(Var(f"φ_{{{name}}}"), angle),)),)),)


def _counted(scope: Scope, *links: str) -> Words:
    """That angles which arctangents give are counted on, where they are none of the frame or of the drive."""
    known = {FRAME, scope.mech.drive.link}
    jumping = [
        f"$φ_{{{scope.name(link)}}}$" for link in links if isinstance(scope.phi(link), Var) and link not in known
    ]
    if not jumping:
        return Words("", "")
    return Words(
        f"（{'、'.join(jumping)} 自给定位置起连续计量，不跳变整周）",
        f" ({', '.join(jumping)} counted on from there, without jumps by whole turns)",
    )


def _circles(link: str, joint: Rolling) -> tuple[Circle, Circle]:
    """The pitch circles of the gear and of its partner."""
    mine, other = (joint.gear, joint.on) if joint.gear.link == link else (joint.on, joint.gear)
    assert isinstance(mine, Circle) and isinstance(other, Circle)
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
    return radius(scope, other) / radius(scope, mine)


def _rolled(arm: Expr, relative: Expr, ratio: Expr, internal: bool) -> Expr:
    return arm - ratio * relative if internal else arm + ratio * relative
