"""The names of points and of lines' ends: those at one place share one label."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache

from ...algebra.formula import Row, Txt, row
from ...board.paper.marks import Dot, Mark, Point, Role, Segment
from ...board.strokes import OVERRUN
from ...typeset import Box, layout, layout_words
from ...typeset.atoms import is_unit
from ...typeset.runs import letters
from ...words import Lang, Words
from ..hues import Tones, line_hue
from ..style import LETTER, THIN, Hue
from ..symbols.shapes import NEAR
from .actions import along_action, line_of_action
from .dimensions import beyond_end, dimension_line, over
from .numbers import along_line
from .want import Piece, Spot, Thing, Want

Named = tuple[complex, list[Point]]  # a place, and the points that have a name there
ON_LINE, PARALLEL = 0.5, 0.05  # mm by which a line is off one with it; sine of an angle between lines of one direction
TOGETHER = 0.25  # mm
INNER = 0.3  # of a line: a letter nearer to an end is the name of the end
MEASURED = (Role.CONSTRUCTION, Role.IDEAL)
RATE = re.compile(r"d([a-zψ])/d([tφ])")  # a derivative: its d are no symbols
NAMED = (Role.CENTRE, Role.HIDDEN)  # lines that have a name at an end


def piece(text: str, hue: Hue, step: int, dx: float = 0.0) -> Piece:
    """A symbol in type that belongs to a step."""
    return Piece(_lettered(text), dx, hue, step)


@lru_cache(maxsize=1024)
def _lettered(text: str) -> Box:
    """A symbol in type, of an axis with its unit upright; the same few come again and again."""
    if (rate := RATE.fullmatch(text)) is not None:
        return layout(Row((Txt("d"), *row(rate[1]).items, Txt("/d"), *row(rate[2]).items)), LETTER)
    symbol, stroke, unit = text.partition("/")
    return layout_words(f"${symbol}$/{unit}", LETTER) if stroke and is_unit(unit) else layout(row(text), LETTER)


def points(marks: tuple[Mark, ...], taken: list[Spot], lang: Lang, tones: Tones) -> Iterable[Want]:
    """The label of every lettered place."""
    lines = [mark for mark in marks if isinstance(mark, Segment)]
    numbered = any(isinstance(mark, Point) and mark.label == "II" for mark in marks)
    ruled = {mark.b: mark for mark in lines if mark.role is Role.DIRECTION}
    named = {
        end: mark for mark in lines if mark.role in NAMED and abs(mark.b - mark.a) > NEAR for end in (mark.a, mark.b)
    }
    for at, group in _once(_grouped(marks), ruled):
        pieces = tuple(_pieces(group, lang, tones, numbered))
        if any(mark.dot is not Dot.NONE for mark in group):
            yield Want(pieces, (at,), (0j,), keep_at(at, taken), (at, at), thing=Thing.POINT)
        elif (action := line_of_action(group[0], lines)) is not None:
            yield along_action(pieces, at, action)
        elif (measured := dimension_line(at, marks)) is not None:
            yield over(measured, pieces)
        elif group[0].label[:1].islower() and (line := _through(at, lines)) is not None:
            yield along_line(line.a, line.b, THIN / 2, pieces, Thing.END)
        else:
            keep = keep_at(at, taken)
            bare = at in named and at not in ruled and not keep
            yield beyond_end(pieces, at, named[at]) if bare else _end(pieces, at, keep, ruled.get(at))


def _grouped(marks: Iterable[Mark]) -> list[Named]:
    """The points that have a name, those at one place together, or that a hand hardly parts, none twice."""
    groups: list[Named] = []
    for mark in marks:
        if isinstance(mark, Point) and (mark.label or mark.said):
            home = next((g for at, g in groups if abs(at - mark.at) < _as_one(mark, g[0])), None)
            if home is None:
                groups.append((mark.at, [mark]))
            elif all((other.label, other.said) != (mark.label, mark.said) for other in home):
                home.append(mark)
    return groups


def _as_one(one: Point, other: Point) -> float:
    """How far apart (mm) two names may be for one label: O and the end of a polygon that all but closes."""
    return NEAR if Dot.NONE in (one.dot, other.dot) else TOGETHER


def _once(groups: list[Named], ruled: Mapping[complex, Segment]) -> Iterator[Named]:
    """Without directions in words that stand on the same line once more, or that name lines of two directions."""
    told = [(group[0].said, ruled[at]) for at, group in groups if not group[0].label and at in ruled]
    said: list[tuple[Words | None, Segment]] = []
    for at, group in groups:
        one = (group[0].said, ruled[at]) if not group[0].label and at in ruled else None
        if one is not None:
            like = [line for words, line in told if words == one[0]]
            before = [line for words, line in said if words == one[0]]
            if not all(_parallel(one[1], line) for line in like) or any(_on(one[1], line) for line in before):
                continue
            said.append(one)
        yield at, group


def _parallel(line: Segment, other: Segment) -> bool:
    """Whether two lines have one direction."""
    u, v = (one.b - one.a for one in (line, other))
    return abs((u * v.conjugate()).imag) < PARALLEL * max(abs(u) * abs(v), NEAR)


def _on(line: Segment, other: Segment) -> bool:
    """Whether both are parts of one straight line."""
    along = (other.b - other.a) / max(abs(other.b - other.a), NEAR)
    return all(abs(((end - other.a) * along.conjugate()).imag) < ON_LINE for end in (line.a, line.b))


def _pieces(group: Iterable[Point], lang: Lang, tones: Tones, numbered: bool) -> Iterator[Piece]:
    """Their names in one line, with commas between; numbered: I is a number among others, and no point."""
    x = 0.0
    for n, mark in enumerate(group):
        if n:
            comma = Piece(layout(Txt(","), LETTER), x, Hue.BLACK, mark.step)
            yield comma
            x += comma.box.width + 0.3 * LETTER
        if mark.said is not None and not mark.label:
            made = Piece(layout_words(mark.said.of(lang), LETTER), x, Hue.BLACK, mark.step)
        elif mark.label == "I" and not numbered:
            made = Piece(letters("I", LETTER, False), x, line_hue(mark.key, tones, Hue.BLACK), mark.step)
        else:
            made = piece(mark.label, line_hue(mark.key, tones, Hue.BLACK), mark.step, x)
        yield made
        x = made.dx + made.box.width


def _through(at: complex, lines: Iterable[Segment]) -> Segment | None:
    """The shortest measured line in the middle of which a place lies: the small letter that stands there is its
    length."""
    found = [line for line in lines if line.role in MEASURED and abs(line.b - line.a) > NEAR and _between(at, line)]
    return min(found, key=lambda line: abs(line.b - line.a), default=None)


def _between(at: complex, line: Segment) -> bool:
    part = (at - line.a) / (line.b - line.a)
    return INNER < part.real < 1 - INNER and abs(part.imag * (line.b - line.a)) < NEAR


def _end(pieces: tuple[Piece, ...], at: complex, radius: float, line: Segment | None) -> Want:
    """A name at the end of a line; a direction's stands beyond its line, or beside what of it runs on past the point
    that it found."""
    if line is None or abs(line.b - line.a) < NEAR:
        return Want(pieces, (at,), (0j,), radius, (at, at), thing=Thing.END)
    u = (at - line.a) / abs(at - line.a)
    foot = at - min(OVERRUN, abs(at - line.a)) * u
    feet = tuple(at + (foot - at) * share for share in (0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5))
    ways = (u, *(u * side for _ in range(3) for side in (1j, -1j)))
    return Want(pieces, feet, ways, THIN / 2, (foot, at), one_sided=True, thing=Thing.DIRECTION)


def keep_at(at: complex, taken: list[Spot]) -> float:
    """The radius of whatever is drawn at a point."""
    return max((radius for here, radius in taken if abs(here - at) < NEAR), default=0.0)
