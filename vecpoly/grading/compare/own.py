"""Follow-through: what follows from somebody's own earlier values, for one step at a time."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import hypot, isclose
from typing import Any

import numpy as np

from ...answer import bearing
from ...board.otherwise.amended import Amended, Own, plain_letters
from ...errors import VecpolyError
from ...foundation.frozen import FrozenMap
from ...foundation.slotted import replace
from ...problem.problem import Problem
from ..key import AnswerKey, Graded, Kind, spot_letters
from ..redraw import by_hands
from ..rules import Rules
from .band import Target, is_other_sense
from .measured import Measured, UnitFault
from .ways import ways

DIAGRAM_SCALE = "mu_l"


@dataclass(frozen=True, slots=True, kw_only=True)
class Followed:
    """What follows for one quantity: `target` from its nearest own values, None where no figure closes; `deep` from all
    own values below it, which turn its direction too; `otherwise` by another way. sources: the nearest own values;
    below: all of them.
    """

    target: Target | None
    sources: tuple[str, ...]
    below: tuple[str, ...] = ()
    deep: Target | None = None
    otherwise: Target | None = None


@dataclass(slots=True)
class Inputs:
    """The own values that one step goes on with."""

    readings: dict[str, float] = field(default_factory=dict)
    values: dict[str, float] = field(default_factory=dict)
    shifts: dict[str, complex] = field(default_factory=dict)
    sources: list[str] = field(default_factory=list)

    def frozen(self) -> Own:
        """As the construction takes them."""
        return Own(readings=FrozenMap(self.readings), values=FrozenMap(self.values), shifts=FrozenMap(self.shifts))


@dataclass(frozen=True, slots=True, kw_only=True)
class Follower:
    """A problem with its key, and what somebody wrote of it (in the key's units, at the key's scales)."""

    problem: Problem
    key: AnswerKey
    given: Mapping[str, Measured]
    rules: Rules
    trusted: frozenset[str] = frozenset()  # right by own values, however far from the exact ones

    def follow(self, steps: Sequence[Graded]) -> dict[str, Followed]:
        """For each step that rests on an own value that can be used: what follows from it; all in one drawing."""
        if not self.rules.following or any(first not in self.given for first in self.rules.first):
            return {}
        return self._otherwise(steps, self._drawn(steps))

    def _otherwise(self, steps: Sequence[Graded], drawn: dict[str, Followed]) -> dict[str, Followed]:
        """With what follows by other ways than that of the drawing."""
        for one in steps:
            for way in ways(self.problem, one):
                source = self.key.find(way.source)
                if source is None or not self.usable(source) or self.key.below(source) & {one.key, one.line}:
                    continue  # what was found from this very quantity tells nothing of it
                mine = self.given[way.source]
                size = way.of(abs(mine.value))
                turned = 180.0 if is_other_sense(mine, source) else 0.0
                degrees = None if one.degrees is None else one.degrees + turned
                target = Target(value=size, allowed=self.allowed(one, size), degrees=degrees)
                so_far = drawn.get(one.key) or Followed(target=target, sources=())
                drawn[one.key] = replace(so_far, otherwise=target, sources=(*so_far.sources, way.source))
        return drawn

    def _drawn(self, steps: Sequence[Graded]) -> dict[str, Followed]:
        near = {one.key: self.inputs(one, deep=False) for one in steps}
        chosen = [one for one in steps if near[one.key].sources]
        if not chosen:
            return {}
        deep = {one.key: self.inputs(one, deep=True) for one in chosen}
        own = tuple(inputs[one.key].frozen() for inputs in (near, deep) for one in chosen)
        try:
            found = by_hands(self.problem, self.key, Amended(own=own))
        except VecpolyError:
            return {one.key: Followed(target=None, sources=tuple(near[one.key].sources)) for one in chosen}
        return {
            one.key: Followed(
                target=self._target(one, found[one.key][i]),
                deep=self._target(one, found[one.key][i + len(chosen)]),
                sources=tuple(near[one.key].sources),
                below=tuple(deep[one.key].sources),
            )
            for i, one in enumerate(chosen)
            if one.key in found
        }

    def usable(self, one: Graded) -> bool:
        """Whether an own value may be continued from: there, not zero, of its dimension, within reach of the exact
        one.
        """
        mine = self.given.get(one.key)
        if mine is None or mine.fault is UnitFault.DIMENSION or one.key in self.rules.independent:
            return False
        if one.kind is Kind.PLACE:
            return self._within_reach(one, mine)
        if not mine.value or not one.exact or one.kind is Kind.YES_NO:
            return False
        return one.key in self.trusted or 1 / self.rules.reach <= abs(mine.value / one.exact) <= self.rules.reach

    def _within_reach(self, one: Graded, mine: Measured) -> bool:
        """Whether an own place may be continued from: on a diagram to scale, no farther off than places lie apart."""
        if mine.at is None or one.at is None or DIAGRAM_SCALE not in self.key.scales:
            return False
        widest = max(abs(other.exact) for other in self.key.quantities if other.kind is Kind.PLACE)
        return hypot(mine.at[0] - one.at[0], mine.at[1] - one.at[1]) <= self.rules.reach * widest

    def refused(self, one: Graded) -> tuple[str, ...]:
        """The own values below a step that are there and may not be continued from."""
        return tuple(name for name in one.needs if name in self.given and not self.usable(self.key[name]))

    def inputs(self, step: Graded, *, deep: bool = False) -> Inputs:
        """The own values that a step goes on with: the nearest, or all below it."""
        found = Inputs()
        self._collect(step.needs, found, {step.key}, deep)
        return found

    def _collect(self, needs: Sequence[str], found: Inputs, seen: set[str], deep: bool) -> None:
        """Own values of the needs; of those that were not written, or of all where `deep`, the own values below
        them."""
        for name in needs:
            if name in seen:
                continue
            seen.add(name)
            one, stands_for = self.key[name], self._standing_for(name, seen)
            if self.usable(one):
                self._take(one, one.key, found)
            elif stands_for is not None:
                self._take(one, stands_for.key, found)
            elif name in self.given or name in self.rules.independent:
                continue
            if deep or not (self.usable(one) or stands_for):
                self._collect(one.needs, found, seen, deep)

    def _standing_for(self, name: str, seen: set[str]) -> Graded | None:
        """The value that was written in place of another: v_C for pc, ω_3 for the ω_2 that it is equal to; of several
        found from it the first."""
        if name in self.given:
            return None
        of = self.key[name]
        if of.kind is Kind.READING and of.mu not in self.key.scales:
            return None
        found = [one for one in self.key.quantities if _tells(one, of, self.key.scales) and self.usable(one)]
        return found[0] if found and found[0].key not in seen else None

    def _take(self, one: Graded, source: str, found: Inputs) -> None:
        """The own value of a quantity, as it was written or as another tells it."""
        mine = self.given[source]
        if one.kind is Kind.PLACE and mine.at is not None and one.at is not None:
            off = complex(mine.at[0] - one.at[0], mine.at[1] - one.at[1])
            found.shifts[spot_letters(one.key)] = off / self.key.scales[DIAGRAM_SCALE]
        elif one.kind is Kind.READING:
            found.readings[one.letters] = abs(mine.value) / (1.0 if source == one.key else self.key.scales[one.mu])
        else:
            own = -abs(mine.value) if is_other_sense(mine, one) else abs(mine.value)
            found.values |= {one.key: own, plain_letters(one.symbol): own}  # what is computed of θ has no other key
        found.sources.append(source)

    def _target(self, one: Graded, found: Any) -> Target | None:
        if not np.isfinite(found):
            return None
        if one.kind is Kind.PLACE:
            return self._place(one, found)
        size = float(abs(found)) if one.kind in (Kind.VECTOR, Kind.READING) else float(np.real(found))
        direction = bearing(complex(found)) if one.kind is Kind.VECTOR and np.iscomplexobj(found) and found else None
        mm = one.mm * abs(size / one.exact) if one.mm and one.exact else None
        return Target(value=size, allowed=self.allowed(one, size), degrees=direction, mm=mm)

    def _place(self, one: Graded, found: Any) -> Target | None:
        """A place, within what the lines drawn in this step scatter by."""
        if not np.iscomplexobj(found):
            return None
        return Target(value=float(abs(found)), allowed=one.allowed, at=(float(found.real), float(found.imag)))

    def allowed(self, one: Graded, size: float) -> float:
        """No error of the construction, but of reading and reckoning; a length, of the lines drawn in this step."""
        rule, short = self.key.allowance, self._shortest(one)
        if one.kind is Kind.READING:
            return max(one.allowed, rule.floor)
        reckoned = min(rule.arithmetic, one.allowed / abs(one.exact)) if one.exact else rule.arithmetic
        return abs(size) * max(reckoned, rule.reading / short if short else 0.0)

    def _shortest(self, one: Graded) -> float | None:
        """The shortest length that a value is computed from (mm)."""
        lengths = [self.key[name].exact for name in one.needs if self.key[name].kind is Kind.READING]
        return min(lengths, default=None)


def _tells(one: Graded, of: Graded, scales: Mapping[str, float]) -> bool:
    """Whether a value tells another that was not written down: what a length stands for by its scale, vector or not, or
    what is equal to it alone."""
    if of.kind is Kind.READING:
        return one.line == of.key and (one.kind is Kind.VECTOR or isclose(abs(one.exact), of.exact * scales[of.mu]))
    return one.needs == (of.key,) and (one.kind, one.unit) == (of.kind, of.unit) and isclose(one.exact, of.exact)
