"""Lettering finds its places:
each label moves about what it names until it stands on nothing, and shrinks only if it must."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..scene import Item, Layer, Rect, Stroke, TextBox
from ..style import THIN, Hue
from .obstacles import Complexes, Floats, Indices, Obstacles, clip
from .rivals import misled
from .spots import Spots, spots
from .wants import Piece, Want, smaller

APART = 0.7  # mm between two labels
AS_ONE, MISREAD = 1.8, 9.0  # mm side by side below which two labels are read as one, and what that costs
OVERLAP, PER_AREA = 120.0, 8.0
LEADER_ON_LABEL = 60.0
OUTSIDE, BEYOND_FRAME = 0.25, 60.0  # a mm beyond the drawn lines, beyond the allowed frame
BAD = 38.0  # a label that costs more than this by where it stands is on something
SHRINK = (0.85, 0.72)
PASSES = 8
AT_ONCE = 24  # places weighed against the other labels in one go


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
        table = _Table.of(tight, obstacles, drawn, frame, table)
    else:
        chosen = table.solve()
    return tuple(table.placed(i, chosen) for i in range(len(wanted)))


@dataclass(frozen=True, slots=True)
class _Row:
    """The candidate places of one label."""

    spots: Spots
    half: complex  # half the width and height of the label
    hard: Floats  # what a place stands on
    total: Floats  # with preference


@dataclass(frozen=True, slots=True)
class _Table:
    """All candidate places of all labels with what each costs by itself."""

    wants: tuple[Want, ...]
    rows: tuple[_Row, ...]
    near: tuple[tuple[int, ...], ...]  # of each label the others that it can meet

    @classmethod
    def of(
        cls,
        wanted: tuple[Want, ...],
        obstacles: Obstacles,
        drawn: Rect,
        frame: Rect | None,
        before: _Table | None = None,
    ) -> _Table:
        """Every label's candidates, priced against the lines of the figure;
        those of a label that is as `before` are known."""
        known = (
            {} if before is None else {i: before.rows[i] for i, want in enumerate(wanted) if want is before.wants[i]}
        )
        rows = tuple(known.get(i) or _row(want, obstacles, drawn, frame, wanted) for i, want in enumerate(wanted))
        return cls(wanted, rows, _neighbours(rows))

    def solve(self) -> list[int]:
        """The most constrained label chooses first; then each reconsiders until none moves."""
        n = len(self.wants)
        chosen = [-1] * n
        seen: list[list[int]] = [[] for _ in range(n)]  # of each label, where its neighbours stood when it last chose
        freedom = [int((row.total < row.total.min() + 6.0).sum()) for row in self.rows]
        order = sorted(range(n), key=lambda i: (freedom[i], i))
        for _ in range(PASSES):
            before = list(chosen)
            for i in order:
                around = [chosen[j] for j in self.near[i]]
                if chosen[i] < 0 or around != seen[i]:
                    chosen[i], seen[i] = self._best(i, chosen), around
            if chosen == before:
                break
        return chosen

    def _best(self, i: int, chosen: list[int]) -> int:
        """The cheapest place of label i among the others where they are;
        dearer places are not weighed against them at all."""
        total, others = self.rows[i].total, [j for j in self.near[i] if chosen[j] >= 0]
        ranked, best, least = np.argsort(total, kind="stable"), -1, np.inf
        for start in range(0, len(ranked), AT_ONCE):
            some = ranked[start : start + AT_ONCE]
            if total[some[0]] > least:
                break
            cost = total[some] + self.clashes(i, some, others, chosen).sum(axis=1)
            found = int(some[cost == cost.min()].min())
            if (cost.min(), found) < (least, best):
                best, least = found, float(cost.min())
        return best

    def clashes(self, i: int, which: Indices, others: Sequence[int], chosen: list[int]) -> Floats:
        """What some places of label i cost for each of the other labels where it is now; shape (places, others)."""
        here, half = self.rows[i].spots, self.rows[i].half
        mine, led = here.centre[which, None], here.foot[which, None]
        c = np.array([self.rows[j].spots.centre[chosen[j]] for j in others], dtype=complex)
        f = np.array([self.rows[j].spots.foot[chosen[j]] for j in others], dtype=complex)
        size = np.array([self.rows[j].half for j in others], dtype=complex)
        apart = mine - c
        dx = size.real + half.real + APART - np.abs(apart.real)
        dy = size.imag + half.imag + APART - np.abs(apart.imag)
        cost: Floats = np.where((dx > 0) & (dy > 0), OVERLAP + PER_AREA * dx * dy, 0.0)
        cost += np.where((dx <= 0) & (dx > APART - AS_ONE) & (dy > 0), MISREAD, 0.0)
        own, theirs = ~np.isnan(led[:, 0].real), ~np.isnan(f.real)
        if own.any():
            cost[own] += LEADER_ON_LABEL * _struck(led[own], mine[own], c, size)
        if theirs.any():
            cost[:, theirs] += LEADER_ON_LABEL * _struck(f[theirs], c[theirs], mine, half)
        return cost

    def trouble(self, i: int, chosen: list[int]) -> float:
        """What label i stands on, lines and other labels."""
        k = chosen[i]
        return float(self.rows[i].hard[k] + self.clashes(i, np.array([k]), self.near[i], chosen).sum())

    def placed(self, i: int, chosen: list[int]) -> Placed:
        """Label i at its chosen place."""
        s, k = self.rows[i].spots, chosen[i]
        foot = complex(s.foot[k])
        return Placed(self.wants[i], complex(s.centre[k]), self.trouble(i, chosen), None if foot != foot else foot)


def _row(want: Want, obstacles: Obstacles, drawn: Rect, frame: Rect | None, wanted: tuple[Want, ...]) -> _Row:
    found = spots(want, drawn.centre)
    hard = _price(want, found, obstacles, frame, wanted)
    return _Row(
        found, complex(want.width / 2, want.height / 2), hard, hard + found.cost + OUTSIDE * _beyond(want, found, drawn)
    )


def _neighbours(rows: Sequence[_Row]) -> tuple[tuple[int, ...], ...]:
    """Of each label the others that any of its places, or their leaders, can meet."""
    reach = [_reach(row) for row in rows]
    x0, y0, x1, y1 = (np.array(side) for side in zip(*reach, strict=True)) if reach else (np.zeros(0),) * 4
    meets = (x0[:, None] <= x1) & (x1[:, None] >= x0) & (y0[:, None] <= y1) & (y1[:, None] >= y0)
    return tuple(tuple(int(j) for j in np.flatnonzero(row) if j != i) for i, row in enumerate(meets))


def _reach(row: _Row) -> tuple[float, float, float, float]:
    """The rectangle about all places of a label, with their leaders and half the room to keep."""
    foot = row.spots.foot[~np.isnan(row.spots.foot.real)]
    x, y = np.append(row.spots.centre.real, foot.real), np.append(row.spots.centre.imag, foot.imag)
    w, h = row.half.real + AS_ONE, row.half.imag + AS_ONE
    return float(x.min()) - w, float(y.min()) - h, float(x.max()) + w, float(y.max()) + h


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
