"""Quantities of which each of two solutions has its own."""

from __future__ import annotations

from ...names import Named


def of_solution(stem: str, letter: str, sub: str, way: str, unit: str) -> Named:
    """m_b, or m_b_1 with the symbol m_{b,1}; way: `_1` or `_2`, "" of a single solution."""
    symbol = f"{letter}_{{{sub}{way.replace('_', ',')}}}"
    return Named(f"{stem}_{sub}{way}", symbol, unit, solution=int(way.removeprefix("_") or 0))
