"""The frozen record of a solution: figures, steps, readings.
Everything that comes after drawing reads this, and only this."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import Self

from ..algebra.formula import Node
from ..foundation.frozen import FrozenMap
from ..foundation.slotted import dataclass, replace
from ..names import ascii_key
from ..words import Words, language
from .acts import Act
from .candidates import Candidate
from .chain import following, keys_of, needed, numbers
from .paper.marks import Mark
from .paper.tones import tones, whose
from .place import Pane, Place, View, view_of
from .said.told import told
from .scale import Scale

__all__ = [
    "Construction",
    "EquationTable",
    "Figure",
    "LineOfAction",
    "Pane",
    "Place",
    "Reading",
    "Scale",
    "Step",
    "View",
    "view_of",
]


@dataclass(frozen=True, slots=True, kw_only=True)
class Figure:
    """One drawing: its marks in mm, its scale, its title; `name` tells it from others of its view.

    aside: as its pane. parts: of what is drawn for each of several solutions alone the step with which it begins, and
    the solution's number. tones: by which its vectors are told apart, by what they belong to (`paper/tones.py`); {}: by
    none, in black; None: by the kind of figure alone.
    """

    view: View
    title: Words
    scale: Scale
    marks: tuple[Mark, ...]
    name: str = ""
    aside: bool = False
    tones: Mapping[str, int] | None = None
    parts: tuple[tuple[int, int], ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class EquationTable:
    """A vector equation with its direction and magnitude rows, ready to be typeset.

    symbols: one per term; signs: "" for the first term, "=", "+" before the others; directions and magnitudes: one
    entry a term, in words (``⊥$BC$``, ``$B→A$``, ``?``, ``✓``, ``$ω_1 l_{AB}$``). tones: one a term, 0 for black;
    where none are given, all are black.
    """

    symbols: tuple[str, ...]
    signs: tuple[str, ...]
    directions: tuple[Words, ...]
    magnitudes: tuple[str, ...]
    tones: tuple[int, ...] = ()

    def __post_init__(self) -> None:
        if not self.tones:
            object.__setattr__(self, "tones", (0,) * len(self.symbols))


@dataclass(frozen=True, slots=True, kw_only=True)
class Listing:
    """What is read at many places, as a table: column heads with inline formulas, and rows of printed numbers.

    told: of a row for a table that like steps share, the sentence of the step, in whose place it may stand; lead: what
    that table says of all of them.
    """

    head: tuple[Words, ...]
    rows: tuple[tuple[str, ...], ...]
    blocks: int = 3  # beside each other on a page, at most
    told: Words | None = None
    lead: Words = Words.same("")


@dataclass(frozen=True, slots=True, kw_only=True)
class Step:
    """One numbered step: a sentence, and what belongs to it:
    an equation table, formulas, the figure it was drawn in, what is read at many places.

    written: of each formula, how many acts had been done on the sheet when it was written. row: of a table that like
    steps share.
    """

    number: int
    section: Words  # heading under which the step stands: position diagram, velocity analysis ...
    words: Words
    equation: EquationTable | None = None
    formulas: tuple[Node, ...] = ()
    view: Place | None = None
    listing: Listing | None = None
    row: Listing | None = None
    written: tuple[int, ...] = ()

    def writing(self, formulas: Sequence[Node], done: int) -> Step:
        """The step with these formulas too, each once; done: how many acts had been done when they were needed."""
        more = tuple(one for one in formulas if one not in self.formulas)
        return replace(self, formulas=(*self.formulas, *more), written=(*self.written, *[done] * len(more)))

    def tabled(self, listing: Listing) -> Step:
        """The step with this table, or its row in one of like steps."""
        return replace(self, listing=listing) if listing.told is None else replace(self, row=listing)


def _toned(step: Step, found: Mapping[str, int]) -> Step:
    """The step with the tones of the symbols of its equation."""
    if step.equation is None:
        return step
    of = tuple(found.get(whose(ascii_key(symbol)), 0) for symbol in step.equation.symbols)
    return replace(step, equation=replace(step.equation, tones=of))


@dataclass(frozen=True, slots=True, kw_only=True)
class LineOfAction:
    """Where a reaction acts: a point of its line (m, on the diagram's axes),
    and the side on which it touches a friction circle.

    tangent: sense of its moment about the pin, "ccw" or "cw"; "" where it passes through the centre, or there is no
    pin.
    told: how the line lies, where the method itself says so. couple: N·m (counter-clockwise) that a slide passes on
    beside a force of
    zero, whose line lies at infinity.
    """

    point: complex
    tangent: str = ""
    told: Words | None = None
    couple: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Reading:
    """One answer read off the paper.

    key: ASCII symbol; symbol: textbook notation; vector: value as x + iy (SI), None for ω, α; scalar: signed value for
    ω, α (ccw positive), magnitude for vectors; mm: length measured on paper (None where computed only); line: the paper
    length's letters (``pe``); scale: symbol of the scale used; factor: by what besides (ω_4); formula: symbol = ... .
    """

    key: str
    symbol: str
    unit: str
    scalar: float
    vector: complex | None = None
    mm: float | None = None
    line: str = ""
    scale: str = ""
    factor: str = ""
    formula: Node | None = None
    remark: Words | None = None
    acts: LineOfAction | None = None  # of a reaction


@dataclass(frozen=True, slots=True, kw_only=True)
class Construction:
    """A solved problem as drawn."""

    problem: str
    hand: str
    figures: tuple[Figure, ...]
    steps: tuple[Step, ...]
    readings: Mapping[str, Reading]
    forces: Mapping[str, Reading] = field(default_factory=dict)  # all that a force analysis found, asked for or not
    acts: tuple[Act, ...] = ()  # what was done, in order; the marks of the figures follow from it
    candidates: tuple[Candidate, ...] = ()  # the linkages that a synthesis found, in the order of their numbers
    conclusion: Words | None = None  # stands among the answers: that no candidate serves, and why
    warning: Words | None = None  # stands in red on every sheet: answers that must not be taken for right

    def __post_init__(self) -> None:
        for name in ("readings", "forces"):
            object.__setattr__(self, name, FrozenMap(getattr(self, name)))
        if self.figures and all(figure.tones is None for figure in self.figures):
            written = [step.equation.symbols for step in self.steps if step.equation is not None]
            drawn = [figure.marks for figure in self.figures if figure.view.across is None]  # else it has axes
            if found := tones(drawn, written):
                self._tone(found)

    def _tone(self, found: Mapping[str, int]) -> None:
        """Give its vectors these tones, wherever they appear."""
        object.__setattr__(self, "figures", tuple(replace(figure, tones=found) for figure in self.figures))
        object.__setattr__(self, "steps", tuple(_toned(step, found) for step in self.steps))

    @property
    def tones(self) -> Mapping[str, int]:
        """The tones of its vectors, by what they belong to."""
        return next((figure.tones for figure in self.figures if figure.tones is not None), {})

    def toned(self, found: Mapping[str, int]) -> Self:
        """The same with these tones; with none, in black: for examinations, and for printers without colours."""
        same = replace(self)
        same._tone(FrozenMap(found))
        return same

    def __str__(self) -> str:
        """The steps, and under each its acts with what they gave and what they needed."""
        return told(self.steps, self.acts, language())

    def depends(self, key: str) -> tuple[str, ...]:
        """The keys of all that this rests on, in the order in which they were found: letters, readings, quantities."""
        return keys_of(self.acts, needed(self.acts, numbers(self.acts, key)), key)

    def dependents(self, key: str) -> tuple[str, ...]:
        """The keys of all that rests on this, in the order in which they were found."""
        return keys_of(self.acts, following(self.acts, numbers(self.acts, key)), key)

    def figure(self, place: Place) -> Figure | None:
        """The figure at this place (the first of a view), if drawn."""
        name = place.name if isinstance(place, Pane) else None
        return next((f for f in self.figures if f.view is view_of(place) and name in (None, f.name)), None)
