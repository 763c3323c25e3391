"""A polygon that is right but for how it lies: its directions are wrong from one cause, which costs once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import degrees

import numpy as np

from ....foundation.slotted import replace
from ....words import Words
from ..matching.fit import Fit
from ..matching.held import UPRIGHT, Held, one_turn
from .mark import NO_WORDS, Basis, FigureMark, VectorMark, Verdict
from .reason import FAIR

HALF, UNSEEN = 180.0, 0.5  # degrees: half a turn; a direction that a mirror leaves
NO_DIAGRAM = Words(
    "没有认出正放的机构简图，分不清是多边形画歪了，还是图纸放斜了；请核对",
    "no diagram that lies upright was recognised: the polygon may be drawn askew, or the paper have lain so; check it",
)


@dataclass(slots=True)
class _Cause:
    """One way in which the paper lay; root: the first vector that it spoils."""

    held: Held
    root: VectorMark | None = None


def as_laid(figures: Sequence[FigureMark], fits: Sequence[Fit]) -> tuple[FigureMark, ...]:
    """The figures, those that had to be held by themselves with the directions that they were drawn with."""
    laid = {fit.shape.name: fit.held for fit in fits if fit.held != UPRIGHT}
    upright = any(fit.shape.diagram for fit in fits)
    causes: list[_Cause] = []
    found: list[FigureMark] = []
    for one in figures:
        if one.figure in laid:
            held = laid[one.figure]
            cause = next((each for each in causes if one_turn(each.held, held)), None)
            if cause is None:
                causes.append(cause := _Cause(held))
            one = _figure(one, held, cause, upright)
        found.append(one)
    return tuple(found)


def _figure(figure: FigureMark, held: Held, cause: _Cause, upright: bool) -> FigureMark:
    vectors = tuple(_vector(one, held, cause) for one in figure.vectors)
    doubt = figure.doubt or (None if upright else NO_DIAGRAM)
    turned = 0.0 if held.mirror else held.degrees
    said = (_told(held), *figure.remarks)
    return replace(figure, vectors=vectors, remarks=said, turned=turned, mirrored=held.mirror, doubt=doubt)


def _told(held: Held) -> Words:
    if held.mirror:
        return Words(
            "整个多边形画成了镜像；各矢量的长度和图形的封闭按还原后衡量，方向应按机构简图确定",
            "the whole polygon is drawn in a mirror; lengths and closing are held against it unmirrored; directions "
            "are taken from the diagram",
        )
    by, way = abs(held.degrees), Words("逆时针", " ccw") if held.degrees > 0 else Words("顺时针", " cw")
    way = Words("", "") if by == HALF else way
    return Words(
        f"整个多边形{way.zh}转过了 {by:.3g}°；各矢量的长度和图形的封闭按转正后衡量，方向应按机构简图确定",
        f"the whole polygon is turned by {by:.3g}°{way.en}; lengths and closing are held against it upright; "
        "directions are taken from the diagram",
    )


def _vector(one: VectorMark, held: Held, cause: _Cause) -> VectorMark:
    """As it was drawn: what is right in the polygon has a wrong direction on the sheet."""
    if one.own is None:
        return one
    own, tail = held.drawn(one.own), held.drawn(one.tail)
    if one.verdict not in FAIR or one.basis is Basis.SLIP:
        return replace(one, own=own, tail=tail)
    lean = degrees(float(np.angle(own / one.should)))
    if held.mirror and abs(lean) <= UNSEEN:
        return replace(one, own=own, tail=tail)  # along the mirror
    basis, said = (Basis.EXACT, NO_WORDS) if cause.root is None else (Basis.SLIP, _follows(cause.root))
    turned = replace(
        one, own=own, tail=tail, verdict=Verdict.WRONG, direction=Verdict.WRONG, sense=True, turned=lean, basis=basis,
        reason=leaning(lean) + said,
    )  # fmt: skip
    cause.root = cause.root or turned
    return turned


def leaning(by: float) -> Words:
    """That a direction is off by so many degrees with the polygon."""
    off = f"{by:+.1f}°".replace("-", "−")
    return Words(f"长度可以，方向随整个多边形偏了 {off}", f"length fine, direction off by {off} with the whole polygon")


def _follows(root: VectorMark) -> Words:
    return Words(
        f"；与 ${root.symbol}$ 同一原因，不重复扣分", f"; of one cause with ${root.symbol}$, not penalised again"
    )
