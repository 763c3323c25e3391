"""The answers read off the finished drawing: one reading for every quantity asked."""

from __future__ import annotations

import numpy as np

from ..algebra.formula import Node, Row, Txt, letters_node, plain, sym
from ..algebra.quantity import Quantity, magnitude, paper
from ..algebra.worked import spot_in_mm, stated, worked
from ..board.board import NO_LENGTH
from ..board.construction import Reading, View
from ..board.strokes import amount, spot
from ..errors import NoMethodError
from ..foundation.slotted import replace
from ..names import Key, Kind, Rel
from ..plane import Points, Reals, nominal
from ..problem.asked.asks import AskNamed
from ..problem.problem import Problem
from ..words import Words
from .desk import Desk
from .standing import computed, standing

Repeats = dict[str, Reals]  # key -> what the reading's `scalar` is by every hand


def answered(desk: Desk, problem: Problem) -> tuple[dict[str, Reading], Repeats]:
    """All that the problem asks, read off the paper: the readings, and their scalars by all hands.

    Raises NoMethodError where one is not on the paper.
    """
    readings: dict[str, Reading] = {}
    repeats: Repeats = {}
    for ask in problem.asks:
        if isinstance(ask, AskNamed) or ask.rel.key in desk.board.readings:
            reading, scalars = named_answer(desk, ask.rel)
        else:
            reading, scalars = answer(desk, ask.rel)
        readings[reading.key] = reading
        repeats[reading.key] = np.asarray(scalars, dtype=float)
    return readings, repeats


def answer(desk: Desk, rel: Rel) -> tuple[Reading, Reals]:
    """Read one asked quantity off the paper: the reading, and its scalar by all hands.

    Raises NoMethodError when the construction holds no such line.
    """
    if not rel.kind.is_vector:
        return _turn(desk, rel)
    if rel.kind is Kind.P:
        return _position(desk, rel)
    return _vector(desk, rel)


def named_answer(desk: Desk, named: Key) -> tuple[Reading, Reals]:
    """What the force analysis or the instant centres gave: a load, a reaction, a centre;
    raises NoMethodError where it was not found."""
    if named.key not in desk.board.readings:
        raise NoMethodError(
            Words(
                f"图上没有作出 {named.key}：现有图解法对此机构求不出此量",
                f"{named.key} was not found on the drawing: no method on file gives it for this mechanism",
            )
        )
    return desk.board.readings[named.key], desk.board.found[named.key]


def _turn(desk: Desk, rel: Rel) -> tuple[Reading, Reals]:
    if rel not in desk.turns:
        raise NoMethodError(
            Words(
                f"图上没有作出 {rel.key}：现有图解法求不出此量",
                f"{rel.key} was not found on the drawing: no method on file gives it",
            )
        )
    turn = desk.turns[rel]
    name = f"{rel.kind.stem}_{rel.to.link}"
    remark = Words("该构件作平动", "the link only translates") if turn.never else None
    value = float(nominal(turn.value))
    desk.board.answer(rel.key, amount(turn.value), rel.kind.unit, turn.value, each=turn.value)
    size = stated(magnitude(name, abs(value), rel.kind.unit)).items[1:]
    return Reading(
        key=rel.key,
        symbol=name,
        unit=rel.kind.unit,
        scalar=value,
        remark=remark,
        formula=Row((sym(name), *_turn_of_another(desk, rel), *size)),
    ), turn.value


def _turn_of_another(desk: Desk, rel: Rel) -> tuple[Node, ...]:
    """Links that turn alike have one turn, which was found of the first: ω_3 = ω_2."""
    own = desk.turns[rel]
    first = own.same or next(one for one, turn in desk.turns.items() if turn is own)
    return () if first == rel or own.never else (Txt(" = "), sym(f"{first.kind.stem}_{first.to.link}"))


