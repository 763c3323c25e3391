"""Pins from shared letters; sliding and rolling joints in words: ``4 slides in 5``, ``4 rolls on 3 at H``."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import pairwise

from ..errors import FaultError
from ..mechanism.model import FRAME, Contact, Joint, Prismatic, Revolute
from ..units import Dim, read
from ..words import Words
from .draft import LETTER, Draft, Line, letters_of
from .faults import meant, not_on_frame, not_on_link
from .problem import Shape
from .slides import check_cylinder, note_slide

LINK = r"\d+[a-z']?"
_GUIDE = rf"[xy] = .+?|line through {LETTER} at .+?|{LETTER}{LETTER}(?: of {LINK})?|{LINK}"
_SLIDE = re.compile(
    rf"(?:(?P<pin>{LETTER}) of )?(?P<block>{LINK}) slides (?:in|on|along) (?P<guide>{_GUIDE})"
    rf"(?: with (?P<off>{LETTER}) (?P<offset>.+?) (?P<side>left|right))?(?: turned (?P<turn>.+))?"
)
_THROUGH = re.compile(rf"(?P<guide>{LINK}) passes through (?P<block>{LINK})")
_RUNS = re.compile(rf"(?P<pin>{LETTER}) runs in (?P<guide>{_GUIDE})")
FORMS = (_SLIDE, _THROUGH, _RUNS)  # for editors too
EXAMPLES = (
    "'4 slides in 5', '5 slides on y = 600 mm', '2 passes through 3', 'B runs in 3', "
    "'3 rolls on y = 0 mm at D', '4 rolls on 3 at H' or '1 touches 2 at K'"
)


@dataclass(frozen=True, slots=True)
class Bodies:
    """The frame's points and the links read so far."""

    frame: Mapping[str, complex]
    drafts: dict[str, Draft]
    pitch: list[str] = field(default_factory=list)  # letters of pitch points and contacts
    contacts: list[Contact] = field(default_factory=list)
    welded: dict[str, str] = field(default_factory=dict)  # rollers -> the links to which they were welded

    def draft(self, name: str) -> Draft:
        """The moving link `name`; for a roller the link to which it is welded."""
        name = self.welded.get(name, name)
        if name not in self.drafts:
            raise FaultError(Words(f"构件“{name}”不存在", f"link '{name}' does not exist") + meant(name, self.drafts), code="unknown-name")
        return self.drafts[name]

    def free(self, name: str) -> str:
        """A name that no link has yet."""
        while name in self.drafts:
            name += "′"
        return name

    def letters(self) -> tuple[str, ...]:
        """All letters: the frame's first, then link by link."""
        return tuple(
            dict.fromkeys([*self.frame, *(p for draft in self.drafts.values() for p in draft.points)])
        )


def revolutes(bodies: Bodies) -> tuple[Revolute, ...]:
    """A letter on two bodies is a pin; on k bodies a compound hinge of k - 1 pins. The frame comes last."""
    pins = []
    for letter in bodies.letters():
        names = [name for name, draft in bodies.drafts.items() if letter in draft.points]
        names += [FRAME] if letter in bodies.frame else []
        pins += [Revolute(point=letter, a=a, b=b) for a, b in pairwise(names)]
    return tuple(pins)


def read_joint(text: object, bodies: Bodies) -> Joint:
    """One entry of `joints`. A pin in a slot adds its massless block to the bodies."""
    if not isinstance(text, str):
        raise FaultError(Words(f"运动副应写成一句话，如 {EXAMPLES}", f"a joint is a sentence such as {EXAMPLES}"))
    if m := _SLIDE.fullmatch(text):
        return _slide(m, bodies)
    if m := _THROUGH.fullmatch(text):
        return _through(m, bodies)
    if m := _RUNS.fullmatch(text):
        return _runs(m, bodies)
    raise FaultError(Words(
        f"“{text}”不是运动副的写法；应写 {EXAMPLES}（转动副不必写：字母相同即为铰链）",
        f"'{text}' is no joint; write {EXAMPLES} (pins need no entry: shared letters make them)"), code="spelling")


