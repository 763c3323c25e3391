"""The pitch line of a rack, as the links see it that slide along it."""

from __future__ import annotations

import cmath
from math import pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vecpoly.mechanism.joints import Prismatic, Rack
from vecpoly.mechanism.model import Link, Mechanism
from vecpoly.mechanism.pitch_lines import pitch_lines

LENGTHS = st.floats(-0.5, 0.5)
SPOTS = st.builds(complex, LENGTHS, LENGTHS)
ANGLES = st.floats(-3.0, 3.0)


def own(spot: complex, at: complex, angle: float) -> complex:
    """A spot of the plane as a link sees it whose origin lies there, turned by so much."""
    return (spot - at) * cmath.exp(-1j * angle)


@given(
    slide=st.builds(
        Prismatic,
        guide=st.just("1"),
        block=st.just("2"),
        origin=SPOTS,
        direction=ANGLES,
        pin=st.just("C"),
        offset=LENGTHS,
        turn=ANGLES,
    ),
    pin=SPOTS,
    rack_on=st.sampled_from("12"),
    origin=SPOTS,
    back=st.booleans(),
    guide=st.tuples(SPOTS, ANGLES),
    travel=LENGTHS,
    spot=SPOTS,
)
def test_wherever_the_slide_stands_both_of_its_links_see_a_spot_as_far_to_the_left_of_the_pitch_line(
    slide: Prismatic,
    pin: complex,
    rack_on: str,
    origin: complex,
    back: bool,
    guide: tuple[complex, float],
    travel: float,
    spot: complex,
) -> None:
    mech = Mechanism(
        frame={}, links=(Link(name="1", points={}), Link(name="2", points={"C": pin})), joints=(slide,), drives=()
    )
    along = (slide.direction if rack_on == "1" else -slide.turn) + back * pi
    seen = pitch_lines(mech, Rack(link=rack_on, origin=origin, direction=along))
    at, angle = guide
    way = angle + slide.direction
    pinned = at + slide.origin * cmath.exp(1j * angle) + complex(travel, slide.offset) * cmath.exp(1j * way)
    stands = {"1": guide, "2": (pinned - pin * cmath.exp(1j * (way + slide.turn)), way + slide.turn)}
    left = {link: line.left(own(spot, *stands[link])) for link, line in seen.items()}
    assert left["1"] == pytest.approx(left["2"], abs=1e-9)
    turned = [cmath.exp(1j * (line.direction + stands[link][1])) for link, line in seen.items()]
    assert turned[0] == pytest.approx(turned[1])


def test_a_slide_that_is_not_along_the_rack_does_not_carry_its_pitch_line_on() -> None:
    links = (Link(name="1", points={}), Link(name="2", points={"C": 0j}))
    slide = Prismatic(guide="1", block="2", origin=0j, direction=0.5, pin="C")
    mech = Mechanism(frame={}, links=links, joints=(slide,), drives=())
    assert pitch_lines(mech, Rack(link="1", origin=0j, direction=0.6)).keys() == {"1"}
    assert pitch_lines(mech, Rack(link="1", origin=0j, direction=0.5)).keys() == {"1", "2"}
