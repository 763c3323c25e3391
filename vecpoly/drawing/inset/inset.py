"""The polygon of one equation, as large as its place beside the equation allows, turned as on the sheet."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...board.construction import Construction, Figure, Step
from ...board.paper.marks import Mark, Point, Role, Segment
from ...board.strokes import OVERRUN
from ...foundation.slotted import dataclass, replace
from ...words import Lang
from ..figure import Bare
from ..scene import Rect, Scene
from .chain import ONE, Chain, chain_of, is_one
from .letters import lettered

SHARE = 0.64  # of its size on a sheet is everything that has a size of its own: letters, heads, widths of lines
MANY = 8  # vectors: a polygon with more is looked at on the sheet
SHORT, FLAT = 1.2, 2.2  # mm on the page: of the shortest vector, and across the whole polygon, at least
PAST = 2.8  # mm of the sheet by which a line runs past the point that it finds
EDGE = 4.0  # mm of the sheet for letters on each side, at first
TRIES, SPARE = 3, 0.2 + 0.2j  # sizes tried; mm by which the next one is smaller than it seems to need


@dataclass(frozen=True, slots=True)
class Outline:
    """What one equation draws, before it has a size: its polygon, the lines that find a corner, the letters."""

    figure: Figure
    chain: Chain
    lines: tuple[tuple[Segment, complex, complex], ...]  # each with the corner where it begins, and the one it finds
    points: tuple[Point, ...]

    @classmethod
    def of(cls, construction: Construction, step: Step) -> Outline | None:
        """Of a step; None where it draws no polygon, or one of too many vectors."""
        figure = None if step.view is None else construction.figure(step.view)
        chain = None if figure is None else chain_of(figure, step)
        if figure is None or chain is None or len(chain.vectors) > MANY:
            return None
        here = [mark for mark in figure.marks if mark.step <= step.number]
        ruled = (one for one in here if isinstance(one, Segment) and one.role is Role.DIRECTION)
        lines = tuple(_found_by(chain, (one for one in ruled if one.step == step.number)))
        named = (one for one in here if isinstance(one, Point) and one.label and one.said is None)
        points = tuple(one for one in named if any(is_one(one.at, corner) for corner in chain.corners))
        return cls(figure, chain, lines, points)

    def at(self, factor: float) -> tuple[Figure, tuple[complex, ...]]:
        """The figure so many times as large as on the sheet, and its corners."""
        marks: list[Mark] = [replace(one, a=one.a * factor, b=one.b * factor) for one in self.chain.vectors]
        for line, start, end in self.lines:
            way = PAST * (line.b - line.a) / abs(line.b - line.a)
            begun = start * factor - (way if is_one(start, end) else 0.0)
            marks.append(replace(line, a=begun, b=end * factor + way))
        marks += [replace(one, at=one.at * factor) for one in self.points]
        return replace(self.figure, marks=tuple(marks)), tuple(z * factor for z in self.chain.corners)

    @property
    def extent(self) -> Rect:
        """The rectangle of its corners on the sheet."""
        across, up = [z.real for z in self.chain.corners], [z.imag for z in self.chain.corners]
        return Rect(min(across), min(up), max(across), max(up))

    def is_legible(self, factor: float) -> bool:
        """Whether each of its vectors can be seen, and that they enclose something."""
        page, vectors = factor * SHARE, self.chain.vectors
        longest = max(vectors, key=lambda one: abs(one.b - one.a))
        along = (longest.b - longest.a).conjugate() / abs(longest.b - longest.a)
        across = [(z * along).imag for z in self.chain.corners]
        shortest = min(abs(one.b - one.a) for one in vectors)
        return page * shortest >= SHORT and page * (max(across) - min(across)) >= FLAT


def inset(outline: Outline, lang: Lang, width: float, height: float) -> Scene | None:
    """The figure for so many mm of the page, in mm of the sheet: it is drawn `SHARE` as large; None where no size that
    has room there can be read."""
    e, wide, high, edges = outline.extent, width / SHARE, height / SHARE, complex(2 * EDGE, 2 * EDGE)
    for _ in range(TRIES):
        factor = min(max(wide - edges.real, 1.0) / max(e.width, ONE), max(high - edges.imag, 1.0) / max(e.height, ONE))
        figure, corners = outline.at(factor)
        bare = Bare.of(figure, lang)
        letters = lettered(bare, corners) if outline.is_legible(factor) else None
        if letters is None:
            return None
        scene = Scene.of(bare.items + tuple(item for one in letters for item in one.items()))
        own = scene.extents
        if own.width <= wide and own.height <= high:
            return scene
        edges = complex(own.width - factor * e.width, own.height - factor * e.height) + SPARE
    return None


def _found_by(chain: Chain, ruled: Iterable[Segment]) -> Iterator[tuple[Segment, complex, complex]]:
    """The lines that lead from a corner to one that they find, as a ruler leaves them (`board/strokes.py`)."""
    for line in ruled:
        past = OVERRUN * (line.b - line.a) / abs(line.b - line.a)
        begins = [z for z in chain.corners if is_one(z, line.a) or is_one(z, line.a + past)]
        found = [z for z in chain.corners if is_one(z, line.b - past)]
        if begins and found:
            yield line, begins[0], found[0]
