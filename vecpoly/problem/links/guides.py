"""The line along which something slides: fixed, of a link's own slot or rod, or through two points."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Mapping

from ...errors import FaultError
from ...foundation.indices import LETTER
from ...mechanism.model import FRAME
from ...units.reading import Dim, read
from ...words import Words, joined
from ..problem import Shape
from ..schema.faults import not_on_frame
from .bodies import Bodies
from .draft import Draft, Line, letters_of

LINK = r"\d+[a-z']?"
GUIDE = rf"[xy] = .+?|line through {LETTER} at .+?|{LETTER}{LETTER}(?: of {LINK})?|{LINK}"


def guide_of(text: str, bodies: Bodies, block: str) -> tuple[str, Line]:
    """The guide link and its line; `block`: the link that slides on it."""
    if fixed := fixed_line(text, bodies):
        return FRAME, fixed
    if re.fullmatch(LINK, text):
        return text, own_line(bodies.draft(text))
    letters, _, on = text.partition(" of ")
    first, second = letters_of(letters)
    if not on and first in bodies.frame and second in bodies.frame:
        return FRAME, _along(bodies.frame, first, second)
    owners = [on] if on else [n for n, d in bodies.drafts.items() if {first, second} <= d.points.keys() and n != block]
    if not owners or not {first, second} <= bodies.draft(owners[0]).points.keys():
        where = [_carried(letter, bodies) for letter in (first, second)]
        raise FaultError(
            Words(
                f"没有同时具有 {first}、{second} 两点的构件（{where[0].zh}；{where[1].zh}）；导路须在一个构件上",
                f"no link has both points {first} and {second} ({where[0].en}; {where[1].en}); a guide is on one link",
            )
        )
    return owners[0], _along(bodies.drafts[owners[0]].points, first, second)


def _carried(letter: str, bodies: Bodies) -> Words:
    """On which links a letter lies."""
    links = [name for name, draft in bodies.drafts.items() if letter in draft.points]
    here = [Words("机架", "the frame")] if letter in bodies.frame else []
    here += [Words(f"构件 {name}", f"link {name}") for name in links]
    if not here:
        return Words(f"{letter} 不在任何构件上", f"{letter} lies on none")
    return Words(f"{letter} 在{'、'.join(one.zh for one in here)} 上", f"{letter} is on {joined(here).en}")


def own_line(draft: Draft) -> Line:
    """The line of a link's slot or rod; of a bar without one, that of its first two points. A block has none."""
    if draft.line is not None:
        return draft.line
    first, *others = draft.points
    if draft.shape is Shape.BLOCK or not others:
        remedy = f"slot: {first}", f", or name the line: 'slides on {first}{others[0]}'" if others else ""
        raise FaultError(
            Words(
                f"构件 {draft.name} 没有导路；请在构件 {draft.name} 中写 {remedy[0]}（或 rod: {first}）"
                + (f"，或指明直线 {first}{others[0]}" if others else ""),
                f"link {draft.name} has no guide line; write {remedy[0]} (or rod: {first}) "
                f"in link {draft.name}{remedy[1]}",
            )
        )
    return _along(draft.points, first, others[0])


def _along(points: Mapping[str, complex], first: str, second: str) -> Line:
    if points[first] == points[second]:
        raise FaultError(
            Words(
                f"{first}、{second} 重合，不能确定直线；请另取两点",
                f"{first} and {second} are one place, through which no line is given; name two points",
            )
        )
    return Line(points[first], cmath.phase(points[second] - points[first]), first, second)


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
