"""Letters that follow from a load's symbol:
its arms, the foot of a velocity on it, the pair of forces that stands for a couple, its power."""

from __future__ import annotations

ARM = "h"  # the letter of arms


def bare(symbol: str) -> str:
    """The symbol's letters in one row: F_{I2} → FI2."""
    return "".join(c for c in symbol if c not in "_{},")


def subscript(symbol: str) -> str:
    """What tells a force from the others: F_{I2} → I2, R_{56} → 56, R_{12,0} → 12,0, R^t_{56} → 56t, F → F,
    G_{2} → G2."""
    base, _, sub = symbol.partition("_")
    if base.startswith("R^"):
        return bare(sub) + base[2:]
    return "".join(c for c in sub if c not in "_{}") if sub and base in ("F", "R") else bare(symbol)


def arm_about_point(symbol: str, about: str = "") -> str:
    """h_{I2}: the arm of a force on the diagram; h_{S,I2} about a point beside others."""
    return f"h_{{{about},{subscript(symbol)}}}" if about else f"h_{{{subscript(symbol)}}}"


def arm_about_pole(symbol: str) -> str:
    """d_{I2}: the arm of a force on the lever."""
    return f"d_{{{subscript(symbol)}}}"


def pair_symbol(symbol: str) -> str:
    """F_{M1}: each of the two forces that stand for the couple M_1."""
    return f"F_{{{bare(symbol)}}}"


def power_symbol(symbol: str) -> str:
    """P_{FI2}: the power of a load."""
    return f"P_{{{bare(symbol)}}}"


def slide_couple(symbol: str) -> str:
    """M_{R23}: the couple that a slide passes on, beside a force R_{23} of zero."""
    return f"M_{{{bare(symbol)}}}"


def foot_letter(tip: str, symbol: str) -> str:
    """The letter of a tip's foot on the direction of a force: b_{F}, s_{2,I2}; d_{F3} of F_3, as d_3 would be
    a point of link 3, and h_{Fs} of F_s, whose arm is h_s."""
    letter, _, digits = tip.partition("_")
    told = subscript(symbol)
    return f"{letter}_{{{digits + ',' if digits else ''}{bare(symbol) if told.isdigit() or letter == ARM else told}}}"
