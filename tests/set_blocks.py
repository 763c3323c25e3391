"""Blocks of a report set on a canvas that remembers:
what stands where, in points from the block's lower left corner."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import pytest

from vecpoly.report.flow.base import Block
from vecpoly.typeset.box import MM, Glyphs
from vecpoly.typeset.canvas import Ink
from vecpoly.typeset.fonts import Face
from vecpoly.typeset.runs import run


@dataclass(frozen=True, slots=True)
class Piece:
    """A run of text: its baseline from left to right, its size."""

    text: str
    x: float
    y: float
    right: float
    size: float

    @property
    def middle(self) -> float:
        """Halfway between its ends."""
        return (self.x + self.right) / 2


@dataclass
class Paper:
    """Stands for a canvas: texts, ruled lines (x, y, width, height) and every other call with its arguments."""

    texts: list[Piece] = field(default_factory=list)
    rules: list[tuple[float, float, float, float]] = field(default_factory=list)
    calls: list[tuple[str, tuple[Any, ...]]] = field(default_factory=list)
    told: list[tuple[str, dict[str, Any]]] = field(default_factory=list)  # what calls were given by name
    _code: list[str] = field(default_factory=list)
    _pagesize: tuple[float, float] = (210 * MM, 297 * MM)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)

        def noted(*args: Any, **named: Any) -> None:
            self.calls.append((name, args))
            self.told.append((name, named))

        return noted

    def absolutePosition(self, x: float, y: float) -> tuple[float, float]:
        """The block stands at the corner of the page."""
        return x, y

    def mark_place(self, goal: str, x: float, y: float) -> None:
        """A place to which references lead leaves no ink."""

    def called(self, name: str) -> list[tuple[Any, ...]]:
        """The arguments of every such call."""
        return [args for called, args in self.calls if called == name]

    def piece(self, text: str) -> Piece:
        """The one run with this text in it."""
        (found,) = (piece for piece in self.texts if text in piece.text)
        return found

    def lines(self) -> list[float]:
        """The heights of the baselines, from the top."""
        return sorted({round(piece.y, 3) for piece in self.texts}, reverse=True)


def paper_of(block: Block, width: float, height: float = 1000.0) -> Paper:
    """The block wrapped to a column of this width (pt) and drawn: every state that it saves is restored."""
    block.wrap(width, height)
    with remembered() as paper:
        block.canv = paper
        block.draw()
    depth = 0
    for name, _ in paper.calls:
        depth += (name == "saveState") - (name == "restoreState")
        assert depth >= 0, "a state is restored that was not saved"
    assert depth == 0, "a state is saved and never restored"
    return paper


class remembered:
    """While this lasts all ink goes to one paper."""

    def __enter__(self) -> Paper:
        self._patch, paper = pytest.MonkeyPatch(), Paper()
        self._patch.setattr(
            Ink,
            "text",
            lambda _, glyphs, x, y, chars=0.0, blanks=0.0: paper.texts.append(_piece(glyphs, x, y, chars, blanks)),
        )
        self._patch.setattr(Ink, "rule", lambda _, *box: paper.rules.append(box))
        self._patch.setattr(Ink, "flush", lambda _: paper.calls.append(("flush", ())))
        return paper

    def __exit__(self, *_: object) -> None:
        self._patch.undo()


def _piece(glyphs: Glyphs, x: float, y: float, chars: float, blanks: float) -> Piece:
    faces = {face.value: face for face in Face}
    natural = run(glyphs.text, faces[glyphs.font], glyphs.size / MM).width * MM if glyphs.font in faces else 0.0
    spaced = chars * max(len(glyphs.text) - 1, 0) + blanks * glyphs.text.count(" ")
    return Piece(glyphs.text, x, y, x + natural + spaced, glyphs.size)


def pairs(values: list[float]) -> Iterator[float]:
    """The distances of neighbours."""
    return (a - b for a, b in pairwise(values))
