"""Which mistake explains a drawing: a catalogued one, an image turned over, two names or two letters exchanged."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations

from ....board.otherwise.slip import Slip
from ....words import Words
from ..expected import Expected, Shape
from ..matching.assign import Match
from ..matching.fit import Fit
from ..matching.naming import letters_in
from ..model import DrawingKey
from ..segment import Label
from .mark import VectorMark, Verdict

ROOM, SHARE = 0.3, 0.01  # mm, and of a vector's length: beside T, for lengths that were rounded when laid off
FAR, CLEARLY = 8.0, 2.0  # mm, and times: how far a letter stands from its point, and nearer to another
LETTER_ROOM = 8.0  # mm: a letter of a point stands within


def slips_that_fit(key: DrawingKey, matches: Mapping[str, Match]) -> tuple[Slip, ...]:
    """The mistakes that lead to just what is drawn: more than one where they draw the same."""
    return tuple(slip for slip, world in key.worlds if _fits(key, world, matches))


def _fits(key: DrawingKey, world: Expected, matches: Mapping[str, Match]) -> bool:
    return all(_same(key, world.shape(name), match, name) for name, match in matches.items())


def _same(key: DrawingKey, shape: Shape | None, match: Match, name: str) -> bool:
    """Whether a figure has just the vectors that are drawn."""
    if shape is None:
        return not match.lines
    there = {edge.key: edge.along for edge in shape.edges}
    for quantity, line in match.lines.items():
        should, allowed = there.get(quantity), key.allowed[name, quantity]
        if should is None:
            return False
        room = key.allowance.wrong * allowed.mm + ROOM + (SHARE + 0.0175 * allowed.degrees) * abs(should)
        if abs(line.along - should) > room:
            return False
    exact = key.exact.shape(name)
    undrawn = {edge.key for edge in exact.edges if edge.key not in match.lines} if exact else set()
    return all(_spared(key, match, name, quantity, there[quantity]) for quantity in undrawn & there.keys())


def _spared(key: DrawingKey, match: Match, name: str, quantity: str, along: complex) -> bool:
    """Whether a vector need not be drawn: it is nothing, or both its ends are there, where only its line is left
    out."""
    ends = {end for line in match.lines.values() for end in (line.start, line.end)}
    room = key.allowance.wrong * key.allowed[name, quantity].mm + ROOM
    return abs(along) <= ROOM or any(abs(b - a - along) <= room for a in ends for b in ends)


def turned_over(shape: Shape, places: Mapping[str, complex], wrong: Sequence[VectorMark]) -> Iterator[Words]:
    """Images of links whose letters run the other way round."""
    if not wrong:
        return
    for image in shape.images:
        if len(image) != 3:
            continue
        letters = [vertex.letters[0] if (vertex := shape.vertex(at)) else "" for at in image]
        if not all(letter in places for letter in letters):
            continue
        a, b, c = (places[letter] for letter in letters)
        flipped = (image[2] - image[0]) / (image[1] - image[0]) if image[1] != image[0] else 0j
        if abs(flipped.imag) > 0.05 and abs(c - a - flipped.conjugate() * (b - a)) < ROOM + 0.02 * abs(c - a):
            name = "".join(letters)
            yield Words(
                f"影像 △{name} 的字母顺序与构件上相反", f"the image △{name} has its letters in the reversed order"
            )


def exchanged(marks: Sequence[VectorMark], lines: Match) -> Iterator[Words]:
    """Two vectors whose names have been exchanged."""
    wrong = [one for one in marks if one.verdict is Verdict.WRONG and one.own is not None]
    for one, other in combinations(wrong, 2):
        named = all(lines.lines[mark.key].name for mark in (one, other) if mark.key in lines.lines)
        if named and _is(one.own, other) and _is(other.own, one):
            yield Words(
                f"${one.symbol}$ 与 ${other.symbol}$ 的名称似乎互换了",
                f"${one.symbol}$ and ${other.symbol}$ seem exchanged by name",
            )


def _is(own: complex | None, other: VectorMark) -> bool:
    return own is not None and abs(own - other.should) <= 2 * other.allowed + SHARE * abs(other.should)


def misplaced(fit: Fit, places: Mapping[str, complex], labels: Sequence[Label], shift: complex) -> Iterator[Words]:
    """Letters that stand at another letter's point."""
    for label in labels:
        at = label.middle / fit.scale - shift
        for letter in letters_in(label.text):
            if letter not in places or abs(at - places[letter]) * fit.scale < FAR:
                continue
            near = min(places, key=lambda other: abs(at - places[other]))
            gap = abs(at - places[near]) * fit.scale
            if gap < LETTER_ROOM and abs(at - places[letter]) * fit.scale > CLEARLY * gap:
                yield Words(f"字母 {letter} 标在 {near} 点处", f"the letter {letter} stands at the point {near}")
