"""The driving link in its given position: φ_1 laid off with the protractor, or the travel along the guide."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from ....algebra.quantity import number
from ....board.construction import View
from ....board.paper.marks import Role
from ....mechanism.gearing import pitch_circles
from ....mechanism.model import FRAME, Drive, Mechanism, Prismatic
from ....mechanism.offsets import offset_symbol
from ....mechanism.travel import counted_from
from ....plane import ahead, nominal
from ....words import Words
from ...desk import Desk
from ...diagram import Pose
from ...registry import Stage, method

SEEN = 0.005  # rad: a smaller angle is no arc on paper
ON_LINE = 1e-6  # rad: what is as near to φ lies on its line


@method(
    stage=Stage.POSITION,
    group="crank",
    source="机械原理, kinematic diagrams",
    example="3-9",
    title=Words("原动件的位置", "Position of the driving link"),
)
def position_crank(desk: Desk, drive: Drive) -> None:
    """Lay off φ from the x axis, or from the line that is told, at the fixed pivot, then l_AB / μ_l along it."""
    link, board = desk.mech.link(drive.link), desk.board
    pivot, others = desk.crank(drive.link)
    board.step(_said(desk, drive, pivot, others), View.MECHANISM)
    along = board.turn(np.exp(1j * board.given(drive.position, drive.key)))
    local = link.points[pivot]
    desk.pose[drive.link] = Pose(desk.at[pivot] - along * desk.mm(1.0) * local, along)
    for name in others:
        base = desk.place(drive.link, link.points[name])
        desk.letter(name, ahead(base, along, board.hand.carry(0.0)))
    desk.settle_rest(drive.link)
    if (others or _is_bar(desk, drive)) and not desk.thought and abs(swept(_told(drive))) > SEEN:
        _angle(desk, pivot, drive, max((abs(desk.mm(abs(link.points[p] - local))) for p in others), default=40.0))


def stepped_off(desk: Desk, drive: Drive) -> str:
    """The first point on the line through the pivot at φ; none where all are set off from it."""
    pivot, others = desk.crank(drive.link)
    points = desk.mech.link(drive.link).points
    arms = {name: points[name] - points[pivot] for name in others}
    return next((name for name, arm in arms.items() if abs(arm.imag) < ON_LINE * abs(arm)), "")


def _is_bar(desk: Desk, drive: Drive) -> bool:
    """Whether the link is a guide bar through its pivot, which stands at φ whether or not it has a further point."""
    return any(not past and not guide.offset for guide, past in _guides_along(desk, drive))


def _is_beside(desk: Desk, drive: Drive) -> bool:
    """Whether a guide on the link runs along φ, but past the pivot."""
    return any(past for _, past in _guides_along(desk, drive))


def _guides_along(desk: Desk, drive: Drive) -> Iterator[tuple[Prismatic, bool]]:
    """The link's own guides in the direction φ, and whether they run past its pivot."""
    local = desk.mech.link(drive.link).points[desk.crank(drive.link)[0]]
    for joint in desk.mech.joints:
        if isinstance(joint, Prismatic) and joint.guide == drive.link and abs(math.sin(joint.direction)) < SEEN:
            yield joint, abs((joint.origin - local).imag) > ON_LINE


def _said(desk: Desk, drive: Drive, pivot: str, others: list[str]) -> Words:
    """The fixed points, and how the driving link is set out:
    at its angle, or as a pitch circle where it has no further point."""
    first = fixed_points(desk) + Words("；", "; ")
    if desk.thought:
        return first + _at_angle(desk, drive, others, "")
    cam = next((one for one in desk.mech.cams if one.link == drive.link and others == [one.centre]), None)
    if cam is not None:
        return first + _centre_found(desk, drive, pivot, cam.centre)
    if not others and (gear := next((c for c in pitch_circles(desk.mech) if c.link == drive.link), None)) is not None:
        return first + Words(
            f"以 ${pivot}$ 为圆心、$r_{gear.link}/μ_l$ 为半径作齿轮 {gear.link} 的节圆。",
            f"about ${pivot}$ draw the pitch circle of gear {gear.link} with the radius $r_{gear.link}/μ_l$.",
        )
    return first + _at_angle(desk, drive, others, f" = {number(math.degrees(_told(drive)), 5)}°")


