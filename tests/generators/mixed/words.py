"""What acts on any mechanism in any words of the manual: loads by laws, masses, friction; its drive told otherwise."""

from __future__ import annotations

import re
from math import pi

import numpy as np

from vecpoly.mechanism.groups.assur import hinges
from vecpoly.mechanism.model import FRAME, Contact, Mechanism, Prismatic

from ..library import data_of
from ..powers import held

Random = np.random.Generator
WAYS = ("left", "right", "up", "down")


def bodies(mech: Mechanism) -> list[str]:
    """The links on which something may act."""
    return [name for name in mech.numbered if mech.link(name).points and held(mech, name)]


def _spot(rng: Random, mech: Mechanism) -> tuple[str, str]:
    link = str(rng.choice(bodies(mech)))
    return link, str(rng.choice(held(mech, link)))


def lawful(rng: Random, mech: Mechanism, name: str) -> str:
    """A load that depends on place or speed: a window, a table, a spring, a damper, a motor."""
    match int(rng.integers(6)):
        case 0 | 1:
            return _windowed(rng, mech, name)
        case 2:
            return _tabled(rng, mech, name)
        case 3:
            return _coil(rng, mech, name)
        case 4 if not mech.drive.slide and not mech.drive.between:
            stall, slope = rng.integers(5, 90), rng.uniform(0.1, 4)
            return f"  M_{name}: {{on: {mech.number(mech.drive.link)}, motor: [{stall} N*m, {slope:.2f} N*m*s]}}\n"
    return _spring(rng, mech, name)


def _windowed(rng: Random, mech: Mechanism, name: str) -> str:
    link, point = _spot(rng, mech)
    if rng.random() < 0.3:
        way = rng.choice(["ccw", "cw"])
        turning = f"while: {mech.number(str(rng.choice(bodies(mech))))} turns {way}"
        return f"  M_{name}: {{on: {mech.number(link)}, size: {rng.integers(-40, 40)} N*m, {turning}}}\n"
    way = str(rng.choice(WAYS)) if rng.random() < 0.6 else f"along {rng.integers(-179, 180)} deg"
    low, high = sorted(int(x) for x in rng.choice(101, 2, replace=False))
    part = f", between: [{low} %, {high} %]" if rng.random() < 0.4 else ""
    unit = "mm" if mech.drive.slide or mech.drive.between else "deg"
    when = f"while: {point} moves {way}{part}"
    if unit == "deg" and rng.random() < 0.3:
        when = f"during: [{rng.integers(0, 360)} deg, {rng.integers(0, 360)} deg]"
    head = f"  F_{name}: {{on: {mech.number(link)}, at: {point}, size: {rng.integers(50, 900)} N"
    return f"{head}, direction: {rng.integers(-179, 180)} deg, {when}}}\n"


def _tabled(rng: Random, mech: Mechanism, name: str) -> str:
    link, point = _spot(rng, mech)
    if rng.random() < 0.4:
        rows = ", ".join(f"[{x}, {rng.integers(0, 900)}]" for x in (0, 30, 80, 200, 4000))
        size = f"{{columns: [s (mm), F (N)], rows: [{rows}]}}"
    elif rng.random() < 0.5:
        rows = ", ".join(f"[{x}, {rng.uniform(-1, 2):.2f}]" for x in range(0, 361, 60))
        size = f"{{columns: [phi (deg), p (MPa)], rows: [{rows}], bore: {rng.integers(10, 40)} mm}}"
    else:
        rows = ", ".join(f"[{x}, {rng.integers(-500, 500)}]" for x in range(0, 361, 45))
        size = f"{{columns: [phi (deg), F (N)], rows: [{rows}]}}"
    way = rng.integers(-179, 180)
    return f"  F_{name}: {{on: {mech.number(link)}, at: {point}, size: {size}, direction: {way} deg}}\n"


def _ends(rng: Random, mech: Mechanism) -> tuple[str, str]:
    one, other = (str(x) for x in rng.permutation([*bodies(mech), FRAME])[:2])
    return (other, one) if one == FRAME else (one, other)


def _spring(rng: Random, mech: Mechanism, name: str) -> str:
    one, other = _ends(rng, mech)
    foot = str(rng.choice(list(mech.frame))) if other == FRAME else _seat(rng, mech, other)
    ends = f"{_seat(rng, mech, one)}-{foot}"
    damping = f"c: {rng.integers(1, 60)} N*s/m"
    if rng.random() < 0.25:
        return f"  F_{name}: {{damper: {ends}, {damping}}}\n"
    more = f", preload: {rng.integers(-200, 200)} N" if rng.random() < 0.4 else ""
    more += f", {damping}" if rng.random() < 0.3 else ""
    return f"  F_{name}: {{spring: {ends}, k: {rng.integers(1, 8)} N/mm, l_0: {rng.integers(20, 300)} mm{more}}}\n"


def _seat(rng: Random, mech: Mechanism, link: str) -> str:
    return f"{rng.choice(held(mech, link))}{mech.number(link)}"