def _slide(m: re.Match[str], bodies: Bodies) -> Prismatic:
    block = bodies.draft(m["block"])
    guide, line = _guide(m["guide"], bodies, block.name)
    pin = m["off"] or m["pin"] or next(iter(block.points))
    if pin not in block.points:
        raise not_on_link(pin, block.name, block.points)
    offset = read(m["offset"], Dim.LENGTH) if m["offset"] else None
    check_cylinder(guide, block, bodies.drafts)
    note_slide(m, block, pin)
    return Prismatic(
        guide=guide,
        block=block.name,
        origin=line.origin,
        direction=line.direction,
        pin=pin,
        through=line.through,
        offset=0.0 if offset is None else offset.si if m["side"] == "left" else -offset.si,
        turn=read(m["turn"], Dim.ANGLE).si if m["turn"] else 0.0,
    )


def _through(m: re.Match[str], bodies: Bodies) -> Prismatic:
    block = bodies.draft(m["block"])
    guide, line = _guide(m["guide"], bodies, block.name)
    check_cylinder(guide, block, bodies.drafts)
    return Prismatic(
        guide=guide,
        block=block.name,
        origin=line.origin,
        direction=line.direction,
        pin=next(iter(block.points)),
        through=line.through,
    )


def _runs(m: re.Match[str], bodies: Bodies) -> Prismatic:
    pin = m["pin"]
    if not any(pin in draft.points for draft in bodies.drafts.values()):
        raise FaultError(Words(
            f"点“{pin}”不在任何活动构件上",
            f"point '{pin}' is on no moving link") + meant(pin, bodies.letters()), code="unknown-name")
    guide, line = _guide(m["guide"], bodies, "")
    name = bodies.free(f"pin{pin}")
    bodies.drafts[name] = Draft(name, Shape.PIN, {pin: 0j})
    return Prismatic(
        guide=guide,
        block=name,
        origin=line.origin,
        direction=line.direction,
        pin=pin,
        through=line.through,
        pin_in_slot=True,
    )


def _guide(text: str, bodies: Bodies, block: str) -> tuple[str, Line]:
    """The guide link and its line."""
    if fixed := fixed_line(text, bodies):
        return FRAME, fixed
    if re.fullmatch(LINK, text):
        draft = bodies.draft(text)
        if draft.line is None and len(draft.points) >= 2:
            return text, _along(draft.points, *list(draft.points)[:2])
        if draft.line is None:
            raise FaultError(Words(
            f"构件 {text} 没有导路线；请在构件 {text} 中写 slot: {next(iter(draft.points))}（或 rod:）",
            f"link {text} has no guide line; write slot: {next(iter(draft.points))} (or rod:) in link {text}"), code="missing")
        return text, draft.line
    letters, _, on = text.partition(" of ")
    first, second = letters_of(letters)
    if not on and first in bodies.frame and second in bodies.frame:
        return FRAME, _along(bodies.frame, first, second)
    owners = (
        [on]
        if on
        else [n for n, d in bodies.drafts.items() if {first, second} <= d.points.keys() and n != block]
    )
    if not owners or not {first, second} <= bodies.draft(owners[0]).points.keys():
        raise FaultError(Words(
            f"没有构件同时含有点 {first} 和 {second}",
            f"no link has both points {first} and {second}"), code="unknown-name")
    return owners[0], _along(bodies.drafts[owners[0]].points, first, second)


def _along(points: Mapping[str, complex], first: str, second: str) -> Line:
    return Line(points[first], cmath.phase(points[second] - points[first]), first)


def fixed_line(text: str, bodies: Bodies) -> Line | None:
    """y = 600 mm, x = 0 mm, or line through K at -12 deg; directed to the right, upwards, or by the angle."""
    if m := re.fullmatch(r"([xy]) = (.+)", text):
        at = read(m[2], Dim.LENGTH).si
        return Line(complex(at, 0), math.pi / 2, "") if m[1] == "x" else Line(complex(0, at), 0.0, "")
    if m := re.fullmatch(rf"line through ({LETTER}) at (.+)", text):
        if m[1] not in bodies.frame:
            raise not_on_frame(m[1], bodies.frame)
        return Line(bodies.frame[m[1]], read(m[2], Dim.ANGLE).si, m[1])
    return None
