"""What a symbol must know of the figure in which it stands."""

from __future__ import annotations

from itertools import pairwise

from ...board.construction import View
from ...board.paper.marks import (
    AngleMark,
    Block,
    Disc,
    Dot,
    FrictionCircle,
    Ground,
    Mark,
    Point,
    Role,
    Segment,
    Slot,
    Vector,
)  # fmt: skip
from ...board.paper.walls import holds, leaves
from ...foundation.slotted import dataclass
from ...words import Lang
from ..hues import Tones
from ..scene import Layer
from ..style import JOINT_RADIUS, LINK, POLE_RADIUS
from .outlines import outlines
from .shapes import NEAR
from .shared import shared

CENTRED = 6.0  # mm: a circle with a larger radius has its centre marked
RING = "detail"  # whose the ring about a detail is: it shows a place, and has no centre to be marked
UNCENTRED = (RING, "mechanism centre polygon")  # nor has the circle on which links are points in order


@dataclass(frozen=True, slots=True, kw_only=True)
class Surroundings:
    """What a symbol must know of its figure:
    the view, the blocks, the tips of its vectors, its friction circles and discs, the language, by which tones vectors
    are told apart."""

    view: View
    blocks: tuple[Block, ...] = ()
    slots: tuple[Slot, ...] = ()
    tips: tuple[complex, ...] = ()
    circles: tuple[FrictionCircle, ...] = ()
    discs: tuple[Disc, ...] = ()
    lang: Lang = "zh"
    tones: Tones = None
    spots: frozenset[complex] = frozenset()  # where points and pivots stand
    links: tuple[tuple[complex, complex], ...] = ()  # the lines of links
    angles: tuple[AngleMark, ...] = ()
    common: frozenset[Segment] = frozenset()  # lines of action on which several forces lie

    @classmethod
    def of(cls, view: View, marks: tuple[Mark, ...], lang: Lang = "zh", tones: Tones = None) -> Surroundings:
        """Gathered from the figure's marks."""
        return cls(
            view=view,
            blocks=tuple(m for m in marks if isinstance(m, Block)),
            slots=tuple(m for m in marks if isinstance(m, Slot)),
            lang=lang,
            tones=tones,
            circles=tuple(m for m in marks if isinstance(m, FrictionCircle)),
            discs=tuple(m for m in marks if isinstance(m, Disc)),
            links=() if view.images else tuple(outlines(marks)),
            angles=tuple(m for m in marks if isinstance(m, AngleMark)),
            common=shared(view, marks),
            tips=tuple(m.b for m in marks if isinstance(m, Vector) and abs(m.b - m.a) > 0.5),
            spots=frozenset(
                m.at for m in marks if isinstance(m, Ground | Point) and getattr(m, "dot", "") is not Dot.NONE
            ),
        )

    def pin_radius(self, at: complex) -> float:
        """Of the joint drawn here: smaller within a friction circle, so that both are seen."""
        tight = any(abs(c.centre - at) < NEAR and c.radius < JOINT_RADIUS + 0.8 for c in self.circles)
        return POLE_RADIUS if tight else JOINT_RADIUS

    def link_layer(self, owner: str, *points: complex) -> Layer:
        """Where a link through these points lies: over a block of another link whose pin it carries, unless it runs
        along the block, and over a slot in which its own pin runs; a bar ends at the walls of a block that is one with
        it."""
        others = [block for block in self.blocks if not owner or block.owner != owner]
        slots = [slot for slot in self.slots if owner and slot.owner != owner]
        pairs = tuple(pairwise(points))
        over = any(_carries(a, b, block) for a, b in pairs for block in others)
        return Layer.OVER if over or any(_runs_in(z, slot) for z in points for slot in slots) else Layer.LINE

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

    def bare(self, centre: complex, radius: float) -> bool:
        """Whether the centre of a large circle is still to be marked."""
        return radius > CENTRED and all(abs(spot - centre) > NEAR for spot in self.spots)

    def on_link(self, at: complex) -> bool:
        """Whether a point lies on the line of a link, in which a small dot would be lost."""
        return any(abs(b - a) > NEAR and _between(at, a, b) for a, b in self.links)

    def tipped(self, at: complex) -> bool:
        """Whether an arrowhead already shows the place."""
        return any(abs(at - tip) < NEAR for tip in self.tips)


def _runs_in(pin: complex, slot: Slot) -> bool:
    """Whether a pin stands on the middle line of a slot."""
    if abs(slot.b - slot.a) < NEAR:
        return False
    return _between(pin, slot.a, slot.b)


def _between(at: complex, a: complex, b: complex) -> bool:
    """Whether a point lies on the line from a to b."""
    u = (b - a) / abs(b - a)
    off = (at - a) * u.conjugate()
    return abs(off.imag) < LINK / 2 and -LINK < off.real < abs(b - a) + LINK


def _carries(a: complex, b: complex, block: Block) -> bool:
    if abs(b - a) < NEAR:
        return False
    u = (b - a) / abs(b - a)
    off = (block.at - a) * u.conjugate()
    across = abs((u * block.along.conjugate()).imag) > 0.02
    ends_here = min(abs(block.at - a), abs(block.at - b)) < NEAR
    return (across or ends_here) and abs(off.imag) < NEAR and -NEAR < off.real < abs(b - a) + NEAR