def _told(drive: Drive) -> float:
    """φ as the problem tells it (rad): of the ray from the pivot, from the line that is named."""
    return drive.told(float(nominal(drive.position)))


def _centre_found(desk: Desk, drive: Drive, pivot: str, k: str) -> Words:
    """The cam's own angle is no direction of its centre of curvature, which is found beforehand."""
    points, phi = desk.mech.link(drive.link).points, f"$φ_{drive.link}$ = {number(math.degrees(_told(drive)), 5)}°"
    size = f"$l_{pivot}{k}$ = {number(1e3 * abs(points[k] - points[pivot]))} mm"
    return Words(
        f"凸轮 {drive.link} 在 {phi} 时的曲率中心 ${k}$ 已作得（{size}），连 ${pivot}{k}$，为代换机构的"
        f"构件 {drive.link}。",
        f"the centre of curvature ${k}$ of cam {drive.link} at {phi} has already been found ({size}): join "
        f"${pivot}{k}$, link {drive.link} of the substitute.",
    )


def _at_angle(desk: Desk, drive: Drive, others: list[str], phi: str) -> Words:
    """phi: its value as printed; nothing where it was found by trial."""
    pivot, _ = desk.crank(drive.link)
    found, found_en = ("试得的", "the ") if not phi else ("", "")
    told = drive.ray if phi else None
    below = phi and _told(drive) < 0  # by its sign alone a reader may not know the side
    axis = Words(f"${told.line}$ ", f"${told.line}$") if told and told.line else Words("$x$ 轴", "the $x$ axis")
    line = Words(
        f"过固定铰链 ${pivot}$ 作与 {axis.zh}成{found} $φ_{drive.link}${phi}{'（顺时针）' if below else ''} 的直线",
        f"{found_en}$φ_{drive.link}${phi}{' found' if not phi else ''} to {axis.en}{' (clockwise)' if below else ''}",
    )
    if told is not None and told.to in others:
        return _along(desk, drive, pivot, line)
    if others and not (b := stepped_off(desk, drive)):
        return _direction(desk, drive, pivot, line)
    of_link = Words(
        line.zh + f"，为构件 {drive.link}", f"through the fixed pivot ${pivot}$ draw link {drive.link} at " + line.en
    )
    return of_link + (_to_point(desk, drive, pivot, b) if others else Words("。", "."))


def _along(desk: Desk, drive: Drive, pivot: str, line: Words) -> Words:
    """A link whose told direction is that of its ray from the pivot."""
    assert drive.ray is not None
    size = f"${pivot}{drive.ray.to} = l_{desk.bar(drive.link, pivot, drive.ray.to)}/μ_l$"
    return Words(
        f"{line.zh}，在其上截取 {size}，得构件 {drive.link}。",
        f"through the fixed pivot ${pivot}$ draw the line at {line.en} and step off {size} on it: link {drive.link}.",
    )


def _direction(desk: Desk, drive: Drive, pivot: str, line: Words) -> Words:
    """A link all of whose points are set off from the line at φ stands by it."""
    beside = _is_beside(desk, drive)
    return Words(
        f"{line.zh}，以定构件 {drive.link} 的方位{'（其导路与此线平行）' if beside else ''}。",
        f"through the fixed pivot ${pivot}$ draw the line at {line.en}, by which link {drive.link} stands"
        f"{' (its guide is parallel to this line)' if beside else ''}.",
    )


def _to_point(desk: Desk, drive: Drive, pivot: str, b: str) -> Words:
    """On which side of the pivot the point lies, where it is not that to which φ points: φ of BA, from B to A."""
    points, phi = desk.mech.link(drive.link).points, f"$φ_{drive.link}$"
    size = f"${pivot}{b} = l_{desk.bar(drive.link, pivot, b)}/μ_l$"
    if (points[b] - points[pivot]).real >= 0.0:
        return Words(f"，截取 {size}。", f" and step off {size} on it.")
    return Words(
        f"；{phi} 为 ${b}{pivot}$ 的方向角，故在 ${pivot}$ 的另一侧反向截取 {size}。",
        f"; {phi} being the direction of ${b}{pivot}$, step off {size} on it beyond ${pivot}$, the opposite way.",
    )


