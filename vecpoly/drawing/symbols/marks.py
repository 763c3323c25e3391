"""Mark -> primitives: what each mark of a construction looks like on paper."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import assert_never

from ...board.construction import View
from ...board.paper.marks import (
    AngleMark,
    Arc,
    Block,
    Body,
    Cell,
    Curve,
    Disc,
    Dot,
    FixedGuide,
    FrictionCircle,
    GearMark,
    Ground,
    Hatched,
    ImageOf,
    LinkNumber,
    Mark,
    Note,
    Outline,
    Passing,
    Plate,
    Point,
    RackMark,
    RightAngle,
    Role,
    Segment,
    Slot,
    Solid,
    Trace,
    TurnArrow,
    Vector,
    Weld,
)
from ...board.paper.tones import key_of
from ...board.paper.walls import holds, leaves
from ...words import Lang
from ..hues import Tones, dash_of, image_hue, is_hollow, line_hue, mark_hue, tint_of
from ..scene import Fill, Item, Layer, Stroke
from ..style import DOT_RADIUS, JOINT_RADIUS, POLE_RADIUS, THIN, Dash, Hue, pen
from . import bodies, shapes, solids
from .angles import draw_angle, draw_square, draw_turn
from .shapes import NEAR


@dataclass(frozen=True, slots=True, kw_only=True)
class Surroundings:
    """What a symbol must know of its figure:
    the view, the blocks, the tips of its vectors, its friction circles, the language, by which tones vectors are told
    apart."""

    view: View
    blocks: tuple[Block, ...] = ()
    tips: tuple[complex, ...] = ()
    circles: tuple[FrictionCircle, ...] = ()
    lang: Lang = "zh"
    tones: Tones = None

    @classmethod
    def of(cls, view: View, marks: tuple[Mark, ...], lang: Lang = "zh", tones: Tones = None) -> Surroundings:
        """Gathered from the figure's marks."""
        return cls(
            view=view,
            blocks=tuple(m for m in marks if isinstance(m, Block)),
            lang=lang,
            tones=tones,
            circles=tuple(m for m in marks if isinstance(m, FrictionCircle)),
            tips=tuple(m.b for m in marks if isinstance(m, Vector) and abs(m.b - m.a) > 0.5),
        )

    def pin_radius(self, at: complex) -> float:
        """Of the joint drawn here: smaller within a friction circle, so that both are seen."""
        tight = any(abs(c.centre - at) < NEAR and c.radius < JOINT_RADIUS + 0.8 for c in self.circles)
        return POLE_RADIUS if tight else JOINT_RADIUS

    def link_layer(self, owner: str, *points: complex) -> Layer:
        """Where a link through these points lies: over a block of another link whose pin it carries, unless it runs
        along the block; a bar ends at the walls of a block that is one with it."""
        others = [block for block in self.blocks if not owner or block.owner != owner]
        pairs = tuple(pairwise(points))
        return Layer.OVER if any(_carries(a, b, block) for a, b in pairs for block in others) else Layer.LINE

    def outside(self, bar: Segment) -> tuple[complex, complex]:
        """The ends of a line: a bar that starts in a block of its own link starts at the block's wall."""
        a, b = bar.a, bar.b
        own = [block for block in self.blocks if bar.owner and block.owner == bar.owner and bar.role is Role.LINK]
        for block in own:
            a, b = (
                (leaves(block, z, other) or z) if holds(block, z) and abs(other - z) > NEAR else z
                for z, other in ((a, b), (b, a))
            )
        return a, b

    def tipped(self, at: complex) -> bool:
        """Whether an arrowhead already shows the place."""
        return any(abs(at - tip) < NEAR for tip in self.tips)


def draw(mark: Mark, around: Surroundings) -> tuple[Item, ...]:
    """The primitives of one mark, without lettering."""
    if isinstance(mark, Trace):
        return _line(mark, around)
    if isinstance(mark, Solid):
        return _solid(mark, around)
    if isinstance(mark, Body):
        return _body(mark, around)
    match mark:
        case Point():
            return _point(mark, around)
        case RightAngle():
            return draw_square(mark)
        case ImageOf(points=points, step=step):
            return (
                (Fill(points=points, hue=tint_of(around.view, around.tones), layer=Layer.TINT, step=step),)
                if len(points) > 2
                else ()
            )
        case TurnArrow():
            return draw_turn(mark, mark_hue(mark, around.view, mark.label, around.tones))
        case AngleMark():
            return draw_angle(mark)
        case LinkNumber() | Note():
            return ()
    assert_never(mark)


def _carries(a: complex, b: complex, block: Block) -> bool:
    if abs(b - a) < NEAR:
        return False
    u = (b - a) / abs(b - a)
    off = (block.at - a) * u.conjugate()
    across = abs((u * block.along.conjugate()).imag) > 0.02
    ends_here = min(abs(block.at - a), abs(block.at - b)) < NEAR
    return (across or ends_here) and abs(off.imag) < NEAR and -NEAR < off.real < abs(b - a) + NEAR


