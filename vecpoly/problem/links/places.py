"""A further point of a link: by offsets along a ray, by an angle, or by two lengths."""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Mapping

from ...errors import FaultError
from ...foundation.indices import LETTER
from ...foundation.patterns import pattern
from ...mechanism.dimensions.placements import ByAngle, ByLengths, ByOffsets, Placement, Side, local
from ...names import subscripted
from ...units.reading import Dim, Quantity, positive, read
from ...words import Words
from ..schema.faults import meant
from ..text.source import Value
from ..values.leaning import at_angle
from ..values.seen import OffItsGuide, SetOff
from .draft import ANGLE_FROM, PLACED, Draft, ends_of, ray
from .lines_told import line_words
from .starts import is_phased, phased

_SIDE = pattern(rf"(left|right) of ({LETTER})({LETTER})")
_KEYS = ("along", "at", "left", "right", "angle", "side")


def place(draft: Draft, point: str, data: Value) -> None:
    """A further point of the link, by offsets, by an angle, or by two lengths."""
    if not isinstance(data, dict):
        raise FaultError(
            Words(
                f"缺少 {point} 的位置；如写 {{along: BC, at: 175 mm, left: 220 mm}}",
                f"the place of {point} is missing; write e.g. {{along: BC, at: 175 mm, left: 220 mm}}",
            ),
            code="missing",
        )
    if point in draft.points:
        twice = Words(f"点 {point} 已在构件 {draft.name} 上", f"point {point} is already on link {draft.name}")
        raise FaultError(twice + Words("；请删去其中一处", "; leave out one of the two"), code="contradiction")
    lengths = [key for key in data if PLACED.fullmatch(key)]
    for key in data:
        if key not in (*_KEYS, *lengths):
            raise FaultError(
                Words(f"“{key}”不是位置的键", f"'{key}' is no key of a place") + meant(key, _KEYS),
                key,
                code="unknown-key",
            )
    if "along" in data:
        placement = _by_offsets(draft, point, data)
    elif "angle" in data:
        placement = _by_angle(draft, point, data, lengths)
    elif len(lengths) == 2:
        placement = _by_lengths(draft, point, data, lengths)
    else:
        raise FaultError(
            Words(
                f"{point} 的位置不完整；请写 along/at/left，或一个长度和一个角，或两个长度和一侧",
                f"the place of {point} is incomplete; write along/at/left, or a length and an angle, or two "
                "lengths and a side",
            ),
            code="missing",
        )
    draft.placements.append(placement[0])
    draft.points[point] = placement[1]


def _by_offsets(draft: Draft, point: str, data: Mapping[str, Value]) -> tuple[Placement, complex]:
    for key in data:
        if key not in ("along", "at", "left", "right"):
            raise FaultError(
                Words(
                    "不能与 along 同用；请写 along、at 和 left 或 right",
                    "does not go together with 'along'; write along, at and left or right",
                ),
                key,
                code="contradiction",
            )
    base, start, unit = ray(draft, str(data["along"]))
    at, left = read(data.get("at"), Dim.LENGTH), aside(data)
    _note_offsets(draft, point, data, start + unit * at.si, base[0], at)
    placement = ByOffsets(point=point, base=base, along=at.si, left=left)
    return placement, start + unit * local(placement, draft.points)


def aside(data: Mapping[str, Value]) -> float:
    """How far to the left (m): `left` or, to the other side, `right`; raises FaultError where both are written."""
    if "left" in data and "right" in data:
        raise FaultError(
            Words(
                f"left: {data['left']} 与 right: {data['right']} 互相矛盾，一点只在一侧；请删去其一",
                f"left: {data['left']} and right: {data['right']} contradict each other, for "
                "a point lies on one side; leave out one of them",
            ),
            "right",
        )
    return read(data["left"], Dim.LENGTH).si if "left" in data else -read(data.get("right", "0"), Dim.LENGTH).si


def _alone(data: Mapping[str, Value], allowed: Iterable[str], by: str) -> None:
    """Raise FaultError for a key that says nothing beside those that already place the point."""
    for key in data:
        if key not in allowed:
            raise FaultError(
                Words(
                    f"'{key}' 与 {by} 不能并用：该点已由 {by} 确定；请删去其一",
                    f"'{key}' does not go together with {by}, which places the point already; leave out one of them",
                ),
                key,
            )


def _note_offsets(
    draft: Draft, point: str, data: Mapping[str, Value], foot: complex, origin: str, at: Quantity
) -> None:
    """l_BD = 50 mm on the ray; l_DE = 40 mm where a point D is the foot of E; words otherwise."""
    side = "left" if "left" in data else "right"
    beside = read(data[side], Dim.LENGTH).si if side in data else 0.0
    away, distance = str(data.get(side, "")).lstrip("-−+ "), at.text.lstrip("-−+ ")
    produced = Words("的反向延长线上", " produced backwards") if at.si < 0 else Words("上", "")
    below = next((letter for letter, place in draft.points.items() if abs(place - foot) < 1e-12), "")
    if not beside:
        draft.note(f"l_{origin}{point}", abs(at.si), distance)
        if at.si < 0:
            line, point = line_words(draft, str(data["along"]), origin), subscripted(point)
            draft.say(Words(f"${point}$ 在{line.zh}{produced.zh}", f"${point}$ lies on {line.en}{produced.en}"))
    elif below:
        draft.note(f"l_{below}{point}", abs(beside), away)
    else:
        zh, en = ("左", "left") if (side == "left") is (beside > 0) else ("右", "right")
        line, named = line_words(draft, str(data["along"]), origin), subscripted(point)
        back = "的反向延长线" if at.si < 0 else ""
        draft.say(
            Words(
                f"${named}$ 沿{line.zh}{back}距 ${origin}$ {distance}，位于其{zh}侧 {away}",
                f"${named}$ lies {distance} from ${origin}$ along {line.en}{produced.en} and {away} to its {en}",
            ),
            SetOff(point=point, start=origin, along=at.si, left=beside if side == "left" else -beside),
        )


