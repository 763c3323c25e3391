"""What a group's force polygon is begun with and gives: reactions in two parts, and the corners with their letters."""

from __future__ import annotations

from dataclasses import dataclass

from ....board.construction import Pane
from ....names import Named
from ....plane import Points
from ....vector.equation import Term
from ....words import Words
from ..acting import Acting, Drawn
from ..lines.arms import Turning, without_moment
from ..state import Statics


@dataclass(frozen=True, slots=True, kw_only=True)
class Reaction:
    """A reaction whose tangential part (mm along i·line, from moments) is known,
    and whose part along `line` is sought."""

    by: str
    on: str
    line: Points
    direction: Words
    part: str = ""  # "n" where a tangential part stands beside it
    across: Points | None = None  # the tangential part, mm on the polygon
    across_direction: Words | None = None
    pin: str = ""  # letter of the pin at which both parts act

    def sought(self, st: Statics) -> Term:
        """The part along the line."""
        named = part_named(st.named(self.by, self.on), self.part)
        return Term(rel=named, symbol=named.symbol, direction=self.direction, magnitude="?", along=self.line)

    def found(self, st: Statics, tip: str) -> tuple[Term, ...]:
        """The part from moments, where there is one."""
        if not self.part or self.across is None or self.across_direction is None:
            return ()
        named = part_named(st.named(self.by, self.on), "t")
        return (
            Term(
                rel=named,
                symbol=named.symbol,
                direction=self.across_direction,
                magnitude="✓",
                vector=self.across,
                tip=tip,
            ),
        )

    def parts(self, st: Statics) -> list[Acting]:
        """The reaction as found; in its two parts at the pin where it was split."""
        whole = st.push(self.by, self.on)
        if whole is None or not self.part or self.across is None:
            return [whole] if whole is not None else []
        at = st.desk.at[self.pin]
        return [
            Acting(named=part_named(whole.named, "n"), vector=whole.vector - self.across, at=at),
            Acting(named=part_named(whole.named, "t"), vector=self.across, at=at),
        ]


@dataclass(frozen=True, slots=True, kw_only=True)
class Corners:
    """The polygon's letters and points:
    start and end of R_pj, end of the forces of j (J), of k (K), and the corner X."""

    pane: Pane
    p: tuple[tuple[str, Points], tuple[str, Points]]
    j: tuple[str, Points]
    k: tuple[str, Points]
    x: tuple[str, Points]

    def side(self, start: tuple[str, Points], end: tuple[str, Points]) -> Drawn:
        """The vector from one corner to another."""
        return Drawn(place=self.pane, start=start[1], end=end[1], letters=f"{start[0]} {end[0]}")


def part_named(named: Named, part: str) -> Named:
    """R^n_12 and R^t_12 beside R_12."""
    return Named(f"{named.key}_{part}", named.symbol.replace("R_", f"R^{part}_", 1), "N", True) if part else named


def tangential(st: Statics, by: str, on: str, arm: tuple[str, str], turning: Turning) -> Points:
    """R^t = Σ M / l, square to the line from `arm`'s second point to its first, where it acts: mm on the polygon."""
    p, about = arm
    outward = st.desk.towards(about, p)
    named = part_named(st.named(by, on), "t")
    if not turning.way:
        st.board.remark(without_moment(f"${named.symbol}$", turning))
        return 0j
    length = st.desk.length(p, about)
    st.board.compute(named.symbol, turning.size / length, "N")
    return -1j * outward * st.mm(turning.value / length.value)
