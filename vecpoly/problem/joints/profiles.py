"""Whether the follower that a mechanism gives to a plate cam is the one for which the cam was designed."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from typing import TYPE_CHECKING

from ...errors import FaultError
from ...mechanism.model import FRAME, CamProfile, Circle, Contact, Mechanism, Prismatic, Rack, Revolute, Side
from ...words import Words
from ..links.bodies import Bodies
from ..links.draft import Draft
from ..schema.faults import Faults

if TYPE_CHECKING:
    from ...devices.cams.cam import Cam

NEAR, TILT = 1e-7, 1e-7  # m, rad: by how much follower and cam problem may differ
Told = tuple[Words, float, float]  # what is compared (mm, deg), in the mechanism and in the cam problem


def read_profiles(mech: Mechanism, bodies: Bodies, faults: Faults) -> tuple[CamProfile, ...]:
    """The cams of the mechanism with their followers; faults are noted at the cams."""
    if faults.found:
        return ()
    found = []
    for name, draft in bodies.drafts.items():
        if draft.cam is not None:
            with faults.at("links", name, "cam"):
                found.append(_profile(mech, draft, draft.cam))
    return tuple(found)


def _profile(mech: Mechanism, draft: Draft, cam: Cam) -> CamProfile:
    touching = [contact for contact in mech.contacts if draft.name in contact.links]
    if len(touching) != 1:
        raise FaultError(
            Words(
                f"凸轮 {draft.name} 应与一个从动件接触，这里有 {len(touching)} 处接触；请在 joints 中写如 1 touches "
                "2 at K",
                f"cam {draft.name} touches one follower, and here are {len(touching)} contacts; write e.g. "
                "'1 touches 2 at K' in joints",
            ),
            code="cam-follower",
        )
    _drives(mech, draft)
    contact = touching[0]
    follower = next(name for name in contact.links if name != draft.name)
    pivot, centre = draft.points
    end = _end(mech, draft, contact, follower, cam)
    for what, here, there in _compared(mech, mech.frame[pivot], follower, end, contact, cam):
        if abs(here - there) > 1e3 * NEAR:
            raise FaultError(
                Words(
                    f"凸轮 {draft.name} 的从动件与凸轮题不符：{what.zh}此处为 {here:.6g}，凸轮题中为 {there:.6g}；"
                    "请使两者一致",
                    f"the follower of cam {draft.name} is not that of the cam problem: {what.en} is {here:.6g} here "
                    "and "
                    f"{there:.6g} there; make them agree",
                ),
                code="cam-follower",
                numbers={"here": here, "there": there},
            )
    return CamProfile(
        link=draft.name, pivot=pivot, centre=centre, point=contact.point, follower=follower, end=end, cam=cam
    )


def _drives(mech: Mechanism, draft: Draft) -> None:
    """The law of motion is told over the angle of the cam: it must be the input, about its own pivot."""
    pivot = next(iter(draft.points))
    drive = next((drive for drive in mech.drives if drive.link == draft.name and not drive.between), None)
    if pivot not in mech.frame or drive is None or drive.slide or drive is not mech.drive:
        raise FaultError(
            Words(
                f"带廓线的凸轮 {draft.name} 应为绕机架点 {pivot} 转动的原动件；请写 input: "
                f"{{link: {draft.name}, phi: …, "
                f"omega: …}}，并在 frame 中给出 {pivot}",
                f"a cam with a profile drives: cam {draft.name} must turn about {pivot} on the frame; write input: "
                f"{{link: {draft.name}, phi: ..., omega: ...}} and give {pivot} in 'frame'",
            ),
            code="cam-follower",
        )


def _end(mech: Mechanism, draft: Draft, contact: Contact, follower: str, cam: Cam) -> str:
    """The follower's letter that the law places; raises FaultError where its form is not that of the cam problem."""
    on = next(end for end in (contact.disc, contact.on) if end.link != draft.name)
    if isinstance(on, Rack) != cam.follower.flat or contact.internal:
        raise FaultError(
            Words(
                f"凸轮题的从动件是{_form(cam).zh}，构件 {follower} 却不是；平底写 face，滚子或尖顶写 disc（尖顶 "
                "radius: 0 mm）",
                f"the follower of the cam problem has a {_form(cam).en}, and link {follower} has not; a flat face is "
                "written as 'face', a roller or a knife edge as 'disc' (of a knife edge radius: 0 mm)",
            ),
            code="cam-follower",
        )
    letters = mech.link(follower).points
    return (
        on.centre
        if isinstance(on, Circle)
        else next((at for at in letters if at not in mech.frame), next(iter(letters)))
    )


def _form(cam: Cam) -> Words:
    if cam.follower.flat:
        return Words("平底", "flat face")
    return Words("滚子", "roller") if cam.follower.roller else Words("尖顶", "knife edge")


