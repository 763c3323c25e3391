"""The work of a press over a turn: its moment is given at some angles, and straight between them.

The data, the drawing and the truth of a task, in one file.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import reduce
from itertools import pairwise
from operator import add
from typing import ClassVar

import numpy as np

from vecpoly.algebra.formula import Txt
from vecpoly.algebra.quantity import Expr, Quantity, number
from vecpoly.board.board import Board
from vecpoly.board.construction import Construction, Reading, Scale
from vecpoly.board.hand import Hand, hand
from vecpoly.board.otherwise.amended import AS_DRAWN, Amended
from vecpoly.board.paper.marks import Role
from vecpoly.board.paper.scales import round_scale
from vecpoly.board.place import View, view_named
from vecpoly.check.truth import ActsAt, Values, knows, size_of
from vecpoly.foundation.frozen import FrozenMap
from vecpoly.methods.desk import Desk
from vecpoly.methods.drawing import Paper, draws
from vecpoly.methods.drawn import Drawn
from vecpoly.names import Named, Rel
from vecpoly.plane import Points, nominal
from vecpoly.problem.asked.asks import AskNamed
from vecpoly.problem.problem import Printed, Problem, Scales
from vecpoly.words import Words

W = Named("W", "W", "J")
TWO = Quantity(Txt("2"), 2.0, "")


@dataclass(frozen=True)
class Press:
    """Angles (rad) and the moments there (N·m)."""

    moments: tuple[tuple[float, float], ...]
    kind: ClassVar[str] = "press"

    def quantities(self) -> tuple[Named, ...]:
        return (W,)

    def given(self) -> tuple[tuple[str, str], ...]:
        return tuple((f"M_{i}", f"{number(moment)} N·m") for i, (_, moment) in enumerate(self.moments, 1))


def problem(*moments: tuple[float, float], scales: Mapping[str, float]) -> Problem:
    return Problem(
        id="press",
        title=Words("压力机一转的功", "Work of a press"),
        subject=Press(moments),
        asks=(AskNamed(rel=W),),
        scales=Scales(scales),
    )


@draws(Press)
class PressDrawing:
    turning = ()

    def draw(self, problem: Problem, by: Hand, paper: Paper, amended: Amended, sketch: Desk | None = None) -> Drawn:
        assert isinstance(problem.subject, Press)
        scale = _scale(problem, problem.subject, paper)
        board, ideal = (
            _drawn(Board(one, {view_named("work"): scale}, how), view_named("work"), problem.subject)
            for one, how in ((by, amended), (hand("exact"), AS_DRAWN))
        )
        made = Construction(
            problem=problem.id,
            hand=by.name,
            figures=board.figures(),
            steps=tuple(board.steps),
            acts=tuple(board.acts),
            readings=board.readings,
        )
        return Drawn(made, {W.key: np.asarray(board.found[W.key], dtype=float)}, ideal.readings)


def _scale(problem: Problem, press: Press, paper: Paper) -> Scale:
    """Given, or such that the diagram fills its place."""
    view = view_named("work")
    assert view.across is not None
    (wide, high), (over, most) = paper.room(view), (max(column) for column in zip(*press.moments, strict=True))
    return Scale.of(
        view,
        problem.scales.of(view.mu) or round_scale(most / 100, (0.0, 100.0), (wide, high)),
        problem.scales.of(view.across) or round_scale(over / 100, (100.0, 0.0), (wide, high)),
    )


def _drawn(board: Board, view: View, press: Press) -> Board:
    board.section(Words("作力矩图", "Diagram of moments"))
    board.step(
        Words(
            "按 $μ_{φ}$ 量转角，按 $μ_M$ 量力矩，连成折线。",
            "Lay off the angles to the scale $μ_{φ}$ and the moments to $μ_M$, and join them.",
        ),
        view,
    )
    corners = [_corner(board, view, phi, moment) for phi, moment in press.moments]
    board.join(view, corners[0][0], corners[-1][0], Role.GIVEN)
    for (_, one), (_, other) in pairwise(corners):
        board.arrow(view, one, other, Role.RESULT, label="M")
    board.step(
        Words("图线下的面积乘以两个比例尺，即为功。", "The area under the line, times both scales, is the work."), view
    )
    area = board.compute("A", _area(board, corners), "mm^2")
    work = board.compute(W.symbol, board.mu(view) * board.mu_across(view) * area, "J")
    board.keep(Reading(key=W.key, symbol=W.symbol, unit=W.unit, scalar=float(nominal(work.value))), work.value)
    return board


def _corner(board: Board, view: View, phi: float, moment: float) -> tuple[Points, Points]:
    """The foot on the axis and the point of the line."""
    foot = board.lay_off(0j, 1 + 0j, board.to_paper_across(view, phi))
    top = board.lay_off(foot, 1j, board.to_paper(view, moment))
    board.join(view, foot, top, Role.CONSTRUCTION)
    return foot, top


def _area(board: Board, corners: list[tuple[Points, Points]]) -> Expr:
    """Half of the sum of (y₁ + y₂) x over the strips."""
    strips: list[Expr] = [
        (_ordinate(board, i, one) + _ordinate(board, i + 1, other))
        * board.measure(one[0], other[0], f"x_{i} x_{i + 1}")
        for i, (one, other) in enumerate(pairwise(corners), 1)
    ]
    return reduce(add, strips) / TWO


def _ordinate(board: Board, i: int, corner: tuple[Points, Points]) -> Quantity:
    return board.measure(*corner, f"x_{i} m_{i}")


@knows(Press)
@dataclass(frozen=True)
class PressTruth:
    """The integral, by many small steps."""

    problem: Problem
    lines: Mapping[str, ActsAt] = FrozenMap({})
    likely: Mapping[str, float] = FrozenMap({})
    nearby: tuple[Values, ...] = ()

    @property
    def values(self) -> Values:
        assert isinstance(self.problem.subject, Press)
        angles, moments = np.array(self.problem.subject.moments).T
        fine = np.union1d(np.linspace(angles[0], angles[-1], 10001), angles)
        return {W.key: float(np.trapezoid(np.interp(fine, angles, moments), fine))}

    def known(self, rel: Rel) -> None:
        return None

    def behind(self) -> Callable[[Printed], float | None]:
        return lambda printed: size_of(self.values[W.key])

    def way(self) -> Callable[[Printed], complex | None]:
        return lambda printed: None
