"""Pins from shared letters; sliding and rolling joints in words: ``4 slides in 5``, ``4 rolls on 3 at H``."""

from __future__ import annotations

import re
from itertools import pairwise

from ..errors import FaultError
from ..mechanism.model import FRAME, Circle, Joint, Rack, Revolute, Rolling, Side
from ..units import positive
from ..words import Words
from .bodies import Bodies
from .draft import LETTER
from .faults import not_on_frame
from .guides import LINK, fixed_line
from .slides import read_slide

_ROLLS = re.compile(
    rf"(?P<gear>{LINK}) rolls (?P<how>on|inside|above|below|left of|right of) "
    rf"(?P<on>[xy] = .+?|line through {LETTER} at .+?|circle about {LETTER} of .+?|{LINK}) "
    rf"at (?P<point>{LETTER})"
)
EXAMPLES = (
    "'4 slides in 5', '5 slides on y = 600 mm', '2 passes through 3', 'B runs in 3', "
    "'3 rolls on y = 0 mm at D', '4 rolls on 3 at H' or '1 touches 2 at K'"
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
    if (slide := read_slide(text, bodies)) is not None:
        return slide
    if m := _ROLLS.fullmatch(text):
        return _rolls(m, bodies)
    raise FaultError(Words(
        f"“{text}”不是运动副的写法；应写 {EXAMPLES}（转动副不必写：字母相同即为铰链）",
        f"'{text}' is no joint; write {EXAMPLES} (pins need no entry: shared letters make them)"))


def _rolls(m: re.Match[str], bodies: Bodies) -> Rolling:
    how, on = m["how"], m["on"]
    bodies.pitch.append(m["point"])
    gear = _circle(m["gear"], bodies)
    side = Side.RIGHT if how in ("below", "right of") else Side.LEFT
    other = _partner(on, bodies)
    if isinstance(other, Circle) and how not in ("on", "inside"):
        raise FaultError(Words(
            f"齿轮只能写 rolls on 或 rolls inside，不能写“{how}”",
            f"a gear rolls 'on' or 'inside' another, not '{how}'"))
    if how == "inside" and isinstance(other, Rack):
        raise FaultError(Words(
            "齿轮在齿条上滚动，应写 on、above、below、left of 或 right of，不能写 inside",
            "a gear rolls on, above, below, left of or right of a rack, not inside it"))
    return Rolling(point=m["point"], gear=gear, on=other, internal=how == "inside", side=side)


def _partner(on: str, bodies: Bodies) -> Circle | Rack:
    if m := re.fullmatch(rf"circle about ({LETTER}) of (.+)", on):
        if m[1] not in bodies.frame:
            raise not_on_frame(m[1], bodies.frame)
        return Circle(link=FRAME, centre=m[1], radius=positive(m[2]).si)
    if (fixed := fixed_line(on, bodies)) is not None:
        return Rack(link=FRAME, origin=fixed.origin, direction=fixed.direction)
    draft = bodies.draft(on)
    if draft.gear is None and draft.line is not None:
        return Rack(link=on, origin=draft.line.origin, direction=draft.line.direction)
    return _circle(on, bodies)


def _circle(name: str, bodies: Bodies) -> Circle:
    draft = bodies.draft(name)
    if draft.gear is None:
        raise FaultError(Words(
        f"构件 {name} 不是齿轮；请在构件 {name} 中写 gear: {next(iter(draft.points))}, radius: 60 mm",
        f"link {name} is no gear; write gear: {next(iter(draft.points))}, radius: 60 mm in link {name}"))
    return draft.gear
