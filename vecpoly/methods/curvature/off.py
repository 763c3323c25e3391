"""What lies off the paper is found on a second figure, at a smaller scale: lines keep their directions there."""

from __future__ import annotations

from ...board.paper.marks import Dot, Role
from ...plane import nominal
from ...words import Words
from ..centres.size import Paper
from .state import CurvatureFigure

SEEN = 6.0  # mm from the pole: nearer points have no dot of their own


def carry_over(fig: CurvatureFigure, paper: Paper | None) -> None:
    """Pole and normals once more on the second figure; paper: its own, None on a sketch."""
    if fig.off is None:
        return
    names = [f"${name}$" for name in sorted(fig.off.names, key=_order)]
    told = paper.told if paper else ""
    fig.board.step(
        Words(
            f"{'、'.join(names)} 落在图外：另取 {told} 作缩小图，将 ${fig.p}$ 和各法线移画其上，长度按比例缩小，"
            "方向不变（用三角板推平行线）；这些点及到它们的连线都画在缩小图上。",
            f"Draw ${fig.p}$ and the normals once more, to the scale {told}, for {', '.join(names)} "
            f"lie{'s' if len(names) == 1 else ''} off the paper. Lengths are reduced, directions are carried over with "
            "the set squares; these points, and the lines to them, are drawn there.",
        ),
        fig.off.pane,
    )
    _again(fig)


def _order(name: str) -> tuple[bool, str]:
    return name[0].islower(), name


def _again(fig: CurvatureFigure) -> None:
    """P with its letter, the normals through it, and dots where their points stand clear of it."""
    off = fig.off
    assert off is not None
    at = fig.pole * off.ratio
    if fig.p not in off.names:
        fig.board.plot(off.pane, at, fig.p)
    for ray in fig.rays:
        spots = [spot * off.ratio for spot in ray.spots()]
        low, high = at - 10 * ray.line.along, at + 10 * ray.line.along
        fig.board.join(off.pane, low, high, Role.CENTRE)
        for spot, letter in zip(spots, filter(None, (ray.moving, ray.fixed)), strict=True):
            clear = abs(complex(nominal(spot - at))) > SEEN
            fig.board.plot(off.pane, spot, fig.shown(letter) if clear else "", Dot.POINT if clear else Dot.NONE)
