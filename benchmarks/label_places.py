"""What a lecturer marks down in labels, counted over the library, each complaint by itself.

`python -m benchmarks.label_places [ID ...] [--en]` prints the figures with most of them last, and the sums of all.
"""

from __future__ import annotations

import cmath
import sys
from collections import Counter
from collections.abc import Iterator, Sequence

import shapely

from vecpoly.board.construction import Figure
from vecpoly.board.paper.marks import TurnArrow
from vecpoly.drawing.figure import Drawing, drawing
from vecpoly.drawing.labels.want import Thing
from vecpoly.drawing.scene import Fill, Rect, Stroke
from vecpoly.drawing.sheets.sheet import sheets
from vecpoly.drawing.symbols.angles import sweep_of
from vecpoly.drawing.weighing.placed import Placed
from vecpoly.errors import VecpolyError
from vecpoly.problem.library import library
from vecpoly.problem.load import load
from vecpoly.solution import solve
from vecpoly.words import Lang

FAR = 2.5  # mm from the rim of its point to a letter without a leader
HEAD = 4.0  # mm about the head of an arrow that turns
HEAP, MOST = 10.0, 4  # mm to either side of a letter; letters in that square
STRAIGHT = 0.5  # cosine, below which a leader bends away from the line of a direction


def faults(figure: Figure, drawn: Drawing) -> Iterator[str]:
    """Each complaint about a figure, by its name."""
    heads = [head(mark) for mark in figure.marks if isinstance(mark, TurnArrow)]
    tints = [one for one in drawn.obstacles if isinstance(one, Fill) and one.hue.is_tint]
    areas = [shapely.Polygon([(z.real, z.imag) for z in one.points]) for one in tints]
    for label in drawn.labels:
        own = label.want
        if label.foot is None and own.thing is Thing.POINT and away(label.rect, own.own[0]) - own.radius > FAR:
            yield "far"
        if own.thing is not Thing.ARC and any(away(label.rect, at) < HEAD for at in heads):
            yield "head"
        box = shapely.box(label.rect.x0, label.rect.y0, label.rect.x1, label.rect.y1)
        if own.thing is Thing.POINT and any(box.intersects(area) for area in areas):
            yield "tint"
        if label.foot is not None and own.thing is Thing.DIRECTION and bent(label):
            yield "bent"
        if sum(is_near(label.centre, other.centre) for other in drawn.labels) > MOST:
            yield "heap"


def head(mark: TurnArrow) -> complex:
    """Where its arrow ends, about."""
    return mark.at + cmath.rect(mark.radius, mark.start + sweep_of(mark))


def bent(label: Placed) -> bool:
    """Whether its leader leaves the line that it names sideways."""
    a, b = label.want.own
    strokes = [item for item in label.items() if isinstance(item, Stroke)]
    if not strokes or abs(b - a) < 1e-6:
        return False
    start, end = strokes[0].points[0], strokes[0].points[-1]
    if abs(end - start) < 1e-6:
        return False
    return abs((cmath.exp(-1j * cmath.phase(b - a)) * (end - start)).real) < STRAIGHT * abs(end - start)


def is_near(one: complex, other: complex) -> bool:
    """Whether a square of 20 mm about the one holds the other."""
    return max(abs((one - other).real), abs((one - other).imag)) <= HEAP


def away(rect: Rect, at: complex) -> float:
    """From a rectangle to a place (mm)."""
    return float(shapely.box(rect.x0, rect.y0, rect.x1, rect.y1).distance(shapely.Point(at.real, at.imag)))


def of_problem(name: str, lang: Lang) -> Iterator[tuple[str, Counter[str]]]:
    """The complaints about each figure of its sheets."""
    problem = load(name)
    solution = solve(problem, repeats=0, precise=False)
    made = sheets(solution.construction, lang=lang, title=problem.title, on=problem.paper, plates=True, bands=False)
    for sheet in made:
        for one in sheet.figures:
            if one.figure is not None:
                counts = Counter(faults(one.figure, drawing(one.figure, lang=lang)))
                counts["labels"] = len(drawing(one.figure, lang=lang).labels)
                yield f"{name} {one.figure.view.name} {one.figure.name}", counts


def main(ids: Sequence[str], lang: Lang) -> None:
    """The figures, the worst last, and the sums."""
    found: list[tuple[str, Counter[str]]] = []
    for name in ids or [entry.id for entry in library()]:
        try:
            found += of_problem(name, lang)
        except VecpolyError:
            continue
    for name, counts in sorted(found, key=lambda one: one[1].total() - one[1]["labels"]):
        print(f"{name:45}", dict(counts))
    print(dict(sum((counts for _, counts in found), Counter[str]())))


if __name__ == "__main__":
    names = [one for one in sys.argv[1:] if not one.startswith("--")]
    main(names, "en" if "--en" in sys.argv else "zh")
