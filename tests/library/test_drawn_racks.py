"""A rack that moves reaches past its own pins, and one that slides on a fixed guide lies on it with all its length."""

from __future__ import annotations

import math

import pytest

from tests.drawn_library import LIBRARY, drawn, given
from tests.each import Later, each
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.marks import Dot, FixedGuide, Point, RackMark
from vecpoly.drawing.symbols.bodies import BLOCK_HEIGHT, TOOTH
from vecpoly.mechanism.model import FRAME, Mechanism, Prismatic, Rack, Rolling

NEAR = 0.05  # mm
BODY = TOOTH + BLOCK_HEIGHT  # mm from the pitch line to the underside of a rack


def _moving_rack(name: str) -> bool:
    mech = given(name).subject
    return isinstance(mech, Mechanism) and any(True for _ in _racks(mech))


def _racks(mech: Mechanism) -> list[str]:
    """The links that are racks and move."""
    rolls = (joint.on for joint in mech.joints if isinstance(joint, Rolling))
    return [on.link for on in rolls if isinstance(on, Rack) and on.link != FRAME]


def _diagram(name: str) -> Figure:
    return drawn(name).figures(View.MECHANISM)[0]


RACKS = Later(lambda: [name for name in LIBRARY if _moving_rack(name)])


@each(RACKS)
def test_a_rack_reaches_past_its_own_pins_at_both_ends(name: str) -> None:
    mech, figure = given(name).mechanism, _diagram(name)
    points = [mark for mark in figure.marks if isinstance(mark, Point) and mark.dot is not Dot.NONE]
    pins = {mark.label.split(",")[0]: mark.at for mark in points}
    for link in _racks(mech):
        (rack,) = (m for m in figure.marks if isinstance(m, RackMark) and not m.fixed and m.owner == f"link {link}")
        way, long = (rack.b - rack.a) / abs(rack.b - rack.a), abs(rack.b - rack.a)
        own = [letter for letter in mech.link(link).points if letter in pins]
        assert own
        for letter in own:
            room = 0.0 if letter in mech.frame else 4.0  # a fixed pivot has its symbol about the end
            assert room - NEAR < ((pins[letter] - rack.a) / way).real < long - room + NEAR, letter


@each(RACKS)
def test_a_rack_on_a_fixed_guide_lies_on_it_with_all_its_length(name: str) -> None:
    """One whose pitch line is at an angle to its guide stands on a block."""
    mech, figure = given(name).mechanism, _diagram(name)
    for link in _racks(mech):
        (rack,) = (m for m in figure.marks if isinstance(m, RackMark) and not m.fixed and m.owner == f"link {link}")
        under = [mark for mark in figure.marks if isinstance(mark, FixedGuide) and _is_under(mark, rack)]
        assert bool(under) is _lies_along(mech, link)
        for guide in under:
            ends = [((end - rack.a) / (rack.b - rack.a)).real for end in (guide.a, guide.b)]
            assert guide.to_scale and min(ends) < 0 and max(ends) > 1


def _lies_along(mech: Mechanism, link: str) -> bool:
    """Whether the pitch line of a rack runs along a fixed guide on which it slides."""
    ways = {
        j.on.direction for j in mech.joints if isinstance(j, Rolling) and isinstance(j.on, Rack) and j.on.link == link
    }
    turns = [j.turn for j in mech.joints if isinstance(j, Prismatic) and j.block == link and j.guide == FRAME]
    return any(abs(math.sin(turn + way)) < 1e-6 for turn in turns for way in ways)


def _is_under(guide: FixedGuide, rack: RackMark) -> bool:
    """Whether a guide runs along the underside of a rack, beside it."""
    way = (rack.b - rack.a) / abs(rack.b - rack.a)
    ends = [(end - rack.a) / way for end in (guide.a, guide.b)]
    beside = min(e.real for e in ends) < abs(rack.b - rack.a) and max(e.real for e in ends) > 0
    return beside and [end.imag for end in ends] == pytest.approx([-BODY, -BODY])
