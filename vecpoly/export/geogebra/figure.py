"""One figure in a GeoGebra file: its acts become points, lines, vectors, arcs about an anchor, which may be dragged."""

from __future__ import annotations

from collections.abc import Sequence
from math import tau
from typing import Any
from xml.etree import ElementTree as ET

import numpy as np

from ...board import acts as done
from ...board.otherwise.amended import plain_letters
from ...board.paper.marks import Dot, Role
from ...board.paper.tones import known_as
from ...board.place import View
from ...drawing.hues import Tones, ink_of
from ...drawing.style import Hue, Pen, kind_hue, pen
from ..parts import Numbers
from ..terms import Pair
from .labels import caption
from .page import DOTTED, RING, Page
from .spelling import Spelling

_DOTS = {
    Dot.JOINT: (RING, "4"),
    Dot.MULTIPLE: (RING, "5"),
    Dot.MASS: (RING, "3"),
    Dot.POLE: (RING, "3"),
    Dot.POINT: (DOTTED, "3"),
    Dot.NONE: (DOTTED, "1"),
}


class Figure:
    """The points of one figure, and how each is written."""

    def __init__(
        self, page: Page, terms: Numbers, spelling: Spelling, view: View, anchor: str, tones: Tones = None
    ) -> None:
        self.page, self.terms, self.spelling, self.view, self.anchor = page, terms, spelling, view, anchor
        self.tones = tones
        self.hue = kind_hue(view)
        self.points: dict[Pair, str] = {}
        self._letters: dict[tuple[str, Pair], ET.Element] = {}
        self._shown: set[Pair] = set()
        self.placed: list[tuple[ET.Element, Pair]] = []
        self.vectors: list[tuple[ET.Element, Pair]] = []

    def draw(self, act: done.Act) -> None:
        """What an act leaves on this figure; what it only finds is a hidden point."""
        match act:
            case done.Locate():
                self.locate(act.key, act.at)
            case done.LayOff() | done.Meet() | done.Image():
                self._find(act.at)
            case done.Plot():
                self._plot(act)
            case done.Join(a=a, b=b, role=role):
                self.segment(a, b, self._pen(role))
            case done.Rule(a=a, b=b, label=label):
                self.segment(a, b, self._pen(Role.DIRECTION), label)
            case done.Arrow(shown=True):
                look = pen(
                    act.role,
                    ink_of(known_as(act.key, act.label), self.tones) if self.tones else kind_hue(self.view, act.label),
                )
                vector = self.page.line("Vector", "vector", (self.at(act.a), self.at(act.b)), look)
                self.vectors.append((vector, self.terms.parts(act.b - act.a)))
            case done.Swing(centre=centre, radius=radius, sweep=sweep) if abs(sweep) >= tau:
                self.circle(centre, radius, self._pen(act.role))
            case done.Swing():
                self.arc(act.centre, act.radius, act.start, act.sweep, self._pen(act.role))
            case done.Curve(points=points, role=role):
                self.lines(points, self._pen(role))
            case done.Corner(at=at, u=u, v=v):
                self.lines((at + 2.5 * u, at + 2.5 * u + 2.5 * v, at + 2.5 * v), self._pen(Role.DIRECTION))
            case done.Tint(points=points):
                self.lines((*points, points[0]), Pen(width=0.18, hue=Hue.GHOST))
            case _:
                return

    def locate(self, letter: str, at: Any) -> ET.Element:
        """A point with its letter, from which others are found."""
        pair = self.terms.parts(at)
        if (letter, pair) not in self._letters:
            self._letters[letter, pair] = self._placed(self.page.labels.point(letter, self.view), pair)
        return self._letters[letter, pair]

    def at(self, value: Any) -> str:
        """How a place on the figure is written: a point's label, or the anchor and the way from it."""
        pair = self.terms.parts(value)
        return self.points[pair] if pair in self.points else f"{self.anchor} + {self.spelling.pair(pair)}"

    def segment(self, a: Any, b: Any, look: Pen, label: str = "") -> None:
        """A straight line."""
        self.page.line("Segment", "segment", (self.at(a), self.at(b)), look, caption=label)

    def lines(self, points: Sequence[Any], look: Pen) -> None:
        """Lines from point to point."""
        self.page.line("PolyLine", "polyline", [self.at(point) for point in points], look)

    def arc(self, centre: Any, radius: Any, start: Any, sweep: Any, look: Pen) -> None:
        """An arc, counter-clockwise from its first end."""
        first, last = (centre + radius * np.exp(1j * angle) for angle in (start, start + sweep))
        if float(sweep) < 0:
            first, last = last, first
        self.page.line("CircleArc", "conicpart", (self.at(centre), self.at(first), self.at(last)), look)

    def circle(self, centre: Any, radius: float, look: Pen) -> None:
        """A whole circle."""
        self.page.line("Circle", "conic", (self.at(centre), self.at(centre + radius)), look)

    def _pen(self, role: Role) -> Pen:
        return pen(role, self.hue)

    def _find(self, at: Any) -> None:
        pair = self.terms.parts(at)
        if pair not in self.points and not all(self.spelling.knows(part) for part in pair):
            self._placed(self.page.labels.new("h", str(len(self.page.root))), pair)

    def _placed(self, label: str, pair: Pair) -> ET.Element:
        point = self.page.point(label, self.points.get(pair) or f"{self.anchor} + {self.spelling.pair(pair)}")
        self.points.setdefault(pair, label)
        self.placed.append((point, pair))
        self.spelling.know(pair[0], f"(x({label}) - x({self.anchor}))")
        self.spelling.know(pair[1], f"(y({label}) - y({self.anchor}))")
        return point

    def _plot(self, act: done.Plot) -> None:
        pair = self.terms.parts(act.at)
        if act.dot is Dot.POLE:
            self._shown.add(pair)
            return  # the anchor is the pole
        point = self.locate(plain_letters(act.label), act.at)
        if pair in self._shown:
            self.page.beside(point)  # a second letter at one place
        self._shown.add(pair)
        self.page.show(point, *_DOTS[act.dot], caption(act.label), self.hue)
