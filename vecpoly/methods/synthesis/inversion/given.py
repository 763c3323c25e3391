"""What is given, laid out: pivots, links by their directions, places of a slider, positions of a body."""

from __future__ import annotations

from math import sin

from ....board.paper.marks import Dot, Role
from ....designs.inversion.plan import FRAME, Body, Limits, Pin, Plan
from ....diagram.single import outline
from ....foundation.frozen import FrozenMap
from ....names import ascii_key
from ....plane import Points
from ....words import Words
from ..angles import marked
from ..draft import SHEET, Draft
from ..linkage import pin, slider
from .sheet import Places, Sheet, Stands, lettered, placed

STRAIGHT = 1e-6  # sine of the angle between two lines that are one
AXIS = 0.6  # of that: how far the axis is drawn from which its directions count
HALF = 1.8  # mm: half the breadth of a body, which is seen under links that lie along it
REACH = 0.35  # of the extent of what is given: from the origin of a body to the point that marks its line


def laid_out(draft: Draft, plan: Plan) -> Sheet:
    """The first step: all that is given, in all positions."""
    board = draft.board
    board.section(Words("给定的位置", "The given positions"))
    board.step(_told(plan), SHEET)
    fixed = {one.letter: placed(draft, one.at) for one in plan.pins if one.on == FRAME}
    pins: dict[str, Places] = {letter: lettered(draft, letter, (at,) * plan.count) for letter, at in fixed.items()}
    for slide in plan.slides:
        places = tuple(placed(draft, at) for at in slide.places)
        pins[slide.letter] = lettered(draft, slide.letter, places)
        board.join(SHEET, pins[slide.letter][0], pins[slide.letter][-1], Role.CENTRE)
        slider(draft, pins[slide.letter], slide.along)
    for stage in limits_of(plan):
        first = pin(draft, f"{stage.pin}_1", placed(draft, stage.first))
        board.join(SHEET, fixed[stage.pivot], first, Role.GIVEN)
        pins[stage.pin] = (first,)
    sheet = Sheet(draft=draft, plan=plan, pins=FrozenMap(pins), bodies=FrozenMap({}))
    for body in plan.bodies:
        sheet = _with_body(sheet, body)
    return sheet


def limits_of(plan: Plan) -> list[Limits]:
    """The rockers of which one limit position is given."""
    return [stage for stage in plan.stages if isinstance(stage, Limits)]


_COUNTED = {2: Words("两", "two"), 3: Words("三", "three"), 4: Words("四", "four")}
_LINE = Words(
    "，$P$ 在所给坐标处，$PQ$ 沿所给方向，长度任取",
    ", $P$ at the place given, $PQ$ in the direction given, of any length",
)


def _told(plan: Plan) -> Words:
    zh, en = ["选 $μ_l$，画出"], ["Choose $μ_l$ and draw "]
    if fixed := [f"${one.letter}$" for one in plan.pins if one.on == FRAME]:
        zh.append(f"固定铰链 {'、'.join(fixed)}、")
        en.append(f"the pivot{'s' * (len(fixed) > 1)} {', '.join(fixed)}, ")
    if plan.slides:
        letters = "、".join(f"${slide.letter}$" for slide in plan.slides)
        zh.append(f"滑块铰链 {letters} 的各位置、")
        en.append(f"the positions of the slider's pin {letters.replace('、', ', ')}, ")
    for stage in limits_of(plan):
        rocker, side = f"${stage.pivot}{stage.pin}_1$", stage.limit.label
        zh.append(f"摇杆的{side.zh}极限位置 {rocker}、")
        en.append(f"the {side.en} limit position {rocker} of the rocker, ")
    for body in plan.bodies:
        marks = _lines(plan, body)
        said = _LINE if _free(body) else Words("", "")
        held = Words(f"（{'、'.join(marks)}{said.zh}）", f" ({', '.join(marks)}{said.en})") if marks else Words("", "")
        told = _axes_told(plan, body) if _has_axes(plan, body) else held
        zh.append(f"{_body_zh(plan, body)}{told.zh}、")
        en.append(f"{_body_en(plan, body)}{told.en}, ")
    return Words("".join(zh).rstrip("、") + "。", "".join(en).rstrip(", ") + ".")


