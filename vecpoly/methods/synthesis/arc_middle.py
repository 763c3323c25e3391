"""A on its circle by the middle of an arc, where the crank or the coupler is given."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ...plane import Line, Points, line_circle_meet, nominal, unit
from ...words import Words
from .draft import SHEET, Draft
from .eta import Eta, Locus, Straight
from .linkage import point

MIRROR = Words(
    "（另一交点是它的镜像，所得机构相同。）",
    " (The other intersection is its mirror image and gives the same linkage.)",
)


def primes_of(locus: Locus) -> str:
    """The primes of the letters on this locus."""
    return locus.marks if isinstance(locus, Eta) else ""


def called(locus: Locus) -> Words:
    """What the locus is called: the circle η′, the line C₁C₂."""
    if isinstance(locus, Straight):
        return Words("直线 $C_{1}C_{2}$", "the line $C_{1}C_{2}$")
    return Words(f"圆 $η{primes_of(locus)}$", f"the circle $η{primes_of(locus)}$")


def by_arc(draft: Draft, limits: tuple[Points, Points], eta: Eta, twice: float, given: str) -> Iterator[Points]:
    """The construction by the middle of an arc: S on C₂A with C₂S = AC₂ − AC₁ = 2 AB, or AC₂ + AC₁ = 2 BC.

    The triangle A C₁ S is isosceles, so that C₁C₂ is seen from S under 90° + θ/2, or θ/2: S lies on a circle about the
    middle M of the arc C₁C₂ on which A does not lie, or does.
    """
    (c1, c2), board = limits, draft.board
    crank, primes, letter = given == "AB", primes_of(eta), draft.letter("A")
    lies = ("不含", f"on which ${letter}$ does not lie") if crank else ("含", f"on which ${letter}$ lies")
    ray = _ray(primes, letter, beyond=crank)
    board.step(
        Words(
            f"取圆 $η{primes}$ 上{lies[0]} ${letter}$ 的弧 $C_{{1}}C_2$ 的中点 $M{primes}$（在过 $O{primes}$ 的 "
            f"$C_{{1}}C_2$ 的垂线上），以 $M{primes}$ 为圆心、"
            f"$M{primes}C_1$ 为半径作弧；"
            f"以 $C_2$ 为圆心、$2l_{given}/μ_l$ 为半径作弧，两弧交于 $S{primes}$；{ray.zh}",
            f"From the middle $M{primes}$ of the arc $C_{{1}}C_2$ of $η{primes}$ {lies[1]} (on the perpendicular to "
            f"$C_{{1}}C_2$ through $O{primes}$) draw an arc through "
            f"$C_1$; the arc about "
            f"$C_2$ with the radius $2l_{given}/μ_l$ meets it at $S{primes}$. {ray.en[0].upper()}{ray.en[1:]}",
        ),
        SHEET,
        again=_again(primes, letter, lies, ray),
    )
    far = eta.flat and not crank  # the middle of the greater arc
    m = _middle(draft, limits, eta, upper=(eta.side < 0) == crank, far=far)
    radius, what = np.abs(c1 - m), Words(f"求 $S{primes}$", f"finding $S{primes}$")
    spots = board.arcs(c2, twice, m, radius, what)
    s = point(draft, f"S{primes}", board.either(min(spots, key=lambda at: _across(c2, at, eta))))
    board.swing(SHEET, c2, twice, s)
    if far:
        board.swing(SHEET, m, radius, s)
    else:
        board.arcs_past(SHEET, m, radius, c1, s)
    board.remark(MIRROR)
    line = Line(c2, unit(s - c2))
    a, _ = board.arc_on_line(line, eta.centre, eta.radius, Words(f"求 ${letter}$", f"finding ${letter}$"))
    board.rule(SHEET, line, a)
    yield board.either(a)


def _again(primes: str, letter: str, lies: tuple[str, str], ray: Words) -> Words:
    """The same on the other circle."""
    return Words(
        f"同样，由圆 $η{primes}$ 上{lies[0]} ${letter}$ 的弧 $C_{{1}}C_2$ 的中点 $M{primes}$ 得 $S{primes}$，{ray.zh}",
        f"In the same way: $M{primes}$ is the midpoint of the arc $C_{{1}}C_2$ of $η{primes}$ {lies[1]}; it gives "
        f"$S{primes}$, and {ray.en}",
    )


def _ray(primes: str, letter: str, *, beyond: bool) -> Words:
    """How C₂S gives A: beyond S where C₂S = AC₂ − AC₁, between C₂ and S where it is their sum."""
    if beyond:
        return Words(
            f"$C_{{2}}S{primes}$ 的延长线与 $η{primes}$ 交于 ${letter}$。",
            f"the line $C_{{2}}S{primes}$, produced, meets $η{primes}$ at ${letter}$.",
        )
    return Words(
        f"连 $C_{{2}}S{primes}$，与 $η{primes}$ 交于 ${letter}$。",
        f"the line $C_{{2}}S{primes}$ meets $η{primes}$ at ${letter}$, between $C_2$ and $S{primes}$.",
    )


def _middle(draft: Draft, limits: tuple[Points, Points], eta: Eta, *, upper: bool, far: bool) -> Points:
    """M, the upper or the lower end of the diameter across C₁C₂; without a letter where it is far off."""
    board = draft.board
    line = board.parallel(eta.centre, 1j * unit(limits[1] - limits[0]))
    ends = board.arc_on_line(line, eta.centre, eta.radius, Words("求弧的中点", "the middle of the arc"))
    m = (max if upper else min)(ends, key=lambda at: float(nominal(at).imag))
    if far:
        return m
    board.rule(SHEET, line, m)
    return point(draft, f"M{eta.marks}", m)


def _across(c2: Points, s: Points, eta: Eta) -> float:
    """How far to the right A comes to lie by this S."""
    start, way = complex(nominal(c2)), complex(nominal(unit(s - c2)))
    a, _ = line_circle_meet(Line(start, way), complex(nominal(eta.centre)), float(nominal(eta.radius)))
    return complex(a).real
