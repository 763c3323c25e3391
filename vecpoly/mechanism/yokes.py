"""A yoke that a crank drives by slides alone 正弦机构: what the best counterweight on the crank leaves of its force."""

from __future__ import annotations

from math import sin

from ..words import Words
from .counterweights import no_way
from .groups.assur import hinges, pivot_of
from .loads import Loads, Mass
from .model import FRAME, Mechanism, Prismatic, Revolute


def half_left(mech: Mechanism, loads: Loads, *, rate: bool) -> None:
    """Raise FaultError with the numbers for a yoke on the frame, in the slot of which a block on the crank slides.

    Its travel is r cos(φ − φ_0) / sin β, two vectors of half that size which turn against each other; a counterweight
    on the crank balances the one that turns with it: m r / (2 sin β) is the best, and as much is left.
    """
    for mass in loads.masses:
        if (travel := _amplitude(mech, mass.link)) is not None:
            raise no_way(mech, mass.link, _left(mech, mass, travel, rate=rate))


def _amplitude(mech: Mechanism, link: str) -> float | None:
    """r / sin β of a yoke (m): its crank over the sine of the angle from its guide to its slot."""
    slides = [joint for joint in mech.joints if isinstance(joint, Prismatic)]
    guide = next((one for one in slides if {one.guide, one.block} == {FRAME, link}), None)
    slot = next((one for one in slides if one.guide == link and one.block != FRAME), None)
    if guide is None or slot is None or any(link in names for names in hinges(mech).values()):
        return None
    pin = next((j for j in mech.joints if isinstance(j, Revolute) and slot.block in (j.a, j.b)), None)
    crank = mech.drive.link
    if pin is None or crank not in (pin.a, pin.b) or not (pivot := pivot_of(mech, crank)):
        return None
    turned = guide.direction + guide.turn if guide.guide == FRAME else -guide.direction - guide.turn
    travel = guide.direction if guide.guide == FRAME else turned + guide.direction
    points = mech.link(crank).points
    return abs(points[pin.point] - points[pivot]) / abs(sin(turned + slot.direction - travel))


def _left(mech: Mechanism, mass: Mass, travel: float, *, rate: bool) -> Words:
    product, pace = mass.mass * travel, mech.drive.rate**2
    crank = mech.number(mech.drive.link)
    zh, en = (
        (
            f"（{product * pace:.6g} N 中还剩 {product * pace / 2:.6g} N）",
            f" ({product * pace / 2:.6g} N of {product * pace:.6g} N)",
        )
        if rate and not mech.drive.slide and pace
        else ("", "")
    )
    return Words(
        f"；它沿导路作简谐运动，可分解为两个等大反向转动的矢量，曲柄 {crank} 上的配重最多只能取 "
        f"{product / 2:.6g} kg·m，消去其中一个，余下一半为反向转动的力{zh}",
        f"; its harmonic motion is two equal vectors that turn against each other. The best counterweight on crank "
        f"{crank}, {product / 2:.6g} kg·m, takes the one and leaves the other: half the force, turning backwards{en}",
    )
