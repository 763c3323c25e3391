"""Formulas as they are copied: one line of plain text, brackets where they are needed."""

from __future__ import annotations

from ..algebra.formula import Frac, Node, Root, Row, plain


def copied(node: Node) -> str:
    """The formula as text: ``ω_2 = (0.006 × 40.9)/0.123 = 1.995 rad/s``."""
    match node:
        case Row(items):
            return "".join(map(copied, items))
        case Frac(num, den):
            return f"{_factor(num)}/{_factor(den)}"
        case Root(body):
            return f"√{_factor(body)}"
        case _:
            return primed(plain(node))


def primed(text: str) -> str:
    """A prime stands by itself: b′, not b^′."""
    return text.replace("^′", "′").replace("^'", "′")


def _factor(node: Node) -> str:
    text = copied(node)
    return f"({text})" if any(sign in text for sign in " +−×·/") else text
