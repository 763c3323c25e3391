"""The condition for a crank, and the range of CD by trying which links turn fully about their neighbours."""

from __future__ import annotations

from ...designs.grashof import Grashof
from ...designs.verdict import Verdict
from .registry import Linkage, synthesizes

_HALVINGS = 80


@synthesizes(Grashof)
def grashof(design: Grashof) -> list[Linkage]:
    """Shortest and longest beside the others; the least CD with which neither neighbour turns fully, and the most."""
    a, b, c, d = (one.si for one in (design.AB, design.BC, design.CD, design.AD))
    least, *middle, most = sorted((a, b, c, d))
    low, high = 0.0, max(b, d)  # where CD is as long as the longest it is a double rocker
    for _ in range(_HALVINGS):
        half = (low + high) / 2
        low, high = (low, half) if _rocks(half, (a, b, d)) else (half, high)
    values = {
        "ends": least + most,
        "middle": sum(middle),
        "CD_min": high,
        "CD_max": a + b + d,
        "AB": a,
        "BC": b,
        "CD": c,
        "AD": d,
    }
    pins = {"A": 0j, "D": complex(d)}
    return [
        Linkage(
            values={key: 1e3 * value for key, value in values.items()},
            pins=pins,
            verdict=Verdict.VALID,
            order=(a, b, d, 0.0),
        )
    ]


def _rocks(frame: float, others: tuple[float, float, float]) -> bool:
    """Whether the chain closes and neither neighbour of this frame turns fully; others: opposite, then neighbours."""
    opposite, one, two = others
    closes = 2 * max(frame, *others) < frame + sum(others)
    return closes and not (_turns(one, frame, two, opposite) or _turns(two, frame, one, opposite))


def _turns(link: float, frame: float, other: float, coupler: float) -> bool:
    """Whether a link on the frame turns fully: the others close where it lies along the frame, either way."""
    return abs(coupler - other) <= abs(frame - link) and frame + link <= coupler + other