def _body_zh(plan: Plan, body: Body) -> str:
    if _free(body):
        return f"平面 ${body.name}$ 的{_COUNTED[len(body.positions)].zh}个位置"
    return f"{'构件' if _pinned(plan, body) else '标线'} ${body.name}$ 的各位置"


def _body_en(plan: Plan, body: Body) -> str:
    if _free(body):
        return f"the {_COUNTED[len(body.positions)].en} positions of the body ${body.name}$"
    return f"the positions of the {'link' if _pinned(plan, body) else 'line'} ${body.name}$"


def _pinned(plan: Plan, body: Body) -> bool:
    """Whether its line is the link itself, with a pin at its end, and not a mark on a link whose pins are sought."""
    return any(one.on == body.name and one.letter == body.name[1] for one in plan.pins)


def _lines(plan: Plan, body: Body) -> list[str]:
    """The letters of its line in every position, where no pins of it have any: AM_1, AM_2; P_1Q_1."""
    own = sum(one.on == body.name for one in plan.pins)
    if own > 1 or (own and not _free(body)):
        return []
    mark, moves = mark_of(plan, body), body.name[0] in {slide.letter for slide in plan.slides}
    start = "P" if _free(body) else body.name[0]
    starts = (f"{start}_{{{n}}}" if _free(body) or moves else start for n in range(1, plan.count + 1))
    return [f"${start}{mark}_{{{n}}}$" for n, start in enumerate(starts, 1)]


def _free(body: Body) -> bool:
    """Whether it is a plane that turns about no lettered point."""
    return len(body.name) == 1


def _with_body(sheet: Sheet, body: Body) -> Sheet:
    """Its positions, and its pins that are given."""
    own = [one for one in sheet.plan.pins if one.on == body.name]
    stands = tuple(_stands(sheet, body, n) for n in range(sheet.plan.count))
    sheet = sheet.with_body(body.name, stands)
    for one in own:
        places = tuple(_on_body(sheet.draft, at, one) for at in stands)
        sheet = sheet.with_pin(one.letter, lettered(sheet.draft, one.letter, places))
    return _marked(sheet, body, own)


def _stands(sheet: Sheet, body: Body, n: int) -> Stands:
    """Its origin, and the point that marks its line, in one position."""
    draft, position = sheet.draft, body.positions[n]
    start = sheet.pins[body.name[0]][n] if not _free(body) else placed(draft, position.at)
    along = draft.board.ray(start, 1 + 0j, position.angle, key=f"{body.name}{n + 1}").along
    return Stands(start=start, end=draft.board.lay_off(start, along, draft.mm(REACH * sheet.plan.extent)))


def _on_body(draft: Draft, stands: Stands, one: Pin) -> Points:
    """A pin of the body in one position."""
    if one.at == 0:
        return stands.start
    return draft.board.lay_off(stands.start, stands.along * one.at / abs(one.at), draft.mm(abs(one.at)))


