"""Lettering finds its places: each label moves about what it names until it stands on nothing, and shrinks only if it must."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .obstacles import Complexes, Floats, Obstacles, clip
from .rivals import misled
from .scene import Item, Layer, Rect, Stroke, TextBox
from .style import THIN, Hue
from .wants import Piece, Spots, Want, smaller, spots

APART = 0.7  # mm between two labels
AS_ONE, MISREAD = 1.8, 9.0  # mm side by side below which two labels are read as one, and what that costs
OVERLAP, PER_AREA = 120.0, 8.0
LEADER_ON_LABEL = 60.0
OUTSIDE, BEYOND_FRAME = 0.25, 60.0  # a mm beyond the drawn lines, beyond the allowed frame
BAD = 38.0  # a label that costs more than this by where it stands is on something
SHRINK = (0.85, 0.72)
PASSES = 8


@dataclass(frozen=True, slots=True)
class Placed:
    """A label at its place, with its leader line if it has one."""

    want: Want
    centre: complex
    cost: float  # what it stands on, beyond mere preference
    foot: complex | None = None

    @property
    def rect(self) -> Rect:
        """The rectangle it covers."""
        w, h, c = self.want.width / 2, self.want.height / 2, self.centre
        return Rect(c.real - w, c.imag - h, c.real + w, c.imag + h)

    def items(self) -> tuple[Item, ...]:
        """Its type and leader line."""
        rect = self.rect
        baseline = rect.y1 - self.want.ascent
        text = tuple(_text(piece, rect.x0, baseline) for piece in self.want.pieces)
        if self.foot is None:
            return text
        step = min(piece.step for piece in self.want.pieces)
        end = _nearest(self.foot, rect.grown(0.4))
        return (Stroke(points=(self.foot, end), width=THIN, hue=Hue.BLACK, layer=Layer.TEXT, step=step), *text)


def _text(piece: Piece, x: float, y: float) -> TextBox:
    return TextBox(box=piece.box, x=x + piece.dx, y=y, hue=piece.hue, step=piece.step)


def _nearest(point: complex, rect: Rect) -> complex:
    return complex(min(max(point.real, rect.x0), rect.x1), min(max(point.imag, rect.y0), rect.y1))


def place(wanted: tuple[Want, ...], obstacles: Obstacles, drawn: Rect, frame: Rect | None = None) -> tuple[Placed, ...]:
    """A place for each label; the same input always gives the same places."""
    table = _Table.of(wanted, obstacles, drawn, frame)
    for factor in SHRINK:
        chosen = table.solve()
        crowded = [i for i in range(len(wanted)) if table.trouble(i, chosen) > BAD]
        if not crowded:
            break
        tight = tuple(smaller(w, factor / w.scale) if i in crowded else w for i, w in enumerate(table.wants))
        table = _Table.of(tight, obstacles, drawn, frame)
    else:
        chosen = table.solve()
    return tuple(table.placed(i, chosen) for i in range(len(wanted)))


@dataclass(frozen=True, slots=True)
class _Table:
    """All candidate places of all labels with what each costs by itself."""

    wants: tuple[Want, ...]
    half: tuple[complex, ...]  # half the width and height of each label
    spots: tuple[Spots, ...]
    hard: tuple[Floats, ...]  # what a place stands on
    total: tuple[Floats, ...]  # with preference

    @classmethod
    def of(cls, wanted: tuple[Want, ...], obstacles: Obstacles, drawn: Rect, frame: Rect | None) -> _Table:
        """Every label's candidates, priced against the lines of the figure."""
        half = tuple(complex(want.width / 2, want.height / 2) for want in wanted)
        found = tuple(spots(want, drawn.centre) for want in wanted)
        hard = tuple(_price(w, s, obstacles, frame, wanted) for w, s in zip(wanted, found, strict=True))
        total = tuple(h + s.cost + OUTSIDE * _beyond(w, s, drawn) for w, s, h in zip(wanted, found, hard, strict=True))
        return cls(wanted, half, found, hard, total)

    def solve(self) -> list[int]:
        """The most constrained label chooses first; then each reconsiders until none moves."""
        n = len(self.wants)
        chosen, seen = [-1] * n, [[-1] * n for _ in range(n)]
        price = [np.zeros((len(here.centre), n)) for here in self.spots]  # of each place, for each other label where it was last seen
        freedom = [int((cost < cost.min() + 6.0).sum()) for cost in self.total]
        order = sorted(range(n), key=lambda i: (freedom[i], i))
        for _ in range(PASSES):
            before = list(chosen)
            for i in order:
                moved = [j for j in range(n) if j != i and chosen[j] != seen[i][j]]
                price[i][:, moved] = self.clashes(i, slice(None), moved, chosen)
                seen[i] = list(chosen)
                chosen[i] = int(np.argmin(self.total[i] + price[i].sum(axis=1)))
            if chosen == before:
                break
        return chosen

    def clashes(self, i: int, which: slice, others: list[int], chosen: list[int]) -> Floats:
        """What some places of label i cost for each of the other labels where it is now; shape (places, others)."""
        here, half = self.spots[i], self.half[i]
        mine, led = here.centre[which, None], here.foot[which, None]
        c = np.array([self.spots[j].centre[chosen[j]] for j in others], dtype=complex)
        f = np.array([self.spots[j].foot[chosen[j]] for j in others], dtype=complex)
        size = np.array([self.half[j] for j in others], dtype=complex)
        apart = mine - c
        dx = size.real + half.real + APART - np.abs(apart.real)
        dy = size.imag + half.imag + APART - np.abs(apart.imag)
        cost: Floats = np.where((dx > 0) & (dy > 0), OVERLAP + PER_AREA * dx * dy, 0.0)
        cost += np.where((dx <= 0) & (dx > APART - AS_ONE) & (dy > 0), MISREAD, 0.0)
        own, theirs = ~np.isnan(led[:, 0].real), ~np.isnan(f.real)
        cost[own] += LEADER_ON_LABEL * _struck(led[own], mine[own], c, size)
        cost[:, theirs] += LEADER_ON_LABEL * _struck(f[theirs], c[theirs], mine, half)
        return cost

    def trouble(self, i: int, chosen: list[int]) -> float:
        """What label i stands on, lines and other labels."""
        others, k = [j for j in range(len(chosen)) if j != i], chosen[i]
        return float(self.hard[i][k] + self.clashes(i, slice(k, k + 1), others, chosen).sum())

    def placed(self, i: int, chosen: list[int]) -> Placed:
        """Label i at its chosen place."""
        s, k = self.spots[i], chosen[i]
        foot = complex(s.foot[k])
        return Placed(self.wants[i], complex(s.centre[k]), self.trouble(i, chosen), None if foot != foot else foot)


