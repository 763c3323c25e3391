"""A crowded place of a figure drawn apart: circled and numbered Ⅰ where it is, enlarged beside it (局部放大图)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from unicodedata import normalize

import numpy as np

from ...board.construction import Figure
from ...board.paper.marks import Arc, Dot, Mark, Point, Role, Segment, Vector
from ...foundation.slotted import replace
from ...words import Words
from ..symbols.around import RING
from ..symbols.shared import shared
from .knot import Knot
from .knots import MOST, knots
from .within import spoken, unlettered, within

ROMAN = "ⅠⅡⅢⅣⅤⅥⅦⅧⅨⅩⅪⅫ"
ROW = 25.0  # mm: the height of a row in which knots are read from left to right
NEAR = 4.0  # radii of a knot about it in which its number looks for room


def detailed(figure: Figure, first: int = 1, most: int = MOST) -> tuple[Figure, ...]:
    """The figure with its worst knots circled and left with the letters that are spoken of alone, then each detail,
    which has all, numbered from `first` on; the figure alone where it has no knot."""
    found = shown(figure, most)
    if not found:
        return (figure,)
    names = [numeral(first + n) for n in range(len(found))]
    marks: Iterable[Mark] = figure.marks
    for knot in found:
        kept = spoken(figure, knot)
        marks = [mark if mark in kept else unlettered(mark, knot) for mark in marks]
    rings, details, common = list[Mark](), list[Figure](), shared(figure.view, figure.marks)
    inked = [replace(mark, key="") if mark in common else mark for mark in figure.marks]  # of no force
    for number, (knot, name) in enumerate(zip(found, names, strict=True), start=1):
        inner = tuple(part for mark in inked for part in within(mark, knot))
        rings += _ringed(figure, knot, name, inner)
        details.append(_detail(figure, knot, name, number, inner))
    return (replace(figure, marks=(*marks, *rings)), *details)


def shown(figure: Figure, most: int = MOST) -> tuple[Knot, ...]:
    """The worst knots of a figure, so many at most, as they are read: row by row."""
    return tuple(sorted(knots(figure)[:most], key=lambda knot: (-round(knot.centre.imag / ROW), knot.centre.real)))


def all_detailed(figures: Sequence[Figure], most: int = MOST) -> tuple[tuple[Figure, ...], ...]:
    """Each figure with so many details at most, which are numbered through."""
    made, count = list[tuple[Figure, ...]](), 1
    for figure in figures:
        made.append(detailed(figure, count, most))
        count += len(made[-1]) - 1
    return tuple(made)


def is_detail(name: str, figure: Figure) -> bool:
    """Whether a figure of this name and of its kind is a detail of the figure."""
    return re.fullmatch(re.escape(_named(figure, 0))[:-1] + r"\d+", name) is not None


def numeral(number: int) -> str:
    """A roman numeral as one character; of many details those after the twelfth by letters."""
    return ROMAN[number - 1] if number <= len(ROMAN) else f"Ⅻ{chr(ord('a') + number - len(ROMAN) - 1)}"


def _detail(figure: Figure, knot: Knot, name: str, number: int, inner: tuple[Mark, ...]) -> Figure:
    """The figure of one detail, its ring about the origin, at a scale of its own."""
    ring = _circle(0j, knot.radius * knot.factor, inner)
    return replace(
        figure,
        title=Words(f"局部放大图 {name}（{knot.factor:g}:1）", f"Detail {normalize('NFKC', name)} ({knot.factor:g}:1)"),
        scale=replace(figure.scale, symbol="", value=figure.scale.value / knot.factor),  # its title tells it
        marks=(*inner, ring),
        name=_named(figure, number),
        aside=False,
    )


def _named(figure: Figure, number: int) -> str:
    return f"{figure.name} detail {number}".strip()


def _ringed(figure: Figure, knot: Knot, name: str, inner: Sequence[Mark]) -> tuple[Mark, Mark]:
    """The circle about a knot with its number."""
    at = knot.centre + (knot.radius + 0.1) * _outwards(figure, knot)
    ring = _circle(knot.centre, knot.radius, inner)
    return ring, Point(at=at, label=name, dot=Dot.NONE, step=ring.step)


def _circle(centre: complex, radius: float, about: Sequence[Mark]) -> Arc:
    """A thin circle, that stands from the step on in which something stands inside."""
    step = min((mark.step for mark in about), default=0)
    return Arc(
        centre=centre, radius=radius, start=0.0, sweep=2 * math.pi, role=Role.CONSTRUCTION, step=step, owner=RING
    )


def _outwards(figure: Figure, knot: Knot) -> complex:
    """The direction from the knot in which the figure has least."""
    ways = np.exp(2j * np.pi * np.arange(16) / 16)
    seen = [
        complex(z) - knot.centre
        for m in figure.marks
        if isinstance(m, Vector | Segment)
        for z in np.linspace(m.a, m.b, 12)
        if not knot.holds(complex(z))
    ]
    near = [z / abs(z) for z in seen if abs(z) < NEAR * knot.radius]
    return complex(max(ways, key=lambda w: min((abs(w - z) for z in near), default=0.0)))
