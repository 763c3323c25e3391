"""A gear train solved as one group located link by link:
arms from their given angles, gears about their centres, bars by arcs."""

from __future__ import annotations

from itertools import combinations

from ....board.construction import View
from ....errors import NoMethodError
from ....mechanism.groups.assur import Group
from ....mechanism.model import Circle, Joint, Prismatic, Revolute, Rolling
from ....words import Words
from ...desk import Desk
from ...registry import Stage, method
from ..gears.pitch import letter_pitch_points, rolling_in, wheel
from .assembly import choose, said
from .rolling import crossings, led, locus_of, meeting, settle_on
from .standing import said_standing, standing, start_of


@method(
    stage=Stage.POSITION,
    group="gear train",
    source="机械原理, planetary gear trains",
    example="planetary-sun-drives",
    title=Words("轮系杆组的位置", "Position of a gear train"),
)
def position_train(desk: Desk, group: Group) -> None:
    """One link after the other, as soon as two points of it, or one point and its angle, are known."""
    joints = (*group.inner, *(outer.joint for outer in group.outer))
    desk.board.step(
        Words(
            f"定出轮系中构件 {'、'.join(group.links)} 的位置：", f"Locate links {', '.join(group.links)} of the train:"
        ),
        View.MECHANISM,
    )
    waiting = list(group.links)
    while waiting:
        link = next((one for one in waiting if _placed(desk, group, one)), None)
        if link is not None:
            waiting.remove(link)
        elif not _arced(desk, group, waiting):
            raise NoMethodError(
                Words(
                    f"{group.name.zh}：没有相应的图解法能定出构件 {'、'.join(waiting)} 的位置；可用 vecpoly exact "
                    "求解析值",
                    f"the {group.name.en}: no graphical method on file locates links "
                    f"{', '.join(waiting)}; 'vecpoly exact' gives the analytic answers",
                )
            )
    letter_pitch_points(desk, joints)
    names = (
        "$、$".join(joint.point for joint in rolling_in(joints)),
        "$, $".join(joint.point for joint in rolling_in(joints)),
    )
    desk.board.remark(Words(f"各轮节圆的切点为啮合点 ${names[0]}$。", f" The pitch circles touch at ${names[1]}$."))


def _placed(desk: Desk, group: Group, link: str) -> bool:
    """Place the link from two known points, or from one and its angle."""
    points = desk.mech.link(link).points
    drawn = [p for p in points if p in desk.at]
    if len(drawn) > 1:
        desk.settle(link, (drawn[0], drawn[1]))
    elif drawn and (start_of(desk, link) is not None or _only_centre(group, link, tuple(points))):
        words = said_standing(desk, link)
        desk.settle_turned(link, drawn[0], standing(desk, link))
        desk.board.remark(words)
    else:
        return False
    return True


def _only_centre(group: Group, link: str, points: tuple[str, ...]) -> bool:
    """Whether the link is a gear without any point but its centre."""
    joints = rolling_in((*group.inner, *(outer.joint for outer in group.outer)))
    wheels = [wheel(joint, link) for joint in joints if link in (joint.gear.link, joint.on.link)]
    return len(points) == 1 and any(isinstance(mine, Circle) for mine in wheels)


def _arced(desk: Desk, group: Group, waiting: list[str]) -> bool:
    """Place two links that share an undrawn hinge, each led by its drawn point, its slide or its rolling."""
    for one, two in combinations(waiting, 2):
        shared = [
            j.point
            for j in group.inner
            if isinstance(j, Revolute) and {j.a, j.b} == {one, two} and j.point not in desk.at
        ]
        leads = [_lead(desk, group, link) for link in (one, two)]
        if not shared or leads[0] is None or leads[1] is None or _idle(group, shared[0], (leads[0], leads[1])):
            continue
        c, sides = shared[0], ((leads[0], one), (leads[1], two))
        desk.board.remark(meeting([led(desk, joint, link, c) for joint, link in sides], c))
        loci = [locus_of(desk, joint, link, c) for joint, link in sides]
        found, why = choose(
            desk,
            c,
            (one, two),
            crossings(desk, loci[0], loci[1], Words(f"构件 {one}、{two} 在 {c} 处", f"links {one} and {two} at {c}")),
        )
        desk.letter(c, found)
        desk.board.remark(said(why) + Words("。", "."))
        for (joint, link), locus in zip(sides, loci, strict=True):
            settle_on(desk, joint, link, c, locus)
            waiting.remove(link)
        return True
    return False


def _lead(desk: Desk, group: Group, link: str) -> Joint | None:
    """What leads the link: a hinge already drawn, else a slide or a rolling pair on a known link."""
    drawn = next((p for p in desk.mech.link(link).points if p in desk.at), None)
    if drawn is not None:
        return Revolute(point=drawn, a="", b=link)
    outer = [out.joint for out in group.outer if out.link == link]
    return next(
        (joint for joint in outer if isinstance(joint, Prismatic)),
        next((joint for joint in outer if isinstance(joint, Rolling)), None),
    )


def _idle(group: Group, c: str, leads: tuple[Joint, Joint]) -> bool:
    """Whether both leads say the same: an arm holds the gear's centre at the distance at which it rolls."""
    rolls = [joint for joint in leads if isinstance(joint, Rolling)]
    return (
        any(isinstance(joint.on, Circle) and c in (joint.gear.centre, joint.on.centre) for joint in rolls)
        and len(group.links) > 2
    )
