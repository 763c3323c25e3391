"""Display formulas: one a line, centred, those that follow each other with their equality signs under each other; one
that is too wide breaks before its equality signs."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from itertools import groupby

from ...algebra.formula import Node, plain
from ...foundation.slotted import dataclass
from ...tagging.copied import copied
from ...tagging.references import goal_of
from ...tagging.speech import said
from ...tagging.tag import Role, Tag
from ...tagging.tree import tree_of
from ...typeset.atoms import Kind
from ...typeset.box import MM, Box, beside
from ...typeset.canvas import Ink
from ...typeset.layout import RELATIONS, SIGNS, layout, segments
from ...typeset.words import layout_words
from .base import Block, Tightness
from .style import BODY

_SKIP = 1.2  # mm between the lines of a broken formula
_LEAST = 0.7  # how far a piece without equality sign may be made smaller
_CLOSE, _CLOSEST = 4.0, 2.5  # pt between two formulas that follow each other, and however tightly they are set
_STRUT = (0.78, 0.26)  # em over and under the base line, however low a line is: simple ones stand evenly
_TALL, _AIR = 1.4, 0.12  # em: a line higher than this, a fraction, has so much more white over and under it


@dataclass(frozen=True, slots=True)
class _Sides:
    """How far a formula reaches to the left and to the right of where its relation begins (mm)."""

    left: float
    right: float

    @property
    def width(self) -> float:
        """Both together."""
        return self.left + self.right


class Formula(Block):
    """One display formula, with an optional number at the right margin."""

    role = Role.FORMULA
    pieces = True

    def __init__(self, node: Node, number: str = "", size: float = BODY.size) -> None:
        super().__init__(5.0, 6.0)
        self.node, self.goal = node, goal_of(number)
        self._em = size / MM
        self._number = layout_words(number, self._em) if number else None
        self._lines: tuple[tuple[float, Box], ...] = ()
        self._room = 0.0  # mm, for its lines
        self._run: tuple[_Sides, ...] = ()  # of the formulas that stand in one column with it
        self._broken: dict[float, tuple[tuple[float, Box], ...]] = {}  # by room; for all copies

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """Size in a column."""
        self.width = width
        room = width / MM - (2 * self._number.width + self._em if self._number else 0.0)
        if room not in self._broken:
            self._broken[room] = tuple((x, _strutted(box, self._em)) for x, box in lines(self.node, self._em, room))
        self._lines, self._room = self._broken[room], room
        boxes = [box for _, box in self._lines]
        self.height = (sum(box.height for box in boxes) + _SKIP * (len(boxes) - 1)) * MM
        return width, self.height

    def tighten(self, degree: Tightness) -> None:
        """Never so near to its neighbours that a line over letters touches what is above."""
        super().tighten(degree)
        if self._run:
            self.spaceBefore, self.spaceAfter = max(self.spaceBefore, _CLOSEST), max(self.spaceAfter, _CLOSEST)

    def sides(self) -> _Sides | None:
        """What stands on each side of its first relation; None where it has none."""
        return _sides(self.node, self._em)

    def follow(self, run: tuple[_Sides, ...], *, first: bool, last: bool) -> None:
        """It stands in a column of these formulas, close to its neighbours."""
        self._run = run
        self.spaceBefore, self.spaceAfter = self.spaceBefore if first else _CLOSE, self.spaceAfter if last else _CLOSE

    @property
    def _left(self) -> float:
        """Where its first line begins in the column (mm)."""
        return self._start(self._room) + (self.width / MM - self._room) / 2

    def _start(self, room: float) -> float:
        """Where it begins in so much room: with its relation under that of its neighbours, in the middle else."""
        own, wide = self.sides(), max(x + box.width for x, box in self._lines)
        fitting = [one for one in self._run if one.width <= room]
        if own is not None and fitting:
            left, right = max(one.left for one in fitting), max(one.right for one in fitting)
            start = (room - left - right) / 2 + left - own.left
            if left + right <= room and 0.0 <= start <= room - wide:
                return start
        return max(0.0, (room - wide) / 2)

    @property
    def reach(self) -> tuple[float, float]:
        """Where its ink begins and ends in the column (mm)."""
        return self._left, self._left + max(x + box.width for x, box in self._lines)

    def draw(self) -> None:
        """Draw the lines as one group."""
        ink, lang = Ink(self.canv), tree_of(self.canv).lang
        tag = Tag(Role.FORMULA, self.tag.within, said(self.node, lang))
        ink.under(tree_of(self.canv).opener(tag, copied(self.node)))
        left, y = self._left * MM, self.height
        for x, box in self._lines:
            base = y - box.ascent * MM
            ink.box(box, left + x * MM, base)
            y -= (box.height + _SKIP) * MM
        if self._number is not None:
            ink.under(tree_of(self.canv).opener(Tag(Role.P, self.tag.within)))
            ink.box(self._number, self.width - self._number.width * MM, base)
        ink.flush()


def _strutted(box: Box, em: float) -> Box:
    """The line with the room that it keeps free over and under it."""
    air = _AIR * em if box.height > _TALL * em else 0.0
    over, under = (max(part + air, least * em) for part, least in zip((box.ascent, box.descent), _STRUT, strict=True))
    return Box(box.width, over, under, box.items)


@lru_cache(maxsize=4096)
def _sides(node: Node, em: float) -> _Sides | None:
    says = plain(node)
    at = frozenset({Kind.TIGHT}) if "→" in says and "=" not in says and "/" not in says else RELATIONS
    first, *rest = segments(node, em, before=True, at=at)
    return _Sides(first.width, layout(node, em).width - first.width) if rest else None


def in_columns(story: Iterable[object]) -> None:
    """Formulas that follow each other stand with their relations under each other."""
    for shown, some in groupby(story, key=lambda one: isinstance(one, Formula)):
        run = [one for one in some if isinstance(one, Formula)]
        if shown and len(run) > 1:
            sides = tuple(found for one in run if (found := one.sides()) is not None)
            for n, one in enumerate(run):
                one.follow(sides, first=n == 0, last=n == len(run) - 1)


def lines(node: Node, em: float, width: float) -> tuple[tuple[float, Box], ...]:
    """The formula as (indent, line) pairs no wider than `width`, later lines beginning with ``=``."""
    whole = layout(node, em)
    if whole.width <= width:
        return ((0.0, whole),)
    parts = segments(node, em, before=True)
    if max(part.width for part in parts) > width:
        parts = segments(node, em, before=True, at=SIGNS)
    gap = 5 / 18 * em
    indent = min(parts[0].width + gap, width / 3) if len(parts) > 1 else 0.0
    widest = max(part.width + (indent if i else 0.0) for i, part in enumerate(parts))
    if widest > width and em > _LEAST * BODY.size / MM:
        return lines(node, em * max(width / widest, 0.9), width)
    return _stack(parts, indent, gap, width)


def _stack(parts: tuple[Box, ...], indent: float, gap: float, width: float) -> tuple[tuple[float, Box], ...]:
    out: list[tuple[float, Box]] = []
    line: list[Box] = []
    used = 0.0
    for part in parts:
        start = indent if out else 0.0
        if line and start + used + gap + part.width > width:
            out.append((start, beside(line)))
            line, used = [], 0.0
        if line:
            line.append(Box(gap, 0.0, 0.0))
            used += gap
        line.append(part)
        used += part.width
    out.append((indent if out else 0.0, beside(line)))
    return tuple(out)
