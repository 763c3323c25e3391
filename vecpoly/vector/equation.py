"""The vector equation with its direction/magnitude rows: it checks itself, prints itself and is drawn by one object.

    v_C   =  v_B   +  v_CB
    ⊥CD      ⊥AB      ⊥BC
     ?       ω₁l_AB    ?

Two chains of terms start at the pole and end at one point. A term is known wholly (already on the paper), or its line
of action is known, or its length. Exactly two scalars are unknown. Forces in equilibrium have no right side: their sum
closes at its start, R_12 + R_32 + Q = 0; being no relative vectors, they make no chain of points.
"""

from __future__ import annotations

from ..board.construction import EquationTable
from ..errors import EquationError
from ..foundation.slotted import dataclass
from ..names import At, Key, Kind, Named, Rel, ascii_key
from ..plane import Points, Reals
from ..words import Words

UNKNOWN = Words.same("?")
KNOWN = Words.same("✓")
NOTHING = Words.same("")
_PARTS = {Kind.AN, Kind.AT, Kind.AK, Kind.AR}


@dataclass(frozen=True, slots=True, kw_only=True)
class Term:
    """One vector of the equation.

    along: unit vector on paper of its line (with its sense where the length is known); mm: its length on paper;
    vector: the whole vector where it is already drawn; tip: letter of its end on the polygon; drawn: no new line
    needed.
    summed: the vectors whose sum this term is, parallel ones of unknown sizes: v_BO + v_SB counts as one unknown.
    """

    rel: Key
    symbol: str
    direction: Words
    magnitude: str
    along: Points | None = None
    mm: Reals | None = None
    vector: Points | None = None
    tip: str = ""
    drawn: bool = False
    summed: tuple[Rel, ...] = ()

    @property
    def key(self) -> str:
        """The key of its acts: of a force its own, else the ASCII form of the printed symbol, ``ak_C2C3``."""
        return self.rel.key if isinstance(self.rel, Named) else ascii_key(self.symbol)

    @property
    def unknowns(self) -> int:
        """How many of direction and magnitude are unknown."""
        return 0 if self.vector is not None else (self.along is None) + (self.mm is None)


@dataclass(frozen=True, slots=True, kw_only=True)
class Equation:
    """[total =] left = right: two chains from the pole to one point; an empty right side is zero.

    total: symbol printed in front where neither chain is the sought vector itself.
    Raises EquationError when a chain is broken or the unknowns are not two.
    """

    left: tuple[Term, ...]
    right: tuple[Term, ...] = ()
    total: str = ""

    def __post_init__(self) -> None:
        if not any(isinstance(term.rel, Named) for term in (*self.left, *self.right)):
            ends = {_end(self.left), _end(self.right)}
            if len(ends) != 1:
                raise EquationError(
                    Words(
                        f"矢量方程两边的终点不同：{'、'.join(sorted(map(str, ends)))}",
                        f"the two sides end at different points: {' and '.join(sorted(map(str, ends)))}",
                    )
                )
        count = sum(t.unknowns for t in (*self.left, *self.right))
        if count != 2:
            raise EquationError(
                Words(
                    f"平面矢量方程恰可解两个未知量；“{self}”有 {count} 个",
                    f"a plane vector equation is closed by exactly two unknown scalars; '{self}' has {count}",
                )
            )

    def __str__(self) -> str:
        sides = [" + ".join(t.symbol for t in side) or "0" for side in (self.left, self.right)]
        return " = ".join([self.total, *sides] if self.total else sides).replace("{", "").replace("}", "")

    def table(self) -> EquationTable:
        """The equation with its two rows, ready to be typeset."""
        front = ((self.total, UNKNOWN, "?"),) if self.total else ()
        cells = [*front]
        signs = [""] if front else []
        for side in (self.left, self.right):
            for i, term in enumerate(side):
                cells.append((term.symbol, term.direction, term.magnitude))
                signs.append("+" if i else ("=" if signs else ""))
        if not self.right:
            cells.append(("0", NOTHING, ""))
            signs.append("=")
        return EquationTable(
            symbols=tuple(c[0] for c in cells),
            signs=tuple(signs),
            directions=tuple(c[1] for c in cells),
            magnitudes=tuple(c[2] for c in cells),
        )


def _end(chain: tuple[Term, ...]) -> At:
    """The point a chain arrives at; raises where a term does not start where the sum has arrived.

    The moves of a summed term stand at the end of the equation, but anywhere on the way.
    """
    here: At | None = None
    last: tuple[At, At | None] | None = None
    summed = {rel.ref: rel.to for term in chain for rel in term.summed}
    for term in chain:
        assert not isinstance(term.rel, Named)
        move = (term.rel.to, term.rel.ref)
        if term.summed or (term.rel.kind in _PARTS and move == last):
            continue
        while here != term.rel.ref and here in summed:
            here = summed.pop(here)
        if term.rel.ref != here:
            raise EquationError(
                Words(
                    f"{term.symbol} 起于 {term.rel.ref or '极点'}，而前面各项之和终于 {here or '极点'}",
                    f"{term.symbol} starts at {term.rel.ref or 'the pole'}, but the sum has arrived at "
                    f"{here or 'the pole'}",
                )
            )
        here, last = term.rel.to, move
    while here in summed:
        here = summed.pop(here)
    if here is None:
        raise EquationError(Words("矢量方程的一边是空的", "an empty side of a vector equation"))
    return here
