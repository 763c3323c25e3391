"""Lettering finds its places: each label moves about what it names until it stands on nothing; if it must
it goes farther off, on a leader. It never shrinks: one figure has one size of type."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from math import inf, isnan

from ...foundation.slotted import replace
from ..scene import Item, Layer, Rect, Stroke, TextBox
from ..style import THIN, Hue
from ..weighing.places import Row, cheapest, price_all
from ..weighing.prices import Around
from ..weighing.standing import AWAY, ROUNDING, Meeting, Pair, Standing
from .about.obstacles import Obstacles
from .spots import SHORT
from .want import Line, Piece, Spot, Want

BAD = 38.0  # a label that costs more than this by where it stands is on something
PASSES = 8
DEAR, GAIN = 24.0, 6.0  # what a label costs that fares badly; what must be won for others to move
TRIED, FEW = 6, 2  # places that it tries; others that may have to move for one
NOBODY = -2  # the number of no place
MANY = 0.2  # of all labels: where more are in trouble, all that are near go farther off at once
CROWDS = (0.0, 12.0, 25.0, 40.0)  # mm about a label in trouble within which labels may go farther off, if need be


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
        end = _nearest(self.foot, rect.grown(SHORT))
        return (Stroke(points=(self.foot, end), width=THIN, hue=Hue.GREY, layer=Layer.TEXT, step=step), *text)


def _text(piece: Piece, x: float, y: float) -> TextBox:
    return TextBox(box=piece.box, x=x + piece.dx, y=y, hue=piece.hue, step=piece.step)


def _nearest(point: complex, rect: Rect) -> complex:
    return complex(min(max(point.real, rect.x0), rect.x1), min(max(point.imag, rect.y0), rect.y1))


def place(
    wanted: tuple[Want, ...],
    obstacles: Obstacles,
    drawn: Rect,
    frame: Rect | None = None,
    unnamed: tuple[Spot, ...] = (),
    grounds: tuple[Line, ...] = (),
) -> tuple[Placed, ...]:
    """A place for each label; the same input always gives the same places."""
    table = _Table.of(Around(obstacles, wanted, drawn, frame, unnamed, grounds))
    for around in CROWDS:
        crowded, reach = table.crowded(table.settled), CROWDS[-1]
        if len(crowded) <= MANY * len(wanted):  # else there is no room to be made
            crowded = table.crowded(table.standing)
            reach = CROWDS[-1] if len(crowded) > MANY * len(wanted) else around
        if not crowded:
            break
        sooner = {i for i in range(len(wanted)) if any(table.near(i, k) <= reach for k in crowded)}
        if any(not table.around.wanted[i].farther for i in sooner):
            table = table.eased(sooner)
    return tuple(table.placed(i) for i in range(len(wanted)))


@dataclass(frozen=True, eq=False)
class _Table:
    """All candidate places of all labels, and which of them they choose."""

    around: Around
    rows: tuple[Row, ...]
    meetings: dict[tuple[int, int, int], Meeting] = field(default_factory=dict)
    pairs: dict[Pair, float] = field(default_factory=dict)  # what two labels cost each other

    @classmethod
    def of(cls, around: Around) -> _Table:
        """The places of every label."""
        return cls(around, tuple(Row.of(want, around) for want in around.wanted))

    def eased(self, crowded: set[int]) -> _Table:
        """With some of the labels on longer leaders; what the places of the others cost is known."""
        wanted = tuple(
            replace(want, farther=True) if i in crowded and not want.farther else want
            for i, want in enumerate(self.around.wanted)
        )
        around = replace(self.around, wanted=wanted)
        pairs = zip(wanted, self.rows, strict=True)
        rows = tuple(row if want is row.want else row.eased(want, around) for want, row in pairs)
        known = {(i, k): part for i, row in enumerate(self.rows) for k, part in enumerate(row.parts)}
        kept = {key: one.again() for key, one in self.meetings.items() if rows[key[0]].parts[key[1]] is known[key[:2]]}
        return _Table(around, rows, kept, self.pairs)

    def crowded(self, standing: Standing) -> list[int]:
        """The labels that are on something where they stand."""
        return [i for i in range(len(self.rows)) if self._trouble(i, standing) > BAD]

    def near(self, i: int, k: int) -> float:
        """How far apart the middles of two labels stand."""
        one, other = self.settled.stood[i], self.settled.stood[k]
        return inf if one is None or other is None else abs(one.centre - other.centre)

    def _meeting(self, i: int, k: int, n: int, standing: Standing) -> Meeting:
        """What the others cost label i at a batch of its places beside what it names (k = 0), or on leaders."""
        if (meeting := self.meetings.get((i, k, n))) is None:
            batch = self.rows[i].parts[k].batches[n]
            meeting = Meeting(batch.trial, batch.numbers, i, len(self.rows), self.pairs)
            self.meetings[i, k, n] = meeting
        meeting.look(standing)
        return meeting

    def _met(self, i: int, standing: Standing) -> float:
        """What the others cost label i where it stands."""
        k, n, place = self.rows[i].where(standing.chosen[i])
        return self._meeting(i, k, n, standing).at(place, standing)

    @cached_property
    def standing(self) -> Standing:
        """Those that fared badly have made room for each other."""
        self._make_room(self.settled)
        return self.settled

    @cached_property
    def settled(self) -> Standing:
        """The most constrained label chooses first; then each reconsiders until none moves."""
        standing = Standing.nowhere(len(self.rows))
        price_all(self.rows)
        freedom = [row.freedom for row in self.rows]
        order = sorted(range(len(self.rows)), key=lambda i: (freedom[i], i))
        for _ in range(PASSES):
            before = [*standing.chosen]
            for i in order:
                self._choose(i, standing)
            if standing.chosen == before:
                break
        return standing

    def _make_room(self, standing: Standing) -> None:
        """A label that fares badly takes a place where another stands, if that one finds a place for less than is
        won."""
        for i, row in enumerate(self.rows):
            now = self._cost(i, standing)
            if now < DEAR:
                continue
            for parts in ((row.near,), row.led):
                better = cheapest(parts, now - GAIN, TRIED)
                if any(self._makes_room(i, number, now, standing) for number in better):
                    break

    def _makes_room(self, i: int, number: int, now: float, standing: Standing) -> bool:
        """Whether label i stands better at this place together with those that have to move; if not they stay."""
        k, n, place = self.rows[i].where(number)
        others = self._meeting(i, k, n, standing).whom(place, standing)
        if not 0 < len(others) <= FEW:
            return False
        before = now + sum(self._cost(k, standing) for k in others)
        stood = {k: standing.chosen[k] for k in (i, *others)}
        self._put(i, number, standing)
        there = self._moved_on(others, before - GAIN - self._bare(i, standing), standing)
        if there and sum(self._cost(k, standing) for k in stood) < before - GAIN:
            return True
        for k, old in stood.items():
            self._put(k, old, standing)
        return False

    def _moved_on(self, others: Sequence[int], below: float, standing: Standing) -> bool:
        """Let these choose again one after the other; false as soon as they cannot cost less than this together."""
        for k in others:
            if not self._choose(k, standing, below if k == others[-1] else inf):
                return False
            below -= self._bare(k, standing)
        return True

    def _bare(self, i: int, standing: Standing) -> float:
        """What label i costs where it stands, by itself."""
        k, n, place = self.rows[i].where(standing.chosen[i])
        return float(self.rows[i].parts[k].batches[n].total[place])

    def _cost(self, i: int, standing: Standing) -> float:
        """What label i costs where it stands, the others included."""
        return self._bare(i, standing) + self._met(i, standing)

    def _choose(self, i: int, standing: Standing, below: float = inf) -> bool:
        """Label i takes its cheapest place among the others where they are, of equal ones the first; whether it costs
        less than this there."""
        now = standing.chosen[i]
        best = (inf, now) if now == AWAY else (self._cost(i, standing), now)
        best = min(best, (below + ROUNDING, NOBODY))
        for k, part in enumerate(self.rows[i].parts):
            if part.above(best[0] + ROUNDING):
                continue
            for n, batch in enumerate(part.batches):
                if batch.least > best[0]:
                    break
                best = self._meeting(i, k, n, standing).cheapest(batch.total, best, standing)
        if best[1] not in (now, NOBODY):
            self._put(i, best[1], standing)
        return best[1] != NOBODY

    def _put(self, i: int, number: int, standing: Standing) -> None:
        k, n, place = self.rows[i].where(number)
        standing.put(i, number, self.rows[i].parts[k].batches[n].trial.one(place))

    def _trouble(self, i: int, standing: Standing) -> float:
        """What a label stands on, lines and other labels."""
        part, at = self.rows[i].of_number(standing.chosen[i])
        return float(part.hard[at]) + self._met(i, standing)

    def placed(self, i: int) -> Placed:
        """Label i at its chosen place."""
        part, at = self.rows[i].of_number(self.standing.chosen[i])
        foot = complex(part.spots.foot[at])
        cost = self._trouble(i, self.standing)
        return Placed(self.around.wanted[i], complex(part.spots.centre[at]), cost, None if isnan(foot.real) else foot)
