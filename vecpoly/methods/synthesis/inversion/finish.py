"""The linkage that is found: drawn in its positions, its lengths read, its verdict told."""

from __future__ import annotations

from collections.abc import Iterator
from functools import reduce
from itertools import pairwise
from operator import add

import numpy as np

from ....board.paper.marks import Dot
from ....board.said.behind import behind
from ....designs.inversion.loops import Loop, Sliding
from ....designs.inversion.plan import Find, On
from ....designs.quantities import TURN_AB, TURN_AD, TURN_DC
from ....designs.verdict import Verdict
from ....names import Named
from ....plane import Points, Reals, nominal
from ....plane.geometry import dot
from ....words import Words
from ..angles import marked, valued
from ..draft import SHEET
from ..linkage import drawn, rejected
from .judged import drives, judged, turns_fully
from .sheet import Sheet, Stands

HALF = 180.0  # deg
NO_OFFSET = 0.05  # mm: a guide that passes so near passes through


def finish(sheet: Sheet) -> None:
    """The linkage as it is found, and its verdict."""
    verdict = judged(sheet)
    joined(sheet, verdict)
    closed(sheet, verdict)


def joined(sheet: Sheet, verdict: Verdict) -> None:
    """Draw the links, thick in the first position and dashed in the others; read what was sought."""
    draft, plan = sheet.draft, sheet.plan
    draft.board.section(Words("所得机构", "The linkage"))
    draft.board.step(_told(sheet, verdict), SHEET)
    for loop in plan.loops:
        thick, *thin = (_chain(sheet, loop, n) for n in range(plan.count))
        drawn(draft, thick, *thin, verdict=verdict)
    if sheet.labels and verdict is Verdict.VALID:
        _lettered(sheet)
    draft.rejected = verdict is not Verdict.VALID
    rejected(draft, verdict)
    _lengths(sheet)
    _ahead(sheet)
    _turned(sheet)


def closed(sheet: Sheet, verdict: Verdict) -> None:
    """The candidate is finished."""
    kinds = [kind for kind, _ in _kinds(sheet)] if verdict is Verdict.VALID else []
    sheet.draft.kind = reduce(add, kinds) if kinds else None
    sheet.draft.last = verdict is Verdict.VALID and _last_drives(sheet)
    sheet.draft.candidate(verdict, _order(sheet), **_pins(sheet))


def _last_drives(sheet: Sheet) -> bool:
    """Whether only the last link on the frame leads a valid linkage through its positions."""
    return sheet.plan.either and drives(sheet, sheet.plan.loops[0])[0] is not Verdict.VALID


def _told(sheet: Sheet, verdict: Verdict) -> Words:
    plan = sheet.plan
    if verdict is not Verdict.VALID:
        pins = [f"${sheet.named(letter, 0)}$" for loop in plan.loops for letter in loop.letters]
        return Words(
            f"连接第一位置的各铰链 {'、'.join(pins)}。", f"Join the pins {', '.join(pins)} in the first position."
        )
    also = (
        Words("和第一位置的方向角", " and the directions in the first position") if sheet.plan.either else Words("", "")
    )
    told = Words(
        f"连接各铰链，第一位置画粗实线，其余位置画虚线；由图量得各构件长度{also.zh}：",
        f"Join the pins: thick in the first position, dashed in the others. Measure the lengths{also.en}:",
    )
    if not sheet.plan.either:
        kinds = [why for _, why in _kinds(sheet)]
        return behind(told, reduce(add, kinds)) if kinds else told
    first, last = drives(sheet, sheet.plan.loops[0])
    if first is last is Verdict.VALID:
        return told
    able, other, why = ("CD", "AB", first) if last is Verdict.VALID else ("AB", "CD", last)
    zh, en = ("经过死点", "meets a dead point") if why is Verdict.BRANCH else ("次序不对", "comes in another order")
    driver = Words(
        f"（须以 ${able}$ 为原动件；若以 ${other}$ 为原动件，则在各位置之间{zh}。）",
        f" (The link ${able}$ must drive it: ${other}$ as the driver {en} between the positions.)",
    )
    return behind(told, driver)


def _lettered(sheet: Sheet) -> None:
    """The pins of a linkage by the letters of its lengths, beside those by which each of them was found."""
    draft, found = sheet.draft, [letter for loop in sheet.plan.loops for letter in loop.letters]
    letters = [draft.letter(one if sheet.still(one) else f"{one}1") for one in found]
    for one, letter in zip(found, letters, strict=True):
        draft.board.plot(SHEET, sheet.pins[one][0], letter, Dot.NONE)
    same = [f"${letter}$ = ${sheet.named(one, 0)}$" for one, letter in zip(found, letters, strict=True)]
    draft.board.remark(Words(f"各铰链的字母：{'、'.join(same)}。", f" Letters of its pins: {', '.join(same)}."))


