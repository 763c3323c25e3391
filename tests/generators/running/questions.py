"""Every question to every mechanism: curvatures, equivalents, flywheels, pressure angles of any member of the families
of motion, whatever its joints and its drive. What a question does not suit is refused in words."""

from __future__ import annotations

from math import pi

from vecpoly.mechanism.groups.assur import ends
from vecpoly.mechanism.model import FRAME, Mechanism

from ..crossed import masses, moving
from ..curvatures import WAYS, three_places
from ..family import family
from .machines import Random


def _with_couplers(rng: Random) -> tuple[str, Mechanism, list[str]]:
    """A mechanism, and its links that are not joined to the frame."""
    while True:
        text, mech = moving(rng)
        held = {link for joint in mech.joints for link in ends(joint) if FRAME in ends(joint)}
        if couplers := [name for name in mech.numbered if name not in held]:
            return text, mech, couplers


@family("any-curvature", also=three_places, often=1, first=3)
def curvature(rng: Random) -> str:
    """Of a random link by a random construction, with one of its points; now and then both centrodes."""
    text, mech, couplers = _with_couplers(rng)
    frame, link = mech.number(FRAME), str(rng.choice(couplers))
    number, points = mech.number(link), list(mech.link(link).points)
    point = f", p_O{points[0]}, rho_{points[0]}" if points and points[0] not in mech.frame else ""
    pole = f"P_{number}{frame}" if len(number + frame) == 2 else f"P_{number}_{frame}"
    asked = f"{pole}, W_{number}, delta_{number}{point}"
    if rng.random() < 0.2:
        here = mech.drive.position * (1e3 if mech.drive.slide else 180 / pi)
        unit = "mm" if mech.drive.slide else "deg"
        asked += f", {{centrodes: {number}, positions: 5, over: [{here - 4:.3f} {unit}, {here + 4:.3f} {unit}]}}"
    return f"{text}method: curvature\nconstruction: {rng.choice(WAYS)}\nfind: [{asked}]\n"


@family("any-equivalent", first=2, often=2)
def equivalent(rng: Random) -> str:
    """J_e and M_e of the drive and of another link, masses anywhere, a moment somewhere."""
    text, mech = moving(rng)
    link = mech.number(str(rng.choice(mech.numbered)))
    asked = ["J_e", "M_e"] if not mech.drive.slide else ["m_e", "F_e"]
    if rng.random() < 0.5:
        asked += [f"J_e{link}", f"M_e{link}"] if rng.random() < 0.6 else [f"m_e{link}", f"F_e{link}"]
    load = f"loads:\n  M_q: {{on: {link}, size: {rng.integers(-300, 300)} N*m}}\n"
    return f"{text}{load}{masses(rng, mech)}find: [{', '.join(asked)}]\n"


@family("any-flywheel", first=6)
def flywheel(rng: Random) -> str:
    """A constant moment on the drive, a moment on another link during part of the turn."""
    text, mech = moving(rng)
    link, first = mech.number(str(rng.choice(mech.numbered))), rng.integers(0, 360)
    load = (
        f"loads:\n  M_q: {{on: {link}, size: {rng.integers(20, 300)} N*m, during: [{first} deg, "
        f"{(first + rng.integers(30, 200)) % 360} deg]}}\n"
        f"  M_c: {{on: {mech.number(mech.drive.link)}, size: constant}}\n"
    )
    run = "machine: {n: 100 r/min, delta: 0.05}\n" if rng.random() < 0.5 else ""
    asked = "M_c, dW_max, J_F" if run else "M_c"
    return f"{text}{load}{masses(rng, mech)}{run}find: [{asked}]\n"


@family("any-pressure", first=1)
def pressure(rng: Random) -> str:
    """Pressure and transmission angle of whatever is driven."""
    text, _ = moving(rng)
    return f"{text}find: [alpha, gamma]\n"
