"""How the line of a link is called, and where that of a slot, a rod, a rack or a face runs, as 已知 tells it where a
reader could not know otherwise."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from math import degrees, radians

from ...units.reading import Dim, read
from ...words import Words
from ..problem import Shape
from ..text.source import Value
from ..values.leaning import at_angle
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
_SIDES = {True: Words("左", "left"), False: Words("右", "right")}  # whether it is on the left


def note_lines(draft: Draft, data: Mapping[str, Value]) -> None:
    """The angle and the distance of the link's lines for 已知; once all points of the link are known."""
    for key, line in (("slot", draft.line), ("rod", draft.line), ("rack", draft.rack), ("face", draft.face)):
        given = data.get(key)
        if line is None or given is None:
            continue
        named = Words(f"构件 {draft.name} 的{_LINES[key].zh}", f"{_LINES[key].en} of link {draft.name}")
        if not isinstance(given, dict):
            if key == "rack":  # its body lies beside the pitch line, and so may its pins
                draft.say(named + Words(f"过 ${line.through}$", f" passes through ${line.through}$"))
        elif told := _told(draft, key, line, {one: str(value) for one, value in given.items()}):
            draft.say(named + told)


def _told(draft: Draft, key: str, line: Line, given: Mapping[str, str]) -> Words | None:
    """How it runs; None where it runs along a ray of its link through its letter, and is no rack whose pins may lie
    beside it, or is a face square to a guide."""
    letter, m = line.through, ANGLE_FROM.fullmatch(given.get("angle", ""))
    left, distance = _beside(given)
    turn = degrees(read(m[1], Dim.ANGLE).si) if m else 0.0
    if m is None or turn % _HALF == 0.0:
        ahead = m[2] if m else letter + _ahead(draft, letter, cmath.exp(1j * line.direction))
        if key == "rack" and not distance and len(ahead) > 1 and ahead != "line":
            return Words(f"与 ${ahead}$ 重合", f" coincides with ${ahead}$")
        return _parallel(letter, ahead, distance, _SIDES[left is (turn % 360 == 0.0)]) if distance else None
    on_guide, square = m[2] == "line", turn % _HALF == _RIGHT
    if square and on_guide and key == "face" and not distance:
        return None
    ray = _GUIDE if on_guide else Words(f" ${m[2]}$ ", f"${m[2]}$")
    how = Words(f"与{ray.zh}垂直", f" is perpendicular to {ray.en}") if square else _leaning(ray, turn)
    return how + (_aside(letter, distance, _SIDES[left]) if distance else Words("", ""))


def _beside(given: Mapping[str, str]) -> tuple[bool, str]:
    """Whether it passes its letter on the left, and how far; no distance where it goes through it."""
    for key in ("left", "right"):
        if key in given and (si := read(given[key], Dim.LENGTH).si):
            return (key == "left") is (si > 0), given[key].lstrip("-− ")
    return False, ""


def _parallel(letter: str, ahead: str, distance: str, side: Words) -> Words:
    if ahead == letter:
        return Words(f"在 ${letter}$ {side.zh}侧 {distance}", f" lies {distance} to the {side.en} of ${letter}$")
    if ahead == "line":
        return Words(
            f"与{_GUIDE.zh}平行，在 ${letter}$ {side.zh}侧 {distance}",
            f" is parallel to {_GUIDE.en}, {distance} to the {side.en} of ${letter}$",
        )
    return Words(
        f"与 ${ahead}$ 平行，在有向线 ${ahead}$ {side.zh}侧 {distance}",
        f" is parallel to ${ahead}$, {distance} to the {side.en} of it",
    )


def _leaning(ray: Words, turn: float) -> Words:
    turn = (turn + _HALF) % 360 - _HALF
    return Words("", " is ") + at_angle(f"{round(abs(turn), 9):.10g}°", radians(turn), ray)


def _aside(letter: str, distance: str, side: Words) -> Words:
    return Words(
        f"，沿此方向看在 ${letter}$ {side.zh}侧 {distance}",
        f", and passes {distance} to the {side.en} of ${letter}$, seen in this direction",
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