def _by_angle(draft: Draft, point: str, data: Mapping[str, Value], lengths: list[str]) -> tuple[Placement, complex]:
    if len(lengths) == 1 and is_phased(draft, str(data["angle"])):
        spot = phased(draft, point, lengths[0], data[lengths[0]], str(data["angle"]))
        return ByAngle(point=point, base=(next(iter(draft.points)),), distance=abs(spot), angle=cmath.phase(spot)), spot
    m = ANGLE_FROM.fullmatch(str(data["angle"]))
    if m is None or len(lengths) != 1:
        raise FaultError(
            Words(
                "请写长度和由射线量起的角，如 {BE: 200 mm, angle: 50 deg from BC}",
                "write a length and the angle from a ray, e.g. {BE: 200 mm, angle: 50 deg from BC}",
            ),
            "angle",
            code="spelling",
        )
    _alone(data, ("angle", lengths[0]), f"{lengths[0]}, angle")
    ends = ends_of(lengths[0])
    base, start, unit = ray(draft, m[2])
    if set(ends) != {base[0], point}:
        raise FaultError(
            Words(
                f"长度应为 {base[0]}{point}，即由射线 {m[2]} 的起点量起",
                f"the length must be {base[0]}{point}, from the start of the ray {m[2]}",
            ),
            lengths[0],
            code="out-of-range",
        )
    angle, distance = read(m[1], Dim.ANGLE).si, positive(data[lengths[0]])
    draft.note(f"l_{lengths[0]}", distance.si, distance.text)
    if len(base) == 2:
        draft.note(f"∠{base[1]}{base[0]}{point}", angle, m[1])
    else:
        guide = Words(f"构件 {draft.name} 所沿导路的方向", f"the guide of link {draft.name}")
        draft.say(
            Words(f"${ends[0]}{ends[1]}$ ", f"${ends[0]}{ends[1]}$ is ") + at_angle(m[1], angle, guide),
            OffItsGuide(at=ends[0], end=ends[1], link=draft.name, turn=angle),
        )
    placement = ByAngle(point=point, base=base, distance=distance.si, angle=angle)
    return placement, start + unit * local(placement, draft.points)


def _by_lengths(draft: Draft, point: str, data: Mapping[str, Value], lengths: list[str]) -> tuple[Placement, complex]:
    m = _SIDE.fullmatch(str(data.get("side", "")))
    if m is None:
        raise FaultError(
            Words(
                f"{point} 在哪一侧？如写“side: left of BC”", f"on which side is {point}? write e.g. 'side: left of BC'"
            ),
            code="missing",
        )
    _alone(data, ("side", *lengths), ", ".join(lengths))
    base = (m[2], m[3])
    (_, start, unit) = ray(draft, m[2] + m[3])
    found: dict[str, float] = {}
    for key in lengths:
        other = [letter for letter in ends_of(key) if letter != point]
        if len(other) != 1 or other[0] not in base:
            raise FaultError(
                Words(
                    f"长度应联接 {point} 与 {base[0]} 或 {base[1]}",
                    f"the length must join {point} with {base[0]} or {base[1]}",
                ),
                key,
            )
        length = positive(data[key])
        found[other[0]] = length.si
        draft.note(f"l_{key}", length.si, length.text)
    if set(found) != set(base):
        raise FaultError(
            Words(
                f"需要两个长度：{base[0]}{point} 和 {base[1]}{point}",
                f"two lengths are needed: {base[0]}{point} and {base[1]}{point}",
            ),
            code="missing",
        )
    placement = ByLengths(point=point, base=base, lengths=(found[base[0]], found[base[1]]), side=Side(m[1]))
    seen = local(placement, draft.points)
    if cmath.isnan(seen):
        raise _no_triangle(point, base, abs(draft.points[base[1]] - start), *placement.lengths)
    return placement, start + unit * seen


def _no_triangle(point: str, base: tuple[str, str], c: float, p: float, q: float) -> FaultError:
    """The three lengths, and which of them is too long."""
    (a, b), longest = base, max(c, p, q)
    sizes = (f"{a}{point} = {p * 1e3:g}", f"{b}{point} = {q * 1e3:g}", f"{a}{b} = {c * 1e3:g} mm")
    more = f"{longest * 1e3:g} > {(c + p + q - longest) * 1e3:g}"
    return FaultError(
        Words(
            f"不成三角形：{'、'.join(sizes)}；最长边应小于另两边之和（{more}），请检查长度",
            f"no triangle: {', '.join(sizes)}; the longest must be less than the sum of the other two ({more}); "
            "check the lengths",
        ),
        code="out-of-range",
    )
