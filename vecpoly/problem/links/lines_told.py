"""How the line of a link is called, and where that of a slot, a rod, a rack or a face runs, as 已知 tells it where a
reader could not know otherwise."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from math import degrees

from ...units.reading import Dim, read
from ...words import Words
from ..problem import Shape
from ..text.source import Value
from .draft import ANGLE_FROM, Draft, Line

_ON_LINE = 1e-9  # of a distance: how far beside a line a point of it may lie
_RIGHT, _HALF = 90.0, 180.0  # degrees
_LINES = {
    "slot": Words("滑道", "the slot"),
    "rod": Words("杆的中线", "the rod"),
    "rack": Words("齿条节线", "the pitch line of the rack"),
    "face": Words("平底", "the face"),
}
_OWN = {Shape.SLOT: Words("导槽中线", "the slot's line"), Shape.ROD: Words("杆的中线", "the rod's line")}
_GUIDE = Words("其导路", "its guide")


def note_lines(draft: Draft, data: Mapping[str, Value]) -> None:
    """The angle and the distance of the link's lines for 已知; once all points of the link are known."""
    for key, line in (("slot", draft.line), ("rod", draft.line), ("rack", draft.rack), ("face", draft.face)):
        given = data.get(key)
        if line is None or not isinstance(given, dict):
            continue
        named = Words(f"构件 {draft.name} 的{_LINES[key].zh}", f"{_LINES[key].en} of link {draft.name}")
        if told := _told(draft, key, line, {one: str(value) for one, value in given.items()}):
            draft.say(named + told)


def _told(draft: Draft, key: str, line: Line, given: Mapping[str, str]) -> Words | None:
    """How it runs; None where it runs along a ray of its link through its letter, or is a face square to a guide."""
    letter, m = line.through, ANGLE_FROM.fullmatch(given.get("angle", ""))
    side, distance = _beside(given)
    turn = degrees(read(m[1], Dim.ANGLE).si) if m else 0.0
    if m is None or turn % _HALF == 0.0:
        ahead = m[2] if m else letter + _ahead(draft, letter, cmath.exp(1j * line.direction))
        return _parallel(letter, ahead, distance, (side == "left") is (turn % 360 == 0.0)) if side else None
    ray = _GUIDE if m[2] == "line" else Words.same(f" ${m[2]}$")
    if turn % _HALF == _RIGHT and key == "face" and m[2] == "line" and not side:
        return None
    how = _perpendicular(ray) if turn % _HALF == _RIGHT else _leaning(ray, turn)
    return how + (_aside(letter, distance, left=side == "left") if side else Words("", ""))


def _beside(given: Mapping[str, str]) -> tuple[str, str]:
    """On which side it passes its letter, and how far; nothing where it goes through it."""
    for side, other in (("left", "right"), ("right", "left")):
        if side in given and (si := read(given[side], Dim.LENGTH).si):
            return (side, given[side]) if si > 0 else (other, given[side].lstrip("-− "))
    return "", ""


def _parallel(letter: str, ahead: str, distance: str, left: bool) -> Words:
    zh, en = ("左", "left") if left else ("右", "right")
    if ahead == letter:
        return Words(f"在 ${letter}$ {zh}侧 {distance}", f" lies {distance} to the {en} of ${letter}$")
    if ahead == "line":
        return Words(
            f"与{_GUIDE.zh}平行，在 ${letter}$ {zh}侧 {distance}",
            f" is parallel to {_GUIDE.en}, {distance} to the {en} of ${letter}$",
        )
    return Words(
        f"与 ${ahead}$ 平行，在有向线 ${ahead}$ {zh}侧 {distance}",
        f" is parallel to ${ahead}$, {distance} to the {en} of it",
    )


def _perpendicular(ray: Words) -> Words:
    return Words(f"与{ray.zh} 垂直", f" is perpendicular to {ray.en.strip()}")


def _leaning(ray: Words, turn: float) -> Words:
    turn = (turn + _HALF) % 360 - _HALF
    way = Words("逆时针", "counter-clockwise") if turn > 0 else Words("顺时针", "clockwise")
    size = f"{round(abs(turn), 9):.10g}°"
    return Words(
        f"与{ray.zh} 成 {size}（由后者{way.zh}量）", f" is at {size} to {ray.en.strip()}, {way.en} from the latter"
    )


def _aside(letter: str, distance: str, *, left: bool) -> Words:
    zh, en = ("左", "left") if left else ("右", "right")
    return Words(
        f"，沿此方向看在 ${letter}$ {zh}侧 {distance}",
        f", and passes {distance} to the {en} of ${letter}$, seen in this direction",
    )


def _ahead(draft: Draft, letter: str, turn: complex) -> str:
    """A point of the link that lies from its letter in the direction of the line; "" where there is none."""
    start = draft.points[letter]
    ways = {other: (spot - start) / turn for other, spot in draft.points.items() if other != letter}
    return next((other for other, way in ways.items() if way.real > 0 and abs(way.imag) < _ON_LINE * way.real), "")


def line_words(draft: Draft, along: str, start: str) -> Words:
    """BC, or the link's own guide line, or the guide in which it slides, from the point that is on it."""
    if len(along) == 2:
        return Words(f" ${along}$ ", f"${along}$")
    line = _OWN.get(draft.shape) if draft.line is not None else None
    if line is not None:
        return Words(f"{line.zh}（自 ${start}$ 起）", f"{line.en} from ${start}$")
    return Words(
        f"构件 {draft.name} 所沿导路的方向（自 ${start}$ 起）",
        f"the direction of the guide of link {draft.name} from ${start}$",
    )
