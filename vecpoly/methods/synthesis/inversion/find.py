"""One pin: the known pin is carried onto the position that is kept, and bisectors meet in the pin that is sought."""

from __future__ import annotations

from functools import partial
from itertools import combinations, pairwise
from typing import assert_never

import numpy as np

from ....board.paper.marks import Dot, Role
from ....designs.inversion.plan import FRAME, Find, On, Through
from ....designs.inversion.refusals import coincident, collinear, parallel
from ....plane import Line, Points, cross, nominal, unit
from ....words import Words, joined
from ..draft import SHEET
from ..linkage import pin
from .sheet import Places, Sheet, lettered

PARALLEL = 1e-7  # sine below which a bisector meets nothing
ONE = 1e-7  # mm: places nearer than this are one
NEAR = 0.1  # of the farthest two: places nearer than so are not bisected where others can be


def find(sheet: Sheet, stage: Find) -> Sheet:
    """Carry over, bisect, meet, and lay the pin back into the other positions."""
    fixed = stage.on == FRAME
    sheet.draft.board.section(
        Words(f"求{'固定' * fixed}铰链 ${stage.pin}$", f"The {'fixed pivot' if fixed else 'pin'} ${stage.pin}$")
    )
    seen = _seen(sheet, stage)
    at = _met(sheet, stage, seen)
    return _placed(sheet, stage, at)


def _seen(sheet: Sheet, stage: Find) -> Places:
    """The places of the known pin as the body of the sought one sees them."""
    if stage.on == FRAME:
        return sheet.pins[stage.known]
    board, kept = sheet.draft.board, stage.kept
    board.step(_inverting(sheet, stage), SHEET, again=_inverting_again(sheet, stage))
    board.remark(_goes(sheet, stage))
    seen = []
    for n, place in enumerate(sheet.pins[stage.known]):
        letter = sheet.named(stage.known, n)
        if n == kept:
            seen.append(place)
            continue
        back = sheet.carried(place, stage.on, n, kept, letter)
        onwards = partial(sheet.carried, place, stage.on, kept, n, letter)
        moved = board.inverted(back, onwards, key=f"{stage.known}′")
        seen.append(pin(sheet.draft, _primed(stage.known, n), moved, Dot.POINT))
    return tuple(seen)


def _others(sheet: Sheet, stage: Find) -> list[int]:
    """The positions that are not kept."""
    return [n for n in range(sheet.plan.count) if n != stage.kept]


def _positions(numbers: list[int]) -> Words:
    """位置 2、3; positions 2 and 3."""
    told = joined([Words.same(str(n + 1)) for n in numbers])
    return Words(f"位置 {told.zh}", f"position{'s' * (len(numbers) > 1)} {told.en}")


def _primed(letter: str, position: int) -> str:
    return f"{letter}_{position + 1}^′"


def _inverting(sheet: Sheet, stage: Find) -> Words:
    kept, name = stage.kept + 1, stage.on
    others = _others(sheet, stage)
    turned, way = _positions(others), _carrying(sheet, stage, others)
    return Words(
        f"取构件 ${name}$ 的位置 {kept} 为“机架”，将机构的{turned.zh} 刚化，反转使 ${name}$ 与位置 {kept} "
        f"重合（{way.zh}）。",
        f"Fix link ${name}$ in position {kept} and turn {turned.en} of the mechanism, as a rigid whole, back so that "
        f"${name}$ coincides with it ({way.en}).",
    )


def _inverting_again(sheet: Sheet, stage: Find) -> Words:
    turned = _positions(_others(sheet, stage))
    return Words(f"同样将{turned.zh} 反转。", f"Turn {turned.en} back in the same way.")


def _goes(sheet: Sheet, stage: Find) -> Words:
    """Where the known pin goes by it."""
    others = _others(sheet, stage)
    moved = [f"${_primed(stage.known, n)}$" for n in others]
    figures = list(dict.fromkeys(f"${sheet.named(stage.known, n)}$" for n in others))
    return Words(
        f"点 {'、'.join(figures)} 转到 {'、'.join(moved)}。",
        f" Point{'s' * (len(figures) > 1)} {joined([Words.same(one) for one in figures]).en} "
        f"go{'es' * (len(figures) == 1)} to {joined([Words.same(one) for one in moved]).en}.",
    )


def _carrying(sheet: Sheet, stage: Find, others: list[int]) -> Words:
    """How the places are carried over: along the line of the body where they lie on it, else by arcs."""
    ways = {sheet.on_line(sheet.pins[stage.known][n], stage.on, n) for n in others}
    along = Words("在标线上的点沿标线截取", "points on the line are laid off along it")
    arcs = Words("以两弧相交转移三角形", "each triangle is carried over by two arcs")
    if len(ways) == 2:
        return Words(f"{arcs.zh}；{along.zh}", f"{arcs.en}; {along.en}")
    return along if True in ways else arcs


def _letters(sheet: Sheet, stage: Find) -> tuple[str, ...]:
    """The letters of the places that are seen."""
    return tuple(
        sheet.named(stage.known, n) if stage.on == FRAME or n == stage.kept else _primed(stage.known, n)
        for n in range(sheet.plan.count)
    )


