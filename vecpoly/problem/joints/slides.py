"""Sliding joints in words: ``4 slides in 5``, ``2 passes through 3``, ``B runs in 3``;
which link is the guide, and beside what it passes."""

from __future__ import annotations

import cmath
import re
from collections.abc import Mapping

from ...errors import FaultError
from ...foundation.indices import LETTER
from ...foundation.patterns import pattern
from ...foundation.slotted import replace
from ...mechanism.model import Prismatic
from ...units.reading import Dim, read
from ...words import Words
from ..links.bodies import Bodies
from ..links.draft import Draft, Line
from ..links.guides import GUIDE, LINK, guide_of, own_line
from ..problem import Shape
from ..schema.faults import meant, not_on_link
from .slide_data import note_aside, note_fixed, note_slide

_ASIDE = rf"(?: with (?P<off>{LETTER}) (?P<offset>.+?) (?P<side>left|right))?"
_SLIDE = pattern(
    rf"(?:(?P<pin>{LETTER}) of )?(?P<block>{LINK}) slides (?:in|on|along) (?P<guide>{GUIDE}){_ASIDE}"
    r"(?: turned (?P<turn>.+))?"
)
_TURNED_FIRST = pattern(rf"( turned .+?)( with {LETTER} .+? (?:left|right))$")  # said in the other order
_THROUGH = pattern(rf"(?P<guide>{LINK}) passes through (?P<block>{LINK}){_ASIDE}")
_RUNS = pattern(rf"(?P<pin>{LETTER}) runs in (?P<guide>{GUIDE})")
FORMS = (_SLIDE, _THROUGH, _RUNS)  # for editors too
_SAME = 1e-9  # m


def read_slide(text: str, bodies: Bodies) -> Prismatic | None:
    """A sliding joint; None where the sentence is none. A pin in a slot adds its massless block to the bodies."""
    if m := _SLIDE.fullmatch(_TURNED_FIRST.sub(r"\2\1", text)):
        return _rod(m, bodies) if _is_rod(m, bodies) else _slide(m, bodies)
    if m := _THROUGH.fullmatch(text):
        return _through(m["guide"], m["block"], m, bodies)
    if m := _RUNS.fullmatch(text):
        return _runs(m, bodies)
    return None


def _slide(m: re.Match[str], bodies: Bodies) -> Prismatic:
    block = bodies.draft(m["block"])
    guide, line = guide_of(m["guide"], bodies, block.name)
    _apart(guide, block.name)
    check_cylinder(guide, block, bodies.drafts)
    pin = m["off"] or m["pin"] or next(iter(block.points))
    if pin not in block.points:
        raise not_on_link(pin, block.name, block.points)
    note_slide(m, block, guide, pin)
    return Prismatic(
        guide=guide,
        block=block.name,
        origin=line.origin,
        direction=line.direction,
        pin=pin,
        through=line.through,
        towards=line.towards,
        offset=_left(m),
        aside=pin if m["offset"] else "",
        turn=read(m["turn"], Dim.ANGLE).si if m["turn"] else 0.0,
    )


def _is_rod(m: re.Match[str], bodies: Bodies) -> bool:
    """Whether '2 slides on 3' means that the rod (or slot) 2 passes through the block 3,
    which has no line of its own."""
    if not re.fullmatch(LINK, m["guide"]):
        return False
    led, on = bodies.draft(m["block"]), bodies.draft(m["guide"])
    return led.line is not None and on.line is None and on.shape is Shape.BLOCK


def _rod(m: re.Match[str], bodies: Bodies) -> Prismatic:
    """A rod on a block: the rod is the guide."""
    if m["turn"]:
        rod, block = m["block"], m["guide"]
        raise FaultError(
            Words(
                f"构件 {rod} 的杆线就是滑块 {block} 的导路，不能再写 turned {m['turn']}；请去掉 turned",
                f"the line of link {rod} is the guide of block {block}, so nothing is turned "
                f"by {m['turn']}; leave 'turned' out",
            )
        )
    return _through(m["block"], m["guide"], m, bodies, m["pin"])


