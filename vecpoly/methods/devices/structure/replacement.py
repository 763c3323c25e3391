"""Replacement of higher pairs by links (高副低代):
a link between the two centres of curvature, pinned there; on a flat face it slides."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from dataclasses import dataclass

from ....devices.structure import Structure
from ....devices.structure_pairs import Chain, Form, Pair

PRESSURE = math.radians(20)  # between the line of action of two gears and the common tangent of their pitch circles


@dataclass(frozen=True, slots=True, kw_only=True)
class Substitute:
    """The link that stands for a higher pair, with its two pairs."""

    link: str
    of: Pair
    pairs: tuple[Pair, Pair]


@dataclass(frozen=True, slots=True)
class Replaced:
    """The chain with lower pairs only, and what stands for what."""

    chain: Chain
    substitutes: tuple[Substitute, ...]


def replaced(chain: Chain, device: Structure) -> Replaced:
    """Replace every higher pair."""
    high = [pair for pair in chain.pairs if not pair.form.is_lower]
    letters = _letters({pair.letter for pair in chain.pairs})
    made = tuple(_substitute(pair, device.free_number(i), letters) for i, pair in enumerate(high))
    lower = tuple(pair for pair in chain.pairs if pair.form.is_lower)
    return Replaced(
        Chain((*chain.links, *(s.link for s in made)), lower + tuple(pair for s in made for pair in s.pairs)), made
    )


def _letters(used: set[str]) -> Iterator[str]:
    """O1, O2, ... as far as they are free."""
    number = 0
    while True:
        number += 1
        if f"O{number}" not in used:
            yield f"O{number}"


def _substitute(pair: Pair, link: str, letters: Iterator[str]) -> Substitute:
    """Pinned at each centre of curvature; on a flat face sliding along it."""
    ends = _feet(pair) if pair.form is Form.G else pair.about
    one, two = (
        _end(pair, touching, centre, link, next(letters)) for touching, centre in zip(pair.links, ends, strict=True)
    )
    return Substitute(link=link, of=pair, pairs=(one, two))


def _end(pair: Pair, touching: str, centre: complex | None, link: str, letter: str) -> Pair:
    if centre is None:
        return Pair(letter=letter, form=Form.P, links=(link, touching), at=pair.at, along=1j * pair.normal)
    return Pair(letter=letter, form=Form.R, links=(touching, link), at=centre)


def _feet(pair: Pair) -> tuple[complex, complex]:
    """Of two gears: the feet of the perpendiculars from their centres to the line of action (inclined the other way
    where one runs inside the other)."""
    one, two = pair.about
    assert one is not None and two is not None
    inside = ((one - pair.at).conjugate() * (two - pair.at)).real > 0
    along = 1j * (two - one) / abs(two - one) * cmath.rect(1.0, -PRESSURE if inside else PRESSURE)
    first, second = (pair.at + along * (along.conjugate() * (centre - pair.at)).real for centre in (one, two))
    return first, second