def _coil(rng: Random, mech: Mechanism, name: str) -> str:
    one, other = (mech.number(link) for link in _ends(rng, mech))
    more = f", c: {rng.uniform(0.1, 3):.2f} N*m*s" if rng.random() < 0.4 else ""
    more += f", preload: {rng.integers(-9, 9)} N*m" if rng.random() < 0.3 else ""
    free = f"k: {rng.integers(1, 40)} N*m/rad, phi_0: {rng.integers(-170, 170)} deg"
    return f"  M_{name}: {{spring: {one}-{other}, {free}{more}}}\n"


def masses(rng: Random, mech: Mechanism, text: str) -> str:
    """Masses at a letter, at the one pin, set out by offsets or two lengths, of a round bar; weight, inertia or not."""
    links = data_of(text)["links"]
    told = "".join(
        f"  {mech.number(name)}: {{{_mass(rng, mech, name, links[mech.number(name)])}}}\n"
        for name in bodies(mech)
        if rng.random() < 0.6 and mech.number(name) in links
    )
    flags = f"weight: {rng.choice(['yes', 'no'])}\ninertia: {rng.choice(['yes', 'yes', 'no'])}\n"
    return f"masses:\n{told}{flags}" if told else ""


def _mass(rng: Random, mech: Mechanism, name: str, entry: dict[str, object]) -> str:
    bar = next((key for key in entry if re.fullmatch(r"[A-Z]{2}", key)), "")
    mass = f"mass: {rng.integers(200, 4000)} g"
    inertia = f", inertia: {rng.integers(0, 20000)} kg*mm^2"
    if not bar:
        letters = held(mech, name)
        return mass if len(letters) == 1 and rng.random() < 0.7 else f"{mass}{inertia}, centre: {rng.choice(letters)}"
    p, q = bar[0], bar[1]
    length = abs(mech.link(name).points[q] - mech.link(name).points[p]) * 1e3
    match int(rng.integers(4)):
        case 0:
            return f"rod: {{diameter: {rng.integers(8, 30)} mm, density: 7800 kg/m^3}}"
        case 1:
            s, x, y = f"S{mech.number(name)}", length * rng.uniform(0.2, 0.8), rng.uniform(5, 40)
            two = f"{p}{s}: {np.hypot(x, y):.9g} mm, {q}{s}: {np.hypot(length - x, y):.9g} mm"
            return f"{mass}{inertia}, centre: {{{two}, side: {rng.choice(['left', 'right'])} of {bar}}}"
        case 2:
            beside = f", {rng.choice(['left', 'right'])}: {rng.integers(1, 40)} mm" if rng.random() < 0.5 else ""
            return f"{mass}{inertia}, centre: {{along: {bar}, at: {length * rng.uniform(0, 1):.3f} mm{beside}}}"
    return f"{mass}, centre: {rng.choice([p, q])}"


def rubbing(rng: Random, mech: Mechanism) -> str:
    """Friction of pins, slides and contacts, in every way in which it may be written."""
    sliding = {pin.point for pin in mech.slot_pins.values()}
    pins = [p for p in hinges(mech) if p not in sliding and p not in mech.substitutes and rng.random() < 0.5]
    told = "".join(f"  {p}: {{{_circle(rng)}}}\n" for p in pins)
    for joint in mech.joints:
        if isinstance(joint, Contact) and rng.random() < 0.7:
            told += f"  {joint.point}: {{{rng.choice(['f: 0.12', 'phi: 6 deg'])}}}\n"
        if isinstance(joint, Prismatic) and joint.block not in mech.slot_pins and rng.random() < 0.6:
            ends = [mech.number(joint.block), mech.number(joint.guide)]
            told += f"  {'-'.join(rng.permutation(ends))}: {{{_lean(rng)}}}\n"
    return f"friction:\n{told}" if told else ""


def _circle(rng: Random) -> str:
    rho, f = rng.uniform(0.2, 1), rng.uniform(0.05, 0.3)
    name = rng.choice(["f", "f_v"])
    return f"rho: {rho:.2f} mm" if rng.random() < 0.5 else f"{name}: {f:.3f}, r: {rho / f:.3f} mm"


def _lean(rng: Random) -> str:
    f = float(rng.uniform(0.04, 0.14))
    return str(
        rng.choice([f"phi: {rng.integers(2, 9)} deg", f"f: {f:.3f}", f"f: {f:.3f}, V: {rng.integers(40, 80)} deg"])
    )


def otherwise(rng: Random, text: str) -> str:
    """The drive's ω as a speed in r/min, or its place from a line of the frame, as often as not."""
    if rng.random() < 0.4:
        text = re.sub(
            r"^(input:.*?)omega: (-?[\d.]+) rad/s(?!\^)",
            lambda m: f"{m[1]}n: {float(m[2]) * 30 / pi:.9g} r/min",
            text,
            count=1,
            flags=re.MULTILINE,
        )
    return text
