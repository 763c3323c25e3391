"""Letters that follow a moving figure: each keeps its place beside what it names,
and looks for another only where it would stand on something."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ...board.construction import Figure
from ...words import Lang
from ..beside import beside
from ..figure import unique
from ..prices import priced
from ..scene import Item, Rect, Scene
from ..symbols.marks import Surroundings, draw
from .ground import broken
from .obstacles import Floats, Obstacles
from .placing import BAD, Placed, place
from .spots import spot, spots
from .want import Want, resized
from .wants import wants

APART, BESIDE = 0.9, 1.5  # mm between two labels one over the other, and side by side
CLASH = 200.0  # what standing on another label costs

Name = tuple[object, ...]


@dataclass(slots=True)
class Follower:
    """The lettering of one figure from position to position."""

    lang: Lang
    size: float = 1.0  # of the letters, beside that on paper
    choice: dict[Name, int] = field(default_factory=dict)  # which of its places each label has

    def lettered(self, figure: Figure) -> tuple[Item, ...]:
        """All items of the figure with its letters in place, without its title."""
        marks = beside(figure.view, figure.marks)
        around = Surroundings.of(figure.view, marks, self.lang, figure.tones)
        items = unique(tuple(item for mark in marks for item in draw(mark, around)))
        drawn, obstacles = Scene.of(items).extents, Obstacles.of(items)
        sought = wants(figure.view, marks, self.lang, figure.tones)
        named = _named(tuple(resized(want, self.size) for want in sought))
        placed = self._follow(named, obstacles, drawn) if self.choice else self._first(named, obstacles, drawn)
        ground = broken(items, [label.rect for label in placed])
        return ground + tuple(item for label in placed for item in label.items())

    def _first(self, named: list[tuple[Name, Want]], obstacles: Obstacles, drawn: Rect) -> list[Placed]:
        """Placed all together, as on paper."""
        placed = place(tuple(want for _, want in named), obstacles, drawn)
        found: list[Placed] = []
        for (name, want), label in zip(named, placed, strict=True):
            at = self.choice[name] = int(np.argmin(np.abs(spots(label.want, drawn.centre).centre - label.centre)))
            found.append(_at(want, at) or label)
        return found

    def _follow(self, named: list[tuple[Name, Want]], obstacles: Obstacles, drawn: Rect) -> list[Placed]:
        """Those that may stay first, then the others round them."""
        kept: dict[Name, Placed] = {}
        stayed = [
            (name, label) for name, want in named if name in self.choice and (label := _at(want, self.choice[name]))
        ]
        for (name, label), cost in zip(stayed, _costs([label for _, label in stayed], obstacles), strict=True):
            if cost < BAD and not any(_touch(label, other) for other in kept.values()):
                kept[name] = label
        for name, want in named:
            if name not in kept:
                kept[name] = self._moved(name, want, obstacles, drawn, list(kept.values()))
        return [kept[name] for name, _ in named]

    def _moved(self, name: Name, want: Want, obstacles: Obstacles, drawn: Rect, others: list[Placed]) -> Placed:
        """The cheapest place among lines and the letters that stand already."""
        found = spots(want, drawn.centre)
        cost = priced(obstacles, [(want, found.centre)])[0] + found.cost
        for other in others:
            gap = found.centre - other.centre
            w, h = (want.width + other.want.width) / 2 + BESIDE, (want.height + other.want.height) / 2 + APART
            cost = cost + np.where((np.abs(gap.real) < w) & (np.abs(gap.imag) < h), CLASH, 0.0)
        best = int(np.argmin(cost))
        self.choice[name] = best
        label = _at(want, best)
        assert label is not None
        return label


def _named(wanted: tuple[Want, ...]) -> list[tuple[Name, Want]]:
    """Each label with its name: its type, and which of several of that type it is."""
    seen: dict[Name, int] = {}
    out: list[tuple[Name, Want]] = []
    for want in wanted:
        text: Name = tuple(piece.box for piece in want.pieces)
        seen[text] = seen.get(text, 0) + 1
        out.append(((*text, seen[text]), want))
    return out


def _at(want: Want, index: int) -> Placed | None:
    """The label at one of its places; none where it has not so many."""
    found = spot(want, index)
    return None if found is None else Placed(want, found[0], 0.0, found[1])


def _costs(labels: list[Placed], obstacles: Obstacles) -> Floats:
    """What each label stands on."""
    own = np.array([label.want.own for label in labels], dtype=complex).reshape(-1, 2)
    sizes = np.array([(label.want.width, label.want.height) for label in labels]).reshape(-1, 2)
    at = np.array([label.centre for label in labels], dtype=complex)
    return obstacles.cost(at, sizes[:, 0], sizes[:, 1], (own[:, 0], own[:, 1]), [slice(0, len(at))])


def _touch(a: Placed, b: Placed) -> bool:
    gap, w, h = a.centre - b.centre, a.want.width + b.want.width, a.want.height + b.want.height
    return abs(gap.real) < w / 2 + BESIDE and abs(gap.imag) < h / 2 + APART