def _through(rod: str, through: str, m: re.Match[str], bodies: Bodies, pin: str | None = None) -> Prismatic:
    """A rod through a block: directed from its pin towards the block; a letter of either may lie beside its line."""
    _apart(rod, through)
    guide, block = bodies.draft(rod), bodies.draft(through)
    _not_reversed(guide, block)
    check_cylinder(rod, block, bodies.drafts)
    line, beside = own_line(guide), m["off"] or pin
    led = next(iter(block.points))
    joint = Prismatic(
        guide=rod,
        block=through,
        origin=line.origin,
        direction=line.direction,
        pin=led,
        through=line.through,
        towards=line.towards,
    )
    if beside is None:
        return joint
    if m["offset"]:
        joint = replace(joint, aside=beside)
        note_aside(m, guide if beside in guide.points else block, through, rod)
    if beside in guide.points:
        return replace(joint, origin=_beside(line, guide, beside, _left(m)))
    if beside not in block.points:
        known = (*guide.points, *block.points)
        raise FaultError(
            Words(
                f"点 {beside} 不在构件 {rod}、{through} 上",
                f"point '{beside}' is on neither link {rod} nor link {through}",
            )
            + meant(beside, known)
        )
    return replace(joint, pin=beside, offset=_left(m))


def _not_reversed(guide: Draft, block: Draft) -> None:
    """Refuse a block that is to pass through its own rod or slot."""
    if guide.line is not None or guide.shape is not Shape.BLOCK or block.line is None:
        return
    right = (
        f"{guide.name} slides in {block.name}"
        if block.shape is Shape.SLOT
        else f"{block.name} passes through {guide.name}"
    )
    raise FaultError(
        Words(
            f"构件 {guide.name} 是滑块，有导路的是构件 {block.name}；请写“{right}”",
            f"link {guide.name} is the block, and it is link {block.name} that has the line; write '{right}'",
        ),
        code="spelling",
    )


def _beside(line: Line, guide: Draft, letter: str, left: float) -> complex:
    """Where the line starts whose direction leaves the letter so far (m) to its left;
    refused where the link says otherwise."""
    along = cmath.exp(1j * line.direction)
    stands = (along.conjugate() * (guide.points[letter] - line.origin)).imag
    own = (along.conjugate() * (guide.points[line.through] - line.origin)).imag
    if abs(own) > _SAME and abs(stands - left) > _SAME:
        raise FaultError(
            Words(
                f"构件 {guide.name} 已规定 {letter} 在其导路左侧 {1e3 * stands:g} mm，运动副又写 {1e3 * left:g} mm；"
                "请只保留其一",
                f"link {guide.name} puts {letter} {1e3 * stands:g} mm to the left of its "
                f"line, the joint {1e3 * left:g} mm; keep one of the two",
            )
        )
    return guide.points[letter] - 1j * along * left


def check_cylinder(guide: str, block: Draft, drafts: Mapping[str, Draft]) -> None:
    """A piston runs in a cylinder, and nothing else does."""
    barrel = guide in drafts and drafts[guide].shape is Shape.CYLINDER
    if barrel != (block.shape is Shape.PISTON):
        raise FaultError(
            Words(
                f"缸体（cylinder）与活塞（piston）须成对出现；请将构件 {guide} 写成 {{cylinder: …}}、"
                f"构件 {block.name} 写成 {{piston: …}}，或改用 slot 与 block",
                f"a piston slides in a cylinder and in nothing else: write link {guide} as "
                f"{{cylinder: ...}} and link {block.name} as {{piston: ...}}, or use slot "
                "and block",
            )
        )


def _left(m: re.Match[str]) -> float:
    """How far to the left of the guide the letter lies (m)."""
    if not m["offset"]:
        return 0.0
    away = read(m["offset"], Dim.LENGTH).si
    return away if m["side"] == "left" else -away


def _apart(guide: str, block: str) -> None:
    if guide == block:
        raise FaultError(
            Words(
                f"构件 {block} 不能在自身上滑动；请写出另一构件",
                f"link {block} cannot slide on itself; name the other link",
            )
        )


def _runs(m: re.Match[str], bodies: Bodies) -> Prismatic:
    pin = m["pin"]
    if pin not in bodies.letters():
        raise FaultError(
            Words(f"没有点 {pin}", f"point '{pin}' does not exist") + meant(pin, bodies.letters()), code="unknown-name"
        )
    guide, line = guide_of(m["guide"], bodies, "")
    for owner in [draft for draft in bodies.drafts.values() if pin in draft.points][:1]:
        note_fixed(m["guide"], owner, pin)
    name = bodies.free(f"pin{pin}")
    bodies.drafts[name] = Draft(name, Shape.PIN, {pin: 0j})
    return Prismatic(
        guide=guide,
        block=name,
        origin=line.origin,
        direction=line.direction,
        pin=pin,
        through=line.through,
        towards=line.towards,
        pin_in_slot=True,
    )
