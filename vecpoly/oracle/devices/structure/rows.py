"""Constraints of a planar chain as rows of a Jacobian:
3 coordinates a link (displacement and turn from the given position).

Row by row a constraint is a wrench: its force f at a place p of a link adds f_x, f_y, p × f to the three columns of
that link. All lengths are divided by the size of the chain.
"""

from __future__ import annotations

import cmath
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ....devices.structure_pairs import FRAME, Chain, Form, Pair

Floats = NDArray[np.float64]


@dataclass(slots=True)
class Rows:
    """The chain's links in some position: displacement t and turn θ of each from the given one."""

    chain: Chain
    size: float
    pose: Floats  # (3n,): x, y, θ of each link

    @property
    def shape(self) -> tuple[int, int]:
        """Number of constraints and of coordinates."""
        return len(self.jacobian()), len(self.pose)

    def column(self, link: str) -> int:
        return 3 * self.chain.links.index(link)

    def place(self, link: str, at: complex) -> complex:
        """Where a place of the given position is now, carried by this link."""
        p = at / self.size
        if link == FRAME:
            return p
        x, y, turn = self.pose[self.column(link) :][:3]
        return p * cmath.exp(1j * turn) + complex(x, y)

    def turned(self, link: str, along: complex) -> complex:
        """A direction, carried by this link."""
        return along if link == FRAME else along * cmath.exp(1j * self.pose[self.column(link) + 2])

    def angle(self, link: str) -> float:
        return 0.0 if link == FRAME else float(self.pose[self.column(link) + 2])

    def jacobian(self) -> Floats:
        """One row a constraint, three columns a link."""
        return np.array([row for pair in self.chain.pairs for row, _ in self._pair(pair)]).reshape(-1, len(self.pose))

    def residual(self) -> Floats:
        """By how much each constraint is broken."""
        return np.array([gap for pair in self.chain.pairs for _, gap in self._pair(pair)])

    def _pair(self, pair: Pair) -> list[tuple[Floats, float]]:
        if pair.form is Form.R:
            return [one for other in pair.links[1:] for one in self._pinned(pair.links[0], other, pair.at)]
        if pair.form is Form.P:
            return self._sliding(pair)
        return [self._meshing(pair)] if pair.form is Form.G else [self._touching(pair)]

    def _pinned(self, a: str, b: str, at: complex) -> list[tuple[Floats, float]]:
        p, q = self.place(a, at), self.place(b, at)
        return [(self._row((a, p, f), (b, q, -f)), (f.conjugate() * (p - q)).real) for f in (1 + 0j, 1j)]

    def _sliding(self, pair: Pair) -> list[tuple[Floats, float]]:
        """No turning between block and guide; the block's place stays on the guide's line."""
        block, guide = pair.links
        turn = np.zeros(len(self.pose))
        for link, sign in ((block, 1.0), (guide, -1.0)):
            if link != FRAME:
                turn[self.column(link) + 2] = sign
        p, q, f = self.place(block, pair.at), self.place(guide, pair.at), self.turned(guide, 1j * pair.along)
        return [
            (turn, self.angle(block) - self.angle(guide)),
            (self._row((block, p, f), (guide, p, -f)), (f.conjugate() * (p - q)).real),
        ]

    def _touching(self, pair: Pair) -> tuple[Floats, float]:
        """Two profiles keep the distance of their centres;
        a profile on a flat face keeps its centre's distance from it."""
        (a, b), (one, two) = pair.links, pair.about
        if one is None or two is None:
            round_, flat, centre = (b, a, two) if one is None else (a, b, one)
            p, q, f = self.place(round_, centre or 0j), self.place(flat, pair.at), self.turned(flat, pair.normal)
            height = (pair.normal.conjugate() * ((centre or 0j) - pair.at)).real / self.size
            return self._row((round_, p, f), (flat, p, -f)), (f.conjugate() * (p - q)).real - height
        p, q = self.place(a, one), self.place(b, two)
        f = (p - q) / abs(p - q)
        return self._row((a, p, f), (b, q, -f)), abs(p - q) - abs(one - two) / self.size

    def _meshing(self, pair: Pair) -> tuple[Floats, float]:
        """Pitch circles roll: r₁(θ₁ − ψ) = −r₂(θ₂ − ψ), ψ the turn of the line of centres; radii signed along it."""
        (a, b), (one, two) = pair.links, pair.about
        assert one is not None and two is not None
        p, q = self.place(a, one), self.place(b, two)
        u = (two - one) / abs(two - one)
        r, s = ((u.conjugate() * (pair.at - centre)).real / self.size for centre in (one, two))
        way, apart = (q - p) / abs(q - p), abs(q - p)
        psi = cmath.phase(way / u)
        row = self._row((b, q, 1j * way * (s - r) / apart), (a, p, -1j * way * (s - r) / apart))
        for link, radius in ((a, r), (b, -s)):
            if link != FRAME:
                row[self.column(link) + 2] += radius
        return row, r * (self.angle(a) - psi) - s * (self.angle(b) - psi)

    def _row(self, *wrenches: tuple[str, complex, complex]) -> Floats:
        row = np.zeros(len(self.pose))
        for link, p, f in wrenches:
            if link != FRAME:
                i = self.column(link)
                arm = p - complex(self.pose[i], self.pose[i + 1])
                row[i : i + 3] += (f.real, f.imag, (arm.conjugate() * f).imag)
        return row
