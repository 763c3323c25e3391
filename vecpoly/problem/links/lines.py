"""The line of a slot, a rod, a rack or a face of a link, at an angle or beside a point."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from math import degrees

from ...errors import FaultError
from ...units.reading import Dim, read
from ...words import Words
from ..schema.faults import meant
from ..text.source import Value
from .draft import ANGLE_FROM, ONE, Draft, Line, ray
from .places import aside

_ON_LINE = 1e-9  # of a distance: how far beside a line a point of it may lie
_STRAIGHT, _SQUARE = 180.0, 90.0  # deg
_EVEN = 1e-9  # deg
_CALLED = {
    "slot": Words("导槽中线", "the slot's line"),
    "rod": Words("杆的中线", "the rod's line"),
    "rack": Words("齿条节线", "the rack's pitch line"),
    "face": Words("平底", "the face"),
}


def read_line(draft: Draft, data: Mapping[str, Value], what: str) -> Line:
    """{through: D, angle: 60 deg from CD, left: 10 mm}: the line of a slot, of a rod or of a face."""
    for key in data:
        if key not in ("through", "angle", "left", "right"):
            raise FaultError(
                Words(f"“{key}”不是 {what} 的键", f"'{key}' is no key of a {what}")
                + meant(key, ("through", "angle", "left", "right")),
                key,
                code="unknown-key",
            )
    letter = str(data.get("through", ""))
    if not ONE.fullmatch(letter):
        raise FaultError(
            Words(
                f"{what} 过哪一点？如写 {what}: {{through: D, angle: 60 deg from CD}}",
                f"through which point does the {what} pass? write e.g. {what}: {{through: D, angle: 60 deg from CD}}",
            ),
            code="missing",
        )
    if letter not in draft.points:
        raise FaultError(
            Words(f"点“{letter}”不在构件 {draft.name} 上", f"point '{letter}' is not on link {draft.name}")
            + meant(letter, draft.points),
            "through",
            code="unknown-name",
        )
    turn = _turn(draft, str(data["angle"])) if "angle" in data else 0j + 1
    left = aside(data)
    return Line(draft.points[letter] + 1j * left * turn, cmath.phase(turn), letter)


def _turn(draft: Draft, text: str) -> complex:
    """The unit vector of '60 deg from CD'."""
    m = ANGLE_FROM.fullmatch(text)
    if m is None:
        raise FaultError(
            Words(
                "请由构件上的射线量角，如 60 deg from CD", "write the angle from a ray of the link, e.g. 60 deg from CD"
            ),
            "angle",
            code="missing",
        )
    return ray(draft, m[2])[2] * cmath.exp(1j * read(m[1], Dim.ANGLE).si)


def note_face(draft: Draft, face: Line, data: Mapping[str, Value]) -> None:
    """The distance of the face from its letter for 已知; once all points of the link are known."""
    letter, turn = face.through, cmath.exp(1j * face.direction)
    side = next((key for key in ("left", "right") if key in data), "")
    if side:
        zh, other = "左" if side == "left" else "右", _ahead(draft, letter, turn)
        if other:
            ray = f"${letter}{other}$"
            draft.say(
                Words(
                    f"构件 {draft.name} 的平底与 {ray} 平行，在有向线 {ray} {zh}侧 {data[side]}",
                    f"the face of link {draft.name} is parallel to {ray}, {data[side]} to the {side} of it",
                )
            )
            return
        draft.say(
            Words(
                f"构件 {draft.name} 的平底在 ${letter}$ {zh}侧 {data[side]}",
                f"the face of link {draft.name} lies {data[side]} to the {side} of ${letter}$",
            )
        )


def _ahead(draft: Draft, letter: str, turn: complex) -> str:
    """A point of the link that lies from its letter in the direction of the face; "" where there is none."""
    start = draft.points[letter]
    ways = {other: (spot - start) / turn for other, spot in draft.points.items() if other != letter}
    return next((other for other, way in ways.items() if way.real > 0 and abs(way.imag) < _ON_LINE * way.real), "")


def note_slant(draft: Draft, key: str, data: Mapping[str, Value]) -> None:
    """How the line of a slot, rod, rack or face lies on its link: at an angle, or beside its letter. What lies along a
    line of the link, and a face or a rack square to it, is as it is shown; how far off a face is, is told with it."""
    letter, turned = f"${data['through']}$", _angle(str(data.get("angle", "")), key in ("rack", "face"))
    beside = None if key == "face" else _beside(letter, data)
    own = Words(f"构件 {draft.name} 的{_CALLED[key].zh}", f"{_CALLED[key].en} of link {draft.name} ")
    if beside is not None and turned is not None:
        draft.say(own + turned + Words("，", ", and ") + beside)
    elif turned is not None:
        draft.say(own + Words(f"过 {letter}，", f"passes through {letter} and ") + turned)
    elif beside is not None:
        way = "" if "angle" in data else f"（自 {letter} 向滑块看）"
        draft.say(own + beside + Words(way, f", seen from {letter} towards the block" if way else ""))


def _angle(text: str, is_flank: bool) -> Words | None:
    """60 deg from CD, in words; None of what is seen on the figure."""
    found = ANGLE_FROM.fullmatch(text)
    if found is None:
        return None
    turn = degrees(read(found[1], Dim.ANGLE).si)
    if min(turn % (step := _SQUARE if is_flank else _STRAIGHT), -turn % step) < _EVEN:
        return None
    ray = Words("其导路", "its guide") if found[2] == "line" else Words(f" ${found[2]}$ ", f"${found[2]}$")
    zh, en = ("逆时针", "counter-clockwise") if turn > 0 else ("顺时针", "clockwise")
    return Words(
        f"与{ray.zh}成 {abs(turn):.6g}°（由后者{zh}量）", f"is at {abs(turn):.6g}° to {ray.en}, {en} from the latter"
    )


def _beside(letter: str, data: Mapping[str, Value]) -> Words | None:
    """How far it passes from its letter, and on which side; None where it passes through it."""
    side = next((key for key in ("left", "right") if key in data), "")
    if not side or not aside(data):
        return None
    zh = "左" if side == "left" else "右"
    return Words(f"在 {letter} {zh}侧 {data[side]}", f"passes {data[side]} to the {side} of {letter}")
