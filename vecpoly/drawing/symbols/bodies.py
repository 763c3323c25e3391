"""The machine symbols of GB/T 4460: frame, guides, blocks, slots, gears and racks."""

from __future__ import annotations

import cmath

from ...board.paper.marks import Block, FixedGuide, GearMark, Ground, Passing, Plate, RackMark, Slot, Weld
from ..scene import Fill, Item, Layer, Stroke
from ..style import (
    HATCHING,
    INNER_RADIUS,
    JOINT_RADIUS,
    LINK,
    MASS_RADIUS,
    MULTIPLE_RADIUS,
    RESULT,
    SYMBOL,
    THIN,
    Dash,
    Hue,
)
from .shapes import arc, circle, hatching, rectangle

BLOCK_LENGTH, BLOCK_HEIGHT = 9.0, 5.0
FOOT_HEIGHT, FOOT_HALF, GROUND_HALF = 5.0, 2.6, 4.6
TOOTH = 2.2  # rack: pitch line to body line
CROSS = 1.6  # arms of the cross in the centre of a circle
WELD = 2.4  # legs of the filled corner of a rigid connection


def joint(at: complex, step: int, radius: float = JOINT_RADIUS) -> tuple[Item, ...]:
    """A revolute joint: an open circle that hides the ends of the links it joins."""
    ring = circle(at, radius)
    return (
        Fill(points=ring, hue=Hue.WHITE, layer=Layer.JOINT, step=step),
        Stroke(points=ring, width=SYMBOL, closed=True, layer=Layer.JOINT, step=step),
    )


def multiple(at: complex, step: int, radius: float = JOINT_RADIUS) -> tuple[Item, ...]:
    """A compound hinge: a circle within a circle."""
    share = radius / JOINT_RADIUS  # smaller within a friction circle, as every pin
    inner = circle(at, INNER_RADIUS * share)
    return (
        *joint(at, step, MULTIPLE_RADIUS * share),
        Stroke(points=inner, width=SYMBOL, closed=True, layer=Layer.JOINT, step=step),
    )


def mass(at: complex, step: int) -> tuple[Item, ...]:
    """A centre of mass: a circle of which two opposite quarters are filled."""
    ring = circle(at, MASS_RADIUS)
    quarters = tuple((at, *arc(at, MASS_RADIUS, start, cmath.pi / 2)) for start in (0.0, cmath.pi))
    return (
        Fill(points=ring, hue=Hue.WHITE, layer=Layer.JOINT, step=step),
        *(Fill(points=quarter, layer=Layer.JOINT, step=step) for quarter in quarters),
        Stroke(points=ring, width=THIN, closed=True, layer=Layer.JOINT, step=step),
    )


def passing(mark: Passing, pin: float) -> tuple[Item, ...]:
    """Half a ring about a pin, as thick as the bar that runs on past it."""
    start = cmath.phase(mark.along)
    outer, inner = arc(mark.at, pin + LINK, start, cmath.pi), arc(mark.at, pin, start + cmath.pi, -cmath.pi)
    return (Fill(points=outer + inner, layer=Layer.OVER, step=mark.step),)


def weld(mark: Weld) -> tuple[Item, ...]:
    """The filled corner of a rigid connection."""
    at, u, v = mark.at + mark.off, mark.u / abs(mark.u), mark.v / abs(mark.v)
    return (Fill(points=(at, at + WELD * u, at + WELD * v), layer=Layer.OVER, step=mark.step),)


def hatched(a: complex, b: complex, step: int, width: float = RESULT) -> tuple[Item, ...]:
    """A fixed line, hatched on the right of a -> b."""
    line = Stroke(points=(a, b), width=width, layer=Layer.THIN, step=step)
    return (line, *(Stroke(points=pair, width=HATCHING, layer=Layer.THIN, step=step) for pair in hatching(a, b)))


def ground(mark: Ground, pin: float = JOINT_RADIUS) -> tuple[Item, ...]:
    """A fixed pivot: circle on a small triangle over hatched ground."""
    down = mark.down / abs(mark.down)
    foot, side = mark.at + down * FOOT_HEIGHT, down * 1j
    feet = (mark.at, foot + side * FOOT_HALF, foot - side * FOOT_HALF)
    return (
        Stroke(points=feet, width=SYMBOL, closed=True, layer=Layer.THIN, step=mark.step),
        *hatched(*foot_of(mark), mark.step, SYMBOL),
        *joint(mark.at, mark.step, pin),
    )