def _body(mark: Body, around: Surroundings) -> tuple[Item, ...]:
    match mark:
        case Plate():
            return bodies.plate(mark, around.link_layer(mark.owner, *mark.points, mark.points[0]))
        case Ground():
            return bodies.ground(mark, around.pin_radius(mark.at))
        case FixedGuide():
            return bodies.guide(mark)
        case Block():
            return bodies.block(mark)
        case Slot():
            return bodies.slot(mark)
        case GearMark():
            return bodies.gear(mark)
        case RackMark():
            return bodies.rack(mark)
        case Passing():
            return bodies.passing(mark, around.pin_radius(mark.at))
        case Weld():
            return bodies.weld(mark)
    assert_never(mark)


def _solid(mark: Solid, around: Surroundings) -> tuple[Item, ...]:
    match mark:
        case FrictionCircle():
            return solids.friction_circle(mark)
        case Disc():
            return solids.disc(mark)
        case Outline():
            return solids.outline(mark)
        case Hatched():
            return solids.hatched(mark)
        case Cell():
            return solids.cell(mark, around.lang)
    assert_never(mark)


def _line(mark: Trace, around: Surroundings) -> tuple[Item, ...]:
    match mark:
        case Segment(role=role):
            a, b = around.outside(mark)
            p = pen(role, image_hue(around.view, around.tones))
            layer = Layer.THIN if p.width == THIN else around.link_layer(mark.owner, a, b)
            hue = line_hue(mark.key, around.tones, p.hue)
            return (Stroke(points=(a, b), width=p.width, dash=p.dash, hue=hue, layer=layer, step=mark.step),)
        case Arc(centre=centre, radius=radius, start=start, sweep=sweep, role=role):
            p = pen(role, Hue.BLACK)
            full = abs(abs(sweep) - 2 * math.pi) < 1e-9
            points = shapes.circle(centre, radius) if full else shapes.arc(centre, radius, start, sweep)
            layer = Layer.THIN if p.width == THIN else Layer.LINE
            return (
                Stroke(points=points, width=p.width, dash=p.dash, hue=p.hue, closed=full, layer=layer, step=mark.step),
            )
        case Curve(points=points, role=role):
            p = pen(role, Hue.BLACK)
            layer = Layer.THIN if p.width == THIN else Layer.LINE
            return (Stroke(points=points, width=p.width, dash=p.dash, hue=p.hue, layer=layer, step=mark.step),)
        case Vector():
            return _vector(mark, around)
    assert_never(mark)


def _vector(mark: Vector, around: Surroundings) -> tuple[Item, ...]:
    length = abs(mark.b - mark.a)
    if length < NEAR:
        return ()
    u = (mark.b - mark.a) / length
    p = pen(mark.role, mark_hue(mark, around.view, mark.label, around.tones))
    width, dash = shapes.shaft_width(length, p.width), p.dash if p.dash is not Dash.FULL else dash_of(key_of(mark))
    tip = shapes.head(mark.b, u, shapes.head_length(length), shapes.head_width(length, width))
    # the shaft ends inside the head, where the head is wider than the shaft, so that the tip stays sharp
    end = mark.b - u * shapes.head_length(length) * 0.75
    solid = Layer.OVER if around.view.bodies else Layer.LINE  # a force is seen over the block on which it acts
    layer = Layer.THIN if mark.role in (Role.DIRECTION, Role.CONSTRUCTION, Role.IDEAL) else solid
    shaft = Stroke(points=(mark.a, end), width=width, dash=dash, hue=p.hue, layer=layer, step=mark.step)
    return (
        *(shapes.hollow(shaft) if is_hollow(key_of(mark), around.tones) else (shaft,)),
        Fill(points=tip, hue=p.hue, layer=Layer.HEAD, step=mark.step),
    )


def _point(mark: Point, around: Surroundings) -> tuple[Item, ...]:
    match mark.dot:
        case Dot.JOINT:
            return bodies.joint(mark.at, mark.step, around.pin_radius(mark.at))
        case Dot.MULTIPLE:
            return bodies.multiple(mark.at, mark.step, around.pin_radius(mark.at))
        case Dot.MASS:
            return bodies.mass(mark.at, mark.step)
        case Dot.POLE:
            ring = shapes.circle(mark.at, POLE_RADIUS)
            return (
                Fill(points=ring, hue=Hue.WHITE, layer=Layer.JOINT, step=mark.step),
                Stroke(points=ring, width=0.25, closed=True, layer=Layer.JOINT, step=mark.step),
            )
        case Dot.POINT:
            if around.tipped(mark.at):
                return ()
            return (Fill(points=shapes.circle(mark.at, DOT_RADIUS), layer=Layer.HEAD, step=mark.step),)
        case Dot.NONE:
            return ()
    assert_never(mark.dot)
