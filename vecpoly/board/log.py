"""The log of a drawing: its steps, its acts, the scales and titles of its figures.
What stands on a figure follows from the acts."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from itertools import takewhile
from typing import Any, TypeVar

import numpy as np

from ..algebra.formula import Node
from ..algebra.quantity import Quantity, magnitude
from ..foundation.slotted import replace
from ..plane import Points, Reals
from ..plane.traced import Acts, acts_of, bare, traced
from ..words import Words
from .acts import Act, Arrow, Depict, Head, LayOff, Plot
from .apart import all_apart, named_apart
from .construction import EquationTable, Figure, Listing, Scale, Step
from .ledger import Ledger
from .paper.ends import Ends
from .paper.ink import ends_of, leaves_ink, marks_of
from .paper.marks import Mark
from .paper.symbols import Symbol
from .place import Pane, Place, View, view_of, views
from .said.behind import behind
from .said.grazing import grazing
from .said.short import Short, remarked, too_short
from .said.spaced import shape, spaced

Found = TypeVar("Found", Points, Reals)


class Log:
    """What is written and drawn, in order; the board adds the acts."""

    seen = True  # whether anyone looks at its figures

    def __init__(self, scales: Mapping[View, Scale] | Mapping[Place, Scale]) -> None:
        self.scales = all_apart(scales)  # of each kind of figure, and of a pane that has its own
        self.steps: list[Step] = []
        self.acts: list[Act] = []
        self.ledger = Ledger()
        self.hands: dict[int, Any] = {}  # number of an act → the point, length or value that it gave, by every hand
        self.beside: Mapping[str, Reals] = {}  # of given values: how far every hand's own is from what is told
        self._marks: dict[Place, list[Mark]] = {view: [] for view in views()}  # of acts up to when they were looked at
        self._left = defaultdict[Place, list[Act]](list)  # acts since then that leave marks
        self._ends = defaultdict[Place, Ends](Ends)  # of the vectors there
        self._letters = defaultdict[Place, list[Plot]](list)  # the points that are lettered there
        self.composed = set[Pane]()  # panes whose own scale is chosen with those of the kinds, if it is not told yet
        self._titles: dict[Place, Words] = {}
        self._section = Words.same("")
        self._opened = set[Words]()  # what steps began with
        self._short: list[Short] = []
        self._grazing: dict[int, tuple[float, ...]] = {}  # angles (deg) told of, by the step's number

    def in_each(self, value: float, name: str) -> Reals:
        """A given value by every hand, or in every place that is drawn at once."""
        return value + self.beside.get(name, 0.0)

    # -- the record -------------------------------------------------------------------------------------------

    def section(self, title: Words) -> None:
        """Open a part of the solution."""
        self._section = title

    def step(self, words: Words, view: Place | None = None, *, again: Words | None = None) -> None:
        """Open the next numbered step; marks and formulas that follow belong to it.
        again: what it says where an earlier one began with the same words, whatever its symbols."""
        said = again if again is not None and shape(words) in self._opened else words
        self._opened.add(shape(words))
        self.steps.append(Step(number=len(self.steps) + 1, section=self._section, words=spaced(said), view=view))

    def remark(self, words: Words) -> None:
        """Add a sentence to the step."""
        last = self.steps[-1]
        self.steps[-1] = replace(last, words=behind(last.words, spaced(words)))

    def graze(self, angle: float) -> None:
        """Say in the step that two lines meet at this small angle (deg): one sentence of all such meetings."""
        number = len(self.steps)
        angles = self._grazing.get(number, ())
        self._grazing[number] = (*angles, angle)
        said, more = grazing(angles) if angles else Words("", ""), grazing((*angles, angle))
        words = self.steps[-1].words
        if angles and said.en in words.en:
            words = Words(words.zh.replace(said.zh, more.zh), words.en.replace(said.en, more.en))
            self.steps[-1] = replace(self.steps[-1], words=words)
        else:
            self.remark(more)

    def weigh(self, letters: str, mm: float, place: Place | None) -> None:
        """Remember a length that is read though it is too short; one that no rule shows is none."""
        if too_short(mm):
            scale = None if place is None else self.scale_of(place)
            self._short.append(Short(step=len(self.steps), letters=letters, mm=mm, scale=scale))

    def told(self, steps: Sequence[Step]) -> tuple[Step, ...]:
        """The steps as they are finished, saying what was too short on paper to be measured."""
        return remarked(steps, self._short)

    def equate(self, table: EquationTable) -> None:
        """Write a vector equation with its two rows into the step."""
        self.steps[-1] = replace(self.steps[-1], equation=table)

    def write(self, *formulas: Node, when: int | None = None) -> None:
        """Write formulas into the step, each once. when: how many acts were done when they were needed, if not all."""
        self.steps[-1] = self.steps[-1].writing(formulas, len(self.acts) if when is None else when)

    def laid_off(self, key: str) -> int | None:
        """The number of the act of this step that laid off a quantity."""
        inside = takewhile(lambda act: act.head.step == len(self.steps), reversed(self.acts))
        return next((act.number for act in inside if isinstance(act, LayOff) and act.key == key), None)

    def tabulate(self, listing: Listing) -> None:
        """Write a table into the step, or its row in one of like steps."""
        self.steps[-1] = self.steps[-1].tabled(listing)

    @property
    def here(self) -> Place | None:
        """The figure that the step is drawn on."""
        return self.steps[-1].view if self.steps else None

    def head(self, *inputs: Any, on: Place | None = None, key: str = "", owner: str = "") -> Head:
        """The head of the next act: what it needs, what it is done on, what it stands for."""
        place = self.here if on is None else on
        known = acts_of(*inputs)
        return Head(
            number=len(self.acts),
            step=len(self.steps),
            inputs=tuple(sorted(known)) if known else (),
            place=place,
            key=key,
            owner=owner,
        )

    def log(self, act: Act) -> Acts:
        """Remember an act, and leave its marks; what it gave is known by its number."""
        self.acts.append(act)
        self.ink(act)
        return frozenset((act.number,))

    def gave(self, found: Found, act: Act) -> Found:
        """Remember an act with what it gave by every hand: a length read, a value computed, a lettered point."""
        number = self.log(act)
        if np.ndim(bare(found)):
            self.hands[act.number] = bare(found)
        return traced(found, number)

    def ink(self, act: Act) -> None:
        """Leave the marks of an act on its figure."""
        if leaves_ink(act):
            assert act.head.place is not None
            self._left[act.head.place].append(act)
            if isinstance(act, Arrow | Depict):
                for ends in ends_of(act):
                    self._ends[act.head.place].add(*ends)
            elif isinstance(act, Plot) and act.label:
                self._letters[act.head.place].append(act)

    def depict(self, view: Place, *symbols: Symbol) -> None:
        """Draw symbols of links, joints, bodies; how one looks is told by `diagram`, not here."""
        for it in symbols:
            if it.marks:
                self.log(Depict(head=self.head(on=view, key=it.key, owner=it.owner), marks=it.marks))

    def open_pane(
        self,
        view: View,
        name: str,
        title: Words,
        scale: Scale | None = None,
        *,
        aside: bool = False,
        composed: bool = False,
    ) -> Pane:
        """Begin one of several figures of a kind; those that share a name are one.
        scale: its own, where it differs from its kind's; composed: that one may be another, for the sheet's sake."""
        pane = Pane(view, name, aside)
        self.composed |= {pane} if composed else set()
        if scale is not None:
            self.scales[pane] = named_apart(scale, self._elsewhere(pane))
        self._titles.setdefault(pane, title)
        self._marks.setdefault(pane, [])
        return pane

    def _elsewhere(self, pane: Pane) -> tuple[Scale, ...]:
        """The scales of the other figures on which anything stands, or that have one of their own."""
        there = [at for at in {**self._marks, **self.scales} if isinstance(at, Pane) or self._on(at)]
        return tuple(self.scale_of(at) for at in there if at != pane)

    def entitle(self, place: Place, title: Words) -> None:
        """Call a figure by what is constructed on it."""
        self._titles[place] = title

    def figures(self, titles: Mapping[View, Words] = {}) -> tuple[Figure, ...]:
        """The finished figures, those with marks: by kind, then as they were begun.

        titles: of those that are not called as their kind is.
        """
        return tuple(self._figure(p, titles) for p in sorted((p for p in self._marks if self._on(p)), key=view_of))

    def _figure(self, place: Place, titles: Mapping[View, Words]) -> Figure:
        marks, scale = self.marks(place), self.scale_of(place)
        if isinstance(place, Pane):
            own = self._titles[place]
            return Figure(view=place.view, title=own, name=place.name, scale=scale, marks=marks, aside=place.aside)
        return Figure(
            view=place, title=titles.get(place) or self._titles.get(place, place.title), scale=scale, marks=marks
        )

    def marks(self, view: Place) -> tuple[Mark, ...]:
        """What stands on a figure so far."""
        return tuple(self._on(view))

    def _on(self, place: Place) -> list[Mark]:
        """The same; the marks follow from the acts when they are looked at, which on scratch paper they seldom are."""
        marks, left = self._marks[place], self._left[place]
        for act in left:
            marks += marks_of(act)
        left.clear()
        return marks

    # -- scales -----------------------------------------------------------------------------------------------

    def scale_of(self, place: Place) -> Scale:
        """The scale of a figure."""
        return self.scales.get(place) or self.scales[view_of(place)]

    def mu(self, view: Place) -> Quantity:
        """The scale of a figure as a quantity: μ_v = 0.006 (m/s)/mm."""
        scale = self.scale_of(view)
        return magnitude(scale.symbol, scale.value, scale.per_mm)

    def to_paper(self, view: Place, value: Reals) -> Reals:
        """A quantity as a length on paper (mm)."""
        return value / self.scale_of(view).value

    def mu_across(self, view: Place) -> Quantity:
        """The scale of what is set out to the right: μ_φ = 0.02 rad/mm; that of the figure where it has only one."""
        scale = self.scale_of(view).right
        return magnitude(scale.symbol, scale.value, scale.per_mm)

    def to_paper_across(self, view: Place, value: Reals) -> Reals:
        """A quantity as a length on paper to the right (mm)."""
        return value / self.scale_of(view).right.value