def _kinds(sheet: Sheet) -> Iterator[tuple[Words, Words]]:
    """Of what type its slider-cranks are, whether the link on the frame can turn fully; the same with the reason."""
    for loop in sheet.plan.loops:
        if isinstance(loop, Sliding):
            turns, name = turns_fully(sheet, loop), f"${loop.a}{loop.b}{loop.c}$"
            crank, rocker = Words("曲柄滑块机构", "a slider-crank"), Words("摇杆滑块机构", "a rocker-slider")
            kind, sign = (crank, "≤") if turns else (rocker, ">")
            a, c = (complex(nominal(sheet.pins[letter][0])) for letter in (loop.a, loop.c))
            aside = abs(((c - a) / loop.along).imag) > NO_OFFSET
            terms = f"$l_{{{loop.a}{loop.b}}}{' + e' * aside}$ {sign} $l_{{{loop.b}{loop.c}}}$"
            e = (
                Words(f"，$e$ 为 ${loop.a}$ 到导路的距离", f", where $e$ is the distance of ${loop.a}$ from the guide")
                if aside
                else Words("", "")
            )
            yield (
                Words(f"{name} 为{kind.zh}。", f"The linkage {name} is {kind.en}."),
                Words(f"（因 {terms}{e.zh}，{name} 为{kind.zh}。）", f" (Since {terms}{e.en}, {name} is {kind.en}.)"),
            )


def _chain(sheet: Sheet, loop: Loop, n: int) -> tuple[Points, ...]:
    return tuple(sheet.pins[letter][n] for letter in loop.letters)


def _lengths(sheet: Sheet) -> None:
    """What is given, and every other length of the linkage off the rule."""
    draft, given = sheet.draft, sheet.plan.given_bars
    for one, two in sheet.plan.bars():
        named = Named(one + two, f"l_{{{one}{two}}}", "mm")
        if (known := given.get(frozenset((one, two)))) is not None:
            draft.shared(named, 1e3 * known)
            continue
        letters = f"{sheet.named(one, 0)} {sheet.named(two, 0)}"
        draft.length(
            draft.of_this(named), draft.board.measure(sheet.pins[one][0], sheet.pins[two][0], letters), letters
        )


def _ahead(sheet: Sheet) -> None:
    """The angle by which a pin is ahead of the line of its link: read of three positions, else known."""
    for stage in sheet.plan.stages:
        if not isinstance(stage, Find) or not sheet.plan.turns(stage.on):
            continue
        stands, at = sheet.bodies[stage.on][stage.kept], sheet.pins[stage.pin][stage.kept]
        named = Named(f"delta_{stage.pin}", f"δ_{{{stage.pin}}}", "deg")
        if stage.lies is None:
            own = sheet.draft.of_this(named)
            ahead = sheet.draft.stated(own, _between(sheet, stands, at)).value
            told, ends = valued(sheet.draft, own.symbol, ahead), (stands.end, at)
            marked(sheet.draft, stands.start, ends, told, key=own.key, turn=np.radians(ahead))
        elif stage.lies == On():  # on its line itself, on either side of the pivot
            sheet.draft.shared(named, np.where(dot(stands.along, at - stands.start) < 0, HALF, 0.0))
        else:
            sheet.draft.shared(named, np.degrees(np.angle((at - stands.start) / stands.along)))


def _between(sheet: Sheet, stands: Stands, at: Points) -> Reals:
    """From the line of a link to a pin, by protractor (deg)."""
    return np.degrees(sheet.draft.board.gauge(0j, (at - stands.start) / stands.along))


def _turned(sheet: Sheet) -> None:
    """Of a body led through positions the directions of AB, DC and AD in the first, by protractor (deg)."""
    if not sheet.plan.either:
        return
    pins = sheet.pins
    for named, one, two in ((TURN_AB, "A", "B"), (TURN_DC, "D", "C"), (TURN_AD, "A", "D")):
        turned = np.degrees(sheet.draft.board.gauge(pins[one][0], pins[two][0]))
        sheet.draft.stated(sheet.draft.of_this(named), turned)


def _order(sheet: Sheet) -> tuple[Reals, ...]:
    """AB, BC, and the place of A: the chain of the first loop."""
    chain = _chain(sheet, sheet.plan.loops[-1], 0)
    return (*(np.abs(two - one) for one, two in pairwise(chain)), chain[0].real)


def _pins(sheet: Sheet) -> dict[str, Points]:
    """Every pin by its letter and the number of the position; a fixed one by its letter."""
    return {
        (letter if sheet.still(letter) else f"{letter}{n}"): at
        for letter, places in sheet.pins.items()
        for n, at in enumerate(places, 1)
    }