def foot_of(mark: Ground) -> tuple[complex, complex]:
    """The hatched line under a fixed pivot."""
    down = mark.down / abs(mark.down)
    foot, side = mark.at + down * FOOT_HEIGHT, down * 1j * GROUND_HALF
    return foot - side, foot + side


def guide(mark: FixedGuide) -> tuple[Item, ...]:
    """A fixed guide."""
    return hatched(mark.a, mark.b, mark.step)


def plate(mark: Plate, layer: Layer) -> tuple[Item, ...]:
    """A link with three or more points: tinted, outlined as one body in `layer`."""
    return (
        Fill(points=mark.points, hue=Hue.PLATE, layer=Layer.TINT, step=mark.step),
        Stroke(points=mark.points, width=LINK, closed=True, layer=layer, step=mark.step),
    )


def block_corners(mark: Block) -> tuple[complex, ...]:
    """The outline of a slider block."""
    return rectangle(mark.at, mark.along / abs(mark.along), mark.length, BLOCK_HEIGHT)


def block(mark: Block) -> tuple[Item, ...]:
    """A slider block or sleeve; it hides the rod or guide that runs through it."""
    corners = block_corners(mark)
    return (
        Fill(points=corners, hue=Hue.WHITE, layer=Layer.BODY, step=mark.step),
        Stroke(points=corners, width=RESULT, closed=True, layer=Layer.BODY, step=mark.step),
    )


def slot(mark: Slot) -> tuple[Item, ...]:
    """Two parallel lines with round ends, as wide as the block that runs between them."""
    if abs(mark.b - mark.a) < 1e-9:
        return ()
    u, r = (mark.b - mark.a) / abs(mark.b - mark.a), BLOCK_HEIGHT / 2
    round_a = tuple(mark.a + r * u * cmath.exp(1j * cmath.pi * (0.5 + i / 24)) for i in range(25))
    round_b = tuple(mark.b + r * u * cmath.exp(1j * cmath.pi * (-0.5 + i / 24)) for i in range(25))
    return (
        Fill(points=round_a + round_b, hue=Hue.WHITE, layer=Layer.SLOT, step=mark.step),
        Stroke(points=round_a + round_b, width=RESULT, closed=True, layer=Layer.SLOT, step=mark.step),
    )


def cross(at: complex, step: int, arm: float = CROSS) -> tuple[Item, ...]:
    """Two short lines that cross in the centre of a circle."""
    pairs = ((at - arm, at + arm), (at - 1j * arm, at + 1j * arm))
    return tuple(Stroke(points=pair, width=THIN, layer=Layer.THIN, step=step) for pair in pairs)


def gear(mark: GearMark) -> tuple[Item, ...]:
    """A pitch circle and the cross at its centre."""
    ring = Stroke(
        points=circle(mark.centre, mark.radius),
        width=THIN,
        dash=Dash.DASH_DOT,
        closed=True,
        layer=Layer.THIN,
        step=mark.step,
    )
    return (ring, *cross(mark.centre, mark.step, min(4.0, mark.radius / 2)))


def rack(mark: RackMark) -> tuple[Item, ...]:
    """A rack: dash-dot pitch line, body line on its right, hatched where the rack is fixed, a bar where it moves."""
    if abs(mark.b - mark.a) < 1e-9:
        return ()
    right = -1j * (mark.b - mark.a) / abs(mark.b - mark.a)
    a, b = mark.a + TOOTH * right, mark.b + TOOTH * right
    pitch = Stroke(points=(mark.a, mark.b), width=THIN, dash=Dash.DASH_DOT, layer=Layer.THIN, step=mark.step)
    if mark.fixed:
        return (pitch, *hatched(a, b, mark.step))
    bar = (a, b, b + BLOCK_HEIGHT * right, a + BLOCK_HEIGHT * right)
    return (pitch, Stroke(points=bar, width=RESULT, closed=True, step=mark.step))
