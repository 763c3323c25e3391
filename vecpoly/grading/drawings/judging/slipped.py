"""What follows from one mistake that explains the whole drawing costs nothing more: the mistake is one vector."""

from __future__ import annotations

from collections.abc import Sequence

from ....board.otherwise.slip import Slip
from ....foundation.slotted import replace
from ....words import Words
from ..expected import Expected
from .mark import Basis, FigureMark, VectorMark
from .reason import FAIR


def by_one_mistake(figures: Sequence[FigureMark], slip: Slip, world: Expected) -> tuple[FigureMark, ...]:
    """The figures, with all that is wrong but the mistake itself as what follows from it.

    The mistake is the vector that it was made with, or, where that is not drawn by itself, the first that it spoils.
    """
    wrong = [one for figure in figures if figure.drawn for one in figure.vectors if one.verdict not in FAIR]
    named = [one for one in wrong if slip.key in (one.key, f"{one.figure}:{one.key}")]
    ordered = sorted(wrong, key=lambda one: _order(one, world))
    root = next(iter(named or ordered), None)
    return tuple(
        replace(figure, vectors=tuple(_following(one, root) for one in figure.vectors)) if figure.drawn else figure
        for figure in figures
    )


def _order(one: VectorMark, world: Expected) -> tuple[int, int]:
    """By the figures, and by when it is drawn in them; what the mistake leaves out comes first."""
    names = [shape.name for shape in world.shapes]
    shape = world.shape(one.figure)
    edge = None if shape is None else shape.edge(one.key)
    return names.index(one.figure) if one.figure in names else -1, -1 if edge is None else edge.act


def _following(one: VectorMark, root: VectorMark | None) -> VectorMark:
    if root is None or one.verdict in FAIR or one is root:
        return one
    said = Words(
        f"与 ${root.symbol}$ 处的错误一致，不重复扣分",
        f"follows from the mistake at ${root.symbol}$; not penalised again",
    )
    return replace(one, basis=Basis.SLIP, reason=one.reason + Words("；", "; ") + said)
