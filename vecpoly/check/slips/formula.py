"""Several slips at once in the formula of a point's velocity or acceleration, which is a sum of terms along the links.

v_E = l_AB ω_1 (−sin φ_1, cos φ_1) + l_BC ω_2 (−sin φ_2, cos φ_2) + …; an acceleration has l α (−sin φ, cos φ) and
l ω² (−cos φ, −sin φ) of each bar. In a term, or in one component of it, ω (α, ω²) may be missing, ω stand for ω²,
the angle be another link's, sine stand for cosine, or + for −. All choices of one, two and three such slips are tried.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import reduce
from itertools import combinations, product
from math import log10

import numpy as np
from numpy.typing import NDArray

from ...mechanism.model import FRAME, Mechanism, Revolute
from ...names import Kind
from ...oracle import Motion
from ..table.target import Part, Reals, Target
from ..table.weigh import Column, Weighing

MOST_SLIPS = 3
MOST_BARS = 3  # along the way from the frame to the point
PICKED, SPARED = 9, 2  # rows that every choice is tried on at first; how many of them may be typed over
CLOSEST = 8  # choices of one way and number of slips that are then tried on all rows
FREEDOM = 5  # independent numbers in a smooth column, however many rows it has
SAFETY = 4.0  # powers of ten by which chance must be excluded
MISSING, ONCE, SIGN, TRIG = "missing", "once", "sign", "trig"  # any other slip is the link whose angle was taken

Points = NDArray[np.complex128]
Indices = NDArray[np.intp]


@dataclass(frozen=True, slots=True, kw_only=True)
class Bar:
    """A straight step along a link between two of its points; `along` (m) in the link's own coordinates."""

    name: str
    link: str
    along: complex


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Term:
    """l ω (−sin φ, cos φ), l α (−sin φ, cos φ), or, where `normal`, l ω² (−cos φ, −sin φ); `rate` is ω, or α."""

    bar: Bar
    rate: Reals
    kind: Kind  # of the rate
    normal: bool = False

    def value(self, motion: Motion, slips: frozenset[str]) -> Points:
        """Both components, with these slips in them."""
        link = next((slip for slip in slips if slip not in (MISSING, ONCE, SIGN, TRIG)), self.bar.link)
        bar = self.bar.along * np.exp(1j * motion.angle(link))
        if TRIG in slips:
            bar = 1j * bar.conj()
        rate = np.ones_like(self.rate) if MISSING in slips else self.rate
        size = rate * rate if self.normal and ONCE not in slips else rate
        return np.asarray((-1 if SIGN in slips else 1) * size * (-bar if self.normal else 1j * bar), np.complex128)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Slipped:
    """A term with slips, each with the components that it is in (x, y, xy)."""

    term: Term
    slips: tuple[tuple[str, str], ...]


@dataclass(frozen=True, slots=True, eq=False)
class Variants:
    """A term with every choice of slips:
    in x the choice `x[i]`, in y the choice `y[i]`, and by how much the sum then changes."""

    term: Term
    choices: tuple[frozenset[str], ...]
    x: Indices
    y: Indices
    count: Indices  # of slips, one in both components counted once
    change: Points  # variants × rows

    @classmethod
    def of(cls, term: Term, motion: Motion, part: Part) -> Variants:
        """All variants that change the term, with up to three slips."""
        links = [link for link in motion.mech.numbered if link != term.bar.link]
        kinds = (MISSING, *((ONCE,) if term.normal else ()), SIGN, TRIG, *links)
        choices = [
            choice
            for count in range(MOST_SLIPS + 1)
            for one in combinations(kinds, count)
            if len((choice := frozenset(one)) & {*links}) < 2 and not {MISSING, ONCE} <= choice
        ]
        bits = np.array([sum(1 << kinds.index(slip) for slip in choice) for choice in choices])
        x, y = (
            at.ravel()
            for at in np.meshgrid(
                *([0] if part is less else np.arange(len(choices)) for less in (Part.Y, Part.X)), indexing="ij"
            )
        )
        count = np.array([int(both).bit_count() for both in bits[x] | bits[y]])
        x, y, count = (some[(count > 0) & (count <= MOST_SLIPS)] for some in (x, y, count))
        values = np.array([term.value(motion, choice) for choice in choices])
        change = values[x].real + 1j * values[y].imag - values[0]
        changed = np.nanmax(np.abs(change), axis=1, initial=0.0) > 1e-12 + 1e-9 * float(
            np.nanmax(np.abs(values[0]), initial=0.0)
        )
        return cls(term, tuple(choices), x[changed], y[changed], count[changed], change[changed])

    def slipped(self, i: int) -> Slipped:
        """One of them, told slip by slip."""
        x, y = self.choices[self.x[i]], self.choices[self.y[i]]
        return Slipped(
            term=self.term, slips=tuple((slip, "x" * (slip in x) + "y" * (slip in y)) for slip in sorted(x | y))
        )


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Formula:
    """A choice of slips, and the numbers to which the formula then leads."""

    slipped: tuple[Slipped, ...]
    expected: Reals


@dataclass(frozen=True, slots=True, eq=False)
class Way:
    """The formula along one way from the frame to the point: its right value, and the variants of its terms."""

    right: Points
    terms: tuple[Variants, ...]


