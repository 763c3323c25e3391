"""Mechanisms of the exercise book and of the reports, as the tests of the oracle set them up."""

from __future__ import annotations

from cmath import exp
from math import cos, pi, radians

from vecpoly.mechanism.model import (
    Circle,
    Drive,
    Joint,
    Link,
    Mechanism,
    Prismatic,
    Rack,
    Revolute,
    Rolling,
    Side,
    SideOf,
)


def link(name: str, **points: complex) -> Link:
    return Link(name=name, points=points)


def pins(text: str) -> tuple[Revolute, ...]:
    """'A 0 1, B 1 2': hinges with their links."""
    return tuple(Revolute(point=p, a=a, b=b) for p, a, b in (part.split() for part in text.split(",")))


def says(text: str) -> tuple[SideOf, ...]:
    """'C left B D, F left E'."""
    parts = [part.split() for part in text.split(",") if part.strip()]
    return tuple(SideOf(point=p, side=Side(side), ref=tuple(ref)) for p, side, *ref in parts)


def make(
    frame: dict[str, complex],
    links: list[Link],
    joints: tuple[Joint, ...],
    drive: tuple[float, float],
    branches: str = "",
    *,
    slide: bool = False,
    accel: float = 0.0,
    **guesses: complex,
) -> Mechanism:
    """A mechanism driven at its first link: drive = (angle in degrees or travel in m, rate)."""
    at, rate = drive
    start = at if slide else radians(at)
    first = Drive(link=links[0].name, position=start, rate=rate, accel=accel, slide=slide)
    return Mechanism(
        frame=frame, links=tuple(links), joints=joints, drives=(first,), branches=says(branches), guesses=guesses
    )


def guided(
    guide: str,
    block: str,
    pin: str,
    *,
    origin: complex = 0,
    direction: float = 0.0,
    offset: float = 0.0,
    turn: float = 0.0,
    through: str = "",
) -> tuple[Prismatic]:
    """One sliding pair; direction and turn in degrees."""
    return (
        Prismatic(
            guide=guide,
            block=block,
            origin=origin,
            direction=radians(direction),
            pin=pin,
            offset=offset,
            turn=radians(turn),
            through=through,
        ),
    )


def fourbar(
    ab: float,
    bc: float,
    cd: float,
    d: complex,
    drive: tuple[float, float],
    side: str = "left",
    accel: float = 0.0,
    **coupler: complex,
) -> Mechanism:
    """A at the origin, D in the frame, C on the side of the ray B-D; further points on the coupler."""
    return make(
        {"A": 0, "D": d},
        [link("1", A=0, B=ab), link("2", B=0, C=bc, **coupler), link("3", D=0, C=cd)],
        pins("A 0 1, B 1 2, C 2 3, D 3 0"),
        drive,
        f"C {side} B D",
        accel=accel,
    )


def peaucellier(
    ab: float, be: float, ef: float, bd: float, df: float, ce: float, cd: float, f: complex, phi: float
) -> Mechanism:
    return make(
        {"A": 0, "F": f},
        [
            link("1", A=0, B=ab),
            link("2", B=0, E=be),
            link("3", F=0, E=ef),
            link("4", B=0, D=bd),
            link("5", F=0, D=df),
            link("6", E=0, C=ce),
            link("7", D=0, C=cd),
        ],
        pins("A 0 1, B 1 2, B 2 4, E 2 3, E 3 6, F 3 0, D 4 5, D 5 7, F 5 0, C 6 7"),
        (phi, 10.0),
        "E right B F, D left B F, C left E D",
    )


def hay_press(x_d: float) -> Mechanism:
    return make(
        {"A": 0, "D": x_d + 0.5j},
        [
            link("1", A=0, B=0.15),
            link("2", B=0, C=0.6, E=0.3),
            link("3", D=0, C=0.46),
            link("4", E=0, F=0.6),
            link("5", F=0),
        ],
        pins("A 0 1, B 1 2, C 2 3, D 3 0, E 2 4, F 4 5") + guided("0", "5", "F", origin=0.6j),
        (30.0, 5.0),
        "C left B D, F left E",
    )


