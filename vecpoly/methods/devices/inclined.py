"""What wedges and inclined planes share: friction angles, reactions that lean from the normal, bodies drawn apart."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...algebra.formula import Row, Txt, row, sym
from ...algebra.quantity import Of, Quantity, magnitude
from ...algebra.worked import worked
from ...board.construction import Place
from ...board.paper.marks import Dot, Role
from ...devices.base import Ratio
from ...diagram.single import number as number_of
from ...diagram.single import outline
from ...names import Named
from ...plane import Points, Reals, dot, nominal
from .bench import Bench

ARROW = 17.0  # mm: a force on a body drawn apart, to no scale
NORMAL = 21.0  # mm: how far its normal is drawn
ARC = 14.0  # mm: radius at which the friction angle is marked
INSIDE, CLEAR, SLIDE = 1.6, 3.0, 8.0  # mm: the arrow of the sliding, inside the body beside its face
FLAT = 1e-9  # rad: a friction angle that is none


@dataclass(frozen=True, slots=True, kw_only=True)
class Press:
    """A reaction on a body: who presses, where, the normal into the body,
    the direction of the reaction, the body's sliding (unit vectors)."""

    symbol: str
    at: Points
    normal: Points
    along: Points
    angle: str = "φ"
    slides: Points | None = None
    speed: str = ""  # symbol of the sliding: v_21


def friction_angle(bench: Bench, named: Named, f: Ratio, symbol: str = "f") -> Quantity:
    """φ = arctan f, in degrees."""
    phi = float(np.degrees(np.arctan(f.si)))
    return bench.stated(named, phi, worked(sym(named.symbol), Of("arctan", magnitude(symbol, f.si, "")), "deg"))


def row_of(first: object, text: str) -> Row:
    """A formula of a symbol and a text with symbols between dollar signs."""
    pieces = text.split("$")
    items = [node for i, piece in enumerate(pieces) if piece for node in (row(piece).items if i % 2 else (Txt(piece),))]
    return Row((first, *items))  # type: ignore[arg-type]


def leaned(normal: Points, motion: Points, phi: Reals) -> Points:
    """Direction of a reaction: the normal turned by φ (deg) against the sliding of the body that it acts on."""
    left = float(nominal(dot(motion, 1j * normal)))
    return normal * np.exp(1j * np.radians(phi) * (-1 if left > 0 else 1))


def facing(normal: Points, pushed: Points) -> Points:
    """Of the two faces of a guide the one that the force `pushed` presses the body against:
    its normal into the body."""
    return normal if float(nominal(dot(normal, pushed))) < 0 else -normal


# -- bodies ---------------------------------------------------------------------------------------------------------


def body(bench: Bench, place: Place, owner: str, *points: Points, fixed: bool = False) -> None:
    """Draw the outline of a body: of ``link 2``."""
    bench.board.depict(place, outline(owner, *points, fixed=fixed))


def numbered(bench: Bench, place: Place, *numbers: tuple[Points, str]) -> None:
    """Write the numbers of the bodies where they stand."""
    bench.board.depict(place, *(number_of(name, at) for at, name in numbers))


def press(bench: Bench, place: Place, reaction: Press) -> None:
    """Draw a reaction that presses on a face: the arrow ends on it, and leans by φ from the normal."""
    board, at, normal = bench.board, reaction.at, reaction.normal
    board.arrow(place, at - reaction.along * ARROW, at, Role.RESULT, label=reaction.symbol)
    if reaction.slides is not None:
        start = at + normal * INSIDE + reaction.slides * CLEAR
        board.arrow(place, start, start + reaction.slides * SLIDE, Role.GIVEN, label=reaction.speed)
    lean = np.angle(reaction.along / normal)
    if abs(float(nominal(lean))) < FLAT:
        return
    board.join(place, at, at - normal * NORMAL, Role.CENTRE)
    board.plot(place, at - normal * NORMAL, "n", Dot.NONE)
    board.angle(place, at, -normal, lean, ARC, reaction.angle)


def pull(bench: Bench, place: Place, at: Points, along: Points, symbol: str) -> None:
    """Draw a given force whose arrow ends at a point."""
    bench.board.arrow(place, at - along * ARROW, at, Role.GIVEN, label=symbol)


def haul(bench: Bench, place: Place, at: Points, along: Points, symbol: str, length: float = ARROW) -> None:
    """Draw a given force whose arrow starts at a point: a pull, a weight."""
    bench.board.arrow(place, at, at + along * length, Role.GIVEN, label=symbol)


def ray(bench: Bench, place: Place, at: Points, along: Points, length: float, label: str = "") -> None:
    """Draw a thin line from a point, with a symbol at its end."""
    bench.board.join(place, at, at + along * length, Role.CENTRE)
    if label:
        bench.board.plot(place, at + along * length, label, Dot.NONE)


def between(bench: Bench, place: Place, at: Points, one: Points, other: Points, radius: float, label: str) -> None:
    """Mark the angle from one direction to another, the shorter way."""
    sweep = np.angle(other / one)
    if abs(float(nominal(sweep))) > FLAT:
        bench.board.angle(place, at, one, sweep, radius, label)


def gauged(bench: Bench, one: Points, other: Points) -> Reals:
    """The angle from one direction to another read with the protractor, in degrees."""
    return np.degrees(bench.board.gauge(0j, other / one))


def cone(
    bench: Bench, place: Place, at: Points, axis: Points, phi: Reals, length: float, label: str, angle: str = "φ"
) -> None:
    """The friction cone: the normal with its symbol, and a line at φ (deg) on either side of it."""
    turn = np.exp(1j * np.radians(phi))
    ray(bench, place, at, axis, length, label)
    for side in (turn, 1 / turn):
        bench.board.join(place, at, at + axis * side * (length - 6), Role.CONSTRUCTION)
        between(bench, place, at, axis, axis * side, length - 12, angle)


def concur(bench: Bench, place: Place, at: Points, *ends: Points) -> None:
    """Carry the lines of action on to the point where they meet."""
    for end in ends:
        bench.board.join(place, end, at, Role.HIDDEN)
    bench.board.plot(place, at, "")


def angle(symbol: str, radians: float) -> Quantity:
    """A given angle as a factor of formulas, in degrees."""
    return magnitude(symbol, float(np.degrees(radians)), "deg")
