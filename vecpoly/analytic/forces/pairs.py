"""Joints and contacts in the equations of equilibrium:
what one link does to the other, by its unknowns, and the friction there."""

from __future__ import annotations

from cmath import phase
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import tan

from ...mechanism.asked.forces import press_named, slide_named
from ...mechanism.loads import Friction
from ...mechanism.model import FRAME, Contact, Mechanism, Prismatic, Rack, Revolute, Side
from ..equations import Equation
from ..expr import ZERO, Const, Expr, Var
from ..functions import SquareRoot, cos, sin, square
from .terms import Sense, Size

Pair = tuple[Expr, Expr]


@dataclass(frozen=True, slots=True, kw_only=True)
class Touch:
    """The force (N) and couple (N·m) about `at` of link a on link b; that on a is the opposite.

    before: what must be known first; friction: the equations of the friction in it; unknowns: their symbols; rub: the
    symbol of the moment of friction of a hinge.
    """

    a: str
    b: str
    at: Pair
    letter: str
    force: Pair
    couple: Expr
    unknowns: tuple[str, ...]
    before: tuple[Equation, ...] = ()
    friction: tuple[Equation, ...] = ()
    rub: str = ""


@dataclass(frozen=True, slots=True)
class Frame:
    """How the motion's model names places and angles. turned: angles (rad) of the links that it has no symbol for."""

    mech: Mechanism
    symbols: frozenset[str]
    turned: Mapping[str, float]

    def xy(self, letter: str) -> Pair:
        """Coordinates of a letter."""
        if letter in self.mech.frame:
            place = self.mech.frame[letter]
            return Const(f"x_{{{letter}}}", place.real), Const(f"y_{{{letter}}}", place.imag)
        return Var(f"x_{{{letter}}}"), Var(f"y_{{{letter}}}")

    def angle(self, link: str, more: float) -> Expr:
        """The direction of a line on a link, `more` (rad) from the link's axis."""
        if link == FRAME:
            return Const("θ", more, "rad")
        own: Expr = (
            Var(f"φ_{{{link}}}")
            if f"φ_{{{link}}}" in self.symbols
            else Const(f"φ_{{{link}}}", self.turned[link], "rad")
        )
        return own + Const(f"θ_{{{link}}}", more, "rad")

    def ray(self, link: str, start: str, end: str) -> Expr:
        """The direction of the ray between two letters of a link that has a symbol for its angle."""
        points = self.mech.link(link).points
        more = phase(points[end] - points[start])
        return self.angle(link, more) if more else Var(f"φ_{{{link}}}")

    def velocity(self, letter: str) -> Pair:
        """Components of a letter's velocity, nothing of the frame's."""
        if letter in self.mech.frame:
            return ZERO, ZERO
        return Var(f"v_{{{letter}x}}"), Var(f"v_{{{letter}y}}")

    def rate(self, link: str) -> Expr:
        """ω, nothing where the link cannot turn."""
        return Var(f"ω_{{{link}}}") if f"ω_{{{link}}}" in self.symbols else ZERO


def touches(frame: Frame, friction: Friction) -> Iterator[Touch]:
    """Every pair of links that press on each other."""
    thought = frame.mech.substitutes
    for pin in _pins(frame.mech):
        yield _pin(frame, pin, friction.pins.get(pin.point, 0.0))
    for joint in frame.mech.joints:
        if isinstance(joint, Prismatic) and not {joint.guide, joint.block} & thought:
            yield _slide(frame, joint, friction.slides.get((joint.block, joint.guide), 0.0))
    for contact in frame.mech.contacts:
        yield _contact(frame, contact, friction.contacts.get(contact.point, 0.0))


def _pins(mech: Mechanism) -> Iterator[Revolute]:
    """The hinges that there are: not those of a block that is only thought."""
    thought = {*mech.substitutes, *mech.slot_pins}
    return (joint for joint in mech.joints if isinstance(joint, Revolute) and not {joint.a, joint.b} & thought)


def _pin(frame: Frame, joint: Revolute, radius: float) -> Touch:
    """A force of any direction; friction's couple is ρ R, against the relative rotation."""
    a, b = (joint.b, joint.a) if joint.b == FRAME else (joint.a, joint.b)  # of the frame on the link
    who = frame.mech.number(a) + frame.mech.number(b)
    rx, ry, rub = Var(f"R_{{{who}x}}"), Var(f"R_{{{who}y}}"), Var(_rub_symbol(frame.mech, joint.point, who))
    size = Const(f"ρ_{{{joint.point}}}", radius) * SquareRoot(square(rx) + square(ry))
    law = (Equation(rub, -(size * Sense(frame.rate(b) - frame.rate(a)))),) if radius else ()
    return Touch(
        a=a,
        b=b,
        at=frame.xy(joint.point),
        letter=joint.point,
        force=(rx, ry),
        couple=rub if radius else ZERO,
        unknowns=(rx.symbol, ry.symbol),
        friction=law,
        rub=rub.symbol if radius else "",
    )