def _position(desk: Desk, rel: Rel) -> tuple[Reading, Reals]:
    name = str(rel.to)
    place: Points = desk.at[name] if name in desk.at else desk.at[rel.to.point]
    scale = desk.board.scales[View.MECHANISM]
    metres = desk.board.coordinates(place, name, View.MECHANISM) * scale.value
    vector = complex(nominal(metres))
    desk.board.answer(rel.key, spot(metres), "m", metres, each=metres)
    text = Row((sym(name[0] + (f"_{name[1:]}" if name[1:] else "")), Txt(f" = {spot_in_mm(vector)}")))
    return (
        Reading(
            key=rel.key,
            symbol=name[0] + (f"_{{{name[1:]}}}" if name[1:] else ""),
            unit="m",
            scalar=abs(vector),
            vector=vector,
            scale=scale.symbol,
            formula=text,
        ),
        np.abs(metres),
    )


def _vector(desk: Desk, rel: Rel) -> tuple[Reading, Reals]:
    view, start, end, line = standing(desk, rel)
    board, scale = desk.board, desk.board.scales[view]
    known = computed(desk, rel)
    on_paper = (
        board.measure(start, end, line)
        if known is None
        else paper(letters_node(line), board.hand.read(board.to_paper(view, known.value)))
    )
    direction = board.gauge(start, end)
    size = on_paper.value * scale.value if known is None else known.value
    values = size * np.exp(1j * direction)
    exact_zero = abs(complex(nominal(end - start))) < NO_LENGTH
    if not exact_zero and not board.stands(view, spot(end), spot(start)):
        board.arrow_once(view, start, end, key=rel.key)  # of two points of an image no vector stands there yet
    board.answer(rel.key, 0j if exact_zero else spot(values), rel.kind.unit, start, end, size, direction, each=values)
    reading = Reading(
        key=rel.key,
        symbol=rel.symbol,
        unit=rel.kind.unit,
        scalar=0.0 if exact_zero else float(nominal(size)),
        vector=0j if exact_zero else complex(nominal(values)),
        mm=float(nominal(on_paper.value)),
        line=line,
        scale=scale.symbol,
        formula=_line(desk, rel, view, on_paper, known, exact_zero) if board.writes else None,
        remark=_vanishing(desk, rel, exact_zero),
    )
    return reading, size


def _line(desk: Desk, rel: Rel, view: View, on_paper: Quantity, known: Quantity | None, zero: bool) -> Row:
    """v_C = μ_v pc = ... = 0.65 m/s; of what was computed, and of what has no length to be read, the size alone."""
    if zero:
        return stated(replace(magnitude("", 0.0, rel.kind.unit), node=_as_drawn(desk, rel)))
    if known is not None:
        line = stated(replace(known, node=sym(rel.symbol)))
        own = {plain(sym(one)) for one in (rel.symbol, _told(desk, rel))}
        of_another = (rel.ref is None or rel.kind is Kind.AK) and plain(known.node) not in own
        return Row((line.items[0], Txt(" = "), known.node, *line.items[1:])) if of_another else line
    return worked(_as_drawn(desk, rel), desk.board.mu(view) * on_paper, rel.kind.unit)


def _as_drawn(desk: Desk, rel: Rel) -> Node:
    """The symbol; where the equation has the point under the number of a link, that too: v_D = v_D4."""
    drawn = _told(desk, rel)
    if rel.ref is not None or rel.kind not in (Kind.V, Kind.A) or drawn == rel.symbol:
        return sym(rel.symbol)
    return Row((sym(rel.symbol), Txt(" = "), sym(drawn)))


def _told(desk: Desk, rel: Rel) -> str:
    """The symbol that the equation has for it."""
    own = Rel(rel.kind, desk.canonical(rel.to), desk.canonical(rel.ref) if rel.ref else None)
    return desk.symbol(own)


def _vanishing(desk: Desk, rel: Rel, zero: bool) -> Words | None:
    """Why a Coriolis term is zero."""
    if rel.kind is not Kind.AK or not zero:
        return None
    turns = [t for r, t in desk.turns.items() if r.kind is Kind.OMEGA and r.to.link == rel.to.link]
    if turns and turns[0].never:
        return Words(
            f"构件 {rel.to.link} 作平动，哥氏加速度不存在",
            f"link {rel.to.link} only translates: no Coriolis term exists",
        )
    if turns and abs(float(nominal(turns[0].value))) < 1e-9:
        return Words(f"此瞬时 $ω_{rel.to.link}$ = 0", f"$ω_{rel.to.link}$ = 0 at this instant")
    return Words("此瞬时相对速度为零", "the relative velocity is zero at this instant")
