"""The blank sheets of a question: frames that fill the sheet and tell nothing of what is to be drawn in them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from operator import itemgetter

from ....board.construction import Construction, Figure, View
from ....board.paper.extent import bounds
from ....board.paper.marks import Mark, Role, Segment
from ....drawing.order import begun_in, reading_order
from ....drawing.sheets.boxes.titleblock import TO_BE_DRAWN
from ....drawing.sheets.lettering import title_width
from ....drawing.sheets.sheet import Hung
from ....foundation.slotted import replace
from ....foundation.stock import Format, Paper
from ....problem.problem import Problem
from ...picture import to_scale
from ...statement.further import doubtful
from .blank import WHITE, framed
from .fields import Fields, fields, written
from .grid import NARROWEST, Grid, Need, Size, grid, least_sheets, tightness
from .known import begins_at, enlarged, is_circle, lettered, stands
from .origin import origin
from .readings import Form, is_measured
from .room import outline
from .shapes import completed

WHITES = (8.0, 6.5, 5.0)  # mm that stay free between a figure and its frame: less where that spares a sheet
BORDER = 4  # marks that are the frame itself
NEXT = 2.5  # mm that stay free between a figure and a line to write on
MOST = 6  # frames on a sheet
_WRITTEN = (
    *((white, Form.WHOLE) for white in WHITES[:1]),
    *((white, form) for form in (Form.SHORT, Form.NONE) for white in WHITES),
)  # with how much white, and in which form what is read
_FREE, _LEAST, _NEAR = (
    0.0,
    (1 / 3, 1 / 4),
    (1 / 2, 2 / 5, 1 / 3, 1 / 4),
)  # shares of a frame beside its pole: any, of every frame, better
_NO_END = 10**6  # sheets, before any are found


def frames(construction: Construction, problem: Problem) -> tuple[Construction, tuple[Hung, ...]]:
    """The blank sheets: for each figure a frame with what is given in it (fixed pivots, guides, racks), its pole or
    its axes, lines for its vector equations and for what is read, the bar of its scale, and its place.

    Frames are of a few fixed sizes and together fill the sheet: a large drawing has a large frame, but neither the
    proportions of a polygon nor where it lies can be told from it. A circle diagram, which has no scale, has none where
    that would need a sheet more: it stands in the text; a mechanism that is drawn once more has none of its own.
    """
    on = problem.paper
    main = construction.figure(View.MECHANISM)
    figures = [enlarged(lettered(one, main)) for one in construction.figures]
    known = {(one.view, one.name): stands(construction, one, problem) for one in figures}
    figures = [one for one in figures if known[one.view, one.name] != one.marks]  # there is nothing to be drawn
    figures = [one for one in figures if not _is_drawn_again(one, figures, construction)]
    drawn = as_solved(reading_order([f for f in figures if to_scale(f) or f.aside or f.view is View.BODY]))
    lines = [fields(construction, figure) for figure in drawn]
    asked, told, found = _fewest(_choices(drawn, lines, problem), on)
    sizes = [size for sheet in found for size in sheet.sizes]
    blank = tuple(
        _frame(figure, size, known[figure.view, figure.name], some)
        for figure, size, some in zip(asked, sizes, told, strict=True)
    )
    return replace(construction, figures=blank, hand=TO_BE_DRAWN), tuple(
        Hung(sheet.landscape, sheet.tops) for sheet in found
    )


def _choices(
    asked: Sequence[Figure], told: Sequence[Fields], problem: Problem
) -> Iterator[tuple[Sequence[Figure], Sequence[Fields]]]:
    """What may have frames, the best first: all figures, those about base circles with room for the whole of these;
    without circle diagrams; with as much of base circles as the figures have room for."""
    whole = [completed(one, problem) for one in asked]
    there = [n for n, one in enumerate(asked) if not is_circle(one)] or [*range(len(asked))]
    for some in (whole, asked):
        yield some, told
        yield [some[n] for n in there], [told[n] for n in there]


def _fewest(
    choices: Iterator[tuple[Sequence[Figure], Sequence[Fields]]], on: Paper
) -> tuple[Sequence[Figure], Sequence[Fields], Sequence[Grid]]:
    """The first of these choices that needs the fewest sheets, with what is written in its frames, and the sheets."""
    tried: list[tuple[Sequence[Figure], Sequence[Fields], Sequence[Grid]]] = []
    seen: list[Sequence[Figure]] = []
    for asked, told in choices:
        if asked not in seen:
            seen.append(asked)
            tried.append((asked, *_with_fields(asked, told, on)))
    return min(tried, key=lambda one: len(one[2]))


def _is_drawn_again(figure: Figure, among: Sequence[Figure], construction: Construction) -> bool:
    """Whether a mechanism stands as it is in a later figure, and nothing is read off this one: there it is drawn."""
    parts = _parts(figure)
    if figure.view is not View.MECHANISM or not parts or is_measured(construction, figure):
        return False
    later = among[among.index(figure) + 1 :]
    return any(one.view is figure.view and one.scale == figure.scale and parts <= _parts(one) for one in later)


def _parts(figure: Figure) -> frozenset[tuple[str, complex, complex]]:
    """The links and joints of a mechanism, each where it stands."""
    drawn = [mark for mark in figure.marks if mark.owner and getattr(mark, "role", Role.LINK) is Role.LINK]
    boxes = [(mark.owner, bounds([mark])) for mark in drawn]
    return frozenset((owner, _rounded(low), _rounded(high)) for owner, (low, high) in boxes)


def _rounded(at: complex) -> complex:
    """To a thousandth of a millimetre."""
    return complex(round(at.real, 3), round(at.imag, 3))


def as_solved(figures: Sequence[Figure]) -> list[Figure]:
    """The figures in the order in which they are begun; links that are set free, with their polygons, stay together."""
    bodies = {figure.name for figure in figures if figure.view is View.BODY}
    free = [f for f in figures if f.view is View.BODY or (f.view.beside is View.BODY and f.name in bodies)]
    together = min(map(begun_in, free), default=0)
    return sorted(figures, key=lambda figure: together if figure in free else begun_in(figure))


def _with_fields(asked: Sequence[Figure], told: Sequence[Fields], on: Paper) -> tuple[Sequence[Fields], Sequence[Grid]]:
    """The sheets with lines for equations and for readings. No pole is near an edge, where it would tell to which side
    its polygon lies: for that there may be one sheet more."""
    found = _as_told(asked, told, on, _FREE)
    if not any(map(begins_at, asked)):
        return found
    better = [_as_told(asked, told, on, least) for least in _LEAST]
    return next((one for more in (0, 1) for one in better if len(one[1]) <= len(found[1]) + more), found)


def _as_told(
    asked: Sequence[Figure], told: Sequence[Fields], on: Paper, near: float
) -> tuple[Sequence[Fields], Sequence[Grid]]:
    """The sheets; where they need no sheet more with a line for each quantity that is read; with little white about the
    figures where that spares a sheet; near: as great a share of its frame lies on each side of a pole."""
    best, trials = (told, WHITES[0], (_NO_END, True)), list(_trials(asked, told))
    white, some = trials[-1]
    least = least_sheets([_needed(*one, white, _FREE) for one in zip(asked, some, strict=True)], on.format)
    for white, some in trials:
        found = _found([_needed(*one, white, near) for one in zip(asked, some, strict=True)], on)
        best = min(best, (some, white, tightness(found)[1:3]), key=itemgetter(2))
        if best[2] <= (least, False):
            break
    some, white, _ = best
    return some, _with_poles([*zip(asked, some, strict=True)], white, near, on)


def _trials(asked: Sequence[Figure], told: Sequence[Fields]) -> Iterator[tuple[float, Sequence[Fields]]]:
    """Frames with less and less room for what is written in them, then with less white. Bars that need a line of their
    own go before the names of readings do, and these before the readings."""
    for white, form in _WRITTEN:
        named = [_formed(figure, one, form, white) for figure, one in zip(asked, told, strict=True)]
        for some in (named, [one._replace(own=False) for one in named]):
            yield white, [one._replace(broad=True) for one in some]
            yield white, some


def _formed(figure: Figure, told: Fields, form: Form, white: float) -> Fields:
    """With readings in this form, in columns that the frame has room for."""
    if told.read is None:
        return told
    low, high = outline(figure)
    width = max((high - low).real + 2 * white, title_width(figure), NARROWEST)
    return told._replace(read=told.read.formed(form, width))


def _with_poles(asked: Sequence[tuple[Figure, Fields]], white: float, near: float, on: Paper) -> list[Grid]:
    """The sheets for these figures, with as many poles in the middle of their frames, or near it, as need no sheet
    more."""
    shares = [near] * len(asked)
    needs = [_needed(*one, white, near) for one in asked]
    best = _found(needs, on)
    for share, (n, one) in product(_NEAR, enumerate(asked)):
        tried = [*needs[:n], _needed(*one, white, share), *needs[n + 1 :]]
        if shares[n] > near or tried == needs:
            continue
        found = _found(tried, on)
        if len(found) <= len(best) and all(sheet.ease >= 1.0 for sheet in found):
            needs, best, shares[n] = tried, found, share
    return best


def _found(needs: Sequence[Need], on: Paper) -> list[Grid]:
    """The sheets on which these frames are best, whichever way they lie, each its own way where that spares one."""
    ways = dict.fromkeys([*((way,) for way in on.ways), on.ways])
    return min((_laid(needs, some, on.format) for some in ways), key=tightness)


def _laid(needs: Sequence[Need], ways: Sequence[bool], of: Format) -> list[Grid]:
    """The fewest sheets that lie in one of these ways (landscape or not), in order, with the most ease among these."""
    best: list[list[Grid]] = [[]]
    for end in range(1, len(needs) + 1):
        options = [
            [*best[start], sheet]
            for start in range(max(0, end - MOST), end)
            for way in ways
            if (sheet := grid(tuple(needs[start:end]), way, of)) is not None
        ]
        best.append(min(options, key=tightness))
    return best[-1]


def _needed(figure: Figure, told: Fields, white: float, near: float) -> Need:
    """The room of a figure with this white round it, what is written over and under it and its title
    below it; near: so great a share of the frame at least lies on either side of the pole."""
    (left, foot), (right, top) = ((one.real, one.imag) for one in outline(figure))
    wide, high = right - left, top - foot
    pole = begins_at(figure) if near else None
    if pole is not None:
        low, upper = bounds(figure.marks)
        part = 1 / (1 - near)
        wide = max(wide, part * (max(upper.real - pole.at.real, pole.at.real - low.real) + WHITE) - 2 * white)
        high = max(
            high, part * (max(upper.imag - pole.at.imag, pole.at.imag - low.imag) + WHITE) - 2 * min(NEXT, white)
        )
    high += sum(field + NEXT if field else white for field in (told.above, told.below))
    return Need(max(wide + 2 * white, title_width(figure), told.wide), high, figure.view.across is not None)


def _frame(figure: Figure, size: Size, known: Sequence[Mark], told: Fields) -> Figure:
    """The figure as a blank frame of this size."""
    (low, high), shown = framed(figure, (size[0], size[1] - told.above - told.below), known)
    low, high = low - 1j * told.below, high + 1j * told.above
    box = (low, complex(high.real, low.imag), high, complex(low.real, high.imag))
    if told.placed:
        shown += tuple(origin((low + 1j * told.below, high - 1j * told.above)))
    border = tuple(Segment(a=a, b=b, role=Role.DIRECTION, step=1) for a, b in zip(box, box[1:] + box[:1], strict=True))
    return replace(
        figure,
        title=doubtful(figure.title),
        marks=border + shown + tuple(written(told.within(figure, size[0]), low, high, shown)),
    )