def _compared(mech: Mechanism, pivot: complex, follower: str, end: str, contact: Contact, cam: Cam) -> Iterator[Told]:
    """Lengths in mm and angles in degrees, here and in the cam problem."""
    if not cam.follower.flat:
        tip = next(one for one in (contact.disc, contact.on) if one.link == follower)
        assert isinstance(tip, Circle)
        yield Words("滚子半径（mm）", "the roller's radius (mm)"), 1e3 * tip.radius, 1e3 * cam.follower.radius
    if cam.arm:
        yield from _arm(mech, pivot, follower, end, contact, cam)
    else:
        yield from _guided(mech, pivot, follower, end, contact, cam)


def _arm(mech: Mechanism, pivot: complex, follower: str, end: str, contact: Contact, cam: Cam) -> Iterator[Told]:
    assert cam.arm
    about = next((j.point for j in mech.joints if isinstance(j, Revolute) and {j.a, j.b} == {follower, FRAME}), None)
    if about is None:
        raise _other(follower, Words("摆动从动件，应铰接于机架", "swings, and must be pinned to the frame"))
    off, (oa, ab) = mech.frame[about] - pivot, cam.arm
    yield (
        Words(f"{about} 到凸轮轴心的水平距离（mm）", f"how far {about} is to the right of the axis (mm)"),
        1e3 * off.real,
        1e3 * cam.side * oa,
    )
    yield Words(f"{about} 高出凸轮轴心（mm）", f"how far {about} is above the axis (mm)"), 1e3 * off.imag, 0.0
    points = mech.link(follower).points
    if isinstance(contact.on, Rack):
        _cam_on_its_side(follower, points[end] - points[about], contact, cam)
        side = 1 if contact.side is Side.RIGHT else -1
        off = side * ((contact.on.origin - points[about]) * cmath.exp(-1j * contact.on.direction)).imag
        yield (
            Words("平底到摆动中心的距离（mm）", "the distance of the face from its pivot (mm)"),
            1e3 * off,
            1e3 * cam.face,
        )
    else:
        yield Words("摆杆长（mm）", "the length of the arm (mm)"), 1e3 * abs(points[end] - points[about]), 1e3 * ab


def _cam_on_its_side(follower: str, arm: complex, contact: Contact, cam: Cam) -> None:
    """A cam lies below the face of an arm: left of it, seen from the pivot, where the pivot is right of the axis."""
    assert isinstance(contact.on, Rack)
    outwards = (cmath.exp(1j * contact.on.direction) / arm).real > 0
    on_left = outwards is (cam.side > 0)
    if (contact.side is Side.LEFT) is not on_left:
        zh, en = ("左", "left") if on_left else ("右", "right")
        raise _other(
            follower,
            Words(
                f"的凸轮在平底的{zh}侧（touches ... {en} of the face）",
                f"has the cam on the {en} of its face ('... {en} of the face')",
            ),
        )


def _guided(mech: Mechanism, pivot: complex, follower: str, end: str, contact: Contact, cam: Cam) -> Iterator[Told]:
    guide = next((j for j in mech.joints if isinstance(j, Prismatic) and (j.guide, j.block) == (FRAME, follower)), None)
    if guide is None:
        raise _other(follower, Words("直动从动件，应沿机架上的导路滑动", "slides, and must be led by the frame"))
    lean = cmath.phase(cmath.exp(1j * guide.direction) ** 2 / -1)
    if abs(lean) > TILT:
        raise _other(
            follower, Words("沿铅垂导路运动，如 2 slides on x = 6 mm", "moves upright, as '2 slides on x = 6 mm'")
        )
    if not cam.follower.flat:
        place = guide.origin + 1j * guide.offset * cmath.exp(1j * guide.direction)
        points, turned = mech.link(follower).points, cmath.exp(1j * (guide.direction + guide.turn))
        beside = (place + turned * (points[end] - points[guide.pin])).real - pivot.real
        yield Words("偏距（mm）", "the offset (mm)"), 1e3 * beside, 1e3 * cam.follower.e
        return
    assert isinstance(contact.on, Rack)
    face = cmath.exp(1j * (guide.direction + guide.turn + contact.on.direction))
    normal = face * (1j if contact.side is Side.LEFT else -1j)
    if abs(normal + 1j) > TILT:
        raise _other(
            follower,
            Words("平底与导路垂直，凸轮在其下方", "has a face at right angles to the guide, with the cam below it"),
        )


def _other(follower: str, what: Words) -> FaultError:
    return FaultError(
        Words(
            f"凸轮题的从动件{what.zh}；构件 {follower} 不是这样",
            f"the follower of the cam problem {what.en}; link {follower} does not",
        ),
        code="cam-follower",
    )
