"""Moments about a lettered point:
arms measured from the point square to the lines of action, F × μ_l h, and couples as they are."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from ....algebra.quantity import Expr, Quantity, Sum, magnitude
from ....board.board import NO_LENGTH
from ....board.construction import Pane, Place, View
from ....errors import EquilibriumError
from ....plane import Line, Points, Reals, cross, foot, nominal
from ....words import Words
from ..acting import Acting, summed
from ..couples import every_couple
from ..groups.body import draw_arm
from ..readings import measured
from ..state import Statics
from .letters import arm_about_point


@dataclass(frozen=True, slots=True, kw_only=True)
class Turning:
    """The sum of moments about a point: its terms with their senses,
    and its value (N·m, counter-clockwise positive)."""

    terms: tuple[Expr, ...]
    signs: tuple[int, ...]
    value: Reals

    @property
    def way(self) -> int:
        """Sense by the nominal hand; 0 where nothing turns."""
        return int(np.sign(nominal(self.value))) if self.terms else 0

    @property
    def size(self) -> Sum:
        """The sum as it is written, positive."""
        return Sum(self.terms, tuple(self.way * sign for sign in self.signs))


def moments_about(st: Statics, pane: Pane, links: Iterable[str], point: str) -> Turning:
    """Moments of all known forces and couples on these links about a lettered point; the arms are drawn on the pane."""
    return moments_at(st, pane, links, st.desk.at[point])


def moments_at(st: Statics, pane: Place | None, links: Iterable[str], about: Points, letter: str = "") -> Turning:
    """The same about any point; without a figure no arms are drawn. letter: of the point, where the arms carry it."""
    return _sum(
        part
        for link in links
        for part in (*_of_forces(st, pane, acting_on(st, link), about, letter), *_of_couples(st, link))
    )


def moments_of(st: Statics, pane: Place | None, forces: Iterable[Acting], about: Points, letter: str = "") -> Turning:
    """Moments of these forces alone."""
    return _sum(_of_forces(st, pane, forces, about, letter))


def joined(*turnings: Turning) -> Turning:
    """Several sums of moments as one."""
    return Turning(
        terms=tuple(term for one in turnings for term in one.terms),
        signs=tuple(sign for one in turnings for sign in one.signs),
        value=summed(one.value for one in turnings),
    )


def _sum(parts: Iterable[tuple[Expr, Reals]]) -> Turning:
    found = list(parts)
    return Turning(
        terms=tuple(expr for expr, _ in found),
        signs=tuple(int(nominal(sign)) for _, sign in found),
        value=summed(sign * expr.value for expr, sign in found),
    )


def acting_on(st: Statics, link: str) -> list[Acting]:
    """The known forces on a link that are not zero."""
    return [force for force in st.known(link) if abs(nominal(force.vector)) > NO_LENGTH]


def all_pass(st: Statics, link: str, point: str) -> bool:
    """Whether all known forces on a link pass through its pin, which has no friction, and no couple turns it."""
    if st.rho(point) or any(nominal(value) for _, value in every_couple(st, link)):
        return False
    at = st.desk.at[point]
    return all(abs(nominal(foot(force.line, at) - at)) < NO_LENGTH for force in acting_on(st, link))


def size_of(st: Statics, force: Acting) -> Quantity:
    """A force in N: given or computed, or read off the polygon on which it was found."""
    size = newtons(st, force) if force.drawn is None else measured(st, force.drawn).value
    return magnitude(force.named.symbol, size, "N")


def newtons(st: Statics, force: Acting) -> Reals:
    """The size (N) of a force that stands on no polygon: as it was computed, or else given."""
    return np.abs(force.vector) * st.scale.value if force.computed is None else force.computed


def _of_forces(
    st: Statics, pane: Place | None, forces: Iterable[Acting], about: Points, letter: str = ""
) -> Iterator[tuple[Expr, Reals]]:
    """F μ_l h of every force that does not pass through the point."""
    for force in forces:
        named = arm_about_point(force.named.symbol, letter)
        end = foot(Line(force.at, force.line.along), about)
        arm = st.board.measure(about, end, named)
        if abs(nominal(end - about)) < NO_LENGTH:
            continue
        if pane is not None:
            draw_arm(st, pane, about, end, force.line, named)
        sense = np.sign(cross(end - about, force.vector))
        if np.isnan(nominal(sense)):
            raise EquilibriumError(
                Words(
                    f"{force.named.key} 在图上没有确定的作用线：最大尺寸远大于其余构件，机构在图上过小；请检查各长度",
                    f"{force.named.key} has no definite line on paper: one dimension dwarfs all others, and the rest "
                    "of the mechanism is too small to be drawn; check the lengths",
                )
            )
        yield size_of(st, force) * st.board.mu(View.MECHANISM) * arm, sense


def _of_couples(st: Statics, link: str) -> Iterator[tuple[Expr, Reals]]:
    """Given couples, inertia couples, friction couples of pins."""
    for symbol, value in every_couple(st, link):
        if nominal(value):
            yield magnitude(symbol, np.abs(value), "N·m"), np.sign(value)


def without_moment(symbol: str, turning: Turning) -> Words:
    """After a colon: why the moments about the point come to nothing, so that this force is nothing: the other forces
    pass through the point, so nearly that no arm can be read, or turn against each other."""
    if any(nominal(term.value) for term in turning.terms):
        return Words(
            f"其余各力对该点之矩互相抵消，故 {symbol} = 0。",
            f" the moments of the other forces about it cancel, so {symbol} = 0.",
        )
    if turning.terms:
        return Words(
            f"其余各力的作用线在图上过该点，量不出力臂，故取 {symbol} = 0。",
            f" on paper the other forces pass through it, too near for an arm to be read, so {symbol} = 0 is taken.",
        )
    return Words(
        f"其余各力对该点之矩为零，故 {symbol} = 0。", f" the other forces have no moment about it, so {symbol} = 0."
    )
