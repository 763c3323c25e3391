"""The force polygon of a class III group: every reaction is a side, or a diagonal, of one chain.

From the origin run R^t and the forces of the first leg, the forces of the central link, the forces and the whole
reaction of the third leg, the forces and R^t of the second; the two parts still sought close it in the corner X.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from ....algebra.quantity import Quantity
from ....board.construction import Pane
from ....board.paper.marks import Dot
from ....foundation.slotted import replace
from ....plane import Points
from ....vector.equation import Equation, Term
from ....words import Words
from ..acting import Acting, Drawn
from ..bodies.link_polygon import corner_letters
from ..groups.body import polygon_title
from ..groups.corners import part_named
from ..groups.polygon import closed, term_of
from ..lines.arms import acting_on
from ..state import Statics
from .legs import Pressed, forces_in_chain

Corner = tuple[str, Points]


@dataclass(frozen=True, slots=True, kw_only=True)
class Sides:
    """Of one leg: the reaction at its outer joint, and that on the central link."""

    outer: Drawn
    inner: Drawn


def draw_chain(
    st: Statics,
    links: tuple[str, ...],
    plate: str,
    legs: tuple[Pressed, Pressed, Pressed],
    third: tuple[Points, Quantity | None],
) -> tuple[Sides, Sides, Sides]:
    """ΣF = 0 of the whole group. legs: the two whose parts are sought, and the third, of which that part is known:
    third, and its size as it was computed."""
    (one, two, last), (pushes, size) = legs, third
    chain = _Chain(st=st, letters=corner_letters(st), terms=[])
    chain.add_first(one, plate)
    third_in = chain.reached()
    chain.add(forces_in_chain(st, last))
    third_out = chain.reached()
    chain.add_part(last, "t")
    chain.add_part(last, "n", pushes)
    ended = chain.reached()
    first, second, side = chain.closed(links, one, two)
    outer, inner = side(third_out, ended), side(third_in, ended)
    if not last.reaction.found(st, ""):  # it has no other part: what was laid off is all of it
        outer = replace(outer, laid=size)
        inner = outer if third_in == third_out else inner
    return first, second, Sides(outer=outer, inner=inner)


def draw_chain_of_two(
    st: Statics, links: tuple[str, ...], plate: str, legs: tuple[Pressed, Pressed], pushed: list[Acting]
) -> tuple[Sides, Sides]:
    """ΣF = 0 of the central link with two legs. pushed: what the third leg, known already, presses on it with."""
    chain = _Chain(st=st, letters=corner_letters(st), terms=[])
    chain.add_first(legs[0], plate)
    chain.add(pushed)
    first, second, _ = chain.closed(links, *legs)
    return first, second


@dataclass(slots=True, kw_only=True)
class _Chain:
    """The known terms, head to tail; where R^t of the first leg ends, and where its forces do; letters: of corners."""

    st: Statics
    letters: tuple[str, ...]
    terms: list[Term]
    after_t: int = 0
    start: int = 0

    def add_first(self, one: Pressed, plate: str) -> None:
        """R^t and the forces of the first leg, the forces of the central link."""
        self.add_part(one, "t")
        self.after_t = self.reached()
        self.add(forces_in_chain(self.st, one))
        self.start = self.reached()
        self.add(acting_on(self.st, plate))

    def reached(self) -> int:
        """The corner that the chain has reached."""
        return len(self.terms)

    def add(self, forces: list[Acting]) -> None:
        """Known forces."""
        for force in forces:
            self.terms.append(term_of(force, self.letters[self.reached() + 1]))

    def add_part(self, leg: Pressed, part: str, vector: Points | None = None) -> None:
        """R^t of a leg where it has one; or its part along the axis, once that is known."""
        reaction = leg.reaction
        if part == "t":
            self.terms += reaction.found(self.st, self.letters[self.reached() + 1])
            return
        assert vector is not None
        named = part_named(self.st.named(reaction.by, reaction.on), reaction.part)
        tip = self.letters[self.reached() + 1]
        self.terms.append(
            Term(rel=named, symbol=named.symbol, direction=reaction.direction, magnitude="✓", vector=vector, tip=tip)
        )

    def closed(
        self, links: tuple[str, ...], one: Pressed, two: Pressed
    ) -> tuple[Sides, Sides, Callable[[int, int], Drawn]]:
        """The forces and R^t of the second leg; the two parts still sought close the polygon. Gives the reactions of
        both, and what is a side from corner to corner."""
        second_in = self.reached()
        self.add(forces_in_chain(self.st, two))
        second_out = self.reached()
        self.add_part(two, "t")
        pane = _begin(self.st, links, self.letters[0])
        eq = Equation(left=(*self.terms, two.reaction.sought(self.st), one.reaction.sought(self.st)))
        vertices, x = closed(self.st, pane, self.letters, eq, self.terms)
        corner = (self.letters[len(self.terms) + 1], x)
        at = [(self.letters[i], vertex) for i, vertex in enumerate(vertices)]
        first = Sides(outer=_side(pane, corner, at[self.after_t]), inner=_side(pane, corner, at[self.start]))
        second = Sides(outer=_side(pane, at[second_out], corner), inner=_side(pane, at[second_in], corner))
        return first, second, lambda start, end: _side(pane, at[start], at[end])


def _begin(st: Statics, links: tuple[str, ...], letter: str) -> Pane:
    pane = st.polygon("-".join(map(st.mech.number, links)), polygon_title(st, *links))
    numbers = list(map(st.mech.number, links))
    whole = Words("整个杆组", "the whole group") if len(links) > 3 else Words("其余构件", "the rest of the group")
    st.board.step(
        Words(
            f"列{whole.zh}（构件 {'、'.join(numbers)}）的力平衡方程，按 $μ_F$ 作力多边形，各力首尾相接。",
            f"Write the equilibrium of {whole.en}, links {', '.join(numbers)}, and draw the polygon to $μ_F$, the "
            "forces head to tail.",
        ),
        pane,
    )
    st.board.plot(pane, 0j, letter, Dot.POINT)
    return pane


def _side(pane: Pane, start: Corner, end: Corner) -> Drawn:
    return Drawn(place=pane, start=start[1], end=end[1], letters=f"{start[0]} {end[0]}")
