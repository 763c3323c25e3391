"""Whether gears fit: pitch radii against the distance of centres, where links hold it; and the working pitch circles.

Held at a centre distance a' that is not quite r_1 + r_2 (inside: r_2 - r_1), as rounded coordinates leave it, gears
roll on working pitch circles r' = r a' / a: the ratio stays. What differs by more than SLACK does not fit.
"""

from __future__ import annotations

from ..foundation.slotted import replace
from ..words import Words
from .groups.assur import holders
from .model import Circle, Mechanism, Rack, Rolling, Side
from .pitch_lines import pitch_lines

SLACK = 5e-4  # of the centre distance


def reach(rolling: Rolling) -> float:
    """The distance (m) that the gear's centre keeps:
    from the partner's, r_1 + r_2 or |r_2 - r_1|, or r from the rack's pitch line."""
    if isinstance(rolling.on, Rack):
        return rolling.gear.radius
    return abs(rolling.on.radius - rolling.gear.radius) if rolling.internal else rolling.on.radius + rolling.gear.radius


def held_at(mech: Mechanism, rolling: Rolling) -> float | None:
    """The distance (m) at which a link holds the gear's centre, negative on the other side of a rack;
    None where none holds it."""
    by = next(iter(holders(mech, rolling)), None)
    if by is None:
        return None
    points = mech.link(by).points
    if isinstance(rolling.on, Rack):
        side = 1.0 if rolling.side is Side.LEFT else -1.0
        return side * pitch_lines(mech, rolling.on)[by].left(points[rolling.gear.centre])
    return abs(points[rolling.gear.centre] - points[rolling.on.centre])


def misfit(mech: Mechanism, rolling: Rolling) -> Words | None:
    """Why gears that a link holds at a distance do not fit; None where they do, or where nothing holds them."""
    away = held_at(mech, rolling)
    if away is None or abs(away - reach(rolling)) <= SLACK * reach(rolling):
        return None
    h, gear, got = rolling.point, rolling.gear.link, f"{1e3 * away:.6g} mm"
    needs = f"{1e3 * reach(rolling):.6g} mm"
    if isinstance(rolling.on, Rack):
        return Words(
            f"啮合点 {h}：齿轮 {gear} 的中心到齿条节线的距离应等于其节圆半径 {needs}，而机构保持的距离为 {got}；"
            "请修改半径或尺寸。",
            f"pitch point {h}: the centre of gear {gear} must be its pitch radius {needs} from the "
            f"rack's pitch line, but it is held {got} from it; change the radius or the place",
        )
    sign, two = "−" if rolling.internal else "+", sorted((rolling.gear.radius, rolling.on.radius), reverse=True)
    sizes = f" {sign} ".join(f"{1e3 * r:.6g}" for r in two)
    a, b = rolling.gear.centre, rolling.on.centre
    return Words(
        f"啮合点 {h}：两轮的中心距应为 {sizes} = {needs}，而 {a}{b} = {got}；请修改半径或中心距。",
        f"pitch point {h}: the gears need the centre distance {sizes} = {needs}, but {a}{b} is "
        f"{got}; change a radius or the distance",
    )


def fitted(mech: Mechanism, rolling: Rolling) -> Rolling:
    """The pair with its working pitch circles, and on the side of its rack on which its centre is held."""
    away = held_at(mech, rolling)
    if away is None:
        return rolling
    if isinstance(rolling.on, Rack):
        if away > 0:
            return rolling
        return replace(rolling, side=Side.LEFT if rolling.side is Side.RIGHT else Side.RIGHT)
    more = away / reach(rolling)
    return replace(rolling, gear=_scaled(rolling.gear, more), on=_scaled(rolling.on, more))


def _scaled(circle: Circle, more: float) -> Circle:
    return circle if abs(more - 1) < 1e-12 else replace(circle, radius=circle.radius * more)


def pitch_circles(mech: Mechanism) -> tuple[Circle, ...]:
    """The pitch circles of all gears, those of the frame included."""
    rolling = [joint for joint in mech.joints if isinstance(joint, Rolling)]
    return tuple(circle for joint in rolling for circle in (joint.gear, joint.on) if isinstance(circle, Circle))
