"""One vector against what it should be: length, direction, sense."""

from __future__ import annotations

from math import degrees

import numpy as np

from ....errors import VecpolyError
from ....names import parse_rel
from ....words import Words
from ...allowance import Allowance
from ..expected import Edge
from ..segment import Segment
from .mark import Basis, VectorMark, Verdict
from .tolerance import Allowed

QUARTER = 90.0  # degrees
WORST = (Verdict.RIGHT, Verdict.CLOSE, Verdict.WRONG, Verdict.MISSING)
REVERSAL = 20.0  # degrees: a vector that points the other way, and not merely elsewhere


def judged(
    edge: Edge,
    figure: str,
    line: Segment,
    should: complex,
    allowed: Allowed,
    rule: Allowance,
    heads: bool,
    basis: Basis,
) -> VectorMark:
    """The mark of a vector drawn as this line; should: the vector that it is held against."""
    own = line.along
    turned = degrees(float(np.angle(own / should)))
    sense = abs(turned) <= 180 - REVERSAL
    lean = turned if sense else (turned - 180 if turned > 0 else turned + 180)
    off, mm = abs(own) - abs(should), float(np.hypot(allowed.mm, rule.k * line.sigma))
    length = _banded(abs(off), mm, rule)
    direction = _direction(own, should, lean, mm, allowed, rule)
    worst = max((length, direction, Verdict.RIGHT if sense else Verdict.WRONG), key=WORST.index)
    return VectorMark(
        key=edge.key,
        symbol=symbol(edge.key),
        figure=figure,
        verdict=worst,
        length=length,
        direction=direction,
        sense=sense if line.headed or not heads else None,
        own=own,
        should=should,
        off=off,
        turned=lean,
        allowed=mm,
        basis=basis,
        tail=line.start,
        where=line.where,
        keys=edge.keys,
    )


def missing(edge: Edge, figure: str, allowed: Allowed) -> VectorMark:
    """The mark of a vector that is not drawn."""
    return VectorMark(
        key=edge.key,
        symbol=symbol(edge.key),
        figure=figure,
        verdict=Verdict.MISSING,
        length=Verdict.MISSING,
        direction=Verdict.MISSING,
        sense=None,
        should=edge.along,
        allowed=allowed.mm,
        tail=edge.a,
        reason=Words("图上没有此矢量", "this vector is not on the drawing"),
        keys=edge.keys,
    )


def symbol(key: str) -> str:
    """The textbook's symbol of a quantity."""
    try:
        return parse_rel(key).symbol
    except VecpolyError:
        head, _, body = key.partition("_")
        return f"{head}_{{{body}}}" if body else head


def _banded(off: float, allowed: float, rule: Allowance) -> Verdict:
    if off <= allowed:
        return Verdict.RIGHT
    return Verdict.CLOSE if off <= rule.wrong * allowed else Verdict.WRONG


def _direction(own: complex, should: complex, lean: float, mm: float, allowed: Allowed, rule: Allowance) -> Verdict:
    """By the angle; a short line by how far its tip lies aside."""
    aside = abs((own / should).imag) * abs(should)
    by_tip = Verdict.WRONG if abs(lean) > QUARTER else _banded(aside, mm, rule)
    if abs(should) < rule.short:
        return by_tip
    return min(by_tip, _banded(abs(lean), allowed.degrees, rule), key=WORST.index)