def ways_to(target: Target, motion: Motion) -> list[Way]:
    """The formulas of a point's velocity or acceleration that go over bars and hinges alone;
    none for other quantities."""
    rel = target.rel
    if rel is None or rel.kind not in (Kind.V, Kind.A) or rel.ref is not None:
        return []
    found = []
    known: dict[Bar, list[Variants]] = {}
    for bars in _bars_to(motion.mech, rel.to.point, motion.locate(rel.to)[0]):
        known |= {
            bar: [Variants.of(term, motion, target.part) for term in _terms(bar, motion, rel.kind)]
            for bar in bars
            if bar not in known
        }
        terms = tuple(term for bar in bars for term in known[bar])
        found.append(
            Way(
                sum((one.term.value(motion, frozenset()) for one in terms), np.zeros(motion.shape, np.complex128)),
                terms,
            )
        )
    return found


def formulas(column: Column, ways: Sequence[Way], count: int) -> tuple[int, list[Formula]]:
    """How many choices of so many slips there are, and those that come closest to the column in a few rows."""
    there = np.flatnonzero(column.there)
    rows = there[np.linspace(0, len(there) - 1, min(PICKED, len(there))).astype(int)]
    tried, near = 0, []
    for way, share in product(ways, _shares(count)):
        for terms in combinations(way.terms, len(share)):
            which = [np.flatnonzero(term.count == part) for term, part in zip(terms, share, strict=True)]
            sums = reduce(
                _each_with_each, [term.change[some][:, rows] for term, some in zip(terms, which, strict=True)]
            )
            if not len(sums):
                continue
            off = np.abs(component(column.target, sums + way.right[rows]) - column.values[rows]) / column.half[rows]
            far = np.partition(off, -1 - SPARED, axis=1)[:, -1 - SPARED]
            tried += len(far)
            for i in np.argpartition(far, min(CLOSEST, len(far)) - 1)[:CLOSEST]:
                at = np.unravel_index(i, [len(some) for some in which])
                near.append(
                    (float(far[i]), way, [(term, int(some[k])) for term, some, k in zip(terms, which, at, strict=True)])
                )
    near.sort(key=lambda one: one[0])
    return tried, [_formula(column.target, way, choice) for _, way, choice in near[:CLOSEST]]


def _formula(target: Target, way: Way, choice: Sequence[tuple[Variants, int]]) -> Formula:
    total = sum((term.change[i] for term, i in choice), way.right)
    return Formula(slipped=tuple(term.slipped(i) for term, i in choice), expected=component(target, total))


def _each_with_each(left: Points, right: Points) -> Points:
    return np.asarray((left[:, None] + right).reshape(-1, left.shape[1]), np.complex128)


def beyond_chance(column: Column, before: Weighing, after: Weighing, tried: int) -> bool:
    """Whether so close a fit cannot be the luck of so many trials:
    (deviation left / deviation before)^n × trials < 10^-4."""
    known = column.values[column.there]
    free = min(FREEDOM, len(np.unique(known)) // 3)
    return free * log10(max(before.typical, 1e-3) / max(after.spread, 0.5)) >= log10(max(tried, 1)) + SAFETY


def component(target: Target, value: Points) -> Reals:
    """The number of a vector that the column holds."""
    return np.asarray({Part.X: np.real, Part.Y: np.imag}.get(target.part, np.abs)(value), np.float64)


def _shares(count: int) -> Iterator[tuple[int, ...]]:
    """How so many slips may be shared among terms, in every order."""
    for terms in range(1, count + 1):
        yield from (share for share in product(range(1, count + 1), repeat=terms) if sum(share) == count)


def _bars_to(mech: Mechanism, letter: str, link: str) -> Iterator[tuple[Bar, ...]]:
    """The ways from the frame to a point of a link over hinges and bars, of no more than three bars."""

    def onward(at: str, on: str, bars: tuple[Bar, ...], met: tuple[str, ...]) -> Iterator[tuple[Bar, ...]]:
        hinged = _hinged(mech, at, on)
        if at == letter and link in hinged:
            yield bars
            return
        for name in hinged if len(bars) < MOST_BARS else ():
            points = mech.link(name).points if name != FRAME else {}
            for to in points:
                if to not in met and at in points:
                    yield from onward(
                        to,
                        name,
                        (*bars, Bar(name=f"l_{{{at}{to}}}", link=name, along=points[to] - points[at])),
                        (*met, to),
                    )

    for start in mech.frame:
        yield from onward(start, FRAME, (), (start,))


def _hinged(mech: Mechanism, at: str, on: str) -> list[str]:
    """This link, and those that are hinged to it at this point, directly or by a third one."""
    pairs = [(joint.a, joint.b) for joint in mech.joints if isinstance(joint, Revolute) and joint.point == at]
    known = [on]
    for name in known:
        known += [other for pair in pairs if name in pair for other in pair if other not in known]
    return known


def _terms(bar: Bar, motion: Motion, kind: Kind) -> list[Term]:
    """One term of a bar in a velocity, two in an acceleration."""
    turning = Term(bar=bar, rate=motion.omega(bar.link), kind=Kind.OMEGA, normal=kind is Kind.A)
    return [Term(bar=bar, rate=motion.alpha(bar.link), kind=Kind.ALPHA), turning] if kind is Kind.A else [turning]
