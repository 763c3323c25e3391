"""Which element of the structure each piece of a line belongs to: its words, and every formula in it."""

from __future__ import annotations

from typing import Any

from ...tagging.speech import spoken
from ...tagging.tag import Role, Tag
from ...tagging.tree import ARTIFACT, Open, tree_of
from ...words import Lang
from .cells import Cell, Source


class Marks:
    """The pieces of one paragraph or cell, on one page; without a tag they have been read before."""

    __slots__ = ("_lang", "_last", "_tag", "_tree", "words")

    def __init__(self, canvas: Any, tag: Tag | None, lang: Lang) -> None:
        self._tree, self._tag, self._lang = tree_of(canvas), tag, lang
        self.words: Open = self._tree.opener(tag) if tag is not None else lambda: ARTIFACT
        self._last: tuple[Source, Tag] | None = None

    def formula(self, cell: Cell) -> Open:
        """What opens a piece of a formula; a letter by itself is a word."""
        source = cell.source
        if source is None or len(source.text) == 1 or self._tag is None:
            return self.words
        if self._last is None or not cell.joined or self._last[0].text != source.text:
            self._last = (source, Tag(Role.FORMULA, self._tag, spoken(source.text, self._lang)))
        return self._tree.opener(self._last[1], source.piece)
