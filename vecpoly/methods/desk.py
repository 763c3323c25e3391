"""What lies on the desk while a mechanism is solved: the board, the links as drawn, the velocities found so far.

Every number here was laid off, met, measured or computed on the board. Lengths on paper are in mm.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import count

from ..algebra.quantity import Quantity, magnitude
from ..board.construction import View
from ..board.ledger import Stood
from ..board.otherwise.amended import plain_letters
from ..mechanism.model import FRAME, Link, Mechanism, Prismatic
from ..mechanism.rams import stretched
from ..names import At, Kind, Rel, ascii_key, subscripted
from ..plane import Points, Reals
from ..words import Words
from .diagram import Diagram
from .forces.laws.pull import Acted
from .positions.sides import Sides

FEET = "nmquwxyz"  # letters at tips of normal accelerations, in the order in which they are taken
POLE = {View.VELOCITY: "p", View.ACCELERATION: "p′"}
VECTOR = {View.VELOCITY: Kind.V, View.ACCELERATION: Kind.A}  # what a polygon is made of
QUANTITY = {View.VELOCITY: Words("速度", "velocity"), View.ACCELERATION: Words("加速度", "acceleration")}


def polygon_of(rel: Rel) -> View:
    """The polygon on which a vector stands."""
    return View.VELOCITY if rel.kind is Kind.V else View.ACCELERATION


@dataclass(frozen=True, slots=True)
class Turn:
    """ω or α of a link, signed; `never` where the link cannot turn at all (it only translates); `same`: the ω or α that
    it is."""

    value: Reals
    never: bool = False
    same: Rel | None = None


@dataclass(slots=True)
class Desk(Diagram):
    """The state of one solution."""

    # letter under which links slide over each other → the block
    coincident: Mapping[str, str] = field(default_factory=dict)
    turns: dict[Rel, Turn] = field(default_factory=dict)
    turning: int = 0  # number of the step in which an ω or α was read last
    lengths: dict[frozenset[str], Quantity] = field(default_factory=dict)
    known_as: dict[tuple[View, At], tuple[Words, str]] = field(default_factory=dict)  # direction and magnitude in words
    forces: tuple[str, ...] = ()  # keys of what a force analysis found
    acting: dict[str, Acted] = field(default_factory=dict)  # loads that depend on the motion, as they were found here
    # whether the driving link is only thought to drive, the input acting between two moving links
    thought: bool = False
    # links of a sliding pair → the vector along the guide that was drawn, of the first against the second
    slides: dict[tuple[str, str], Rel] = field(default_factory=dict)
    sides: Sides = field(default_factory=Sides)
    told: Mechanism | None = None  # in the position in which it is told, where another is drawn
    centres: set[str] = field(default_factory=set)  # contacts with a fixed rack: no velocity, but an acceleration

    # -- names ------------------------------------------------------------------------------------------------

    def canonical(self, at: At) -> At:
        """B2 is plain B where link 2 itself carries B, S2 the letter S2 where it does;
        B3 stays B3 where link 3 is only passed over."""
        if at.link and str(at) in self.mech.link(at.link).points:
            return At(str(at))
        carried = at.link and at.point in self.mech.link(at.link).points
        return At(at.point) if carried else at

    def show(self, at: At) -> str:
        """The letter as printed: with a link's number where several links' points coincide here."""
        if at.link and at == self.canonical(at):
            return at.point + at.link
        return at.point + self.coincident.get(at.point, "")

    def name(self, at: At) -> str:
        """The letter in a sentence: C_2."""
        return subscripted(self.show(at))

    def tip_label(self, view: View, at: At) -> str:
        """The letter of a tip on a polygon: b, b_3, b′_3."""
        letter, _, digits = self.name(at).lower().partition("_")
        prime = "′" if view is View.ACCELERATION else ""
        return letter + (f"_{digits}" if digits else "") + (f"^{prime}" if prime else "")

    def start_label(self, view: View, at: At | None) -> str:
        """The letter at which a vector starts on a polygon: the pole for absolute ones and for points at rest."""
        return POLE[view] if at is None or self.at_rest(view, at) else self.tip_label(view, at)

    def k_tip(self, rel: Rel) -> str:
        """The letter at the tip of a Coriolis acceleration: k′; where several sliding pairs turn with the number of the
        point's link, or both numbers, and so where a point K has the letter k′."""
        turning = [joint for joint in self.mech.joints if isinstance(joint, Prismatic) and joint.guide != FRAME]
        taken = "K" not in self.mech.frame and any("K" in link.points for link in self.mech.links)
        if len(turning) < 2 and not (taken and self.tip_label(View.ACCELERATION, At("K")) == "k^′"):
            return "k′"
        number = rel.to.link or self.coincident.get(rel.to.point, "")
        other = self.show(rel.ref).removeprefix(rel.ref.point) if rel.ref is not None else ""
        if not number:  # a block's pin, that has none beside the numbers of its guides
            return f"k_{other}^′" if other else "k′"
        pairs = ((joint.guide, joint.block, self.coincident.get(joint.pin)) for joint in turning)
        alike = taken or sum(number in pair for pair in pairs) > 1
        return f"k_{number}{other if alike else ''}^′"

    def n_tip(self, link: str, primes: int = 1) -> str:
        """The letter at the tip of a normal acceleration: n_2′; another where a point has the letter N, whose tip is
        n_2′."""
        taken = {name[0].lower() for name in self.at}
        letter = next((one for one in FEET if one not in taken), FEET[0])
        return f"{letter}_{link}^" + ("′" if primes == 1 else f"{{{'′' * primes}}}")

    def further_n_tip(self, link: str) -> str:
        """The letter of another normal acceleration of a link, of one that may have one already: n_2″."""
        spots = self.board.ledger.spots
        letters = (self.n_tip(link, primes) for primes in count(1))
        return next(one for one in letters if (View.ACCELERATION, plain_letters(one)) not in spots)

    def symbol(self, rel: Rel) -> str:
        """The printed symbol of a vector: v_{C2B}, a^n_{CB}."""
        ref = self.show(rel.ref) if rel.ref else ""
        return f"{rel.kind.stem}_{{{self.show(rel.to)}{ref}}}"

    def key(self, rel: Rel) -> str:
        """The key of its acts: the ASCII form of the printed symbol."""
        return ascii_key(self.symbol(rel))

    # -- what is known of the motion ------------------------------------------------------------------------------

    def put_tip(self, view: View, at: At, tip: Points) -> Points:
        """A point's vector ends here on its polygon, at the point's letter."""
        own = self.canonical(at)
        return self.board.locate(view, self.tip_label(view, own), tip, own)

    def reach_tip(self, view: View, at: At, tip: Points) -> Points:
        """The same of a polygon that was closed there, where the point was not located by closing it."""
        known = self.board.ledger.points.get((view, self.canonical(at)))
        return tip if known is tip else self.put_tip(view, at, tip)

    def tip(self, view: View, at: At) -> Points:
        """End of a point's vector on a polygon; points of the frame are at the pole."""
        at = self.canonical(at)
        if self.at_rest(view, at):
            return 0j
        return self.board.ledger.points[view, at]

    def tips(self, view: View) -> tuple[At, ...]:
        """The points whose vectors are drawn on a polygon, in order."""
        return tuple(at for place, at in self.board.ledger.points if place is view)

    def stands(self, rel: Rel) -> Stood | None:
        """Where a vector stands on its polygon, if it was drawn: the last time, where it was drawn again."""
        return self.board.ledger.vector(polygon_of(rel), self.key(rel))

    def size(self, rel: Rel) -> Quantity | None:
        """A vector's size, where that was computed and then laid off: it is not read again."""
        return self.board.ledger.laid_off(polygon_of(rel), self.key(rel))

    def at_rest(self, view: View, at: At) -> bool:
        """Whether the point's vector is zero for good:
        a point of the frame, or a contact with a fixed rack (velocity only)."""
        at = self.canonical(at)
        return not at.link and (at.point in self.mech.frame or (view is View.VELOCITY and at.point in self.centres))

    def where(self, at: At) -> Points:
        """Place of a point on the diagram; M2, found as a point of link 2, has a place of its own."""
        return self.at[str(at)] if str(at) in self.at else self.at[at.point]

    def has_tip(self, view: View, at: At) -> bool:
        """Whether the point's vector is already drawn."""
        at = self.canonical(at)
        return self.is_tip(view, at) or self.at_rest(view, at)

    def is_tip(self, view: View, at: At) -> bool:
        """Whether the point itself has a tip on the polygon."""
        return (view, at) in self.board.ledger.points

    def length(self, p: str, q: str) -> Quantity:
        """l_PQ: given by the problem where one link carries both points, or a cylinder joins them; else measured once
        on the diagram, × μ_l."""
        pair = frozenset((p, q))
        for ram in (drive for drive in (*self.mech.drives, self.mech.instead_of) if drive is not None):
            if ram.slide and ram.between and pair == set(ends := stretched(self.mech, ram)):
                return magnitude(f"l_{''.join(ends)}", ram.position, "m")
        for link in (*self.mech.links, Link(name=FRAME, points=self.mech.frame)):
            if pair <= set(link.points):
                return magnitude(f"l_{self.bar(link.name, p, q)}", abs(link.points[p] - link.points[q]), "m")
        if pair not in self.lengths:
            on_paper = self.board.measure(self.at[p], self.at[q], f"{p} {q}")
            mu = self.board.mu(View.MECHANISM)
            self.lengths[pair] = self.board.compute(f"l_{p}{q}", mu * on_paper, "m")
        return self.lengths[pair]
