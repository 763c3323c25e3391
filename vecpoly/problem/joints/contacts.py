"""Cams and contacts: ``1 touches 2 at K``. The contact is replaced by a massless link of the same motion (高副低代)."""

from __future__ import annotations

import cmath
import re

from ...errors import FaultError
from ...foundation.indices import LETTER
from ...foundation.patterns import pattern
from ...mechanism.model import Circle, Contact, Joint, Prismatic, Rack, Side
from ...words import Words
from ..links.bodies import Bodies
from ..links.draft import Draft
from ..links.guides import LINK
from ..problem import Shape

_TOUCHES = pattern(
    rf"(?P<a>{LINK}) touches (?P<on>the (?:disc|face) of )?(?P<b>{LINK})(?P<inside> inside)? at (?P<point>{LETTER})"
    r"(?:,? (?P<side>left|right) of the face)?"
)
FORMS = (_TOUCHES,)  # for editors too
EXAMPLES = Words(
    "'1 touches 2 at K'、'1 touches 2 inside at K'（两圆）或 '1 touches 2 at K right of the face'",
    "'1 touches 2 at K', '1 touches 2 inside at K' (discs) or '1 touches 2 at K right of the face'",
)


def is_contact(text: object) -> bool:
    """Whether this entry of `joints` speaks of a contact."""
    return isinstance(text, str) and (" touches " in text or text.endswith(" of the face"))


def read_contact(text: str, bodies: Bodies) -> tuple[Joint, ...]:
    """One contact: it is kept in the bodies, which get its substitute link too;
    the joints which that link needs beyond pins."""
    m = _TOUCHES.fullmatch(text)
    if m is None:
        raise FaultError(
            Words(f"“{text}”不是接触的写法；应写 {EXAMPLES.zh}", f"'{text}' is no contact; write {EXAMPLES.en}"),
            code="spelling",
        )
    if m["point"] in (*bodies.letters(), *bodies.pitch):
        raise FaultError(
            Words(
                f"字母 {m['point']} 已是一个点；请给接触点另取字母",
                f"the letter {m['point']} already is a point; give the contact a letter of its own",
            ),
            code="contradiction",
        )
    disc, second = _disc_of_one(m, bodies)
    if second.face is not None and (second.disc is None or m["on"] == "the face of "):
        return (_on_face(m, bodies, disc, second),)
    if second.disc is None:
        raise FaultError(
            Words(
                f"构件 {second.name} 既无圆盘也无平面，无从接触；请在其中写 disc: E, radius: 10 mm 或 face: "
                f"{next(iter(second.points))}",
                f"link {second.name} has neither disc nor face to be touched; write disc: E, radius: 10 mm or "
                f"face: {next(iter(second.points))} in it",
            ),
            code="missing",
        )
    _on_disc(m, bodies, disc, second.disc)
    return ()


def _disc_of_one(m: re.Match[str], bodies: Bodies) -> tuple[Circle, Draft]:
    """The disc of the first link, else of the second, and the other link."""
    first, second = bodies.draft(m["a"]), bodies.draft(m["b"])
    if first is second:
        raise FaultError(Words(f"构件 {first.name} 不能与自身接触", f"link {first.name} cannot touch itself"))
    bodies.pitch.append(m["point"])
    if first.disc is None:
        first, second = second, first
    if first.disc is None:
        raise FaultError(
            Words(
                f"构件 {m['a']} 与 {m['b']} 接触，但都没有圆盘；请在其一中写 disc: {next(iter(second.points))}, "
                "radius: 40 mm",
                f"links {m['a']} and {m['b']} touch, but neither has a disc; write e.g. disc: "
                f"{next(iter(second.points))}, radius: 40 mm in one of them",
            ),
            code="spelling",
        )
    return first.disc, second


def _on_disc(m: re.Match[str], bodies: Bodies, one: Circle, two: Circle) -> None:
    """Disc on disc: a bar between the centres, R + r long, or R − r where one runs inside the other."""
    if m["side"]:
        raise FaultError(
            Words(
                f"构件 {one.link} 与 {two.link} 是圆盘与圆盘接触；“of the face”在此无意义，请去掉",
                f"links {one.link} and {two.link} touch with their discs: 'of the face' says nothing here",
            )
        )
    internal = m["inside"] is not None
    if internal:  # the smaller disc is the one inside: it presses outwards
        one, two = sorted((one, two), key=lambda disc: disc.radius)
    reach = two.radius - one.radius if internal else one.radius + two.radius
    if reach <= 0:
        raise FaultError(
            Words(
                f"半径 {one.radius * 1e3:g} mm 的圆盘不能在半径 {two.radius * 1e3:g} mm 的圆盘内运动；请减小其半径",
                f"a disc of {one.radius * 1e3:g} mm inside another of {two.radius * 1e3:g} mm does not run; "
                "give it a smaller radius",
            ),
            code="out-of-range",
        )
    name = bodies.free(f"{one.centre}{two.centre}")
    bodies.drafts[name] = Draft(name, Shape.PIN, {one.centre: 0j, two.centre: complex(reach)})
    bodies.contacts.append(Contact(point=m["point"], disc=one, on=two, substitute=name, internal=internal))


def _on_face(m: re.Match[str], bodies: Bodies, disc: Circle, other: Draft) -> Prismatic:
    """Disc on a flat face: a block pinned at the centre, led along the parallel at the distance R from the face."""
    assert other.face is not None
    if m["side"] is None:
        raise FaultError(
            Words(
                f"圆盘在构件 {other.name} 平面的哪一侧？请写明，如“{m[0]} right of the face”（按平面的方向）",
                f"on which side of the face of link {other.name} does the disc lie? write e.g. '{m[0]} right of "
                "the face' (of its direction)",
            ),
            code="missing",
        )
    if m["inside"]:
        raise FaultError(
            Words(
                "圆盘不能从内侧与平面接触；请去掉 inside",
                "a disc does not touch a flat face from inside; leave 'inside' out",
            )
        )
    side, line = Side(m["side"]), other.face
    name = bodies.free(f"pin{disc.centre}")
    bodies.drafts[name] = Draft(name, Shape.PIN, {disc.centre: 0j})
    face = Rack(link=other.name, origin=line.origin, direction=line.direction)
    bodies.contacts.append(Contact(point=m["point"], disc=disc, on=face, substitute=name, side=side))
    shift = cmath.rect(disc.radius, line.direction) * (1j if side is Side.LEFT else -1j)
    return Prismatic(
        guide=other.name,
        block=name,
        origin=line.origin + shift,
        direction=line.direction,
        pin=disc.centre,
        pin_in_slot=True,
    )