def rocker(ab: float, c: complex, phi: float, omega: float, offset: float = 0.0, **points: complex) -> Mechanism:
    """Crank AB, block 2 (or an L-shaped link 2), slotted rocker 3 about C."""
    return make(
        {"A": 0, "C": c},
        [link("1", A=0, B=ab), link("2", B=0), link("3", C=0, **points)],
        pins("A 0 1, B 1 2, C 3 0") + guided("3", "2", "B", offset=offset, through="C"),
        (phi, omega),
    )


def swinging_block(ab: float, c: complex, phi: float, omega: float, **points: complex) -> Mechanism:
    """Crank AB, rod 2, block 3 about C."""
    return make(
        {"A": 0, "C": c},
        [link("1", A=0, B=ab), link("2", B=0, **points), link("3", C=0)],
        pins("A 0 1, B 1 2, C 3 0") + guided("2", "3", "C", through="B"),
        (phi, omega),
    )


def sine(ab: float, phi: float, omega: float) -> Mechanism:
    """Crank AB, block 2, bar 3 with a level slot, rising in the frame."""
    return make(
        {"A": 0},
        [link("1", A=0, B=ab), link("2", B=0), link("3", C=0)],
        pins("A 0 1, B 1 2") + guided("3", "2", "B", direction=-90.0) + guided("0", "3", "C", direction=90.0),
        (phi, omega),
    )


def sloped_slot(ab: float, phi: float, omega: float, gamma: float) -> Mechanism:
    """3-14: bar 3 slides along the x axis, its slot falls by gamma."""
    return make(
        {"A": 0},
        [link("1", A=0, B=ab), link("2", B=0), link("3", C=0)],
        pins("A 0 1, B 1 2") + guided("3", "2", "B", direction=-gamma) + guided("0", "3", "C"),
        (phi, omega),
    )


def guide_rod(phi: float = 57.0) -> Mechanism:
    """3-11: the driving link 1 is a guide about A; sleeve 2 on it is pinned to block 3 of a fixed guide."""
    d = 0.07 * exp(1j * radians(80.0))
    return make(
        {"A": 0},
        [link("1", A=0), link("2", B=0, D=d), link("3", B=0)],
        pins("A 0 1, B 2 3") + guided("1", "2", "B") + guided("0", "3", "B", origin=0.09j, direction=-12.0),
        (phi, 6.0),
    )


def crank_and_slot() -> Mechanism:
    """3-12: slider-crank 1, 2, 3; block 4 at the middle of the rod; slotted rocker 5 about E with F."""
    return make(
        {"A": 0, "E": 0.165 - 0.065j},
        [link("1", A=0, B=0.05), link("2", B=0, C=0.18, D=0.09), link("3", C=0), link("4", D=0), link("5", E=0, F=0.2)],
        pins("A 0 1, B 1 2, C 2 3, D 2 4, E 5 0") + guided("0", "3", "C") + guided("5", "4", "D", through="E"),
        (64.0, 10.0),
        "C right B",
    )


def geared(phi: float = 128.0, side: str = "left") -> Mechanism:
    """3-13: four-bar with gear 3 on the rack y = 0, gear 4 on gear 3, rocker 6 to its centre."""
    rolls = (
        Rolling(point="D", gear=Circle(link="3", centre="C", radius=0.06), on=Rack(link="0", origin=0, direction=0.0)),
        Rolling(
            point="H", gear=Circle(link="4", centre="E", radius=0.03), on=Circle(link="3", centre="C", radius=0.06)
        ),
    )
    return make(
        {"A": 0.095j, "F": 0.29 + 0.05j},
        [link("1", A=0, B=0.045), link("2", B=0, C=0.17), link("3", C=0), link("4", E=0), link("6", F=0, E=0.085)],
        pins("A 0 1, B 1 2, C 2 3, E 4 6, F 6 0") + rolls,
        (phi, -10.0),
        f"C right B, E {side} C F",
    )


