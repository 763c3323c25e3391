"""Mark -> primitives: what each mark of a construction looks like on paper."""

from __future__ import annotations

import math
from typing import assert_never

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
from ..hues import CENTRODES, curve_hue, dash_of, image_hue, is_hollow, line_hue, mark_hue, tint_of
from ..scene import Fill, Item, Layer, Stroke
from ..style import DOT_RADIUS, FOUND, POINT_RADIUS, POLE_RADIUS, THIN, Dash, Hue, pen
from . import bodies, shapes, solids
from .angles import draw_angle, draw_square, draw_turn
from .around import UNCENTRED, Surroundings
from .shapes import NEAR

WALL, PALE = 0.22, 0.85  # mm: of an open head; as wide as so much of its width a hollow shaft looks


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
            return draw_angle(mark, around.angles)
        case LinkNumber() | Note():
            return ()
    assert_never(mark)


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
            return solids.disc(mark, around.discs)
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
            hue = curve_hue(role, around.tones) if role in CENTRODES else image_hue(around.view, around.tones)
            p = pen(role, hue)
            layer = Layer.THIN if p.width <= THIN else around.link_layer(mark.owner, a, b)
            hue = p.hue if mark in around.common else line_hue(mark.key, around.tones, p.hue)
            cut = role is Role.RESULT and bool(mark.key) and around.view.is_polygon  # a vector that a ring cuts off
            width = FOUND if cut else p.width
            line = Stroke(points=(a, b), width=width, dash=p.dash, hue=hue, layer=layer, step=mark.step)
            return shapes.hollow(line) if mark.key and is_hollow(mark.key, around.tones) else (line,)
        case Arc(centre=centre, radius=radius, start=start, sweep=sweep, role=role):
            p = pen(role, Hue.BLACK)
            full = abs(abs(sweep) - 2 * math.pi) < 1e-9
            points = shapes.circle(centre, radius) if full else shapes.arc(centre, radius, start, sweep)
            layer = Layer.THIN if p.width <= THIN else Layer.LINE
            line = Stroke(
                points=points, width=p.width, dash=p.dash, hue=p.hue, closed=full, layer=layer, step=mark.step
            )
            bare = full and mark.owner not in UNCENTRED and around.bare(centre, radius)
            return (line, *bodies.cross(centre, mark.step)) if bare else (line,)
        case Curve(points=points, role=role):
            p = pen(role, curve_hue(role, around.tones))
            layer = Layer.THIN if p.width <= THIN else Layer.LINE
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
    wide = FOUND if mark.role is Role.RESULT and around.view.is_polygon else p.width
    width, dash = shapes.shaft_width(length, wide), p.dash if p.dash is not Dash.FULL else dash_of(key_of(mark))
    twofold = is_hollow(key_of(mark), around.tones)
    line = PALE * shapes.hollow_width(width) if twofold else width
    tip = shapes.head(mark.b, u, shapes.head_length(length), shapes.head_width(length, line))
    # the shaft ends inside the head, where the head is wider than the shaft, so that the tip stays sharp
    end = mark.b - u * shapes.head_length(length) * 0.75
    solid = Layer.OVER if around.view.bodies else Layer.LINE  # a force is seen over the block on which it acts
    layer = Layer.THIN if mark.role in (Role.DIRECTION, Role.CONSTRUCTION, Role.IDEAL) else solid
    shaft = Stroke(points=(mark.a, end), width=width, dash=dash, hue=p.hue, layer=layer, step=mark.step)
    lines = shapes.hollow(shaft) if twofold else (shaft,)
    known = mark.role is Role.GIVEN and around.view.is_polygon
    heads = [Fill(points=tip, hue=p.hue, layer=Layer.HEAD, step=mark.step)]
    if known and (white := shapes.inside(tip, WALL)):
        heads.append(Fill(points=white, hue=Hue.WHITE, layer=Layer.HEAD, step=mark.step))
    return (*lines, *heads)


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
            radius = POINT_RADIUS if around.on_link(mark.at) else DOT_RADIUS
            return (Fill(points=shapes.circle(mark.at, radius), layer=Layer.HEAD, step=mark.step),)
        case Dot.NONE:
            return ()
    assert_never(mark.dot)
