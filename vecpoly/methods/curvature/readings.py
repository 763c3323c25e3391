"""The answers read off the figure of the curvatures."""

from __future__ import annotations

import numpy as np

from ...algebra.formula import Row, Txt, row, sym
from ...algebra.quantity import Quantity
from ...algebra.worked import worked
from ...board.board import Board
from ...board.construction import Place, Reading
from ...mechanism.asked.centres import centre
from ...mechanism.asked.curvature import (
    ball_point,
    collineation,
    diameter,
    inflection_pole,
    path_centre,
    radius,
    return_pole,
)
from ...mechanism.model import FRAME
from ...names import Named
from ...plane import Points, nominal, unit
from ...words import Words, joined
from ..centres.places import place_read
from .state import CurvatureFigure
from .strokes.collinear import draw_axis


def read_curvatures(fig: CurvatureFigure, wanted: frozenset[str]) -> None:
    """Every answer that is asked, measured on the figure."""
    mech, link = fig.desk.mech, fig.link
    if wanted:
        sought = joined([Words.same(f"${symbol}$") for symbol in _symbols(fig, wanted)])
        fig.board.step(Words(f"由图量得 {sought.zh}：", f"Measure {sought.en} on the figure:"), fig.pane)
    if (pole := centre(mech, link, FRAME)).key in wanted:
        _place(fig, pole, fig.pole, fig.p)
    if (w := inflection_pole(mech, link)).key in wanted:
        _place(fig, w, fig.opposite, fig.w)
    if (back := return_pole(mech, link)).key in wanted:
        _place(fig, back, fig.returned, back.symbol)
    if (ball := ball_point(mech, link)).key in wanted:
        _place(fig, ball, fig.undulating, ball.symbol)
    if (delta := diameter(mech, link)).key in wanted:
        _length(fig, delta, (fig.pole, fig.opposite), f"{fig.p} {fig.w}", fig.w)
    for point, at in fig.centres.items():
        if (named := path_centre(point)).key in wanted:
            _place(fig, named, at, point)
        if (named := radius(point)).key in wanted:
            _length(fig, named, (fig.at(point), at), f"{fig.shown(point)} O_{{{point}}}", point)


def _symbols(fig: CurvatureFigure, wanted: frozenset[str]) -> list[str]:
    """What is measured, by its symbols, in the order in which it is."""
    mech, link = fig.desk.mech, fig.link
    own = (
        centre(mech, link, FRAME),
        inflection_pole(mech, link),
        return_pole(mech, link),
        ball_point(mech, link),
        diameter(mech, link),
        *(named for point in fig.centres for named in (path_centre(point), radius(point))),
    )
    return [named.symbol for named in own if named.key in wanted]


def read_collineation(fig: CurvatureFigure) -> None:
    """λ: the angle of the collineation axis to the line of the pins, by protractor (Freudenstein: 90° where the ratio
    of the two cranks is an extreme)."""
    one, two = fig.rays
    assert one.x is not None and two.x is not None
    named = collineation(fig.desk.mech, fig.link)
    axis = draw_axis(fig).line.along
    line = f"{fig.shown(one.moving)}{fig.shown(two.moving)}"
    fig.board.step(
        Words(
            f"量共线轴与 ${line}$ 的夹角（传动比取极值时为 90°）：",
            f"Measure the angle of the collineation axis to ${line}$ (90° where the ratio of the cranks is an "
            f"extreme):",
        ),
        fig.pane,
    )
    pins = unit(two.x - one.x)
    turned = np.degrees(fig.board.gauge(0j, axis * np.conj(pins)))
    value = 90.0 - np.abs(np.abs(turned) - 90.0)
    degrees = float(nominal(value))
    text = Row((*row(named.symbol).items, Txt(f" = {degrees:.4g}°")))
    fig.board.write(text)
    fig.board.keep(Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=degrees, formula=text), value)


def _place(fig: CurvatureFigure, named: Named, at: Points, found: str) -> None:
    """Both coordinates read off the rule (m on the diagram's axes), on the figure on which the point was found."""
    pane, ratio = fig.homes[found]
    mm, scale = fig.board.coordinates(at * ratio, named.symbol, pane), fig.board.scale_of(pane)
    reading, distance, each = place_read(named.key, named.symbol, mm, scale)
    assert reading.formula is not None
    fig.board.write(reading.formula)
    fig.board.keep(reading, distance, each)


def _length(fig: CurvatureFigure, named: Named, ends: tuple[Points, Points], letters: str, found: str) -> None:
    """μ_l times the length on paper, on the figure on which its end was found."""
    (a, b), (pane, ratio) = ends, fig.homes[found]
    keep_length(fig.board, pane, named, fig.board.measure(a * ratio, b * ratio, letters), letters)


def keep_length(board: Board, pane: Place, named: Named, on_paper: Quantity, line: str = "") -> None:
    """A length (m) by what it measures on paper, written into the step; line: the letters of its ends."""
    scale = board.scale_of(pane)
    size = on_paper.value * scale.value
    formula = worked(sym(named.symbol), board.mu(pane) * on_paper, named.unit)
    board.write(formula)
    reading = Reading(
        key=named.key,
        symbol=named.symbol,
        unit=named.unit,
        scalar=float(nominal(size)),
        mm=float(nominal(on_paper.value)),
        line=line,
        scale=scale.symbol,
        formula=formula,
    )
    board.keep(reading, size)