def _met(sheet: Sheet, stage: Find, seen: Places) -> Points:
    """Where the bisectors meet each other, or the line that carries the pin."""
    board, letters = sheet.draft.board, _letters(sheet, stage)
    pairs = [(n, n + 1) for n in range(len(seen) - 1)] if stage.lies is None else [_apart(seen)]
    named = [f"${letters[one]} {letters[two]}$" for one, two in pairs]
    where = stage.pin if stage.on == FRAME else f"{stage.pin}_{stage.kept + 1}"
    board.step(_bisecting(sheet, stage, named, where), SHEET)
    for one, two in ((seen[i], seen[j]) for i, j in pairs):
        if abs(complex(nominal(two - one))) < ONE:
            raise coincident(stage)
        board.join(SHEET, one, two, Role.CONSTRUCTION)
    if stage.lies is None:
        return _by_bisectors(sheet, stage, seen)
    [(one, two)] = pairs
    return _by_line(sheet, stage, seen[one], seen[two])


def _apart(seen: Places) -> tuple[int, int]:
    """Two places for one bisector: the first two, unless others are much farther apart."""
    spans = {pair: abs(complex(nominal(seen[pair[1]] - seen[pair[0]]))) for pair in combinations(range(len(seen)), 2)}
    return (0, 1) if spans[0, 1] >= NEAR * max(spans.values()) else max(spans, key=lambda pair: spans[pair])


def _bisecting(sheet: Sheet, stage: Find, pairs: list[str], where: str) -> Words:
    if stage.lies is None:
        return Words(
            f"作 {'、'.join(pairs)} 的中垂线，其交点即为 ${where}$。",
            f"The perpendicular bisectors of {' and '.join(pairs)} meet at ${where}$.",
        )
    zh, en = _line_words(sheet, stage)
    return Words(
        f"作 {pairs[0]} 的中垂线，与{zh}的交点即为 ${where}$。",
        f"The perpendicular bisector of {pairs[0]} meets {en} at ${where}$.",
    )


def _line_words(sheet: Sheet, stage: Find) -> tuple[str, str]:
    match stage.lies:
        case Through() as line:
            ends = f"{sheet.named(line.one, stage.kept)} {sheet.named(line.two, stage.kept)}"
            return f"直线 ${ends}$ ", f"the line ${ends}$"
        case _:
            on = "" if stage.on == FRAME else f"（构件 ${stage.on}$ 上）"
            of = "" if stage.on == FRAME else f" of link ${stage.on}$"
            return f"给定直线{on}", f"the given line{of}"


def _by_bisectors(sheet: Sheet, stage: Find, seen: Places) -> Points:
    board = sheet.draft.board
    one, two, three = (complex(nominal(at)) for at in seen)
    if abs(float(cross(unit(two - one), unit(three - two)))) < PARALLEL:
        metres = board.scale_of(SHEET).value
        raise collinear(stage, [metres * at for at in (one, two, three)], three - one)
    first, second = (board.bisector(SHEET, a, b) for a, b in pairwise(seen))
    at = board.meet(first, second, Words(f"求 ${stage.pin}$", f"finding ${stage.pin}$"))
    for line in (first, second):
        board.rule(SHEET, line, at)
    return at


def _by_line(sheet: Sheet, stage: Find, one: Points, two: Points) -> Points:
    board = sheet.draft.board
    line, bisector = _line(sheet, stage), board.bisector(SHEET, one, two)
    if abs(float(nominal(cross(line.along, bisector.along)))) < PARALLEL:
        raise parallel(stage, complex(nominal(line.along)))
    at = board.meet(bisector, line, Words(f"求 ${stage.pin}$", f"finding ${stage.pin}$"))
    board.rule(SHEET, bisector, at)
    board.rule(SHEET, line, at)
    return at


def _line(sheet: Sheet, stage: Find) -> Line:
    """The line that carries the pin, in the position that is kept."""
    board = sheet.draft.board
    match stage.lies:
        case On() as on:
            stands = sheet.bodies[stage.on][stage.kept] if stage.on != FRAME else None
            start, axis = (0j, np.complex128(1)) if stands is None else (stands.start, stands.along)
            off = on.through - on.along * (on.along.conjugate() * on.through).real
            at = start if off == 0 else board.lay_off(start, axis * off / abs(off), sheet.draft.mm(abs(off)))
            return board.parallel(at, axis * on.along)
        case Through() as through:
            one, two = sheet.pins[through.one][stage.kept], sheet.pins[through.two][stage.kept]
            return Line(one, unit(two - one))
        case None:
            raise TypeError("a pin that lies on no line is where bisectors meet")
        case _:
            assert_never(stage.lies)


def _placed(sheet: Sheet, stage: Find, at: Points) -> Sheet:
    """The pin in all positions, with its letters."""
    if stage.on == FRAME:
        return sheet.with_pin(stage.pin, lettered(sheet.draft, stage.pin, (at,) * sheet.plan.count))
    at, back = pin(sheet.draft, f"{stage.pin}_{stage.kept + 1}", at), _positions(_others(sheet, stage))
    sheet.draft.board.remark(
        Words(
            f"再将 ${stage.pin}$ 随构件 ${stage.on}$ 转回{back.zh}。",
            f" Carry ${stage.pin}$ with link ${stage.on}$ back into {back.en}.",
        )
    )
    places = []
    for n in range(sheet.plan.count):
        letter = f"{stage.pin}_{n + 1}"
        moved = sheet.carried(at, stage.on, stage.kept, n, letter)
        places.append(at if n == stage.kept else pin(sheet.draft, letter, moved))
    return sheet.with_pin(stage.pin, tuple(places))