MM = 1e-3


def a26() -> Mechanism:
    e = 400 * cos(radians(50)) * exp(1j * radians(50)) * MM
    return make(
        {"A": 0, "D": (-178.311284 + 186.464704j) * MM, "G": -514 * MM},
        [
            link("1", A=0, B=108 * MM),
            link("2", B=0, C=200 * MM, E=e),
            link("3", D=0, C=200 * MM),
            link("4", E=0, F=320 * MM),
            link("5", G=0, F=162 * MM),
        ],
        pins("A 0 1, B 1 2, C 2 3, D 3 0, E 2 4, F 4 5, G 5 0"),
        (0.0, 10.0),
        "C right B D, F right E G",
    )


def a27(x_g: float = -25.0, side: str = "right", left: float = 220.0) -> Mechanism:
    """Double crank ABCD, slider 4 pinned at F of the coupler, rod 5 through it from G."""
    return make(
        {"A": 0, "D": 160j * MM, "G": (x_g + 80j) * MM},
        [
            link("1", A=0, B=280 * MM),
            link("2", B=0, C=350 * MM, F=(175 + left * 1j) * MM),
            link("3", D=0, C=320 * MM),
            link("4", F=0),
            link("5", G=0),
        ],
        pins("A 0 1, B 1 2, C 2 3, D 3 0, F 2 4, G 5 0") + guided("5", "4", "F", through="G"),
        (0.0, 10.0),
        f"C {side} B D",
    )


def a16() -> Mechanism:
    """Driving guide 1 about A, block 2 at B of the right-angled link 3 about C, block 4 at D on guide 5 about E."""
    return make(
        {"A": 0, "C": -0.1j, "E": -0.2j},
        [link("1", A=0), link("2", B=0), link("3", C=0, B=0.2, D=-0.2j), link("4", D=0), link("5", E=0)],
        pins("A 0 1, B 2 3, C 3 0, D 3 4, E 5 0") + guided("1", "2", "B") + guided("5", "4", "D", through="E"),
        (0.0, 10.0),
        "B right A",
    )


def b_sixbar() -> Mechanism:
    e = (105.6 - 65 * exp(2j * pi / 3)) * MM
    return make(
        {"A": 0, "D": 87.5 * MM, "G": (153.5 + 41.7j) * MM},
        [
            link("1", A=0, B=24 * MM),
            link("2", B=0, C=105.6 * MM, E=e),
            link("3", D=0, C=67.5 * MM),
            link("5", E=0, F=34.4 * MM),
            link("6", G=0, F=25 * MM),
        ],
        pins("A 0 1, B 1 2, C 2 3, D 3 0, E 2 5, F 5 6, G 6 0"),
        (0.0, 1.0),
        "C left B D, F right E G",
    )


def conveyor() -> Mechanism:
    return make(
        {"A": 0, "D": 380 * MM},
        [link("1", A=0, B=115 * MM), link("2", B=0, C=385 * MM), link("3", D=0, C=380 * MM, E=550 * MM)],
        pins("A 0 1, B 1 2, C 2 3, D 3 0"),
        (0.0, 2 * pi * 40 / 60),
        "C left B D",
    )


def class_three() -> Mechanism:
    """A ternary link C D E on crank (by link 2) and on two rockers: links 2, 3, 4, 5 form one group of class III."""
    return make(
        {"A": 0, "F": 0.18 + 0.08j, "G": 0.13 - 0.13j},
        [
            link("1", A=0, B=0.02),
            link("2", B=0, C=0.1),
            link("3", C=0, D=0.08, E=0.03 - 0.05j),
            link("4", F=0, D=0.08),
            link("5", G=0, E=0.08),
        ],
        pins("A 0 1, B 1 2, C 2 3, D 3 4, F 4 0, E 3 5, G 5 0"),
        (20.0, 4.0),
        C=0.12,
        D=0.2,
        E=0.15 - 0.05j,
    )
