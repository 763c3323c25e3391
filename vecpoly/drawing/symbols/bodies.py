"""The machine symbols of GB/T 4460: frame, guides, blocks, slots, gears and racks."""

from __future__ import annotations

import cmath

from ...board.paper.marks import Block, FixedGuide, GearMark, Ground, Plate, RackMark, Slot
from ..scene import Fill, Item, Layer, Stroke
from ..style import GIVEN, JOINT_RADIUS, LINK, RESULT, SYMBOL, THIN, Dash, Hue
from .shapes import circle, hatching, rectangle

BLOCK_LENGTH, BLOCK_HEIGHT = 9.0, 5.0
FOOT_HEIGHT, FOOT_HALF, GROUND_HALF = 5.0, 2.6, 4.6
TOOTH = 2.2  # rack: pitch line to body line


def joint(at: complex, step: int, radius: float = JOINT_RADIUS) -> tuple[Item, ...]:
    """A revolute joint: an open circle that hides the ends of the links it joins."""
    ring = circle(at, radius)
    return (
        Fill(points=ring, hue=Hue.WHITE, layer=Layer.JOINT, step=step),
        Stroke(points=ring, width=SYMBOL, closed=True, layer=Layer.JOINT, step=step),
    )


def hatched(a: complex, b: complex, step: int, width: float = RESULT) -> tuple[Item, ...]:
    """A fixed line, hatched on the right of a -> b."""
    line = Stroke(points=(a, b), width=width, layer=Layer.THIN, step=step)
    return (line, *(Stroke(points=pair, width=THIN, layer=Layer.THIN, step=step) for pair in hatching(a, b)))


def ground(mark: Ground, pin: float = JOINT_RADIUS) -> tuple[Item, ...]:
    """A fixed pivot: circle on a small triangle over hatched ground."""
    down = mark.down / abs(mark.down)
    foot, side = mark.at + down * FOOT_HEIGHT, down * 1j
    feet = (mark.at, foot + side * FOOT_HALF, foot - side * FOOT_HALF)
    return (
        Stroke(points=feet, width=SYMBOL, closed=True, layer=Layer.THIN, step=mark.step),
        *hatched(foot - side * GROUND_HALF, foot + side * GROUND_HALF, mark.step, SYMBOL),
        *joint(mark.at, mark.step, pin),
    )


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


def gear(mark: GearMark) -> tuple[Item, ...]:
    """A pitch circle and the cross at its centre."""
    arm = min(4.0, mark.radius / 2)
    cross = ((mark.centre - arm, mark.centre + arm), (mark.centre - 1j * arm, mark.centre + 1j * arm))
    ring = Stroke(
        points=circle(mark.centre, mark.radius),
        width=GIVEN,
        dash=Dash.DASH_DOT,
        closed=True,
        layer=Layer.THIN,
        step=mark.step,
    )
    return (ring, *(Stroke(points=pair, width=THIN, layer=Layer.THIN, step=mark.step) for pair in cross))


def rack(mark: RackMark) -> tuple[Item, ...]:
    """A rack: dash-dot pitch line, body line on its right, hatched where the rack is fixed, a bar where it moves."""
    if abs(mark.b - mark.a) < 1e-9:
        return ()
    right = -1j * (mark.b - mark.a) / abs(mark.b - mark.a)
    a, b = mark.a + TOOTH * right, mark.b + TOOTH * right
    pitch = Stroke(points=(mark.a, mark.b), width=GIVEN, dash=Dash.DASH_DOT, layer=Layer.THIN, step=mark.step)
    if mark.fixed:
        return (pitch, *hatched(a, b, mark.step))
    bar = (a, b, b + BLOCK_HEIGHT * right, a + BLOCK_HEIGHT * right)
    return (pitch, Stroke(points=bar, width=RESULT, closed=True, step=mark.step))
