"""Which way links turn and glide that have one velocity at their centre, in words."""

from __future__ import annotations

from ....words import Words


def ways(base: str, common: str, via: str) -> Words:
    """How the velocity of P_ij lies as a point of a turning link: the letters of P_ik and P_ij, the link."""
    return Words(
        f"，垂直于 ${base}{common}$，指向与 $ω_{via}$ 一致",
        f", perpendicular to ${base}{common}$ in the sense of $ω_{via}$",
    )


def sense_told(own: str, common: str, base: str, outside: bool) -> Words:
    """Where P_ij lies, and so how the links turn: the letters of P_jk, P_ij, P_ik."""
    if outside:
        return Words(
            f"${base}$、${own}$ 位于 ${common}$ 的同侧，两构件转向相同",
            f"it lies outside ${base}$ and ${own}$, so they turn in the same sense",
        )
    return Words(
        f"${common}$ 位于 ${base}$ 与 ${own}$ 之间，两构件转向相反",
        f"it lies between ${base}$ and ${own}$, so they turn in opposite senses",
    )
