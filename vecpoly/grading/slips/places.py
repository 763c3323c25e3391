"""What explains a wrong place: coordinates in another unit or of another sign, a line divided on the other side."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from ..compare.band import Target
from ..compare.measured import Measured
from ..key import AnswerKey, Graded
from ..told.message import Message, message
from ..told.named import Told

TENS = 4
ALONG = 1e-6  # of their distance: nearer to their line two centres have the third on it
_CENTRE = "P_"


def of_places(one: Graded, mine: Measured, target: Target, key: AnswerKey) -> Iterator[Message]:
    """Every explanation that fits a place."""
    if mine.at is None or target.at is None:
        return
    given, right = complex(*mine.at), complex(*target.at)
    if abs(right) > 2 * one.allowed:
        tens = (n for n in range(-TENS, TENS + 1) if n and abs(given / 10.0**n - right) <= one.allowed)
        yield from (message(Told.POW10, n=str(n)) for n in tens)
    others = {-right, right.conjugate(), -right.conjugate()}
    if any(abs(given - other) <= one.allowed and abs(other - right) > 2 * one.allowed for other in others):
        yield message(Told.COORDINATE_SIGN)
    for ends, other in _divided_otherwise(one, right, key):
        if abs(given - other) <= one.allowed and abs(other - right) > 2 * one.allowed:
            yield message(Told.DIVIDED, line=ends)


def _divided_otherwise(one: Graded, right: complex, key: AnswerKey) -> Iterator[tuple[str, complex]]:
    """The lines through P_ik and P_jk on which P_ij lies, each with the point that divides it in the same ratio on the
    other side: between them, or beyond."""
    centres = [(_links(each.key), each.symbol, complex(*each.at)) for each in key.quantities if each.at is not None]
    for (ik, p, a), (jk, q, b) in combinations(centres, 2):
        if not _links(one.key) or ik ^ jk != _links(one.key) or a == b:
            continue
        share = (right - a) / (b - a)
        if abs(share.imag) < ALONG and abs(2 * share.real - 1) > ALONG:
            yield f"{p}{q}", a + (b - a) * share.real / (2 * share.real - 1)


def _links(key: str) -> frozenset[str]:
    """The links of a centre: P_13, P_1_12; none of another place."""
    body = key.removeprefix(_CENTRE)
    return frozenset(body.split("_") if "_" in body else body) if body != key else frozenset()
