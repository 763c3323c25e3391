"""Whether a file tells where gears, arms and racks stand, wherever rolling leaves it open, and nowhere else;
whether gears fit."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping

from ...errors import FaultError, MobilityError
from ...foundation.slotted import replace
from ...mechanism.assembly.start import Start
from ...mechanism.gearing import fitted, misfit
from ...mechanism.groups.assur import Group, decompose
from ...mechanism.model import Circle, Drive, Mechanism, Prismatic, Rack, Rolling
from ...words import Words
from ..joints.rolling import is_rolling, pitch_letter, tells_side
from ..schema.faults import Faults
from ..schema.models import ProblemSpec

TURN = 1e-9  # rad


def geared(mech: Mechanism, spec: ProblemSpec, faults: Faults) -> Mechanism:
    """The mechanism with working pitch circles and the sides of its racks;
    gears that do not fit are noted at their joint."""
    texts = {pitch_letter(text): (i, text) for i, text in enumerate(spec.joints) if is_rolling(text)}
    joints = list(mech.joints)
    for n, joint in enumerate(joints):
        if not isinstance(joint, Rolling) or joint.point not in texts:
            continue
        i, text = texts[joint.point]
        with faults.at("joints", i):
            own = joint if tells_side(text) and isinstance(joint.on, Rack) else fitted(mech, joint)
            if (why := misfit(mech, joint if isinstance(joint.on, Circle) else own)) is not None:
                raise FaultError(why)
            joints[n] = own
    return replace(mech, joints=tuple(joints))


def check_starts(mech: Mechanism, faults: Faults) -> None:
    """Note every link whose place rolling leaves open and the file does not tell, and every one told in vain."""
    for start in mech.starts:
        with faults.at("links", start.link):
            _letters(mech, start)
    driven = {drive.link for drive in mech.drives}
    for drive in mech.drives:
        with faults.at("links", drive.link):
            _of_drive(mech, drive)
    try:
        groups = decompose(mech)
    except MobilityError:
        return  # told elsewhere
    for group in groups:
        told = [start for start in mech.starts if start.link in group.links and start.link not in driven]
        for link, why in _wrong(mech, group, told):
            with faults.at("links", link):
                raise FaultError(why)


def _letters(mech: Mechanism, start: Start) -> None:
    for letter in start.ray:
        if not mech.links_at(letter):
            raise FaultError(Words(f"没有点 {letter}", f"point '{letter}' does not exist"))


def _of_drive(mech: Mechanism, drive: Drive) -> None:
    """An input's position stands in `input`; a point of an input gear may repeat it."""
    start = next((one for one in mech.starts if one.link == drive.link), None)
    if start is None:
        return
    off = math.degrees(abs(cmath.phase(cmath.exp(1j * (start.value - drive.position)))))
    if start.slide or start.ray or math.radians(off) > TURN:
        raise FaultError(
            Words(
                f"构件 {drive.link} 是原动件，其位置由 input 给出（两处相差 {off:.4g}°）；请去掉此处的角度或使两者一致",
                f"link {drive.link} is the input, whose position stands under input "
                f"({off:.4g} deg away from what is said here); leave it out here, or make "
                "both agree",
            )
        )


def _wrong(mech: Mechanism, group: Group, told: list[Start]) -> Iterator[tuple[str, Words]]:
    """What is missing, or too much, or of no use."""
    rolls = [joint for joint in (*group.inner, *(out.joint for out in group.outer)) if isinstance(joint, Rolling)]
    wheels = {
        circle.link: circle.centre
        for joint in rolls
        for circle in (joint.gear, joint.on)
        if isinstance(circle, Circle) and circle.link in group.links
    }
    idle = [link for link in wheels if _is_plain(mech, link, wheels[link])]
    missing = len(rolls) - len(idle) - len(told)
    if missing > 0:
        open_ = [link for link in group.links if link not in idle and link not in {start.link for start in told}]
        link = next((one for one in open_ if one in wheels), open_[0])
        yield link, _missing(mech, group, link, wheels)
    elif missing < 0:
        yield (
            told[-1].link,
            Words(
                f"构件 {told[-1].link} 的位置已由各运动副确定；请去掉 {_key(told[-1])}",
                f"the joints already tell where link {told[-1].link} stands; leave out its {_key(told[-1])}",
            ),
        )
    elif told and (words := _of_no_use(group, told, wheels)) is not None:
        yield told[0].link, words


def _of_no_use(group: Group, told: list[Start], wheels: Mapping[str, str]) -> Words | None:
    """What is to be told instead, where the group has its place already, or moves in the other way."""
    if group.dyad is not None and any(start.link not in wheels or start.slide for start in told):
        return Words(
            f"构件 {told[0].link} 的位置由杆组确定；应给出齿轮 {'、'.join(wheels)} 的相位 phi",
            f"the group tells where link {told[0].link} stands; tell the phase phi of gear {', '.join(wheels)} instead",
        )
    if group.kind == "rack" and not told[0].slide:
        return Words(
            "齿条只移动：请写 s（沿导路的位移），不写 phi",
            "a rack slides: write s, its travel along the guide, and not phi",
        )
    if group.kind == "gear" and told[0].slide:
        return Words("齿轮绕轮心转动：请写 phi，不写 s", "a gear turns about its centre: write phi, and not s")
    return None


def _key(start: Start) -> str:
    return "s" if start.slide else "phi"


def _is_plain(mech: Mechanism, link: str, centre: str) -> bool:
    """Whether it does not matter how the gear is turned: no point but its centre, no guide, no rack on it."""
    guides = any(isinstance(joint, Prismatic) and joint.guide == link for joint in mech.joints)
    racks = any(
        isinstance(joint, Rolling) and isinstance(joint.on, Rack) and joint.on.link == link for joint in mech.joints
    )
    return set(mech.link(link).points) == {centre} and not guides and not racks


def _missing(mech: Mechanism, group: Group, link: str, wheels: dict[str, str]) -> Words:
    if group.kind == "rack":
        pin = next(iter(mech.link(link).points))
        return Words(
            f"齿条 {link} 在图示位置停在何处未给出（啮合不能确定它）：请在构件 {link} 中写 s，"
            f"即 {pin} 沿导路自其原点起的位移，如 s: 40 mm",
            f"nothing tells where rack {link} stands in the given position (rolling does not): "
            f"write s in link {link}, the travel of {pin} along its guide from the guide's origin, "
            "e.g. s: 40 mm",
        )
    points = list(mech.link(link).points)
    first = wheels.get(link, points[0])
    other = next((p for p in points if p != first), "")
    what, what_en = (
        (f"齿轮 {link} 的相位", f"the phase of gear {link}")
        if link in wheels
        else (f"构件 {link} 的方向", f"the direction of link {link}")
    )
    form = f"；或在该点写 {other}: {{{first}{other}: 30 mm, angle: 40 deg}}" if link in wheels else ""
    form_en = f"; or set the point out by {other}: {{{first}{other}: 30 mm, angle: 40 deg}}" if link in wheels else ""
    return Words(
        f"{what}未给出，啮合不能确定 {other} 在图示位置的方位：请在构件 {link} 中写 phi（自 {first} 至 {other} "
        f"的方向），如 phi: 40 deg{form}",
        f"{what_en} is not told, and rolling leaves open where {other} stands in the given "
        f"position: write phi in link {link}, the direction from {first} to {other}, e.g. phi: 40 "
        f"deg{form_en}",
    )
