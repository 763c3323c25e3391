"""Pure rolling as conditions of loops: how far the gears have rolled since the given position and, where no link holds
them at their distance, that distance."""

from __future__ import annotations

import cmath
from collections.abc import Callable, Iterator

from ...mechanism.groups.assur import Group, ends, holders
from ...mechanism.model import Circle, Mechanism, Rack, Revolute, Rolling, Side
from ..expr import Const, Expr, Var
from ..functions import cos, sin
from ..track import Track, line_through
from ..variables import Scope

Condition = tuple[Expr, Expr]
Told = Callable[[Expr], float]  # the value of an angle at the given position


def in_closed_form(mech: Mechanism, group: Group) -> bool:
    """Whether closed formulas tell how the gears of the group move: a gear on a held centre that rolls on another,
    or dyads hinged in the centre of a gear that only rolls. The rest is solved as loops."""
    rolls = [out for out in group.outer if isinstance(out.joint, Rolling)]
    if group.kind == "gear":
        return all(carriers(mech, out.joint) for out in rolls if isinstance(out.joint, Rolling))
    if any(isinstance(joint, Rolling) for joint in group.inner) or (rolls and group.dyad is None):
        return False
    inner = group.inner[0]
    return not rolls or (
        isinstance(inner, Revolute)
        and all(
            isinstance(out.joint, Rolling)
            and _own(out.joint, out.link) == inner.point
            and not angle_needed(mech, out.link)
            for out in rolls
        )
    )


def angle_needed(mech: Mechanism, link: str) -> bool:
    """Whether more is asked of a gear than how fast it turns:
    letters off its centre, guides, or others that roll on it."""
    pairs = [joint for joint in mech.joints if not isinstance(joint, Revolute) and link in ends(joint)]
    return len(mech.link(link).points) > 1 or len(pairs) > 1


def radius(scope: Scope, circle: Circle) -> Const:
    """r_4, of the second circle of a stepped gear r_4′."""
    return Const(f"r_{{{scope.mech.number(circle.link)}{circle.mark}}}", circle.radius)


def _own(joint: Rolling, link: str) -> str:
    """The centre of the link's pitch circle; nothing of a rack."""
    mine = joint.gear if joint.gear.link == link else joint.on
    return mine.centre if isinstance(mine, Circle) else ""


def carriers(mech: Mechanism, joint: Rolling) -> list[str]:
    """The links that hold two gears by both centres, as letters of their own; none of a gear on a rack."""
    if not isinstance(joint.on, Circle):
        return []
    both = {joint.gear.centre, joint.on.centre}
    return [name for name in holders(mech, joint) if both <= {*mech.link(name).points}]


def rolled(scope: Scope, joint: Rolling, told: Told) -> Iterator[Condition]:
    """The conditions of one rolling pair, all of whose letters are located."""
    if isinstance(joint.on, Rack):
        yield from _on_rack(scope, joint, joint.on, told)
        return
    held = holders(scope.mech, joint)
    arm = scope.phi(held[0]) if held else Var(line_of_centres(joint))
    if not held:
        (x, y), (x0, y0), reach = scope.xy(joint.gear.centre), scope.xy(joint.on.centre), distance(joint)
        yield x, x0 + reach * cos(arm)
        yield y, y0 + reach * sin(arm)
    own, mate = scope.phi(joint.gear.link) - arm, scope.phi(joint.on.link) - arm
    r, rp = radius(scope, joint.gear), radius(scope, joint.on)
    sign = 1.0 if joint.internal else -1.0
    start = Const(f"θ_{{{joint.point}}}", told(own) - sign * rp.size / r.size * told(mate), "rad")
    right = rp * mate
    yield r * (own - start), right if joint.internal else -right


def line_of_centres(joint: Rolling) -> str:
    """The symbol of the angle of the line from the partner's centre to the gear's."""
    return f"φ_{{{joint.point}}}"


def distance(joint: Rolling) -> Const:
    """Of the two centres, from the partner's to the gear's."""
    on, gear = joint.on, joint.gear
    assert isinstance(on, Circle)
    reach = abs(on.radius - gear.radius) if joint.internal else on.radius + gear.radius
    return Const(f"l_{{{on.centre}{gear.centre}}}", reach)


def pitch_line(scope: Scope, joint: Rolling, on: Rack) -> Track:
    """The line on the rack along which the gear's centre goes."""
    side = 1.0 if joint.side is Side.LEFT else -1.0
    base = on.origin + 1j * side * joint.gear.radius * cmath.rect(1.0, on.direction)
    return line_through(scope, on.link, base, on.direction, joint.point)


def _on_rack(scope: Scope, joint: Rolling, on: Rack, told: Told) -> Iterator[Condition]:
    """The gear has turned against the rack by what its centre has gone along it: r Δφ = ∓Δs."""
    line, r = pitch_line(scope, joint, on), radius(scope, joint.gear)
    (x, y), (x0, y0), (c, s) = scope.xy(joint.gear.centre), scope.xy(line.base), line.unit
    if not holders(scope.mech, joint):
        yield (y - y0) * c - (x - x0) * s, line.offset
    along = (x - x0) * c + (y - y0) * s
    own = scope.phi(joint.gear.link) - scope.phi(on.link)
    sign = -1.0 if joint.side is Side.LEFT else 1.0
    gap = _place(scope, joint.gear.centre) - _place(scope, line.base)
    start = told(own) - sign * (gap * line.along.conjugate()).real / r.size
    left = r * (own - Const(f"θ_{{{joint.point}}}", start, "rad"))
    yield left, -along if sign < 0 else along


def _place(scope: Scope, letter: str) -> complex:
    """Where it is at the given position."""
    return scope.mech.frame[letter] if letter in scope.mech.frame else scope.at[letter]
