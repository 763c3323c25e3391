"""From a mechanism to its mathematical model: the driving link, then every Assur group by the method of its kind."""

from __future__ import annotations

from collections.abc import Mapping
from math import radians

from ..errors import NoMethodError
from ..mechanism.groups.assur import Dyad, Group, decompose
from ..mechanism.model import FRAME, Joint, Mechanism, Prismatic, Revolute, Rolling
from ..mechanism.profiles import refuse_profiles
from ..words import Words
from .drive import drive_symbols, driving, given_angles, given_rates
from .equations import GroupModel, Model, Part, Stage
from .groups.crossing import crossing
from .groups.gear import held_gear
from .groups.looped import looped
from .groups.rolled import in_closed_form
from .groups.rolling import rolling
from .groups.rpr import swinging
from .groups.rrp import slider
from .groups.rrr import hinged
from .points import points
from .stages import Arm, Solved
from .track import Track, Turning, settle, track
from .variables import Scope


def model(
    mech: Mechanism, at: Mapping[str, complex], turned: Mapping[str, float], lengths: frozenset[str] = frozenset()
) -> Model:
    """The formulas of a mechanism. at, turned: places of its letters (m) and angles of its links (rad) at the given
    position;
    lengths: the symbols of the given lengths, l_CD.

    Raises NoMethodError for a group that has no closed form here, and for the profile of a cam.
    """
    refuse_profiles(mech.cams, Words("闭式方程组", "a model in formulas"))
    scope = Scope(mech, at, dict(turned) | {FRAME: 0.0}, lengths=lengths)
    groups = [driving(scope), *(_group(scope, group) for group in decompose(mech))]
    step = mech.scale / 50 if mech.drive.slide else radians(4.0)
    return Model(
        tuple(groups), drive_symbols(scope)[0], given_rates(scope), mech.drive.position, step, _followed(scope)
    )


def _followed(scope: Scope) -> tuple[tuple[str, float], ...]:
    """The angles that must not jump by a turn, as at the given position: all, where gears roll off of them."""
    if not any(isinstance(joint, Rolling) for joint in scope.mech.joints):
        return ()
    return tuple((symbol, at) for symbol, at in given_angles(scope).items() if symbol != drive_symbols(scope)[0])


def _group(scope: Scope, group: Group) -> GroupModel:
    if group.kind == "gear" and in_closed_form(scope.mech, group):
        return held_gear(scope, group)
    if group.dyad is None or not in_closed_form(scope.mech, group):
        return looped(scope, group)
    d = group.dyad
    solved = _solved(scope, d)
    links = (d.link_j, d.link_k)
    more = points(scope, links)
    stages = tuple(
        Stage(stage.title, stage.parts + (more[i].parts if more else ())) for i, stage in enumerate(solved.stages)
    )
    names = scope.name(d.link_j), scope.name(d.link_k)
    return GroupModel(
        title=Words(f"{d.kind} 杆组（构件 {names[0]}、{names[1]}）", f"{d.kind} group (links {names[0]}, {names[1]})"),
        opening=_opening(scope, d),
        links=links,
        stages=stages,
        determinant=solved.determinant,
        singular=solved.singular,
    )


def _solved(scope: Scope, d: Dyad) -> Solved:
    match d.outer_j, d.inner, d.outer_k:
        case _, Revolute() as pin, _:
            return _pinned(scope, d, pin.point)
        case Revolute() as first, Prismatic() as guide, Revolute() as second:
            scope.anchors |= {d.link_j: first.point, d.link_k: second.point}
            points_of = {d.link_j: first.point, d.link_k: second.point}
            scope.done |= {first.point, second.point}
            return swinging(scope, guide, points_of[guide.guide], points_of[guide.block])
        case Revolute() as first, Prismatic() as inner, Prismatic() as outer:
            scope.anchors[d.link_j] = first.point
            return _crossed(scope, d, inner, outer)
    raise NoMethodError(
        Words(
            f"没有 {d.kind} 组 {d.link_j}、{d.link_k} 的解析式",
            f"no closed form on file for a {d.kind} group {d.link_j}, {d.link_k}",
        )
    )


