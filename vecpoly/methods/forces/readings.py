"""Answers of a force analysis, kept as they are read: loads and arms by formula, reactions off the polygons."""

from __future__ import annotations

import numpy as np

from ...board.board import NO_LENGTH
from ...board.construction import LineOfAction, Reading, View
from ...formula import sym
from ...mechanism.loads import GRAVITY, Force
from ...mechanism.model import Mechanism
from ...mechanism.quantities import pairs
from ...names import Named
from ...plane import Reals, nominal
from ...problem.problem import Problem
from ...quantity import Expr, Product, worked
from .state import Acting, Drawn, Statics

_SIDE = {1: "ccw", -1: "cw", 0: ""}


def keep_value(st: Statics, named: Named, value: Reals, expr: Expr) -> None:
    """A signed value with the formula from which it was computed."""
    formula = worked(sym(named.symbol), expr, named.unit)
    st.keep(Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=float(nominal(value)), formula=formula), value)


def keep_nothing(st: Statics, named: Named) -> None:
    """A value that is zero because nothing works."""
    st.keep(Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=0.0), 0.0)


def measured(st: Statics, drawn: Drawn) -> Product:
    """A force in N as μ_F × its length on the polygon."""
    return st.board.mu(drawn.place) * st.board.measure(drawn.start, drawn.end, drawn.letters)


def keep_measured(st: Statics, named: Named, drawn: Drawn, sign: int = 1) -> Reals:
    """A scalar force read off a polygon, written into the step."""
    on_paper = st.board.measure(drawn.start, drawn.end, drawn.letters)
    expr = st.board.mu(drawn.place) * on_paper
    st.board.write(worked(sym(named.symbol), expr, named.unit))
    value = sign * expr.value
    st.keep(Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=float(nominal(value)), mm=float(nominal(on_paper.value)),
                    line=drawn.letters, scale=st.scale.symbol, formula=worked(sym(named.symbol), expr, named.unit)), value)
    return value


def write_sizes(st: Statics, *forces: Acting) -> None:
    """R = μ_F × length on the polygon, written into the step."""
    for force in forces:
        if force.drawn is not None:
            st.board.write(worked(sym(force.named.symbol), measured(st, force.drawn), "N"))


def read_reactions(st: Statics, mech: Mechanism) -> None:
    """Every reaction both ways: size off its polygon, direction by protractor, a point of its line, its tangent side."""
    for a, b in pairs(mech):
        for by, on in ((a, b), (b, a)):
            found = st.push(by, on)
            if found is not None:
                _reaction(st, found)


def _reaction(st: Statics, force: Acting) -> None:
    board, named, scale = st.board, force.named, st.scale
    drawn = force.drawn
    ends = (drawn.start, drawn.end, drawn.letters) if drawn else (0j, force.vector, "—")
    on_paper = board.measure(*ends)
    size = on_paper.value * scale.value
    zero = abs(complex(nominal(force.vector))) < NO_LENGTH
    vector = size * np.exp(1j * board.hand.gauge(np.angle(ends[1] - ends[0])))
    metres = complex(nominal(force.at)) * board.scales[View.MECHANISM].value
    st.keep(Reading(
        key=named.key, symbol=named.symbol, unit="N", scalar=0.0 if zero else float(nominal(size)), vector=0j if zero else complex(nominal(vector)),
        mm=float(nominal(on_paper.value)), line=ends[2], scale=scale.symbol, formula=worked(sym(named.symbol), board.mu(View.FORCE) * on_paper, "N"),
        acts=LineOfAction(point=metres, tangent=_SIDE[force.tangent])), size)


def largest_load(problem: Problem) -> float:
    """A force typical of a problem's polygons (N): the largest given one, or what its masses and moments come to."""
    loads, drive = problem.loads, problem.mechanism.drive
    if loads is None:
        return 1.0
    size = problem.mechanism.scale
    pull = (abs(drive.accel) + drive.rate**2) * (1.0 if drive.slide else size) + (GRAVITY if loads.weight else 0.0)
    found = [abs(load.size) / (1.0 if isinstance(load, Force) else size) for load in loads.all if load.size]
    return max([*found, *(m.mass * pull for m in loads.masses if loads.inertia or loads.weight)], default=1.0) or 1.0