def _price(want: Want, found: Spots, obstacles: Obstacles, frame: Rect | None, wanted: tuple[Want, ...]) -> Floats:
    cost = obstacles.cost(found.centre, want.width, want.height, want.own)
    cost += misled(want, wanted, found.centre, ~np.isnan(found.foot.real))
    led = np.flatnonzero(~np.isnan(found.foot.real))
    foot, c = found.foot[led], found.centre[led]
    w, h = want.width / 2 + 0.4, want.height / 2 + 0.4
    end = np.clip(foot.real, c.real - w, c.real + w) + 1j * np.clip(foot.imag, c.imag - h, c.imag + h)
    cost[led] += obstacles.crossings(foot, end, want.own)
    if frame is not None:
        cost += BEYOND_FRAME * _beyond(want, found, frame)
    return cost


def _beyond(want: Want, found: Spots, rect: Rect) -> Floats:
    """How far each place sticks out of a rectangle, mm."""
    x, y, w, h = found.centre.real, found.centre.imag, want.width / 2, want.height / 2
    sides = (rect.x0 - (x - w), x + w - rect.x1, rect.y0 - (y - h), y + h - rect.y1)
    total: Floats = np.sum([np.maximum(side, 0.0) for side in sides], axis=0)
    return total


def _struck(foot: Complexes, end: Complexes, centre: Complexes, half: Complexes | complex) -> Floats:
    """1 where a leader from foot to end runs through a label, else 0."""
    _, hit = clip(foot, end, centre, half.real + 0.4, half.imag + 0.4)
    return np.where(hit, 1.0, 0.0)
