"""Where the shafts of a reduced train stand on paper, which wheels they carry, and which way they turn, to no scale."""

from __future__ import annotations

from cmath import exp, pi
from collections.abc import Sequence

from ....devices.dynamics.reduced import ReducedTrain
from ....devices.dynamics.shafts import Pair
from ....foundation.slotted import dataclass, replace

APART = 1.35  # of the sum of its radii: how far the pulleys of a belt stand from each other
WAYS = (1 + 0j, 1j, -1j, -1 + 0j)  # the first wheel that a shaft drives stands on its right, the next above it ...
LETTER = 2.5  # mm: half a letter
ROUND = tuple(exp(2j * pi * n / 24) for n in (6, 7, 5, 8, 4, 18, 17, 19, 9, 3, *range(24)))  # above first, then below


@dataclass(frozen=True, slots=True, kw_only=True)
class Wheel:
    """A wheel on its shaft, its radius as drawn, whether a belt runs on it, its symbol and its size as given."""

    shaft: str
    radius: float
    belt: bool
    symbol: str
    given: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Shafts:
    """The centres of the shafts, their wheels, and +1 for each that turns as the main one does, −1 against it."""

    at: dict[str, complex]
    wheels: tuple[Wheel, ...]
    turns: dict[str, int]

    def on(self, shaft: str) -> tuple[float, ...]:
        """The radii of the wheels of a shaft."""
        return tuple(wheel.radius for wheel in self.wheels if wheel.shaft == shaft)

    @property
    def corners(self) -> tuple[complex, complex]:
        """Lower left and upper right of all wheels."""
        ends = [self.at[w.shaft] + side * w.radius for w in self.wheels for side in (-1 - 1j, 1 + 1j)]
        (x0, x1), (y0, y1) = ((min(part), max(part)) for part in ([z.real for z in ends], [z.imag for z in ends]))
        return complex(x0, y0), complex(x1, y1)

    def enlarged(self, mm: float) -> Shafts:
        """With so many mm for a unit."""
        wheels = tuple(replace(w, radius=w.radius * mm) for w in self.wheels)
        return replace(self, at={name: z * mm for name, z in self.at.items()}, wheels=wheels)

    def beside(self, wheel: Wheel, gap: float, taken: Sequence[complex] = ()) -> complex:
        """A place so far outside the rim, and outside the wheels of other shafts if there is one, where a letter is
        farthest from other rims and from what is taken."""
        centre = self.at[wheel.shaft]
        places = [(centre + (wheel.radius + gap) * u, u) for u in ROUND]
        others = [(self.at[w.shaft], w.radius) for w in self.wheels if w is not wheel]

        strange = [(self.at[w.shaft], w.radius) for w in self.wheels if w.shaft != wheel.shaft]

        def clear(place: complex, way: complex) -> tuple[bool, float]:
            letter = place + LETTER * way
            outside = all(abs(letter - c) > r for c, r in strange)
            gaps = [abs(abs(letter - c) - r) for c, r in others] + [abs(letter - one) for one in taken]
            return outside, round(min([*gaps, 3 * gap]), 6)

        return max(places, key=lambda one: clear(*one))[0]

    def free_side(self, shaft: str) -> complex:
        """The direction, of left, right and down, away from the neighbours."""
        here = self.at[shaft]
        towards = [(z - here) / abs(z - here) for name, z in self.at.items() if name != shaft and z != here]
        return min((-1 + 0j, 1 + 0j, -1j), key=lambda u: max((u.conjugate() * v).real for v in towards))


def placed(train: ReducedTrain) -> Shafts:
    """Every shaft beside the one that drives it: diameters of belts as so many teeth."""
    at: dict[str, complex] = {train.main: 0j}
    used: dict[str, int] = {}
    turns = {train.main: 1}
    wheels: list[Wheel] = []
    teeth = [sum(pair.sizes) for pair in train.pairs if not pair.belt]
    for name, way in sorted(train.ways.items(), key=lambda item: len(item[1])):
        if not way:
            continue
        pair, forwards = way[-1]
        here = pair.first if forwards else pair.second
        factor = (max(teeth) if teeth else 1.0) / sum(pair.sizes) if pair.belt else 1.0
        pairs = _wheels(train, pair, (here, name), factor)
        way_to = WAYS[min(used.get(here, 0), len(WAYS) - 1)]
        used[here] = used.get(here, 0) + 1
        at[name] = at[here] + way_to * sum(w.radius for w in pairs) * (APART if pair.belt else 1.0)
        turns[name] = turns[here] * (1 if pair.belt else -1)
        wheels += [wheel for wheel in pairs if wheel not in wheels]  # an idler meets two others
    return Shafts(at=at, wheels=tuple(wheels), turns=turns)


def _wheels(train: ReducedTrain, pair: Pair, ends: Sequence[str], factor: float) -> list[Wheel]:
    """The two wheels of a pair, on the one shaft and on the other."""
    one, other = ends
    texts = [text.strip() for text in pair.text.partition(" by ")[2].split("/")]
    both = list(zip(pair.sizes, texts, strict=True))[:: 1 if pair.first == one else -1]
    return [
        Wheel(shaft=shaft, radius=size * factor / 2, belt=pair.belt, symbol=train.wheel(pair, shaft, away), given=text)
        for shaft, away, (size, text) in zip((one, other), (other, one), both, strict=True)
    ]
