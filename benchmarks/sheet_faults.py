"""What a strict reader of sheets would mark down, counted over the library: white bands, knots of letters.

`python -m benchmarks.sheet_faults [ID ...] [--en]` prints the sheets with most faults last, those with the largest
empty rectangles, and the sums of all.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise

import numpy as np
import shapely

from vecpoly.drawing.figure import Drawing, drawing
from vecpoly.drawing.labels.ground import is_ground
from vecpoly.drawing.labels.want import Thing
from vecpoly.drawing.legend.legend import entries
from vecpoly.drawing.legend.on_sheet import with_legend
from vecpoly.drawing.scene import Item, Rect, Stroke, rect_of
from vecpoly.drawing.sheets.sheet import Sheet, sheets
from vecpoly.drawing.sheets.space import FRAME, STRIP
from vecpoly.drawing.weighing.placed import BAD, Placed
from vecpoly.errors import VecpolyError
from vecpoly.problem.library import library
from vecpoly.problem.load import load
from vecpoly.solution import Solution, solve
from vecpoly.words import Lang

NEAR, FEW = 2.0, 2  # mm between letters; others so near that make no crowd
PAIR = 1.8  # mm between two letters that are hard to attribute
DENSE, MANY = 10.0, 5  # mm about the middle of a letter; others there that make a knot
WORST = 20  # sheets that are named for their white
CELL = 4.0  # mm: how finely white is looked for
ON = 0.3  # mm: what touches its own thing


@dataclass(frozen=True, slots=True)
class Faults:
    """Of one sheet: what its figures take of it, the largest white rectangle, and its letters."""

    name: str
    letters: int
    filled: float  # of the sheet, by the box about all figures
    bare: float  # of the sheet, by the largest empty rectangle, without its legend
    white: float  # the same as it is printed
    told: int  # entries of its legend
    untold: int  # entries that a legend would have, where it has none
    on: int  # letters on a line or on another letter
    led: int  # letters on leaders
    struck: int  # leaders that cross a line
    crossing: int  # pairs of leaders that cross
    crowded: int  # letters with more than two others within 2 mm
    pairs: int  # of letters less than 1.8 mm apart
    dense: int  # letters with five others within 10 mm
    astray: int  # letters nearer to another point than to what they name

    @property
    def knots(self) -> float:
        """All that makes letters hard to attribute, weighed."""
        return (
            2 * self.on
            + 0.5 * self.struck
            + 3 * self.crossing
            + self.crowded
            + self.astray
            + 0.5 * self.pairs
            + 0.5 * self.dense
        )

    def __str__(self) -> str:
        return (
            f"{self.name:28} {self.letters:4} letters; filled {self.filled:4.0%}, white {self.bare:4.0%} → "
            f"{self.white:4.0%}; told {self.told}, untold {self.untold}, "
            f"on {self.on}, led {self.led}, struck {self.struck}, crossing {self.crossing}, crowded {self.crowded}, "
            f"pairs {self.pairs}, dense {self.dense}, "
            f"astray {self.astray}"
        )


def of_solution(solution: Solution, lang: Lang) -> Iterator[Faults]:
    """Of every sheet of a report."""
    problem = solution.problem
    made = sheets(solution.construction, lang=lang, title=problem.title, on=problem.paper, plates=True, bands=False)
    for n, sheet in enumerate(made, start=1):
        yield of_sheet(f"{problem.id} {n}/{len(made)}", sheet, lang)


def of_sheet(name: str, sheet: Sheet, lang: Lang) -> Faults:
    """Of one sheet."""
    printed = with_legend(sheet)
    known = len(entries([one.figure for one in sheet.figures if one.figure is not None], lang))
    figures = [drawing(one.figure, lang=lang) for one in sheet.figures if one.figure is not None]
    labels = [label for one in figures for label in one.labels]
    return Faults(
        name,
        len(labels),
        _filled(sheet),
        _white(sheet),
        _white(printed),
        known if printed.results else 0,
        0 if printed.results else known,
        sum(label.cost > BAD for label in labels),
        sum(label.foot is not None for label in labels),
        sum(map(_struck, figures)),
        sum(map(_crossing, figures)),
        sum(map(_crowded, figures)),
        sum(map(_pairs, figures)),
        sum(map(_dense, figures)),
        sum(map(_astray, figures)),
    )


def _filled(sheet: Sheet) -> float:
    boxes = [one.extents for one in sheet.figures]
    wide = max(box.x1 for box in boxes) - min(box.x0 for box in boxes)
    high = max(box.y1 for box in boxes) - min(box.y0 for box in boxes)
    return wide * high / (sheet.room[0] * sheet.room[1])


def _white(sheet: Sheet) -> float:
    """The largest rectangle on which nothing stands, as a share of the sheet."""
    wide, high = (int(side / CELL) for side in sheet.room)
    taken = np.zeros((high, wide), dtype=bool)
    for item in (*sheet.drawn, *sheet.results):
        for box in _boxes(item):
            x0, x1 = ((x - FRAME) / CELL for x in (box.x0, box.x1))
            y0, y1 = ((y - FRAME - STRIP) / CELL for y in (box.y0, box.y1))
            taken[max(0, int(y0)) : int(y1) + 1, max(0, int(x0)) : int(x1) + 1] = True
    best, depth = 0, np.zeros(wide, dtype=int)
    for row in taken:
        depth = np.where(row, 0, depth + 1)
        for start in range(wide):
            low = np.minimum.accumulate(depth[start:])
            best = max(best, int((low * np.arange(1, len(low) + 1)).max()))
    return best / (wide * high)


def _boxes(item: Item) -> Iterator[Rect]:
    """The rectangles that an item covers: of a line piece by piece."""
    if not isinstance(item, Stroke):
        yield rect_of(item)
        return
    ends = item.points + (item.points[:1] if item.closed else ())
    for a, b in pairwise(ends):
        cuts = max(1, int(abs(b - a) / CELL))
        for k in range(cuts):
            p, q = a + (b - a) * k / cuts, a + (b - a) * (k + 1) / cuts
            yield Rect(min(p.real, q.real), min(p.imag, q.imag), max(p.real, q.real), max(p.imag, q.imag))


def _leader(label: Placed) -> shapely.LineString | None:
    strokes = [item for item in label.items() if isinstance(item, Stroke)]
    return _line(strokes[0].points) if strokes else None


def _line(points: Sequence[complex]) -> shapely.LineString:
    return shapely.LineString([(z.real, z.imag) for z in points])


def _box(r: Rect) -> shapely.Polygon:
    return shapely.box(r.x0, r.y0, r.x1, r.y1)


def _struck(one: Drawing) -> int:
    """Leaders that cross a line other than at what they lead to."""
    lines = [_line(item.points) for item in one.obstacles if isinstance(item, Stroke) and not is_ground(item)]
    tree, count = shapely.STRtree(lines), 0
    for label in one.labels:
        if label.foot is not None and (leader := _leader(label)) is not None:
            rest = leader.difference(shapely.Point(label.foot.real, label.foot.imag).buffer(label.want.radius + ON))
            count += bool(len(tree.query(rest, predicate="intersects")))
    return count


def _crossing(one: Drawing) -> int:
    found = [leader for label in one.labels if (leader := _leader(label)) is not None]
    return sum(a.intersects(b) for a, b in combinations(found, 2))


def _crowded(one: Drawing) -> int:
    boxes = np.array([_box(label.rect) for label in one.labels], dtype=object)
    if not len(boxes):
        return 0
    near = shapely.dwithin(boxes[:, None], boxes[None, :], NEAR).sum(axis=1) - 1
    return int((near > FEW).sum())


def _pairs(one: Drawing) -> int:
    boxes = np.array([_box(label.rect) for label in one.labels], dtype=object)
    return int(np.triu(shapely.dwithin(boxes[:, None], boxes[None, :], PAIR), 1).sum()) if len(boxes) else 0


def _dense(one: Drawing) -> int:
    at = np.array([label.centre for label in one.labels], dtype=complex)
    near = (abs(at[:, None] - at) < DENSE).sum(axis=1) - 1
    return int((near >= MANY).sum())


def _astray(one: Drawing) -> int:
    """Letters without a leader that stand nearer to another point's place than to what they name."""
    count = 0
    points = [label for label in one.labels if label.want.thing is Thing.POINT]
    for label in one.labels:
        if label.foot is not None or label.want.thing is Thing.OTHER:
            continue
        box, mine = _box(label.rect), _line(label.want.course)
        own = box.distance(mine) - label.want.radius
        others = (
            box.distance(_line(other.want.course)) - other.want.radius
            for other in points
            if other is not label and not mine.dwithin(_line(other.want.course), ON)
        )
        count += any(away < own + ON for away in others)
    return count


