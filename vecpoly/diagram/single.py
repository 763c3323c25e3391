"""Symbols that stand for themselves, wherever they are: a body, a disc, a pivot, a guide, a number, a friction circle,
a machine of a train. Places in mm on the figure.
"""

from __future__ import annotations

from ..board.paper.marks import (
    Arc,
    Block,
    Cell,
    Disc,
    Dot,
    FixedGuide,
    FrictionCircle,
    GearMark,
    Ground,
    LinkNumber,
    Lump,
    Outline,
    Plate,
    Point,
    Role,
    Segment,
)
from ..board.paper.symbols import Symbol
from ..board.strokes import amount, spot
from ..names import subscripted
from ..plane import Points, Reals
from ..words import Words
from .owners import FIXED, joint, link
from .pins import passing


def outline(owner: str, *points: Points, fixed: bool = False) -> Symbol:
    """A solid body with corners; a fixed one is hatched."""
    return Symbol.of(owner, (Outline(points=tuple(spot(p) for p in points), fixed=fixed),))


def plate(owner: str, *points: Points) -> Symbol:
    """A link with three pins or more, not in line."""
    return Symbol.of(owner, (Plate(points=tuple(spot(p) for p in points)),))


def disc(owner: str, centre: Points, radius: Reals, lump: Lump = Lump.NONE) -> Symbol:
    """A round body; a mass that is thought at one place."""
    return Symbol.of(owner, (Disc(centre=spot(centre), radius=amount(radius), lump=lump),))


def gear(owner: str, centre: Points, radius: Reals) -> Symbol:
    """A gear: its pitch circle."""
    return Symbol.of(owner, (GearMark(centre=spot(centre), radius=amount(radius)),))


def rod(owner: str, a: Points, b: Points) -> Symbol:
    """A straight link, or a part of one."""
    return Symbol.of(owner, (Segment(a=spot(a), b=spot(b), role=Role.LINK),))


def run_on(owner: str, pin: Points, other: Points, end: Points, tip: Points) -> Symbol:
    """The joining half about a pin past which the bar from `end` to `tip` runs on, if it does; other: the far end of
    the link that ends there."""
    return Symbol.of(owner, passing(spot(pin), [(spot(end), spot(tip))], [spot(other) - spot(pin)]))


def rim(owner: str, centre: Points, radius: Reals, middle: float, half: float) -> Symbol:
    """A piece of a round profile: about the direction `middle`, `half` to either side (rad)."""
    arc = Arc(centre=spot(centre), radius=amount(radius), start=middle - half, sweep=2 * half, role=Role.LINK)
    return Symbol.of(owner, (arc,))


def pivot(at: Points, letter: str = "", down: complex = -1j) -> Symbol:
    """A pin on the frame: on its ground, with its letter where it is given here; down: the side of the ground."""
    pin = (Point(at=spot(at), label=subscripted(letter), dot=Dot.JOINT),) if letter else ()
    return Symbol.of(FIXED, (Ground(at=spot(at), down=down), *pin))


def rail(a: Points, b: Points, about: complex | None = None) -> Symbol:
    """A fixed guide; its hatching lies to the right of a → b. about: the pin of the block that runs along it."""
    return Symbol.of(FIXED, (FixedGuide(a=spot(a), b=spot(b), about=about),))


def block(owner: str, at: Points, along: complex) -> Symbol:
    """A block on its guide."""
    return Symbol.of(owner, (Block(at=spot(at), along=along),))


def number(name: str, at: Points, to: Points | None = None, *, owner: str = "") -> Symbol:
    """The number of a link beside a place, or beside the line from it to another."""
    start = spot(at)
    written = LinkNumber(a=start, b=start if to is None else spot(to), number=name)
    return Symbol.of(owner or link(name), (written,))


def friction_circle(pin: str, centre: Points, radius: Reals, times: float = 1.0) -> Symbol:
    """The friction circle of a pin, so many times larger than true."""
    drawn = FrictionCircle(centre=spot(centre), radius=amount(radius) * times, enlarged=times)
    return Symbol.of(joint(pin), (drawn,), key=f"rho_{pin}")


def machine(owner: str, at: complex, width: float, height: float, words: Words) -> Symbol:
    """A machine of a train: its box in the block diagram."""
    return Symbol.of(owner, (Cell(at=at, width=width, height=height, words=words),))
