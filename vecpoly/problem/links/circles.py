"""The pitch circle of a gear, the profile of a disc."""

from __future__ import annotations

from collections.abc import Mapping

from ...errors import FaultError
from ...mechanism.model import Circle
from ...units.reading import Dim, positive, read
from ...words import Words
from ..schema.faults import meant
from ..text.source import Value
from .draft import Draft


def give_circle(draft: Draft, data: Mapping[str, Value]) -> None:
    """A gear with its pitch circle, or a disc with its profile."""
    kinds = [key for key in ("gear", "disc") if key in data]
    if len(kinds) > 1:
        raise FaultError(
            Words(
                f"构件 {draft.name} 既是齿轮又是圆盘；请只写其一及其半径",
                f"link {draft.name} is a gear and a disc at once; one of them, with its radius",
            ),
            "disc",
            code="contradiction",
        )
    if not kinds and "radius" in data:
        raise FaultError(
            Words(
                "半径属于齿轮或圆盘；请写 gear: C, radius: 60 mm 或 disc: O, radius: 40 mm",
                "a radius belongs to a gear or a disc; write gear: C, radius: 60 mm or disc: O, radius: 40 mm",
            ),
            "radius",
            code="spelling",
        )
    for kind in kinds:
        _circle(draft, kind, data)


def _circle(draft: Draft, kind: str, data: Mapping[str, Value]) -> None:
    centre = str(data[kind])
    if centre not in draft.points:
        raise FaultError(
            Words(f"中心“{centre}”不在构件 {draft.name} 上", f"the centre '{centre}' is not on link {draft.name}")
            + meant(centre, draft.points),
            kind,
            code="unknown-name",
        )
    if "radius" not in data:
        raise FaultError(
            Words(
                f"{kind} 要有{'节圆' if kind == 'gear' else ''}半径；请写 {kind}: {centre}, radius: 60 mm",
                f"a {kind} needs its {'pitch ' if kind == 'gear' else ''}radius; write {kind}: {centre}, radius: 60 mm",
            ),
            code="missing",
        )
    size = read(data["radius"], Dim.LENGTH)
    edge = kind == "disc" and size.si == 0  # a knife edge, however its zero is written
    radius = size if edge else positive(data["radius"])
    circle = Circle(link=draft.name, centre=centre, radius=radius.si)
    draft.gear, draft.disc = (circle, None) if kind == "gear" else (None, circle)
    if radius.si:  # of a knife edge there is nothing to tell
        draft.note(f"r_{draft.name}", radius.si, radius.text)