@method(
    stage=Stage.POSITION,
    group="slide",
    source="机械原理, kinematic diagrams",
    example="",
    title=Words("移动原动件的位置", "Position of the driving slider"),
)
def position_slide(desk: Desk, drive: Drive) -> None:
    """Step off the travel along the fixed guide."""
    joint = next(j for j in desk.mech.joints if isinstance(j, Prismatic) and j.block == drive.link and j.guide == FRAME)
    board = desk.board
    board.step(_slid(desk.mech, joint), View.MECHANISM)
    line = desk.locus(joint, drive.link, joint.pin)
    travel = board.given(drive.position, drive.key) / board.scales[View.MECHANISM].value
    desk.letter(joint.pin, board.lay_off(line.at, line.along, travel))
    desk.settle_turned(drive.link, joint.pin, line.along * np.exp(1j * joint.turn))


def _slid(mech: Mechanism, joint: Prismatic) -> Words:
    """Along the guide, or along the parallel on which a pin beside it moves."""
    start, size, pin = counted_from(joint), f"$s_{joint.block}/μ_l$", joint.pin
    if not joint.offset:
        return Words(
            f"取 $μ_l$，沿固定导路{start.zh}截取构件 {joint.block} 的位移 {size}，得 ${pin}$。",
            f"To the scale $μ_l$ step off the travel {size} of link {joint.block} along its fixed guide {start.en}: "
            f"${pin}$.",
        )
    side, side_en = ("左", "left") if joint.offset > 0 else ("右", "right")
    off = f"${offset_symbol(mech, joint)}/μ_l$"
    foot, foot_en = ("的垂足起", " (its foot on the parallel)") if joint.through else ("", "")
    return Words(
        f"取 $μ_l$，在固定导路{side}侧作与其相距 {off} 的平行线，{start.zh}{foot}沿其截取构件 {joint.block} 的位移 "
        f"{size}，得 ${pin}$。",
        f"To the scale $μ_l$ draw the parallel to the fixed guide of link {joint.block}, {off} to its {side_en}, and "
        f"step off the travel {size} on it {start.en}{foot_en}: ${pin}$.",
    )


def say_fixed_points(desk: Desk) -> None:
    """The first step where no link is driven against the frame."""
    desk.board.step(fixed_points(desk) + Words("。", "."), View.MECHANISM)


def fixed_points(desk: Desk) -> Words:
    """Which points are placed by their coordinates."""
    fixed, fixed_en = "$、$".join(desk.mech.frame), "$, $".join(desk.mech.frame)
    return Words(
        f"取 $μ_l$，按坐标定出固定点 ${fixed}$",
        f"Place the fixed point{'s' if len(desk.mech.frame) > 1 else ''} ${fixed_en}$ to the scale $μ_l$",
    )


def say_welded(desk: Desk) -> None:
    """Rollers are drawn as parts of the links that carry them."""
    for roller, host in desk.mech.welded:
        desk.board.step(
            Words(f"滚子 {roller} 与构件 {host} 焊成一体作图。", f"Draw roller {roller} as welded to link {host}."),
            View.MECHANISM,
        )


def swept(position: float) -> float:
    """How far the arc of an angle runs round: as far as is stated, less full turns."""
    return math.fmod(position, 2 * math.pi)


def _angle(desk: Desk, pivot: str, drive: Drive, reach: float) -> None:
    """Mark the angle φ at the pivot: the arc runs in the sense of the stated value."""
    at = complex(nominal(desk.at[pivot]))
    radius = min(11.0, 0.45 * reach)
    level = complex(np.exp(1j * drive.zero))
    desk.board.join(View.MECHANISM, at, at + (radius + 3.5) * level, Role.CENTRE)
    desk.board.angle(View.MECHANISM, at, level, swept(_told(drive)), radius, f"φ_{drive.link}")
