"""Answers of a force analysis, kept as they are read: loads and arms by formula, reactions off the polygons."""

from __future__ import annotations

from ...algebra.formula import Node, Row, Txt, sym
from ...algebra.quantity import Expr, Product, Quantity, magnitude, number
from ...algebra.worked import stated, worked
from ...board.board import NO_LENGTH
from ...board.construction import LineOfAction, Reading, View
from ...mechanism.asked.forces import apart, pairs
from ...mechanism.groups.assur import hinges
from ...mechanism.loads import GRAVITY, Force
from ...mechanism.model import Mechanism
from ...mechanism.seats import seat
from ...names import Named
from ...plane import Points, Reals, nominal
from ...problem.problem import Problem
from ...words import Words
from .acting import NO_LETTER, Acting, Drawn
from .state import Statics

SAME = 1e-6  # mm: shorter vectors are not drawn
_SIDE = {1: "ccw", -1: "cw", 0: ""}


def keep_value(st: Statics, named: Named, value: Reals, expr: Expr) -> None:
    """A signed value with the formula from which it was computed."""
    formula = worked(sym(named.symbol), expr, named.unit) if st.board.writes else None
    st.keep(
        Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=float(nominal(value)), formula=formula),
        value,
    )


def keep_arm(st: Statics, named: Named, arm: Product) -> None:
    """A length that was read on the diagram, with what was read."""
    mu = st.board.mu(View.MECHANISM)
    st.keep(
        Reading(
            key=named.key,
            symbol=named.symbol,
            unit=named.unit,
            scalar=float(nominal(arm.value)),
            mm=float(nominal(arm.value / mu.value)),
            line=named.symbol,
            scale=st.board.scale_of(View.MECHANISM).symbol,
            formula=worked(sym(named.symbol), arm, named.unit) if st.board.writes else None,
        ),
        arm.value,
    )


def keep_nothing(st: Statics, named: Named, otherwise: Reals = 0.0) -> None:
    """A value that is zero because nothing works; otherwise: what other hands find, to whom something seems to work."""
    st.keep(Reading(key=named.key, symbol=named.symbol, unit=named.unit, scalar=0.0), otherwise)


def measured(st: Statics, drawn: Drawn) -> Product:
    """A force in N as μ_F × its length on the polygon."""
    return st.board.mu(drawn.place) * st.board.measure(drawn.start, drawn.end, drawn.letters)


def keep_measured(st: Statics, named: Named, drawn: Drawn, sign: int = 1) -> Reals:
    """A scalar force read off a polygon, written into the step."""
    on_paper = st.board.measure(drawn.start, drawn.end, drawn.letters)
    expr = st.board.mu(drawn.place) * on_paper
    st.board.write_worked(sym(named.symbol), expr, named.unit)
    value = sign * expr.value
    st.keep(
        Reading(
            key=named.key,
            symbol=named.symbol,
            unit=named.unit,
            scalar=float(nominal(value)),
            mm=float(nominal(on_paper.value)),
            line=drawn.letters,
            scale=st.scale.symbol,
            formula=worked(sym(named.symbol), expr, named.unit) if st.board.writes else None,
        ),
        value,
    )
    return value


def say_measured(st: Statics, sides: tuple[tuple[str, Drawn], ...]) -> None:
    """Which reactions are measured, and which are zero since the letters of their ends coincide."""
    none = [(name, drawn) for name, drawn in sides if abs(complex(nominal(drawn.end - drawn.start))) < SAME]
    names = [name for name, drawn in sides if (name, drawn) not in none]
    if names:
        st.board.remark(Words(f"由图量得 ${'$、$'.join(names)}$。", f" Measure ${'$, $'.join(names)}$."))
    if none:
        first, last = none[0][1].letters.split()
        zeros = "".join(f"${name}$ = " for name, _ in none)
        why = (
            Words("", "")
            if first == last
            else Words(f"${first}$ 与 ${last}$ 重合，故 ", f" Points ${first}$ and ${last}$ coincide, so")
        )
        st.board.remark(why + Words(f"{zeros}0。", f" {zeros}0."))


def write_sizes(st: Statics, *forces: Acting) -> None:
    """R = μ_F × length on the polygon, written into the step."""
    for force in forces:
        if force.drawn is not None and abs(complex(nominal(force.drawn.end - force.drawn.start))) > SAME:
            st.board.write_worked(sym(force.named.symbol), measured(st, force.drawn), "N")


def read_reactions(st: Statics, mech: Mechanism) -> None:
    """Every reaction both ways: size off its polygon, direction by protractor, a point of its line, its tangent side.

    Links at a multiple joint that only meet in the pin of a third have none.
    """
    for a, b in pairs(mech):
        action, reaction = st.push(a, b), st.push(b, a)
        if action is not None and reaction is not None:
            start, end, letters = _side(action)
            _reaction(st, action, (start, end, letters))
            _reaction(st, reaction, (end, start, " ".join(reversed(letters.split()))))
    for a, b in apart(mech):
        _no_reaction(st, a, b)


