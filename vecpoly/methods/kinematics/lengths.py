"""How long the computed vectors of an equation become on paper, between the letters at which they are laid off."""

from __future__ import annotations

from ...board.construction import View
from ...names import Rel
from ...vector.equation import Equation, Term
from ..desk import POLE, Desk


def write_lengths(desk: Desk, view: View, eq: Equation) -> None:
    """n′ k′ = a^k / μ_a = 11.5 mm of every vector that was computed:
    its tail is where the known vectors before it have arrived."""
    for chain in (eq.left, eq.right):
        tail = POLE[view]
        for term in chain:
            head = _head(desk, view, term)
            size = desk.size(term.rel) if isinstance(term.rel, Rel) else None
            if term.mm is not None and head and size is not None:
                shifted = (
                    term is chain[-1]
                    and chain[0].unknowns
                    and not term.tip
                    and isinstance(term.rel, Rel)
                    and term.rel.ref
                )
                start = (
                    desk.tip_label(view, shifted) if shifted else tail
                )  # the last one, behind one that was sought, comes to its end
                desk.board.write_length(view, f"{start} {head}", size)
            tail = head or tail


def _head(desk: Desk, view: View, term: Term) -> str:
    """The letter at the end of a term that is laid off or drawn already;
    none of one that is sought, or that vanishes."""
    if term.unknowns or term.magnitude == "0" or not isinstance(term.rel, Rel):
        return ""
    return term.tip or desk.tip_label(view, term.rel.to)
