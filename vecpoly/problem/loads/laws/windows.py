"""When a load acts, as written: ``while: E moves left``, ``between: [5 %, 95 %]``, ``during: [60 deg, 150 deg]``."""

from __future__ import annotations

import re
from math import pi

from ....errors import FaultError
from ....foundation.indices import LETTER
from ....foundation.patterns import pattern
from ....mechanism.laws.windows import During, Moving, Turning, Window
from ....units.reading import Dim, read
from ....words import Words
from ...links.bodies import Bodies
from ...links.guides import LINK
from ...schema.faults import meant
from ...schema.models import LoadSpec
from ..driven import Driven

_WAYS = {"right": 0.0, "up": pi / 2, "left": pi, "down": -pi / 2, "右": 0.0, "上": pi / 2, "左": pi, "下": -pi / 2}
_CCW = {"ccw": 1, "counter-clockwise": 1, "counterclockwise": 1, "逆时针": 1, "cw": -1, "clockwise": -1, "顺时针": -1}
_POINT = rf"(?P<point>{LETTER}\d*)"
_MOVES = pattern(
    rf"{_POINT}\s*(?:moves\s+(?:to\s+the\s+)?(?P<way>left|right|up|down)|moves\s+along\s+(?P<along>.+)"
    r"|(?:点)?\s*向?(?P<向>[左右上下])(?:运动|移动|移)?|(?:点)?\s*沿\s*(?P<沿>.+?)\s*(?:方向)?(?:运动|移动)?)"
)
_TURNS = pattern(rf"(?:link\s+|构件\s*)?(?P<link>{LINK})\s*(?:turns\s+)?(?P<sense>{'|'.join(_CCW)})(?:方向)?(?:转动)?")
_PART = pattern(r"\s*(\d+\.?\d*|\.\d+)\s*([%％]?)\s*")


def read_windows(spec: LoadSpec, bodies: Bodies, driven: Driven) -> tuple[Window, ...]:
    """When the load acts: () for always; raises FaultError."""
    found: list[Window] = []
    text = getattr(spec, "while")
    if text is not None:
        found.append(_moving(text, spec, bodies))
    elif spec.between is not None:
        raise FaultError(
            Words(
                "between 给的是行程的一部分，须写明是哪一点、朝哪边的行程；如 while: E moves left",
                "'between' is part of a stroke; say of which point and which way, e.g. while: E moves left",
            ),
            "between",
            code="missing",
        )
    if spec.during is not None:
        found.append(_during(spec.during, driven))
    return tuple(found)


def _moving(text: str, spec: LoadSpec, bodies: Bodies) -> Window:
    turns = _TURNS.fullmatch(text.strip())
    if turns is not None:
        return _turning(turns, spec, bodies)
    m = _MOVES.fullmatch(text.strip())
    if m is None:
        raise FaultError(
            Words(
                f"“{text}”不可识别；请写 E 向左运动、E 沿 30 deg 运动，或 构件 3 逆时针转动",
                f"'{text}' is not understood; write e.g. E moves left, E moves along 30 deg, or 3 turns ccw",
            ),
            "while",
            code="spelling",
        )
    named, along = m["way"] or m["向"], m["along"] or m["沿"]
    try:
        way = _WAYS[named] if named else read(along, Dim.ANGLE).si
    except FaultError as fault:
        raise fault.under("while") from None
    link, point = point_of(m["point"], spec.on, bodies, "while")
    low, high = _parts(spec) if spec.between is not None else (0.0, 1.0)
    return Moving(link=link, point=point, direction=way, low=low, high=high)


def _turning(m: re.Match[str], spec: LoadSpec, bodies: Bodies) -> Turning:
    if spec.between is not None:
        raise FaultError(
            Words(
                "between 是某点行程的一部分，转动的构件没有行程；请写 during，或 while: E moves left",
                "'between' is part of the stroke of a point, and a link that turns has none; write 'during', or while: "
                "E moves left",
            ),
            "between",
            code="contradiction",
        )
    if m["link"] not in bodies.numbers:
        raise FaultError(
            Words(f"构件“{m['link']}”不存在", f"link '{m['link']}' does not exist") + meant(m["link"], bodies.numbers),
            "while",
            code="unknown-name",
        )
    return Turning(link=bodies.draft(m["link"]).name, sense=_CCW[m["sense"]])


def point_of(text: str, own: str | None, bodies: Bodies, key: str) -> tuple[str, str]:
    """The moving link and the letter meant by E or E5: that of the load's own link first; raises FaultError."""
    letter, number = (text, "") if text in bodies.letters() else re.fullmatch(r"(\D+)(.*)", text).groups()  # type: ignore[union-attr]
    carriers = [name for name in bodies.numbers if letter in bodies.drafts[name].held and number in ("", name)]
    if letter in bodies.frame and not number:
        raise FaultError(
            Words(
                f"点 {letter} 固定在机架上，不运动；请写运动的点",
                f"point {letter} is fixed to the frame and does not move; name one that moves",
            ),
            key,
            code="contradiction",
        )
    if not carriers:
        raise FaultError(
            Words(f"活动构件上没有点“{text}”", f"no moving link has a point '{text}'")
            + meant(letter, {x for one in bodies.drafts.values() for x in one.held if x not in bodies.frame}),
            key,
            code="unknown-name",
        )
    return (own if own in carriers else carriers[0]), letter


def _parts(spec: LoadSpec) -> tuple[float, float]:
    assert spec.between is not None
    low, high = (_part(text) for text in spec.between)
    if not low < high:
        raise FaultError(
            Words(
                f"between 从 {100 * low:g} % 到 {100 * high:g} %：先后颠倒；行程从 while 所说运动的起点（0 %）量起，"
                f"请写 [{100 * high:g} %, {100 * low:g} %]",
                f"'between' goes from {100 * low:g} % to {100 * high:g} %, which is reversed: the stroke counts from "
                f"where the motion of 'while' sets out (0 %); write [{100 * high:g} %, {100 * low:g} %]",
            ),
            "between",
            code="contradiction",
            numbers={"low": low, "high": high},
        )
    return low, high


def _part(text: str) -> float:
    m = _PART.fullmatch(text)
    value = None if m is None else float(m[1]) / (100.0 if m[2] else 1.0)
    if value is None or not 0.0 <= value <= 1.0:
        raise FaultError(
            Words(
                f"“{text}”不是行程的一部分；请写 0 % 至 100 %，如 [5 %, 95 %]",
                f"'{text}' is no part of a stroke; write 0 % to 100 %, e.g. [5 %, 95 %]",
            ),
            "between",
            code="out-of-range",
        )
    return value


def _during(pair: tuple[str, str], driven: Driven) -> During:
    try:
        low, high = (driven.place(text) for text in pair)
    except FaultError as fault:
        raise fault.under("during") from None
    if low == high or (driven.drive.slide and low > high):
        raise FaultError(
            Words(
                f"during 从 {pair[0]} 到 {pair[1]}，其间没有位置；请由小到大写出两个不同的位置",
                f"'during' goes from {pair[0]} to {pair[1]}, and there is no place between; write two places, the "
                "lesser first",
            ),
            "during",
            code="contradiction",
        )
    return During(low=low, high=high, period=driven.period)
