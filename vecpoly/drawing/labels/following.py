"""Letters that follow a moving figure: each keeps its place beside what it names,
and looks for another only where it would stand on something."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from math import inf

import numpy as np

from ...board.construction import Figure
from ...board.paper.marks import Ground
from ...words import Lang
from ..figure import Bare, Drawing, drawing
from ..hung import hung
from ..scene import Item
from ..weighing.placed import BAD, Placed
from ..weighing.places import Places, Row
from ..weighing.prices import Around
from ..widened import Widths, widened
from .about.bounds import Floats
from .about.obstacles import Obstacles
from .ground import broken
from .rivals import Named, misled_here
from .spots import spot, spots
from .want import BREAKING, Want, resized

APART, BESIDE = 0.9, 1.5  # mm between two labels one over the other, and side by side
CLASH = 200.0  # what standing on another label costs

Name = tuple[str, int]  # what a label says, and which of several it is that say so


@dataclass(slots=True)
class Follower:
    """The lettering of one figure from position to position; at the first of them it stands as on paper."""

    lang: Lang
    size: float = 1.0  # of the letters, beside that on paper
    choice: dict[Name, int] = field(default_factory=dict)  # which of its places each label has
    supports: tuple[Ground, ...] = ()  # as they stand at the first position
    widths: Widths = ()  # with which angles are marked otherwise than in the figure

    def again(self) -> Follower:
        """Another that goes on from where these letters and supports stand."""
        return Follower(self.lang, self.size, dict(self.choice), self.supports, self.widths)

    def lettered(self, figure: Figure) -> tuple[Item, ...]:
        """All items of the figure with its letters in place, without its title."""
        if not self.choice:
            paper = drawing(figure, lang=self.lang)
            self.choice, self.widths = _chosen(paper), paper.widths
            self.supports = tuple(mark for mark in hung(figure.marks) if isinstance(mark, Ground))
            if self.size == 1.0:
                return _together(paper.obstacles, paper.labels)
        bare = Bare.of(widened(figure, self.widths), self.lang, self.supports)
        seen = tuple(resized(want, self.size) for want in bare.wanted)
        around = Around(Obstacles.of(bare.items), seen, bare.extents, None, bare.unnamed, bare.grounds)
        placed = self._follow(_names(bare.wanted), around)
        return _together(broken(bare.items, [label.rect for label in placed]), placed)

    def _follow(self, names: list[Name], around: Around) -> tuple[Placed, ...]:
        """Those that may stay first, then the others round them."""
        stayed = {
            number: label
            for number, (name, want) in enumerate(zip(names, around.wanted, strict=True))
            if name in self.choice and (label := _at(want, self.choice[name]))
        }
        kept: dict[int, Placed] = {}
        for (number, label), cost in zip(stayed.items(), _costs(stayed, around), strict=True):
            if cost < BAD and not any(_touch(label, other) for other in kept.values()):
                kept[number] = label
        for number, (name, want) in enumerate(zip(names, around.wanted, strict=True)):
            if number not in kept:
                kept[number] = self._moved(name, want, around, list(kept.values()))
        return tuple(kept[number] for number in range(len(names)))

    def _moved(self, name: Name, want: Want, around: Around, others: list[Placed]) -> Placed:
        """The cheapest place among lines, other things to name and the letters that stand already."""
        best, number = inf, 0
        for part in Row.of(want, around).parts:
            if not part.above(best):
                cost = part.total + _clashes(part, others)
                at = int(np.argmin(cost))
                if cost[at] < best:
                    best, number = float(cost[at]), part.first + at
        self.choice[name] = number
        label = _at(want, number)
        assert label is not None
        return label


def _clashes(part: Places, others: list[Placed]) -> Floats:
    """What it costs each of these places that it is on, or too near to, a label that stands already."""
    cost: Floats = np.zeros(len(part.spots.centre))
    for other in others:
        gap = part.spots.centre - other.centre
        w = (part.want.width + other.want.width) / 2 + BESIDE
        h = (part.want.height + other.want.height) / 2 + APART
        cost += np.where((np.abs(gap.real) < w) & (np.abs(gap.imag) < h), CLASH, 0.0)
    return cost


def _together(items: tuple[Item, ...], placed: tuple[Placed, ...]) -> tuple[Item, ...]:
    """Lines, and letters over them."""
    return items + tuple(item for label in placed for item in label.items())


def _chosen(paper: Drawing) -> dict[Name, int]:
    """Which of its places each label has on paper."""
    wanted = tuple(label.want for label in paper.labels)
    return {
        name: int(np.argmin(np.abs(spots(label.want, paper.drawn.centre).centre - label.centre)))
        for name, label in zip(_names(wanted), paper.labels, strict=True)
    }


def _names(wanted: tuple[Want, ...]) -> list[Name]:
    """The name of each label."""
    seen = Counter[str]()
    out: list[Name] = []
    for want in wanted:
        text = "".join(piece.box.text for piece in want.pieces)
        seen[text] += 1
        out.append((text, seen[text]))
    return out


def _at(want: Want, index: int) -> Placed | None:
    """The label at one of its places; none where it has not so many."""
    found = spot(want, index)
    return None if found is None else Placed(want, found[0], 0.0, found[1])


def _costs(stayed: Mapping[int, Placed], around: Around) -> Floats:
    """What each label stands on, and what it could be taken to name if it has no leader."""
    labels = list(stayed.values())
    own = np.array([label.want.own for label in labels], dtype=complex).reshape(-1, 2)
    size = np.array([complex(label.want.width, label.want.height) for label in labels], dtype=complex)
    breaks = np.array([label.want.thing in BREAKING for label in labels], dtype=bool)
    at = np.array([label.centre for label in labels], dtype=complex)
    cost = around.obstacles.cost(at, size, (own[:, 0], own[:, 1]), [slice(0, len(at))], breaks)
    near = {number: label.centre for number, label in stayed.items() if label.foot is None}
    cost[[label.foot is None for label in labels]] += misled_here(
        Named.by(around.wanted, around.unnamed, around.grounds), near
    )
    return cost


def _touch(a: Placed, b: Placed) -> bool:
    gap, w, h = a.centre - b.centre, a.want.width + b.want.width, a.want.height + b.want.height
    return abs(gap.real) < w / 2 + BESIDE and abs(gap.imag) < h / 2 + APART
