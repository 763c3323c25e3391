"""The pins of a plan, stage by stage, in all positions: by linear equations in the eyes of the body that is sought on.

Where a stage has several answers each of them is gone on with; where it has none the plan is refused with the reason.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import assert_never

from ....designs.inversion.plan import Assemble, CentrePoints, Find, Limits, On, Plan, Position, Stage, Through
from ....designs.inversion.refusals import coincident, collinear, no_centre_point, no_limit, out_of_reach, parallel
from ....foundation.frozen import FrozenMap
from ....foundation.slotted import replace
from .burmester import CentrePoint, centre_points
from .loci import Round, Still, Straight, equidistant, locus
from .meetings import beyond, ray_and_circle
from .motions import Pose, inverted

Places = tuple[complex, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Found:
    """Where every pin lies in every position, and how the bodies stand."""

    pins: Mapping[str, Places]
    bodies: Mapping[str, tuple[Pose, ...]]

    def with_pin(self, letter: str, places: Places) -> Found:
        """The same with one more pin."""
        return replace(self, pins=FrozenMap({**self.pins, letter: places}))

    def length(self, one: str, two: str) -> float:
        """The distance of two pins (m)."""
        return abs(self.pins[two][0] - self.pins[one][0])


def linkages(plan: Plan) -> tuple[Found, ...]:
    """Every linkage that the plan gives; raises AssemblyError with the reason where there is none."""
    found: tuple[Found, ...] = (_given(plan),)
    for stage in plan.stages:
        found = tuple(after for before in found for after in _after(stage, before, plan))
    return found


def _given(plan: Plan) -> Found:
    """What is known before the first stage."""
    bodies = {body.name: tuple(map(pose_of, body.positions)) for body in (*plan.bodies, plan.body(""))}
    pins = {pin.letter: tuple(pose.place(pin.at) for pose in bodies[pin.on]) for pin in plan.pins}
    return Found(pins=FrozenMap(pins | {slide.letter: slide.places for slide in plan.slides}), bodies=FrozenMap(bodies))


def pose_of(position: Position) -> Pose:
    """The position with its turn as a unit vector."""
    return Pose.turned(position.at, position.angle)


def _after(stage: Stage, before: Found, plan: Plan) -> Iterator[Found]:
    match stage:
        case Find():
            yield _found(stage, before)
        case Assemble():
            yield before.with_pin(stage.pin, _assembled(stage, before))
        case Limits():
            yield from _limits(stage, before)
        case CentrePoints():
            yield from _centre_points(stage, before)
        case _:
            assert_never(stage)


def _found(stage: Find, before: Found) -> Found:
    """The pin at one distance from all inverted places of the known one."""
    poses = before.bodies[stage.on]
    seen = inverted(before.pins[stage.known], poses, stage.kept)
    at = _centre(stage, seen) if stage.lies is None else _on_line(stage, before, seen)
    return before.with_pin(stage.pin, tuple(pose.place(poses[stage.kept].trace(at)) for pose in poses))


def _centre(stage: Find, seen: Places) -> complex:
    match locus(seen):
        case Round() as circle:
            return circle.centre
        case Straight() as line:
            raise collinear(stage, seen, line.along)
        case Still():
            raise coincident(stage)


def _on_line(stage: Find, before: Found, seen: Places) -> complex:
    through, along = _line(stage, before)
    if abs(seen[1] - seen[0]) <= 1e-9 * (abs(seen[0] - through) + abs(seen[1] - through)):
        raise coincident(stage)
    at = equidistant(seen[0], seen[1], through, along)
    if at is None:
        raise parallel(stage, along)
    return at


def _line(stage: Find, before: Found) -> tuple[complex, complex]:
    """The line on which the pin lies, in the position that is kept."""
    match stage.lies:
        case On() as on:
            pose = before.bodies[stage.on][stage.kept]
            return pose.place(on.through), pose.turn * on.along
        case Through() as through:
            one, two = before.pins[through.one][stage.kept], before.pins[through.two][stage.kept]
            return one, (two - one) / abs(two - one)
        case None:
            raise TypeError("a pin that lies on no line has a centre")


def _assembled(stage: Assemble, before: Found) -> Places:
    """One meeting of two arcs in every position."""
    ends = zip(before.pins[stage.one], before.pins[stage.two], strict=True)
    places = [beyond(one, stage.to_one, two, stage.to_two, stage.side) for one, two in ends]
    if None in places:
        raise out_of_reach(stage, abs(before.pins[stage.two][0] - before.pins[stage.one][0]))
    return tuple(place for place in places if place is not None)


def _limits(stage: Limits, before: Found) -> Iterator[Found]:
    """Both rays at θ to AC₁ on the rocker's circle give C₂; AC is BC + AB in one limit and BC − AB in the other."""
    a, d, c1 = before.pins[stage.about][0], before.pins[stage.pivot][0], stage.first
    rays = ((c1 - a) / abs(c1 - a) * Pose.turned(0j, turn).turn for turn in (stage.theta, -stage.theta))
    met = [c2 for ray in rays for c2 in ray_and_circle(a, ray, d, abs(c1 - d))]
    kept = [c2 for c2 in met if (c1 - c2).real * stage.limit.sense > 0]
    if not kept:
        raise no_limit(stage, len(met))
    for c2 in kept:
        yield _swung(stage, before, a, (c1, c2), d)


def _swung(stage: Limits, before: Found, a: complex, c: tuple[complex, complex], d: complex) -> Found:
    """The rocker in both limits, and the crank pin beyond A, or this side of it."""
    crank = abs(abs(c[1] - a) - abs(c[0] - a)) / 2
    far = max(c, key=lambda at: abs(at - a))
    b = tuple(a + (crank if at == far else -crank) * (at - a) / abs(at - a) for at in c)
    swung = tuple(Pose(at=d, turn=(at - d) / abs(at - d)) for at in c)
    known = replace(before, bodies=FrozenMap({**before.bodies, stage.of: swung}))
    return known.with_pin(stage.pin, c).with_pin(stage.crank, b)


def _centre_points(stage: CentrePoints, before: Found) -> Iterator[Found]:
    """Every pair of centre points on the lines, with their circle points on the body."""
    poses = before.bodies[stage.on]
    first, second = (centre_points(poses, line.through, line.along) for line in stage.lies)
    same = stage.lies[0] == stage.lies[1]
    pairs = [(a, d) for i, a in enumerate(first) for j, d in enumerate(second) if (i < j if same else _apart(a, d))]
    if not pairs:
        raise no_centre_point(stage, len({point.fixed for point in (*first, *second)}))
    for pair in pairs:
        after = before
        for (fixed, moving), point in zip((stage.one, stage.two), pair, strict=True):
            after = after.with_pin(fixed, (point.fixed,) * len(poses))
            after = after.with_pin(moving, tuple(pose.place(poses[0].trace(point.moving)) for pose in poses))
        yield after


def _apart(one: CentrePoint, other: CentrePoint) -> bool:
    """Whether they are two points, not the one in which both lines cross."""
    return abs(one.fixed - other.fixed) > 1e-9 * one.radius
