"""An input between two moving links: ``{cylinder: 2-3, length: 800 mm, v:
0.1 m/s}``, or one link's motion ``on`` another."""

from __future__ import annotations

import cmath
from collections.abc import Iterable

from ...errors import FaultError
from ...foundation.patterns import pattern
from ...mechanism.model import FRAME, Drive, Joint, Prismatic, Revolute
from ...units.reading import Dim, Quantity, read
from ...words import Words
from ..links.bodies import Bodies
from ..links.guides import LINK
from ..problem import Datum
from ..schema.faults import meant
from ..schema.models import InputSpec

_PAIR = pattern(rf"({LINK})\s*[-–,]\s*({LINK})")
STRAIGHT = 1e-12  # m: pins no farther than this from the guide's line are on it


def is_between(spec: InputSpec) -> bool:
    """Whether the input names two moving links."""
    return spec.cylinder is not None or spec.on is not None


def read_between(spec: InputSpec, bodies: Bodies, joints: Iterable[Joint]) -> tuple[Drive, tuple[Datum, ...]]:
    """The drive, and its data as written; raises FaultError."""
    link, on = _links(spec, bodies)
    if spec.cylinder is None and (spec.phi is not None or spec.omega is not None):
        return _turning(spec, link, on, bodies, joints)
    return _sliding(spec, link, on, bodies, joints)


def _links(spec: InputSpec, bodies: Bodies) -> tuple[str, str]:
    """The link that moves and the one on which; a cylinder's two in any order."""
    if spec.cylinder is not None:
        if spec.link is not None or spec.on is not None:
            raise FaultError(
                Words(
                    "油缸已由 cylinder 指明，请删去 link 和 on",
                    "'cylinder' names the links already; leave out link and on",
                ),
                "cylinder",
            )
        m = _PAIR.fullmatch(spec.cylinder)
        if m is None:
            raise FaultError(
                Words(
                    f"“{spec.cylinder}” 不是两个构件号；请写 cylinder: 2-3",
                    f"'{spec.cylinder}' is no pair of links; write cylinder: 2-3",
                ),
                "cylinder",
            )
        names, key = (m[2], m[1]), "cylinder"
    else:
        if spec.link is None:
            raise FaultError(
                Words("缺少运动的构件；请写 link: 3, on: 2", "the link that moves is missing; write link: 3, on: 2"),
                "on",
            )
        names, key = (spec.link, str(spec.on)), "on"
    for name in names:
        if name not in bodies.drafts:
            raise FaultError(
                Words(f"没有构件 {name}", f"link '{name}' does not exist") + meant(name, bodies.numbers), key
            )
    return names


def _sliding(
    spec: InputSpec, link: str, on: str, bodies: Bodies, joints: Iterable[Joint]
) -> tuple[Drive, tuple[Datum, ...]]:
    pair = next((j for j in joints if isinstance(j, Prismatic) and {j.guide, j.block} == {link, on}), None)
    if pair is None:
        raise FaultError(
            Words(
                f"构件 {link} 与 {on} 之间没有移动副；请写运动副“{link} slides in {on}”",
                f"links {link} and {on} do not slide on each other; write the joint '{link} slides in {on}'",
            ),
            "cylinder" if spec.cylinder else "on",
        )
    if any(value is not None for value in (spec.phi, spec.omega, spec.alpha)):
        raise FaultError(
            Words(
                "油缸的输入是长度（length 或 s）、v 和 a，而不是 phi、omega、alpha",
                "a cylinder's input is its length (or s), v and a, not phi, omega, alpha",
            )
        )
    if (spec.length is None) == (spec.s is None) or spec.v is None:
        raise FaultError(
            Words(
                "油缸的输入需要两铰链间的长度（或行程 s，二者取一）和速度，例如 length: 800 mm, v: 0.1 m/s",
                "a cylinder needs the length between its pins (or the travel s, one of the "
                "two) and the speed, e.g. length: 800 mm, v: 0.1 m/s",
            )
        )
    travel, told = _length(spec, pair, bodies) if spec.length is not None else _travel(spec, pair)
    rate, accel = _read("v", spec.v, Dim.SPEED), _read("a", spec.a, Dim.ACCEL)
    rel = f"{pair.pin}{pair.block}{pair.pin}{pair.guide}"
    data = [told, Datum(symbol=f"v_{rel}", si=rate.si, text=rate.text)]
    if spec.a is not None:
        data.append(Datum(symbol=f"a^r_{rel}", si=accel.si, text=accel.text))
    return Drive(link=pair.block, on=pair.guide, position=travel, rate=rate.si, accel=accel.si, slide=True), tuple(data)


