"""Frames of the text in which something is sketched that has no scale: the linkage that replaces a mechanism with
higher pairs, its groups, what might be corrected. The work is before them, the results at their foot."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...board.construction import Figure
from ...devices.structure import Structure
from ...figures import View
from ...solution import Solution
from ...tagging.tree import artifact, marked
from ...typeset.box import MM
from ...typeset.canvas import Ink
from ...typeset.words import layout_words
from ...words import Lang, Words
from ..flow.base import Block
from ..flow.furniture import COLUMN
from ..flow.style import CAPTION, GREY
from .working import GAP, LITTLE, SQUARE, TALLEST, Squares, Working, tall

LOWEST, _HIGH = 62.0 * MM, 67.0 * MM  # of the room for frames; of each of two that stand one under the other
HALF = 0.5  # of the room that the work needs: frames have the rest
_UNDER, _APART = 6.0 * MM, 4.0 * MM  # for the title under a frame; between two
_GROUPS = Words("原动件与杆组", "Driver and Assur groups")
_BY = Words("（原动件 {}）", " (driver {})")
_REMEDIES = Words("修改方案", "Corrections")


def to_sketch(solution: Solution, lang: Lang) -> list[str]:
    """What is sketched in answer to a question about the structure of a mechanism: the equivalent linkage, the groups
    for each set of drivers in one frame, all corrections in one; how many there are is for the reader to find."""
    if not isinstance(solution.problem.subject, Structure):
        return []
    return [*dict.fromkeys(_titles(solution.construction.figures, lang))]


def _titles(figures: Sequence[Figure], lang: Lang) -> Iterator[str]:
    apart = [one.name.split()[1] for one in figures if one.name.startswith(("left ", "group "))]
    for one in figures:
        if one.view is View.MECHANISM and one.name == "low":
            yield one.title.of(lang)
        elif one.name.startswith(("left ", "group ")):
            driver = one.name.split()[1].replace("+", "、" if lang == "zh" else ", ")
            yield _GROUPS.of(lang) + (_BY.of(lang).format(driver) if len({*apart}) > 1 else "")
        elif one.name.startswith("remedy"):
            yield _REMEDIES.of(lang)


class Frames(Block):
    """Frames of one size with their titles below them, beside each other where they would be low under each other."""

    pieces = True

    def __init__(self, titles: Sequence[str], height: float) -> None:
        super().__init__()
        self.titles, self._room = tuple(titles), height

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """The whole width."""
        self.width, self.height = width, self._room
        return width, self._room

    def places(self) -> list[tuple[float, float, float, float]]:
        """Left, foot, width and height of each frame."""
        count = len(self.titles)
        columns = 1 if count == 1 or self.height / count >= _HIGH else 2
        rows = -(-count // columns)
        wide, step = (self.width - (columns - 1) * _APART) / columns, self.height / rows
        return [
            (n % columns * (wide + _APART), self.height - (n // columns + 1) * step + _UNDER, wide, step - _UNDER)
            for n in range(count)
        ]

    def draw(self) -> None:
        """The frames, each with its title under its middle."""
        ink = Ink(self.canv)
        for title, (left, foot, wide, _) in zip(self.titles, self.places(), strict=True):
            box = layout_words(title, CAPTION.em)
            ink.box(box, left + (wide - box.width * MM) / 2, foot - 0.7 * _UNDER)
        with marked(self.canv, self.tag):
            ink.flush()
        self.canv.saveState()
        self.colour(GREY)
        self.canv.setLineWidth(0.6)
        with artifact(self.canv):
            for place in self.places():
                self.canv.rect(*place, stroke=1, fill=0)
        self.canv.restoreState()


class Sketching(Working):
    """Squares on what is left of a page, then frames on the next, with the results at their foot; all of it on one page
    that has room."""

    def __init__(self, title: str, need: float, frames: Frames, foot: Sequence[Block], lang: Lang) -> None:
        super().__init__(title, need, foot, lang)
        self._frames, self._squared = frames, max(HALF * need, LITTLE) if title else 0.0

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """All that is left, where it suffices: what is more than needed is for the frames."""
        need = LOWEST + self._other(width)
        self.width, self.height = width, height - 0.01 if height >= need - 0.02 else need
        return width, self.height

    def split(self, width: float, height: float) -> list[Block]:
        """Squares on the rest of this page, and the frames overleaf."""
        room = height - sum(tall(one, width) for one in self._head)
        if not self._squared or room < LITTLE:
            return []
        first = Working(self.outline, int(room / SQUARE) * SQUARE, (), self._lang)
        rest = Sketching("", 0.0, self._frames, self._foot, self._lang)
        return [first.made_of(self, first=True), rest.made_of(self, first=False)]

    def draw(self) -> None:
        """The heading and its squares, the frames, the foot."""
        top, squares = self.height, Squares(self._squared)
        frames = Frames(self._frames.titles, self.height - self._other(self.width))
        for one, under in (
            *((one, 0.0) for one in self._head),
            *(((squares, GAP),) if self._squared else ()),
            (frames, GAP if self._foot else 0.0),
            *((one, 0.0) for one in self._foot),
        ):
            top -= tall(one, self.width)
            one.drawOn(self.canv, 0.0, top + one.getSpaceAfter())
            top -= under

    def _other(self, width: float) -> float:
        """What is not for frames."""
        return super()._other(width) + (self._squared + GAP if self._squared else 0.0)


def sketching(title: str, need: float, titles: Sequence[str], foot: Sequence[Block], lang: Lang) -> list[Block]:
    """Squares, frames with these titles, and this at their foot; after them, where it would leave no room on a page."""
    frames, high = Frames(titles, LOWEST), sum(tall(one, COLUMN) for one in foot)
    if high + LOWEST <= TALLEST + LITTLE:
        return [Sketching(title, need * MM, frames, foot, lang)]
    return [Sketching(title, need * MM, frames, (), lang), *foot]
