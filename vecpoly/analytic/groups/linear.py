"""One gear or rack with one unknown: pure rolling is a linear equation, so its place and rates have closed formulas."""

from __future__ import annotations

from ...mechanism.groups.assur import Group
from ...mechanism.model import Rolling
from ...words import Words
from ..calculus import substituted, variables
from ..equations import Equation, GroupModel, Part, Stage
from ..expr import ZERO, Expr, Sum, Var, quotient
from ..newton import Loops
from ..points import points
from ..stages import ACCELERATION, POSITION, VELOCITY
from ..variables import Scope
from .chains import Chains


def is_linear(loops: Loops) -> bool:
    """Whether there is one unknown, with a factor that never changes."""
    return len(loops.unknowns) == 1 and len(loops.conditions) == 1 and not [*variables(loops.jacobian[0][0])]


def linear(scope: Scope, group: Group, chains: Chains, loops: Loops, conditions: list[tuple[Expr, Expr]]) -> GroupModel:
    """q = −f(0) / f′, and its rates alike."""
    ((factor,),), (unknown,), (f,) = loops.jacobian, loops.unknowns, loops.conditions
    rates = [rate for rate in loops.rates[unknown] if isinstance(rate, Var)]
    sides = [-substituted(f, {unknown: ZERO}), *loops.velocity_sides, *loops.acceleration_sides]
    told = [
        Equation(left, quotient(-side, -factor) if isinstance(factor, Sum) else quotient(side, factor))
        for left, side in zip((Var(unknown), *rates), sides, strict=True)
    ]
    rolling = Words("自题设位置起滚过的弧长相等：", "The arcs rolled off since the given position are equal:")
    said = (
        Part(rolling, tuple(Equation(left, right, False) for left, right in conditions)),
        Part(Words("求导得", "Differentiating gives")),
        Part(Words("再求导得", "Differentiating again gives")),
    )
    more, ways = points(scope, group.links), (chains.places, chains.speeds, chains.pushes)
    stages = [
        Stage(title, (*_opened(part, told[i], ways[i]), *(more[i].parts if more else ())))
        for i, (title, part) in enumerate(zip((POSITION, VELOCITY, ACCELERATION), said, strict=True))
    ]
    title, opening = _named(scope, group)
    return GroupModel(title=title, opening=opening, links=group.links, stages=tuple(stages))


def _opened(part: Part, own: Equation, ways: list[Equation]) -> tuple[Part, ...]:
    """What is said, the unknown that it gives, and the points on the way; a condition that is solved as it stands is
    not written twice."""
    solved = any(own.right in (one.left, one.right) for one in part.equations)
    both = part.equations and not solved
    first = (part, Part(Words("故", "hence"), (own,))) if both else (Part(part.said, (own,)),)
    rest = (Part(Words("由此得", "hence"), tuple(ways)),) if ways else ()
    return (*first, *rest)


def _named(scope: Scope, group: Group) -> tuple[Words, Words]:
    name = scope.name(group.links[0])
    noun = Words("齿条", "rack") if group.kind == "rack" else Words("齿轮", "gear")
    joints = (*group.inner, *(out.joint for out in group.outer))
    theta = "、".join(f"$θ_{{{joint.point}}}$" for joint in joints if isinstance(joint, Rolling))
    return (
        Words(f"{noun.zh} {name}", f"{noun.en.capitalize()} {name}"),
        Words(
            f"{noun.zh} {name} 只有一个未知量，由纯滚动条件求得。常数 {theta} 由题设位置确定；转角以弧度计，连续计量，"
            "不减去整周。",
            f"The one unknown of {noun.en} {name} follows from rolling without slip. The constant "
            f"{theta.replace('、', ', ')} is fixed by the given position; angles are in radians, counted continuously, "
            "without jumps of whole turns.",
        ),
    )
