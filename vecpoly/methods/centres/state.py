"""The two figures of the centres while they are drawn, and the centres found so far (mm on their figure)."""

from __future__ import annotations

from cmath import phase
from dataclasses import dataclass
from math import degrees

import numpy as np

from ...board.board import Board
from ...board.construction import Pane
from ...board.paper.marks import Dot, Role, Segment
from ...board.place import Place
from ...mechanism.asked.centres import Pair, centre, pair_of, real_links
from ...mechanism.model import Mechanism
from ...plane import Line, Points, nominal
from ...plane.traced import Acts, acts_of, traced
from ..desk import Desk
from .geometry import Centre
from .places import place_read
from .size import Paper
from .theorem.search import Known

BEYOND = 5.0  # mm a line runs on beyond the outermost of its centres
MANY = 7  # links: with as many, lines are drawn only where they cut
ON_BAR, ASIDE = 1.0, 3.5  # mm beside an arrow that a bar covers it; by which it moves then
GAP, ARROW = 5.0, 13.0  # mm from a slide to the arrow that shows the way to its centre at infinity; its length
LEVEL = 1e-7  # deg: within which a direction is level, and told as 0°
TO_LETTER = 1.5  # mm from an arrow's tip to its letter


@dataclass(slots=True)
class CentreFigure:
    """The figure of the centres (`pane`), the polygon, the centres, and how large the figure is."""

    desk: Desk
    pane: Place
    polygon: Pane
    paper: Paper
    known: Known
    reasoned: bool = False  # whether it was said once why a centre is where two lines meet

    @property
    def board(self) -> Board:
        """The sheet."""
        return self.desk.board

    @property
    def mech(self) -> Mechanism:
        """The mechanism."""
        return self.desk.mech

    def symbol(self, a: str, b: str) -> str:
        """P_{13}, for sentences and labels."""
        return centre(self.mech, a, b).symbol

    def letters(self, a: str, b: str) -> str:
        """The same with its sign at infinity: P_{34}^{∞}."""
        return self.symbol(a, b) + ("^{∞}" if self.known.of(a, b).endless else "")

    def numbers(self, *links: str) -> str:
        """Links by their printed numbers: 123."""
        return "".join(self.mech.number(name) for name in links)

    def far(self, a: str, b: str) -> bool:
        """Whether a centre lies off the paper."""
        return pair_of(self.mech, a, b) in self.paper.far

    @property
    def crowded(self) -> bool:
        """Whether there are so many links that whole lines would cover each other."""
        return len(real_links(self.mech)) >= MANY

    # -- marks --------------------------------------------------------------------------------------------------

    def settle(self, pair: Pair, centre: Centre) -> Centre:
        """A centre is found: it has its letter, unless it is at infinity."""
        if centre.at is not None:
            centre = Centre(at=self.board.locate(self.pane, self.symbol(*pair), centre.at, found_on=True))
        self.known.centres[pair] = centre
        return centre

    def keep_place(self, key: str, symbol: str, mm: Points) -> None:
        """The place of a point, read in mm from the origin, as an answer in m."""
        self.board.keep(*place_read(key, symbol, mm, self.paper.scale))

    def letter(self, pair: Pair, dot: Dot, start: complex) -> None:
        """Letter a centre: a point, or an arrow from `start` towards infinity, in the sense in which its direction is
        told; one off the paper is lettered at its lines."""
        found = self.known.of(*pair)
        if found.along is not None:  # from now on its direction is that of its arrow
            way = traced(upright(found.way()), acts_of(found.along))
            arrow = self.point_out(start, way, self.letters(*pair))
            self.known.centres[pair] = Centre(along=traced(found.along, arrow))
        elif pair not in self.paper.far:
            self.board.plot(self.pane, found.spot(), self.letters(*pair), dot)

    def point_out(self, start: complex, way: Points, label: str) -> Acts:
        """An arrow away from the figure, with a letter at its tip; beside a bar that it would lie on."""
        start += self._beside_bars(start, complex(nominal(way)))
        tip = start + way * (GAP + ARROW)
        arrow = self.board.arrow(self.pane, start + way * GAP, tip, Role.DIRECTION)
        self.board.plot(self.pane, tip + way * TO_LETTER, label, Dot.NONE)
        return arrow

    def _beside_bars(self, start: complex, way: complex) -> complex:
        """How far an arrow this way moves aside, so that no bar covers it."""
        for mark in self.board.marks(self.pane):
            if isinstance(mark, Segment) and mark.role is Role.LINK:
                a, b = ((end - start) * way.conjugate() for end in (mark.a, mark.b))
                if (
                    max(abs(a.imag), abs(b.imag)) < ON_BAR
                    and min(a.real, b.real) < GAP + ARROW
                    and max(a.real, b.real) > GAP
                ):
                    return 1j * way * ASIDE
        return 0j

    def rule(self, line: Line, here: Centre, *on: Centre, whole: bool = False) -> None:
        """A thin line through these centres, a little beyond the outermost;
        towards one off the paper it ends at the edge with an arrow.

        Of many links' lines, unless asked for whole, only the piece at `here`, the centre that they give.
        """
        at, along = complex(nominal(line.at)), complex(nominal(line.along))
        short = self.crowded and not whole and not here.endless and self.paper.holds(here.spot())
        spots = [here.spot()] if short else [c.spot() for c in (here, *on) if not c.endless] + [at]
        near = [s for s in spots if self.paper.holds(s)]
        if not near:
            return  # it runs beside the paper
        reach = [float((np.conj(along) * (s - at)).real) for s in near]
        low, high = min(reach) - BEYOND, max(reach) + BEYOND
        self.board.join(self.pane, at + along * low, at + along * high, Role.DIRECTION)

    def rule_out(self, line: Line, target: Pair) -> None:
        """The line's way to a centre off the paper: on to the edge, with an arrow and its letter."""
        at, along = complex(nominal(line.at)), complex(nominal(line.along))
        way = along if float((np.conj(along) * (self.known.of(*target).spot() - at)).real) > 0 else -along
        tip = self.edge(at, way)
        if tip is not None:
            self.board.arrow(self.pane, at, tip, Role.DIRECTION)
            self.board.plot(self.pane, tip + way * TO_LETTER, self.letters(*target), Dot.NONE)

    def edge(self, at: complex, way: complex) -> complex | None:
        """Where a ray from a point of the paper leaves it."""
        low, high = self.paper.corners
        if not self.paper.holds(at):
            return None
        reach = [
            ((high.real if way.real > 0 else low.real) - at.real) / way.real if abs(way.real) > 1e-12 else np.inf,
            ((high.imag if way.imag > 0 else low.imag) - at.imag) / way.imag if abs(way.imag) > 1e-12 else np.inf,
        ]
        return at + way * float(min(reach))


def upright(way: complex) -> complex:
    """Of both senses of a direction the one from 0 to 180°, by which it is told."""
    turn = degrees(phase(way)) % 360.0
    return way if turn < 180.0 - LEVEL or turn > 360.0 - LEVEL else -way
