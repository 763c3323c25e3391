"""The known forces of a link joined into one:
meeting point of two lines of action, a couple displacing a force by h = M / F."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ....board.board import NO_LENGTH
from ....plane import Line, Points, Reals, cross, lines_meet, nominal, unit
from ....words import Words
from ..acting import Acting, summed
from ..couples import every_couple
from ..state import Statics

NEARLY = 1e-2  # sine below which the meeting point of two lines of action is of no use
# sine below which two forces are parallel, not only nearly so: the interchanged ones give the line of no others
PARALLEL = 1e-12
LONG = 25.0  # mm: longest force laid off on the diagram
Side = tuple[Points, Points]  # from, to


@dataclass(frozen=True, slots=True, kw_only=True)
class Resultant:
    """What the known forces of a link amount to: a force on a line, or (vector 0) a couple (N·m)."""

    forces: tuple[Acting, ...]
    vector: Points  # mm on the polygon
    at: Points  # mm on the diagram
    couple: Reals = 0.0
    interchanged: tuple[Side, Side] | None = (
        None  # two parallel forces, each laid off at the other's point, one of them reversed
    )
    couples: tuple[str, ...] = ()  # those joined with the forces, by their symbols

    @property
    def is_single(self) -> bool:
        """Whether it is one of the known forces, on its own line."""
        return len(self.forces) == 1 and not self.couples

    @property
    def is_couple(self) -> bool:
        """Whether no force is left."""
        return bool(abs(nominal(self.vector)) < 1e-9)

    @property
    def line(self) -> Line:
        """Line of action, along the force."""
        return Line(self.at, self.vector / np.abs(self.vector))

    @property
    def found(self) -> tuple[str, str]:
        """How its line was found, in both languages: by the meeting point of two lines, or by moments."""
        if _concurrent(self.forces) and _on(self.line, self.forces[0].at):
            return "过各力的公共作用点", "through their common point"
        if self.interchanged is not None:
            return (
                "两力平行：在每一力的作用点截取另一力，并将其中之一反向，两端点的连线与两作用点的连线的交点在合力作用线上",
                "they are parallel: at the point of application of each force lay off the other force, one of the two "
                "reversed; where the line through their ends crosses the line through the two points of application "
                "is a point of the resultant's line",
            )
        if len(self.forces) == 2 and all(_on(f.line, self.at) for f in self.forces):
            return "过两力作用线的交点", "through the crossing of their lines"
        if len(self.forces) == 1:
            own = self.symbols.zh
            return (
                f"将 {own} 平移，使其对原作用线上一点之矩等于力偶矩",
                f"{own} shifted aside until its moment equals that of the couple",
            )
        couple = ("（连同力偶）", " (couples included)") if self.couples else ("", "")
        return (
            f"其作用线由各力{couple[0]}对一点之矩的代数和定出",
            f"on the line that the sum of their moments{couple[1]} gives",
        )

    @property
    def symbols(self) -> Words:
        """The forces in symbols: $F$, $R_{21}$."""
        names = [f"${force.named.symbol}$" for force in self.forces]
        return Words("、".join(names), ", ".join(names))

    @property
    def told(self) -> Words:
        """The forces and the couples that are joined with them."""
        if not self.couples:
            return self.symbols
        names = [f"${symbol}$" for symbol in self.couples]
        couples = "couple" if len(names) == 1 else "couples"
        return self.symbols + Words(f" 与力偶 {'、'.join(names)}", f" and the {couples} {', '.join(names)}")


def resultant(st: Statics, link: str) -> Resultant:
    """Join all known forces and couples of a link.

    Two forces meet in a point of the resultant's line; two parallel ones
    are laid off interchanged; more than two, and couples, are joined by moments: M = Σ r × F.
    """
    forces = tuple(f for f in st.known(link) if abs(nominal(f.vector)) > 1e-9)
    moment = st.moment(link)
    total: Points = sum((f.vector for f in forces), 0j)
    sides = _interchanged(forces) if not np.any(moment) else None
    if not forces or abs(nominal(total)) < 1e-9:
        return Resultant(
            forces=forces,
            vector=0j,
            at=0j,
            couple=summed([moment, *(st.newton_metres(cross(f.at, f.vector)) for f in forces)]),
        )
    if sides is not None:
        (one, one_end), (two, two_end) = sides
        return Resultant(
            forces=forces,
            vector=total,
            at=lines_meet(Line(one, unit(two - one)), Line(one_end, unit(two_end - one_end))),
            interchanged=sides,
        )
    couples = tuple(symbol for symbol, size in every_couple(st, link) if np.any(size)) if np.any(moment) else ()
    return Resultant(forces=forces, vector=total, at=_place(st, forces, total, moment), couples=couples)


def _interchanged(forces: tuple[Acting, ...]) -> tuple[Side, Side] | None:
    """Two parallel forces on different lines, each laid off from the other's point, the second one reversed: both
    shortened alike if they are long."""
    if len(forces) != 2 or _sine(*forces) > PARALLEL or _on(forces[0].line, forces[1].at):
        return None
    one, two = forces
    shorter = min(1.0, LONG / max(abs(float(nominal(np.abs(force.vector)))) for force in forces))
    return (one.at, one.at + two.vector * shorter), (two.at, two.at - one.vector * shorter)


def _place(st: Statics, forces: tuple[Acting, ...], total: Points, moment: Reals) -> Points:
    """A point of the resultant's line."""
    if not np.any(moment) and _concurrent(forces):
        return forces[0].at
    if len(forces) == 2 and not np.any(moment) and _cross(forces[0], forces[1]):
        return lines_meet(forces[0].line, forces[1].line)
    about = sum((cross(f.at, f.vector) for f in forces), 0.0) + st.paper_moment(moment)
    return -1j * total * about / np.square(np.abs(total))


def _concurrent(forces: tuple[Acting, ...]) -> bool:
    """Whether all forces act at one point."""
    return all(abs(complex(nominal(f.at - forces[0].at))) < NO_LENGTH for f in forces)


def _on(line: Line, at: Points) -> bool:
    return abs(float(nominal(cross(at - line.at, line.along)))) < 1e-6


def _cross(one: Acting, two: Acting) -> bool:
    return _sine(one, two) > NEARLY


def _sine(one: Acting, two: Acting) -> float:
    return abs(float(nominal(cross(one.line.along, two.line.along))))
