"""The given sizes of an eccentric clamp, of an engine's crankshaft and of a cam on their sketches."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from math import pi

from ...board.construction import Figure
from ...board.paper.marks import Arc, Dot, Ground, Mark, Point, Role, Segment, Vector
from ...devices.balancing.engine import InlineEngine
from ...devices.balancing.field import FieldBalancing
from ...devices.balancing.shaking import ShakingForce
from ...devices.cams.cam import Cam
from ...devices.eccentric_clamp import EccentricClamp
from .lines import AXIS, angle, letter, radius, span

_BETWEEN, _APART = (0.2 * pi, 0.8 * pi, -0.2 * pi, -0.8 * pi, 0.4 * pi), 0.25  # rad: of radii; from a weight
PRESSED = 9.0  # mm: the arrow of the force on the work
BELOW = 7.0  # mm from what is drawn to a dimension under it


def clamp(device: EccentricClamp, figure: Figure) -> Iterator[Mark]:
    """R, e, l, and the three angles from the x axis, and Q on the work; the friction circle is told in the data."""
    mm = figure.scale.value
    contact = next((mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label == "K"), None)
    if contact is not None:
        yield Vector(a=contact, b=contact - 1j * PRESSED, role=Role.GIVEN, label="Q", step=1)
    o, h = (
        cmath.rect(size.si / mm, turn.si) for size, turn in ((device.e, device.theta), (device.lever, device.handle))
    )
    big, side = device.R.si / mm, -1j * cmath.rect(1.0, device.handle.si) * device.turn
    yield from radius(o, big, 0.75 * pi if device.turn > 0 else 0.25 * pi, "R")
    yield from span(0j, o, "e", -1j * cmath.rect(big + BELOW, device.theta.si) * device.turn)
    yield from span(0j, h, "l", side * (BELOW + 3.0))
    yield from angle(0j, device.handle.si % (2 * pi), "θ_{l}", big + BELOW)
    yield from angle(0j, device.theta.si % (2 * pi), "θ_{O}", 0.55 * big)
    yield from angle(h, device.F.si % (2 * pi), "θ_{F}", BELOW)


def field(device: FieldBalancing, figure: Figure) -> Iterator[Mark]:
    """r_t of the trial weights and r_b of the correction, one line where they are alike, and θ_t of each weight."""
    mm, names = figure.scale.value, dict[float, str]()
    for name, size in (("r_t", device.trials[0].r.si), ("r_b", device.correct.r.si)):
        names[size] = f"{names[size]}, {name}" if size in names else name
    weights = [trial.at.si % (2 * pi) for trial in device.trials]
    turns = [turn for turn in _BETWEEN if all(abs(cmath.phase(cmath.rect(1.0, turn - at))) > _APART for at in weights)]
    for turn, (size, name) in zip(turns, names.items(), strict=False):
        yield from radius(0j, size / mm, turn, name)
    for i, at in enumerate(weights, 1):
        if at:
            yield _centre_line(cmath.rect(device.trials[i - 1].r.si / mm, at))
            yield from angle(0j, at, f"θ_{{t{i}}}" if len(weights) > 1 else "θ_t", AXIS * (0.6 + 0.4 * i))


def _centre_line(end: complex) -> Mark:
    return Segment(a=0j, b=end, role=Role.CENTRE, step=1)


def shaking(device: ShakingForce, figure: Figure) -> Iterator[Mark]:
    """r, l and r_c beside the lines that they measure, and the rod's centre of mass, which data give."""
    spots = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label}
    pivot = next(mark.at for mark in figure.marks if isinstance(mark, Ground))
    for symbol, a, b in (("r", pivot, spots["B"]), ("l", spots["B"], spots["C"]), ("r_c", pivot, spots["m_c"])):
        yield letter((a + b) / 2, symbol)
    share = device.BS2.si / device.l.si
    centre = spots["B"] + share * (spots["C"] - spots["B"])
    if 0.0 < share < 1.0:
        yield Point(at=centre, label="S_2", dot=Dot.MASS, step=1)


def engine(device: InlineEngine, figure: Figure) -> Iterator[Mark]:
    """a from the first cylinder to the second; r, l and m of each are in the data."""
    centres = [m for m in figure.marks if isinstance(m, Segment) and m.role is Role.CENTRE and m.a.real == m.b.real]
    if len(device.cranks) > 1:
        low = min(mark.a.imag for mark in centres)
        first, second = sorted(mark.a.real for mark in centres)[:2]
        yield from span(complex(first, low), complex(second, low), "a", -4j)


def cam(device: Cam, figure: Figure) -> Iterator[Mark]:
    """r_0, r_r, the offset e or OA, AB and the way d of a face."""
    mm, spots = figure.scale.value, {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point)}
    if device.r0 is None or "O" not in spots:
        return
    centre, follower = spots["O"], device.follower
    yield from radius(centre, device.r0.si / mm, -0.2 * pi if device.side > 0 else -0.8 * pi, "r_0")
    rims = [m for m in figure.marks if isinstance(m, Arc) and m.role is Role.GIVEN]
    if follower.roller is not None and rims:
        yield from radius(rims[0].centre, rims[0].radius, 0.75 * pi if follower.e <= 0 else 0.25 * pi, "r_r")
    if follower.offset is not None and follower.e:
        yield from span(centre, centre + follower.e / mm, "e", -1j * (device.r0.si / mm + BELOW))
    if follower.arm is not None and "A" in spots:
        yield from _arm(device, figure, centre, spots["A"])


def _arm(device: Cam, figure: Figure, centre: complex, pivot: complex) -> Iterator[Mark]:
    """OA under the circles, AB beside the arm; of a face how far it is from A."""
    assert device.follower.arm is not None
    low = min(-m.radius for m in figure.marks if isinstance(m, Arc) and m.role is Role.CENTRE)
    yield from span(centre, pivot, "l_{OA}", 1j * (low - BELOW))
    bars = [m for m in figure.marks if isinstance(m, Segment) and m.role is Role.LINK]
    if device.follower.arm.AB is not None and bars:
        bar = bars[0]
        yield from span(bar.a, bar.b, "l_{AB}", 1j * BELOW * (bar.b - bar.a) / abs(bar.b - bar.a) * -device.side)
    elif device.face and len(bars) > 1:  # a face that passes the pivot on paper has no way to it
        yield from span(bars[0].a, bars[0].b, "d", BELOW * (bars[1].b - bars[1].a) / abs(bars[1].b - bars[1].a) * -1)