def main(ids: Sequence[str], lang: Lang) -> None:
    """The sheets of these problems, or of the library, the worst last, and the sums."""
    found: list[Faults] = []
    for name in ids or [entry.id for entry in library()]:
        try:
            found += of_solution(solve(load(name), repeats=0, precise=False), lang)
        except VecpolyError:
            continue
    for one in sorted(found, key=lambda one: one.knots):
        print(one)
    if not ids:
        worst = sorted(found, key=lambda one: one.white, reverse=True)[:WORST]
        print("largest empty rectangles:", ", ".join(f"{one.name} {one.white:.0%}" for one in worst))
    print(summed(found))


def summed(found: Sequence[Faults]) -> str:
    """What all of them add up to."""
    filled, bare, white = (np.array([getattr(one, key) for one in found]) for key in ("filled", "bare", "white"))
    legends = f"legends {sum(one.told > 0 for one in found)}, wanting {sum(one.untold > 0 for one in found)}"
    sums = ", ".join(
        f"{key} {sum(getattr(one, key) for one in found)}"
        for key in ("letters", "on", "led", "struck", "crossing", "crowded", "pairs", "dense", "astray")
    )
    return (
        f"{len(found)} sheets: filled {filled.mean():.1%} ({(filled < 0.6).sum()} under 60 %), "
        f"white {bare.mean():.1%} → {white.mean():.1%} ({(bare > 0.2).sum()} → {(white > 0.2).sum()} over 20 %); "
        f"{legends}; {sums}"
    )


if __name__ == "__main__":
    names = [one for one in sys.argv[1:] if not one.startswith("--")]
    main(names, "en" if "--en" in sys.argv else "zh")