def _marked(sheet: Sheet, body: Body, own: list[Pin]) -> Sheet:
    """The line of the body in each position, and its letter where no pin stands on it."""
    draft = sheet.draft
    ends = [sheet.pins[one.letter] for one in own]
    for n, stands in enumerate(sheet.bodies[body.name]):
        role = Role.HIDDEN if n else Role.GIVEN  # dashed as its links are in the others, which lie over these
        if _free(body) and len(ends) == 2:
            draft.board.join(SHEET, ends[0][n], ends[1][n], role)
            if _has_axes(sheet.plan, body):
                _axes_drawn(sheet, body, n)
            continue
        draft.board.join(SHEET, stands.start, stands.end if _free(body) or not own else ends[0][n], role)
        if _free(body):
            half = 1j * stands.along * HALF
            corners = stands.start + half, stands.end + half, stands.end - half, stands.start - half
            draft.board.depict(SHEET, outline(f"body {body.name}{n + 1}", *corners))
            pin(draft, f"P_{n + 1}", stands.start, Dot.POINT)
        if not own or _free(body):
            pin(draft, f"{mark_of(sheet.plan, body)}_{n + 1}", stands.end, Dot.POINT)
    if body.pivot and not _in_line(sheet.plan, body):
        _directions_marked(sheet, body)
    return sheet


def _has_axes(plan: Plan, body: Body) -> bool:
    """Whether two pins of a plane are given in its own coordinates, and are not its origin and a point of its x axis
    themselves."""
    places = [one.at for one in plan.pins if one.on == body.name]
    return _free(body) and len(places) == 2 and not (0 in places and not any(at.imag for at in places))


def _axes_told(plan: Plan, body: Body) -> Words:
    """From where its pins are set out."""
    pins = [f"${one.letter}_i$" for one in plan.pins if one.on == body.name]
    numbers = ", ".join(f"{n}" for n in range(1, plan.count + 1))
    origin = f"${body.name}_i$"
    return Words(
        f"（原点 {origin}、$x′_i$ 轴，$i$ = {numbers}），由各自的坐标定出 {'、'.join(pins)}",
        f" (origins {origin}, axes $x′_i$, $i$ = {numbers}) with {' and '.join(pins)} by their coordinates there",
    )


def _axes_drawn(sheet: Sheet, body: Body, n: int) -> None:
    """Its origin and x axis in one position."""
    board, stands = sheet.draft.board, sheet.bodies[body.name][n]
    end = stands.start + stands.along * sheet.draft.mm(AXIS * REACH * sheet.plan.extent)
    board.arrow(SHEET, stands.start, end, Role.DIRECTION)
    board.plot(SHEET, end, f"x′_{n + 1}", Dot.NONE)
    if all(one.at for one in sheet.plan.pins if one.on == body.name):
        board.plot(SHEET, stands.start, f"{body.name}_{n + 1}", Dot.POINT)


def _in_line(plan: Plan, body: Body) -> bool:
    """Whether another line through its pivot, whose directions are marked, runs on as this one in every position."""
    before = plan.bodies[: plan.bodies.index(body)]
    return any(
        all(abs(sin(a.angle - b.angle)) < STRAIGHT for a, b in zip(one.positions, body.positions, strict=True))
        for one in before
        if one.pivot and one.name[0] == body.name[0]
    )


def _directions_marked(sheet: Sheet, body: Body) -> None:
    """Its direction in each position, from the x axis and under the symbol that the data have: φ_1, φ_2."""
    draft, symbol = sheet.draft, body.symbol or f"φ_{body.name}"
    start, reach = sheet.bodies[body.name][0].start, draft.mm(AXIS * REACH * sheet.plan.extent)
    draft.board.join(SHEET, start, start + reach, Role.CENTRE)
    for n, (stands, position) in enumerate(zip(sheet.bodies[body.name], body.positions, strict=True)):
        own = f"{symbol}{n + 1}" if body.name in symbol else f"{symbol}_{n + 1}"
        rays = start + reach, stands.end
        marked(draft, start, rays, own, key=ascii_key(own), nth=n, turn=position.angle)


def mark_of(plan: Plan, body: Body) -> str:
    """The letter of the point that marks the line of a body: that of its name, unless a pin has it."""
    if _free(body):
        return "Q"
    taken = {*plan.known, *plan.sought}
    if body.name[1] not in taken:
        return body.name[1]
    others = [one for one in plan.bodies if len(one.name) == 2 and one.name[1] in taken]
    return "MNGH"[others.index(body)]
