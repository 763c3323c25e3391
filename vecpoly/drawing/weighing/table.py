"""All labels of a figure with all their places, and which they choose among each other."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from math import inf, isnan

from ..labels.about.bounds import Floats
from .placed import BAD, Placed
from .places import Batch, Row, cheapest, price_all
from .prices import Around
from .standing import AWAY, ROUNDING, Meeting, Pair, Standing

PASSES = 8
DEAR, GAIN = 24.0, 6.0  # what a label costs that fares badly; what must be won for others to move
TRIED, FEW = 6, 2  # places that it tries; others that may have to move for one
NOBODY = -2  # the number of no place
MANY = 0.2  # of all labels: where more are in trouble, there is no room to be made


@dataclass(frozen=True, eq=False)
class Table:
    """All candidate places of some labels, by the number of the label, and which of them they choose.

    pairs, met: what has been found out so far of what labels cost each other: two of them, or all places of a batch."""

    around: Around
    rows: Mapping[int, Row]
    pairs: dict[Pair, float] = field(default_factory=dict)
    met: dict[Batch, dict[tuple[int, int], Floats | None]] = field(default_factory=dict)
    meetings: dict[Batch, Meeting] = field(default_factory=dict)

    @classmethod
    def of(cls, around: Around) -> Table:
        """The places of every label."""
        return cls(around, {i: Row.of(want, around) for i, want in enumerate(around.wanted)})

    def eased(self, crowded: Collection[int]) -> Table:
        """With some of the labels on longer leaders; what the places of the others cost is known."""
        rows = {i: row.eased() if i in crowded and not row.want.farther else row for i, row in self.rows.items()}
        return Table(self.around, rows, self.pairs, self.met)

    def without(self, left_out: Collection[int], brief: Collection[int]) -> Table:
        """Without some of the labels, and with others that say less; what has lost its name can still be taken for what
        others name."""
        rows = {i: row for i, row in self.rows.items() if i not in left_out}
        if not brief:
            return Table(self.around, rows, self.pairs, self.met)
        return Table(self.around, rows | {i: Row.of(rows[i].want.in_brief, self.around) for i in brief})

    def crowded(self, standing: Standing) -> list[int]:
        """The labels that are on something where they stand."""
        return [i for i in self.rows if self._trouble(i, standing) > BAD]

    def about(self, crowded: Collection[int], reach: float) -> set[int]:
        """The labels whose middles stand no farther than this from that of one of these."""
        stood = self.settled.stood
        at = {i: one.centre for i in self.rows if (one := stood[i]) is not None}
        return {i for i, here in at.items() if any(abs(here - at[k]) <= reach for k in crowded)}

    def _meeting(self, i: int, batch: Batch, standing: Standing) -> Meeting:
        """What the others cost label i at a batch of its places."""
        if (meeting := self.meetings.get(batch)) is None:
            met, count = self.met.setdefault(batch, {}), len(self.around.wanted)
            meeting = self.meetings[batch] = Meeting(batch.trial, batch.numbers, i, count, self.pairs, met)
        meeting.look(standing)
        return meeting

    def _met(self, i: int, standing: Standing) -> float:
        """What the others cost label i where it stands."""
        batch, place = self.rows[i].where(standing.chosen[i])
        return self._meeting(i, batch, standing).at(place, standing)

    @cached_property
    def tried(self) -> Standing:
        """Those that fare badly have made room for each other, unless so many do that there is no room to be made."""
        return self.settled if len(self.crowded(self.settled)) > MANY * len(self.rows) else self.standing

    @cached_property
    def standing(self) -> Standing:
        """Those that fared badly have made room for each other."""
        self._make_room(self.settled)
        return self.settled

    @cached_property
    def settled(self) -> Standing:
        """The most constrained label chooses first; then each reconsiders until none moves."""
        standing, rows = Standing.nowhere(len(self.around.wanted)), self.rows
        price_all([*rows.values()])
        order = sorted(rows, key=lambda i: (rows[i].freedom, i))
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
        for i, row in self.rows.items():
            now = self._cost(i, standing)
            if now < DEAR:
                continue
            for parts in ((row.near,), row.led):
                better = cheapest(parts, now - GAIN, TRIED)
                if any(self._makes_room(i, number, now, standing) for number in better):
                    break

    def _makes_room(self, i: int, number: int, now: float, standing: Standing) -> bool:
        """Whether label i stands better at this place together with those that have to move; if not they stay."""
        batch, place = self.rows[i].where(number)
        others = self._meeting(i, batch, standing).whom(place, standing)
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
        batch, place = self.rows[i].where(standing.chosen[i])
        return float(batch.total[place])

    def _cost(self, i: int, standing: Standing) -> float:
        """What label i costs where it stands, the others included."""
        return self._bare(i, standing) + self._met(i, standing)

    def _choose(self, i: int, standing: Standing, below: float = inf) -> bool:
        """Label i takes its cheapest place among the others where they are, of equal ones the first; whether it costs
        less than this there."""
        now = standing.chosen[i]
        best = (inf, now) if now == AWAY else (self._cost(i, standing), now)
        best = min(best, (below + ROUNDING, NOBODY))
        for part in self.rows[i].parts:
            if part.above(best[0] + ROUNDING):
                continue
            for batch in part.batches:
                if batch.least > best[0]:
                    break
                best = self._meeting(i, batch, standing).cheapest(batch.total, best, standing)
        if best[1] not in (now, NOBODY):
            self._put(i, best[1], standing)
        return best[1] != NOBODY

    def _put(self, i: int, number: int, standing: Standing) -> None:
        batch, place = self.rows[i].where(number)
        standing.put(i, number, batch.trial.one(place))

    def _trouble(self, i: int, standing: Standing) -> float:
        """What a label stands on, lines and other labels."""
        part, at = self.rows[i].of_number(standing.chosen[i])
        return float(part.hard[at]) + self._met(i, standing)

    def placed(self, standing: Standing) -> dict[int, Placed]:
        """Each label at its chosen place."""
        return {i: self._placed(i, standing) for i in self.rows}

    def _placed(self, i: int, standing: Standing) -> Placed:
        part, at = self.rows[i].of_number(standing.chosen[i])
        foot, cost = complex(part.spots.foot[at]), self._trouble(i, standing)
        return Placed(self.rows[i].want, complex(part.spots.centre[at]), cost, None if isnan(foot.real) else foot)
