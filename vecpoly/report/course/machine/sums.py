"""The sums over all links that the machine's chapters begin with, as displayed formulas."""

from __future__ import annotations

from ....algebra.formula import Frac, Node, Power, Row, Txt, sym
from ..numbering import Press


def equivalents_of(link: int | str) -> tuple[Node, Node]:
    """J_e = Σ[m_i (v_Si/ω_1)² + J_Si (ω_i/ω_1)²] and M_e = Σ[F_i (v_i/ω_1) cos α_i + M_i (ω_i/ω_1)]."""
    to = f"ω_{link}"
    energy = (sym("m_i"), _squared("v_{Si}", to), Txt(" + "), sym("J_{Si}"), _squared("ω_i", to))
    power = (sym("F_i"), Frac(sym("v_i"), sym(to)), Txt(" cos "), sym("α_i"), Txt(" + "), sym("M_i"))
    return (
        Row((sym("J_e"), Txt(" = Σ["), *energy, Txt("]"))),
        Row((sym("M_e"), Txt(" = Σ["), *power, Frac(sym("ω_i"), sym(to)), Txt("]"))),
    )


def shaking() -> tuple[Node, Node]:
    """F_I = −Σ m_i a_Si and M_I = −Σ[r_Si × m_i a_Si + J_Si α_i]."""
    arm = (sym("r_{Si}"), Txt(" × "), sym("m_i"), sym("a_{Si}"), Txt(" + "), sym("J_{Si}"), sym("α_i"), Txt("]"))
    return (Row((sym("F_I"), Txt(" = −Σ"), sym("m_i"), sym("a_{Si}"))), Row((sym("M_I"), Txt(" = −Σ["), *arm)))


def displayed(press: Press, nodes: tuple[Node, ...]) -> list[str]:
    """The formulas among the objects of the report."""
    return [press.objects.add("f", node) for node in nodes]


def _squared(above: str, below: str) -> Node:
    return Power(Row((Txt("("), Frac(sym(above), sym(below)), Txt(")"))), "2")