def _pinned(scope: Scope, d: Dyad, c: str) -> Solved:
    """The inner joint is a hinge: RRR, RRP, PRP, and the same with rolling gears."""
    scope.done.add(c)
    one, turn_one = _locus(scope, d.outer_j, d.link_j, d.parent_j, c)
    two, turn_two = _locus(scope, d.outer_k, d.link_k, d.parent_k, c)
    match one, two:
        case Arm(), Arm():
            solved = hinged(scope, one, two, c)
        case Arm(), Track():
            solved = slider(scope, one, two, c)
        case Track(), Arm():
            solved = slider(scope, two, one, c)
        case _:
            assert isinstance(one, Track) and isinstance(two, Track)
            solved = crossing(scope, one, two, c)
    return _turning(_turning(solved, turn_one), turn_two)


def _locus(scope: Scope, joint: Joint, link: str, parent: str, c: str) -> tuple[Arm | Track, Turning]:
    """What the outer joint leaves to the inner hinge, a circle or a line,
    and how the link turns where that does not say it."""
    match joint:
        case Revolute():
            scope.anchors[link] = joint.point
            length, turn = scope.arm(link, joint.point, c)
            return Arm(name=scope.name(link), outer=joint.point, length=length, turn=turn), Turning()
        case Prismatic():
            scope.anchors[link] = c
            return track(scope, joint, link, scope.mech.link(link).points[c])
        case Rolling():
            return rolling(scope, joint, link, parent, c)


def _crossed(scope: Scope, d: Dyad, inner: Prismatic, outer: Prismatic) -> Solved:
    """RPP: the last link slides on a known line and keeps its angle;
    the first hangs on its hinge and keeps its angle to it."""
    link = scope.mech.link(d.link_k)
    letter, local = next(iter(link.points.items()), (f"P{scope.name(d.link_k)}", 0j))
    scope.anchors[d.link_k] = letter
    scope.done.add(letter)
    on_known, turn_k = track(scope, outer, d.link_k, local)
    turned = inner.direction + inner.turn
    turn_j = settle(scope, d.link_j, d.link_k, turned if inner.block == d.link_j else -turned)
    on_first, _ = track(scope, inner, d.link_k, local, name=scope.name(d.link_j))
    first = Turning(
        (*turn_k.position, *turn_j.position),
        (*turn_k.velocity, *turn_j.velocity),
        (*turn_k.acceleration, *turn_j.acceleration),
    )
    return crossing(scope, on_known, on_first, letter, first)


def _turning(solved: Solved, turning: Turning) -> Solved:
    """The stages with the equations of a link's angle and rates at their ends."""
    rows = (turning.position, turning.velocity, turning.acceleration)
    stages = tuple(
        Stage(stage.title, (*stage.parts[:-1], Part(stage.parts[-1].said, (*stage.parts[-1].equations, *more))))
        for stage, more in zip(solved.stages, rows, strict=True)
    )
    return Solved(stages, solved.determinant, solved.singular)


def _opening(scope: Scope, d: Dyad) -> Words:
    """Which links, which joints, what they hang on."""
    j, k = scope.name(d.link_j), scope.name(d.link_k)
    outer_j, outer_k = _hangs(scope, d.outer_j, d.parent_j), _hangs(scope, d.outer_k, d.parent_k)
    inner = _called(d.inner)
    return Words(
        f"{d.kind} Ⅱ 级杆组由构件 {j} 和构件 {k} 组成：构件 {j} {outer_j.zh}，构件 {k} {outer_k.zh}，"
        f"两构件以{inner.zh}相连。",
        f"The class II group {d.kind} consists of links {j} and {k}: link {j} {outer_j.en}, link "
        f"{k} {outer_k.en}, and {inner.en} joins them.",
    )


def _hangs(scope: Scope, joint: Joint, parent: str) -> Words:
    on = (
        Words("机架", "the frame")
        if parent == FRAME
        else Words(f"构件 {scope.name(parent)}", f"link {scope.name(parent)}")
    )
    how = _called(joint)
    return Words(f"以外接副（{how.zh}）与{on.zh}相连", f"is connected to {on.en} by {how.en}")


def _called(joint: Joint) -> Words:
    match joint:
        case Revolute():
            return Words(f"转动副 ${joint.point}$", f"the revolute ${joint.point}$")
        case Prismatic():
            return Words("移动副", "a prismatic joint")
        case Rolling():
            return Words("纯滚动副", "a rolling pair")
