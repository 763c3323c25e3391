"""Which element of the structure each piece of a line belongs to: its words, every formula in it, every reference."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .copied import primed
from .speech import spoken
from .tag import Role, Tag
from .tree import ARTIFACT, Open, tree_of


@dataclass(frozen=True, slots=True)
class Source:
    """A formula as it was written, and the piece of it that stands here, which is what is copied.

    text: nothing of a word that only looks otherwise (a unit with its exponent).
    """

    text: str
    piece: str


@dataclass(slots=True)
class _Reach:
    """A reference on a line: where it leads, what it says, from where to where it stands (pt)."""

    goal: str
    words: str
    left: float
    right: float
    low: float
    high: float
    tag: Tag


class Marks:
    """The pieces of one paragraph or cell, on one page; without a tag they have been read before."""

    __slots__ = ("_canvas", "_last", "_links", "_tag", "_tree", "words")

    def __init__(self, canvas: Any, tag: Tag | None) -> None:
        self._canvas, self._tree, self._tag = canvas, tree_of(canvas), tag
        self.words: Open = self._tree.opener(tag) if tag is not None else lambda: (ARTIFACT,)
        self._last: tuple[str, Tag] | None = None
        self._links: list[_Reach] = []

    def of(self, source: Source | None, joined: bool) -> Open:
        """What opens a piece of a formula, one that goes on where it is joined; a letter or two are a word."""
        if source is None or self._tag is None or _is_word(source.text):
            return self.words
        if not source.text:
            return self._tree.opener(self._tag, source.piece)
        if self._last is None or not joined or self._last[0] != source.text:
            self._last = (source.text, Tag(Role.FORMULA, self._tag, spoken(source.text, self._tree.lang)))
        return self._tree.opener(self._last[1], primed(source.piece))

    def link(self, goal: str, words: str, left: float, right: float, y: float, em: float) -> Open | None:
        """What opens a piece of a reference that leads somewhere; it stands from left to right on the baseline y."""
        if goal not in self._tree.goals or self._tag is None:
            return None
        last = self._links[-1] if self._links else None
        if last is not None and last.goal == goal and last.low == y - 0.25 * em and 0 <= left - last.right < em:
            last.right, last.words = right, last.words + words
        else:
            tag = Tag(Role.LINK, self._tag)
            self._links.append(_Reach(goal, words, left, right, y - 0.25 * em, y + 0.85 * em, tag))
        return self._tree.opener(self._links[-1].tag)

    def finish(self) -> None:
        """Lay the links over what has been drawn."""
        for one in self._links:
            self._canvas.link(one.goal, (one.left, one.low, one.right, one.high), one.words.strip(), one.tag)


def _is_word(text: str) -> bool:
    """A point or a line by its letters: C, BC."""
    return 0 < len(text) < 3 and text.isalpha()
