"""The path of a point near its position, and the circle that follows it best."""

from __future__ import annotations

from collections.abc import Sequence
from math import radians

import numpy as np

from ...board.paper.marks import Dot, Role
from ...errors import VecpolyError
from ...plane import Points, nominal
from ...words import Words
from ..centres.size import Paper
from ..positions.placed import placed
from .state import CurvatureFigure

REACH, STEP = 45, 5  # degrees of the crank to both sides, and from one point of the path to the next
TRAVEL = 0.25  # of the mechanism's size: the same of a sliding drive, to both sides
HALF = 45.0  # mm of the osculating circle to both sides; a small circle is drawn whole
WHOLE = 2.6  # rad: from so much to both sides


def draw_paths(fig: CurvatureFigure, paper: Paper) -> None:
    """Path and osculating circle of every point of which the centre was found."""
    if not fig.centres:
        return
    letters = "、".join(f"${fig.shown(p)}$" for p in fig.centres)
    some, rings = ("path", "circle") if len(fig.centres) == 1 else ("paths", "circles")
    fig.board.step(
        Words(
            f"描出 {letters} 的轨迹与曲率圆（虚线）：两者在该点附近重合。",
            f"Trace the {some} of {letters.replace('、', ', ')}; near the point the osculating {rings} (dashed) cannot "
            f"be told from the {some}.",
        ),
        fig.pane,
    )
    places = _places(fig)
    for point, centre in fig.centres.items():
        run = _inside([one.get(point) for one in places], paper)
        if len(run) > 2:
            fig.board.curve(fig.pane, run, Role.GIVEN)
        _osculating(fig, point, complex(nominal(centre)))
        if paper.holds(complex(nominal(centre))):
            _radius(fig, point, centre)


def _osculating(fig: CurvatureFigure, point: str, centre: complex) -> None:
    e = complex(nominal(fig.at(point)))
    radius = abs(e - centre)
    half = min(HALF / max(radius, 1e-9), np.pi)
    half = float(np.pi if half > WHOLE else half)
    start = float(np.angle(e - centre)) - half
    fig.board.circle(fig.pane, fig.centres[point], radius, Role.HIDDEN, start=start, sweep=2 * half)


def _radius(fig: CurvatureFigure, point: str, centre: Points) -> None:
    """The radius that is asked for, named along it."""
    fig.board.join(fig.pane, centre, fig.at(point), Role.CONSTRUCTION)
    fig.board.plot(fig.pane, (centre + fig.at(point)) / 2, f"ρ_{{{point}}}", Dot.NONE, key=f"rho_{point}")


def _places(fig: CurvatureFigure) -> list[dict[str, complex]]:
    """The points in neighbouring positions, in order; where the mechanism does not close, none."""
    desk = fig.desk
    drive = desk.mech.drive
    unit = TRAVEL * desk.mech.scale * STEP / REACH if drive.slide else radians(STEP)
    out = []
    for k in range(-REACH // STEP, REACH // STEP + 1):
        try:
            there = placed(desk, drive.position + k * unit)
            out.append({p: complex(nominal(there.at[p])) * fig.factor for p in fig.centres})
        except VecpolyError:
            out.append({})
    return out


def _inside(run: Sequence[complex | None], paper: Paper) -> list[complex]:
    """The piece of the path about its middle that stays on the paper."""
    middle = len(run) // 2
    first = last = middle
    while first > 0 and _is_on(run[first - 1], paper):
        first -= 1
    while last < len(run) - 1 and _is_on(run[last + 1], paper):
        last += 1
    return [at for at in run[first : last + 1] if at is not None]


def _is_on(at: complex | None, paper: Paper) -> bool:
    return at is not None and paper.holds(at)
