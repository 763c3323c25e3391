"""The cognates of a four-bar in one of its positions, as the design asks for them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields

from ....designs.inversion.cognates import LEFT, RIGHT, Cognates
from ....designs.verdict import Verdict
from ..registry import Linkage, synthesizes
from .cognates import Fourbar, cognates
from .meetings import beyond
from .motions import Pose


@synthesizes(Cognates)
def both(design: Cognates) -> Iterator[Linkage]:
    """One answer: the lengths of both cognates, and where their pins lie."""
    bar = _posed(design)
    left, right = cognates(bar)
    values = dict(zip((*LEFT, *RIGHT), (1e3 * x for one in (left, right) for x in one.lengths), strict=True))
    pins = {field.name.upper(): complex(getattr(bar, field.name)) for field in fields(bar)}
    more = {"G": left.b, "H": left.c, "F": left.d, "M": right.b, "N": right.c}
    yield Linkage(values=values, pins=pins | more, verdict=Verdict.VALID, order=(0.0,))


def _posed(design: Cognates) -> Fourbar:
    """The given four-bar at its angle."""
    d = complex(design.AD.si)
    b = Pose.turned(0j, design.phi.si).place(complex(design.AB.si))
    c = beyond(b, design.BC.si, d, design.CD.si, 1 if design.side == "left" else -1)
    assert c is not None, "the data were looked through"
    return Fourbar(a=0j, b=b, c=c, d=d, e=b + (c - b) * design.E.at / design.BC.si)