def _travel(spec: InputSpec, pair: Prismatic) -> tuple[float, Datum]:
    travel = _read("s", spec.s, Dim.LENGTH)
    return travel.si, Datum(symbol=f"s_{pair.block}{pair.guide}", si=travel.si, text=travel.text)


def _length(spec: InputSpec, pair: Prismatic, bodies: Bodies) -> tuple[float, Datum]:
    """The distance of the first points of both links, which lie on the guide's line."""
    length = _read("length", spec.length, Dim.LENGTH)
    if length.si <= 0:
        raise FaultError(
            Words(f"长度 {length.text} 必须大于零", f"'{length.text}' must be greater than zero; write e.g. 800 mm"),
            "length",
        )
    guide, block = bodies.drafts[pair.guide].points, bodies.drafts[pair.block].points
    g, k = next(iter(guide)), next(iter(block))
    foot = (guide[g] - pair.origin) * cmath.rect(1.0, -pair.direction)
    head = (block[k] - block[pair.pin]) * cmath.rect(1.0, pair.turn) + 1j * pair.offset
    if abs(head - foot) > STRAIGHT:
        raise FaultError(
            Words(
                f"{g}、{k} 不都在油缸的轴线上，长度 {g}{k} 不就是行程；请改写行程 s（销 {pair.pin} 沿导路的位移）",
                f"{g} and {k} do not both lie on the cylinder's line, so that {g}{k} is not "
                f"its travel; give the travel s of the pin {pair.pin} along the guide instead",
            ),
            "length",
        )
    return length.si, Datum(symbol=f"l_{g}{k}", si=length.si, text=length.text)


def _turning(
    spec: InputSpec, link: str, on: str, bodies: Bodies, joints: Iterable[Joint]
) -> tuple[Drive, tuple[Datum, ...]]:
    """`link` turns on `on` about their common pin: the angle is that from the direction of `on` to that of `link`."""
    pin = next((j.point for j in joints if isinstance(j, Revolute) and {link, on} <= _at(j.point, bodies)), None)
    if pin is None:
        raise FaultError(
            Words(f"构件 {link} 与 {on} 没有公共的铰链", f"links {link} and {on} have no pin in common"), "on"
        )
    if (
        any(value is not None for value in (spec.s, spec.v, spec.a, spec.length))
        or spec.phi is None
        or spec.omega is None
    ):
        raise FaultError(
            Words(
                "转动输入需要 phi 和 omega，例如 phi: 60 deg, omega: 2 rad/s ccw",
                "a turning input needs phi and omega, e.g. phi: 60 deg, omega: 2 rad/s ccw",
            )
        )
    angle, rate, accel = (
        _read("phi", spec.phi, Dim.ANGLE),
        _read("omega", spec.omega, Dim.OMEGA),
        _read("alpha", spec.alpha, Dim.ALPHA),
    )
    lean = [_lean(bodies, name, pin) for name in (link, on)]
    data = [
        Datum(symbol=f"φ_{link}{on}", si=angle.si, text=angle.text),
        Datum(symbol=f"ω_{link}{on}", si=rate.si, text=rate.text),
    ]
    if spec.alpha is not None:
        data.append(Datum(symbol=f"α_{link}{on}", si=accel.si, text=accel.text))
    return Drive(link=link, on=on, position=angle.si - lean[0] + lean[1], rate=rate.si, accel=accel.si), tuple(data)


def _at(point: str, bodies: Bodies) -> set[str]:
    """Links that carry the letter."""
    return {name for name, draft in bodies.drafts.items() if point in draft.points} | (
        {FRAME} if point in bodies.frame else set()
    )


def _lean(bodies: Bodies, name: str, pin: str) -> float:
    """The direction, in the link's coordinates, from the common pin to the link's first other point."""
    points = bodies.drafts[name].points
    other = next((place for letter, place in points.items() if letter != pin), None)
    return 0.0 if other is None else cmath.phase(other - points[pin])


def _read(key: str, text: str | None, dim: Dim) -> Quantity:
    try:
        return read(text or "0", dim)
    except FaultError as fault:
        raise FaultError(fault.words, key) from None
