"""Gears that roll: ``4 rolls on 3 at H``, ``2 rolls inside circle about A of 90 mm at P``,
``3 rolls on y = 0 mm at D``."""

from __future__ import annotations

import math
import re

from ...errors import FaultError
from ...foundation.indices import LETTER
from ...foundation.patterns import pattern
from ...foundation.slotted import replace
from ...mechanism.model import FRAME, Circle, Rack, Rolling, Side
from ...units.reading import Dim, positive, read
from ...words import Words
from ..links.bodies import Bodies
from ..links.guides import LINK, fixed_line
from ..links.teeth import pressure_angle
from ..schema.faults import not_on_frame
from ..values.seen import Round

_SIZE = r"[\d.]+ \w+"  # of the second pitch circle of a stepped gear
_BESIDE = "above|below|left|right"
_FIXED = rf"circle about ({LETTER}) of (.+)"
_ROLLS = pattern(
    rf"(?P<gear>{LINK}(?: of {_SIZE})?) rolls (?P<how>on|inside|above|below|left of|right of) "
    rf"(?P<on>[xy] = .+?|line through {LETTER} at .+?|circle about {LETTER} of .+?|(?:the (?:rack|gear) of )?{LINK}"
    rf"(?: of {_SIZE})?)(?:,? (?P<mid>{_BESIDE}))? at (?P<point>{LETTER})(?:,? (?P<last>{_BESIDE}))?"
)
_MOVING = pattern(rf"(?:the (?P<what>rack|gear) of )?(?P<link>{LINK})(?: of (?P<size>{_SIZE}))?")
FORMS = (_ROLLS,)  # for editors too
EXAMPLES = (
    "'3 rolls on y = 0 mm at D', '3 rolls below y = 200 mm at D', '4 rolls on 3 at H', '2 rolls inside circle "
    "about A of 90 mm at P'"
)


def is_rolling(text: object) -> bool:
    """Whether this entry of `joints` speaks of a rolling pair."""
    return isinstance(text, str) and " rolls " in text


def read_rolling(text: str, bodies: Bodies) -> Rolling:
    """One rolling pair; its pitch point's letter is kept in the bodies. Raises FaultError."""
    m = _ROLLS.fullmatch(text)
    if m is None:
        raise FaultError(
            Words(f"'{text}' 不是滚动副；可写 {EXAMPLES}", f"'{text}' is no rolling pair; write {EXAMPLES}")
        )
    _own_letter(m["point"], bodies)
    gear, on = _circle(m["gear"], bodies), _partner(m["on"], bodies)
    if line := re.fullmatch(r"([xy]) = (.+)", m["on"]):
        bodies.draft(gear.link).say(
            Words(f"固定齿条节线 ${line[1]}$ = {line[2]}", f"pitch line of the fixed rack ${line[1]}$ = {line[2]}")
        )
    if fixed := re.fullmatch(_FIXED, m["on"]):
        bodies.draft(gear.link).say(
            _fixed_wheel(gear.link, m["point"], fixed[1], fixed[2], inside=_side(m) == "inside"),
            Round(symbol=f"r_{m['point']}", radius=read(fixed[2], Dim.LENGTH).si),
        )
    if gear.link == on.link:
        raise FaultError(Words(f"构件 {gear.link} 不能在自身上滚动", f"link {gear.link} cannot roll on itself"))
    side = _side(m)
    _matches(side, gear, on)
    bodies.pitch.append(m["point"])
    alpha = pressure_angle(bodies.draft(gear.link), None if on.link == FRAME else bodies.draft(on.link))
    if isinstance(on, Rack):
        return Rolling(point=m["point"], gear=gear, on=on, side=_beside(side, on, m["on"]), alpha=alpha)
    return Rolling(point=m["point"], gear=gear, on=on, internal=side == "inside", alpha=alpha)


def _fixed_wheel(link: str, point: str, centre: str, radius: str, *, inside: bool) -> Words:
    """Its radius is a datum, by the pitch point of which there may be several: it is no link that tells it."""
    what = Words("固定内齿轮", "fixed ring") if inside else Words("固定齿轮", "fixed gear")
    return Words(
        f"{what.zh}（圆心 ${centre}$，与构件 {link} 切于 ${point}$）的节圆半径 $r_{point}$ = {radius}",
        f"the {what.en} about ${centre}$, on which link {link} rolls at ${point}$, has the pitch radius "
        f"$r_{point}$ = {radius}",
    )


def pitch_letter(text: str) -> str:
    """The pitch point's letter; empty where the sentence cannot be read."""
    m = _ROLLS.fullmatch(text)
    return m["point"] if m else ""


def tells_side(text: str) -> bool:
    """Whether the sentence says on which side of its rack the gear lies."""
    m = _ROLLS.fullmatch(text)
    return m is not None and _side(m) != "on"


def _own_letter(point: str, bodies: Bodies) -> None:
    """The pitch point is a point of no link: its letter must be new."""
    if point in bodies.pitch:
        raise FaultError(
            Words(
                f"字母 {point} 已用于另一啮合点或接触点；请另取字母",
                f"{point} already is another pitch point or contact; give this pitch point a letter of its own",
            )
        )
    carriers = [name for name, draft in bodies.drafts.items() if point in draft.points]
    if not carriers and point not in bodies.frame:
        return
    pin = len(carriers) + (point in bodies.frame) > 1
    zh, en = (
        ("铰链", "a pin")
        if pin
        else ("机架的点", "a point of the frame")
        if not carriers
        else (f"构件 {carriers[0]} 的点", f"a point of link {carriers[0]}")
    )
    raise FaultError(
        Words(
            f"{point} 已是{zh}；啮合点请另取字母", f"{point} is already {en}; give the pitch point a letter of its own"
        )
    )


