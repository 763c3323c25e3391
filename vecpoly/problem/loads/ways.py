"""The direction of a force as written: ``180 deg`` from the x axis, or ``along AO``, a ray of the driving link."""

from __future__ import annotations

from cmath import phase

from ...errors import FaultError
from ...foundation.patterns import pattern
from ...units.reading import Dim, read
from ...words import Words
from ..links.draft import Draft, letters_of
from ..schema.faults import not_on_link
from ..schema.models import LoadSpec, TableSpec
from .driven import Driven

_ALONG = pattern(r"\s*(?:along\s+|沿\s*)(\S+)\s*")
Way = tuple[float, tuple[str, str] | None]


def read_way(spec: LoadSpec, draft: Draft, driven: Driven) -> Way:
    """The direction (rad) in the given position, and the ray that it keeps to; raises FaultError."""
    m = _ALONG.fullmatch(str(spec.direction))
    try:
        return (read(spec.direction, Dim.ANGLE).si, None) if m is None else _along(m[1], spec, draft, driven)
    except FaultError as fault:
        raise fault.under("direction") from None


def _along(ray: str, spec: LoadSpec, draft: Draft, driven: Driven) -> Way:
    start, end = letters_of(ray)
    for letter in (start, end):
        if letter not in draft.held:
            raise not_on_link(letter, draft.name, draft.held)
    if draft.points[start] == draft.points[end]:
        raise FaultError(
            Words(f"{start} 与 {end} 是同一点，没有方向", f"{start} and {end} are one point, which is no direction"),
            code="contradiction",
        )
    if draft.name != driven.drive.link or driven.drive.slide or driven.drive.between:
        raise FaultError(
            Words(
                f"只有转动原动件上的力可随构件转动；构件 {draft.name} 上的力请写方向角，如 direction: 180 deg",
                "only a force on a driving link that turns may turn with it; write an angle of this one on link "
                f"{draft.name}, e.g. direction: 180 deg",
            ),
            code="contradiction",
        )
    if isinstance(spec.size, TableSpec):
        raise FaultError(
            Words(
                "随构件转动的力没有沿其方向的行程；其大小不能由表给出",
                "a force that turns with its link has no stroke along itself; its size cannot be that of a table",
            ),
            code="contradiction",
        )
    return driven.drive.position + phase(draft.points[end] - draft.points[start]), (start, end)