def _rub_symbol(mech: Mechanism, letter: str, who: str) -> str:
    """M_fC; at a multiple joint, where several links rub on the one that carries the pin, M_fC,23."""
    hinged = [joint for joint in _pins(mech) if joint.point == letter]
    return f"M_{{f{letter},{who}}}" if len(hinged) > 1 else f"M_{{f{letter}}}"


def _slide(frame: Frame, joint: Prismatic, angle: float) -> Touch:
    """A force square to the guide and a couple about the block's pin;
    friction f N along the guide, against the sliding."""
    mech, line, pin = frame.mech, frame.angle(joint.guide, joint.direction), frame.mech.slot_pins.get(joint.block)
    guide, block = mech.number(joint.guide), mech.number(joint.block)
    who = press_named(mech, joint.guide, joint.block).key.removeprefix("R_")
    normal, turn, rub = Var(f"N_{{{who}}}"), Var(f"T_{{{who}}}"), Var(f"F_{{f{who}}}")
    coefficient, slip = Const(f"f_{{{block}{guide}}}", tan(angle), ""), Var(f"v_{{{slide_named(mech, joint)}}}")
    law = (_rubbed(rub, coefficient, normal, slip),) if angle else ()
    along: Expr = rub if angle else ZERO
    force = along * cos(line) - normal * sin(line), along * sin(line) + normal * cos(line)
    if pin is not None:  # no block: the slot presses on the pin itself, and passes on no couple
        return Touch(
            a=pin.guide,
            b=pin.carrier,
            at=frame.xy(joint.pin),
            letter=joint.pin,
            force=force,
            couple=ZERO,
            unknowns=(normal.symbol,),
            friction=law,
        )
    return Touch(
        a=joint.guide,
        b=joint.block,
        at=frame.xy(joint.pin),
        letter=joint.pin,
        force=force,
        couple=turn,
        unknowns=(normal.symbol, turn.symbol),
        friction=law,
    )


def _rubbed(rub: Var, coefficient: Const, normal: Var, slip: Var) -> Equation:
    """F = −f |N| sgn v."""
    return Equation(rub, -(coefficient * Size(normal) * Sense(slip)))


def _contact(frame: Frame, contact: Contact, angle: float) -> Touch:
    """A force along the common normal, towards the disc; friction f N across it."""
    mech, (disc, on), k = frame.mech, contact.links, contact.point
    who, back = mech.number(on) + mech.number(disc), mech.number(disc) + mech.number(on)
    (cx, cy), radius = frame.xy(contact.disc.centre), Const(f"r_{{{mech.disc_number(disc)}}}", contact.disc.radius)
    nx, ny = Var(f"n_{{{k}x}}"), Var(f"n_{{{k}y}}")
    across = _normal(frame, contact)
    outer = not isinstance(contact.on, Rack) and contact.internal and contact.disc.radius > contact.on.radius
    reach: Expr = -radius if outer else radius
    place = Var(f"x_{{{k}}}"), Var(f"y_{{{k}}}")
    before = (
        Equation(nx, across[0]),
        Equation(ny, across[1]),
        Equation(place[0], cx - reach * nx),
        Equation(place[1], cy - reach * ny),
    )
    normal, rub = Var(f"N_{{{who}}}"), Var(f"F_{{f{who}}}")
    law = (_rubbed(rub, Const(f"f_{{{k}}}", tan(angle), ""), normal, Var(f"v_{{{back}}}")),) if angle else ()
    along: Expr = rub if angle else ZERO
    return Touch(
        a=on,
        b=disc,
        at=place,
        letter=k,
        force=(normal * nx - along * ny, normal * ny + along * nx),
        couple=ZERO,
        unknowns=(normal.symbol,),
        before=before,
        friction=law,
    )


def _normal(frame: Frame, contact: Contact) -> Pair:
    """The unit normal at the contact, towards the disc's centre."""
    on = contact.on
    if isinstance(on, Rack):
        line = frame.angle(on.link, on.direction)
        return (-sin(line), cos(line)) if contact.side is Side.LEFT else (sin(line), -cos(line))
    (ax, ay), (bx, by) = frame.xy(contact.disc.centre), frame.xy(on.centre)
    if contact.internal:
        length = Const(f"l_{{{contact.disc.centre}{on.centre}}}", abs(contact.disc.radius - on.radius))
        return (bx - ax) / length, (by - ay) / length
    length = Const(f"l_{{{contact.disc.centre}{on.centre}}}", contact.disc.radius + on.radius)
    return (ax - bx) / length, (ay - by) / length