def _side(m: re.Match[str]) -> str:
    """on, inside, above, below, left or right; raises FaultError where two are said."""
    said = {word.removesuffix(" of") for word in (m["how"], m["mid"], m["last"]) if word and word != "on"}
    if len(said) > 1:
        one, two = sorted(said)
        raise FaultError(
            Words(
                f"'{m[0]}' 同时写了 {one} 和 {two}；请只写一个", f"'{m[0]}' says both {one} and {two}; keep one of them"
            )
        )
    return next(iter(said), "on")


def _matches(side: str, gear: Circle, on: Circle | Rack) -> None:
    """Gears roll on or inside each other, on or beside racks; what rolls inside is the smaller."""
    if isinstance(on, Rack):
        if side == "inside":
            raise FaultError(
                Words(
                    "齿轮与齿条只有外啮合：可写 on、above、below、left of、right of，不能写 inside",
                    "a gear rolls on, above, below, left of or right of a rack, not inside it",
                )
            )
        return
    if side not in ("on", "inside"):
        raise FaultError(
            Words(
                f"齿轮之间写 'on'（外啮合）或 'inside'（内啮合），不能写 '{side}'",
                f"a gear rolls 'on' or 'inside' another, not '{side}'",
            )
        )
    if side == "inside" and gear.radius >= on.radius:
        r, big = (f"{1e3 * circle.radius:g} mm" for circle in (gear, on))
        other = "" if on.link == FRAME or gear.radius == on.radius else f"'{on.link} rolls inside {gear.link}'"
        raise FaultError(
            Words(
                f"节圆半径为 {r} 的齿轮 {gear.link} 不能在半径为 {big} 的内齿轮中滚动"
                + (f"；可写 {other}" if other else "；请修改半径"),
                f"gear {gear.link} of radius {r} cannot roll inside a ring of radius {big}; "
                + (f"write {other}" if other else "change a radius"),
            )
        )


def _beside(side: str, rack: Rack, text: str) -> Side:
    """The side of the rack's direction; above and below are those of the plane where the rack is fixed."""
    if side in ("on", "left"):
        return Side.LEFT
    if side == "right":
        return Side.RIGHT
    ahead = math.cos(rack.direction) if rack.link == FRAME else 1.0
    if abs(ahead) < 1e-9:
        raise FaultError(
            Words(
                f"齿条 {text} 是竖直的，没有上下之分；请写 left of 或 right of",
                f"the rack {text} is upright and has no {side}; write left of or right of",
            )
        )
    return Side.LEFT if (side == "above") == (ahead > 0) else Side.RIGHT


def _partner(on: str, bodies: Bodies) -> Circle | Rack:
    if m := re.fullmatch(_FIXED, on):
        if m[1] not in bodies.frame:
            raise not_on_frame(m[1], bodies.frame)
        return Circle(link=FRAME, centre=_pinned_there(m[1], bodies), radius=positive(m[2]).si)
    if (fixed := fixed_line(on, bodies)) is not None:
        return Rack(link=FRAME, origin=fixed.origin, direction=fixed.direction)
    m = _MOVING.fullmatch(on)
    assert m
    draft = bodies.draft(m["link"])
    line = draft.rack or (draft.line if draft.gear is None else None)
    if m["what"] == "rack" and line is None:
        raise FaultError(
            Words(
                f"构件 {draft.name} 没有齿条；请在构件 {draft.name} 中写 rack: {next(iter(draft.points))}",
                f"link {draft.name} has no rack; write rack: {next(iter(draft.points))} in link {draft.name}",
            )
        )
    if m["what"] is None and not m["size"] and draft.rack is not None and draft.gear is not None:
        raise _which(on)
    if line is None or m["what"] == "gear" or m["size"]:
        return _circle(on.removeprefix("the gear of "), bodies)
    return Rack(link=m["link"], origin=line.origin, direction=line.direction)


def _which(link: str) -> FaultError:
    return FaultError(
        Words(
            f"构件 {link} 既有齿条又有齿轮；请写明与哪一个啮合，如 on the rack of {link}（与 {link} 的齿条在……啮合）"
            f"或 on the gear of {link}",
            f"link {link} has a rack and a gear; say with which it meshes: 'on the rack of {link}' or 'on the gear of "
            f"{link}'",
        ),
        code="ambiguous",
    )


def _pinned_there(letter: str, bodies: Bodies) -> str:
    """Of several letters of one fixed place that of the pin: an arm pinned there holds the gear about it."""
    same = [p for p, at in bodies.frame.items() if at == bodies.frame[letter]]
    return next((p for p in (letter, *same) if any(p in draft.points for draft in bodies.drafts.values())), letter)


def _circle(text: str, bodies: Bodies) -> Circle:
    """'2', or '2 of 35 mm': the second pitch circle of the stepped gear 2."""
    name, _, size = text.partition(" of ")
    draft = bodies.draft(name)
    if draft.gear is None:
        centre = next(iter(draft.points))
        raise FaultError(
            Words(
                f"构件 {name} 不是齿轮；请在构件 {name} 中写 gear: {centre}, radius: 60 mm",
                f"link {name} is no gear; write gear: {centre}, radius: 60 mm in link {name}",
            )
        )
    if not size:
        return draft.gear
    second = positive(size)
    symbol = f"r_{name}^′"
    if all(datum.symbol != symbol for datum in draft.lengths):
        draft.note(symbol, second.si, second.text)
    elif next(datum.si for datum in draft.lengths if datum.symbol == symbol) != second.si:
        raise FaultError(
            Words(
                f"齿轮 {name} 最多有两个节圆（双联齿轮）",
                f"gear {name} has two pitch circles at most: the one of its link, and one second",
            )
        )
    return replace(draft.gear, radius=second.si, mark="^′")