def _side(force: Acting) -> tuple[Points, Points, str]:
    """Start, end and letters of a force on its polygon; one that stands on none is laid off from a point."""
    return (force.drawn.start, force.drawn.end, force.drawn.letters) if force.drawn else (0j, force.vector, NO_LETTER)


def _reaction(st: Statics, force: Acting, side: tuple[Points, Points, str]) -> None:
    board, named, scale, (start, end, letters) = st.board, force.named, st.scale, side
    on_paper = board.measure(start, end, letters)
    size = on_paper.value * scale.value if force.computed is None else force.computed
    zero = abs(complex(nominal(force.vector))) < NO_LENGTH
    vector = size * board.bearing(start, end)
    metres = complex(nominal(force.at)) * board.scales[View.MECHANISM].value
    couple = float(nominal(force.couple))
    st.keep(
        Reading(
            key=named.key,
            symbol=named.symbol,
            unit="N",
            scalar=0.0 if zero else float(nominal(size)),
            vector=0j if zero else complex(nominal(vector)),
            mm=None if zero else float(nominal(on_paper.value)),
            line=letters,
            scale=scale.symbol,
            formula=_formula(st, force, on_paper) if board.writes else None,
            remark=_couple_words(named, couple) if couple else None,
            acts=LineOfAction(point=metres, tangent=_SIDE[force.tangent], couple=couple or None),
        ),
        size,
        None if zero else vector,
    )


def _formula(st: Statics, force: Acting, on_paper: Quantity) -> Node:
    """R = μ_F × length; of a force that was computed and laid off, not read, what it was computed as: R_43 = R_45."""
    name = sym(force.named.symbol)
    unlettered = force.drawn is None or NO_LETTER in force.drawn.letters
    if unlettered and force.computed is None and abs(complex(nominal(force.vector))) < NO_LENGTH:
        return stated(magnitude(force.named.symbol, 0.0, "N"))
    if force.computed is None:
        return worked(name, st.board.mu(View.FORCE) * on_paper, "N")
    end = worked(name, magnitude(force.named.symbol, force.computed, "N"), "N").items[-1]
    same = next((size.node for size in st.board.ledger.sizes.values() if size.value is force.computed), None)
    if same is None:  # it passes on what was computed as another reaction
        same = next(sym(one.named.symbol) for one in st.acting.values() if one.computed is force.computed)
    return Row((name, end) if same == name else (name, Txt(" = "), same, end))


def _couple_words(named: Named, couple: float) -> Words:
    way = Words("逆时针", "counter-clockwise") if couple > 0 else Words("顺时针", "clockwise")
    return Words(
        f"${named.symbol}$ = 0，移动副只传递力偶 {number(abs(couple))} N·m（{way.zh}）",
        f"${named.symbol}$ = 0, the slide passes on a couple alone: {number(abs(couple))} N·m, {way.en}",
    )


def _no_reaction(st: Statics, a: str, b: str) -> None:
    """R_ij = 0 between links that turn on the pin of a third."""
    point = next(point for point, names in hinges(st.mech).items() if a in names and b in names)
    carrier = st.mech.number(seat(st.mech, point) or "")
    for by, on in ((a, b), (b, a)):
        named = st.named(by, on)
        remark = Words(
            f"铰链 ${point}$ 的销轴属于构件 {carrier}，构件 {st.mech.number(by)}、{st.mech.number(on)} 互不接触"
            f"，${named.symbol}$ = 0",
            f"the pin at ${point}$ belongs to link {carrier}, links {st.mech.number(by)} and "
            f"{st.mech.number(on)} do not touch each other: ${named.symbol}$ = 0",
        )
        st.keep(Reading(key=named.key, symbol=named.symbol, unit="N", scalar=0.0, vector=0j, remark=remark), 0.0)


def largest_load(problem: Problem) -> float:
    """A force typical of a problem's polygons (N): the largest given one, or what its masses and moments come to."""
    loads, drive = problem.loads, problem.mechanism.drive
    if loads is None:
        return 1.0
    size = problem.mechanism.scale
    pull = (abs(drive.accel) + drive.rate**2) * (1.0 if drive.slide else size) + (GRAVITY if loads.weight else 0.0)
    found = [abs(load.size) / (1.0 if isinstance(load, Force) else size) for load in loads.all if load.size]
    return max([*found, *(m.mass * pull for m in loads.masses if loads.inertia or loads.weight)], default=1.0) or 1.0
