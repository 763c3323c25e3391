"""The figures of a cam that stand apart show pivots on the ground, a follower in its guide, a roller of its size."""

from __future__ import annotations

from tests.drawn_library import LIBRARY, drawn, given
from tests.each import Later, each
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.marks import Arc, Dot, FixedGuide, Ground, Point, Role
from vecpoly.devices.cams.cam import Cam

IDS = Later(lambda: (name for name in LIBRARY if isinstance(cam := given(name).subject, Cam) and cam.alpha is None))
NEAR = 1e-6  # mm


def apart(name: str) -> tuple[Figure, ...]:
    """The pressure angles and the curvature."""
    figures = tuple(figure for figure in drawn(name).figures(View.MECHANISM) if figure.name)
    assert figures
    return figures


@each(IDS)
def test_the_pivots_stand_on_the_ground(name: str) -> None:
    for figure in apart(name):
        at = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point)}
        grounds = [mark.at for mark in figure.marks if isinstance(mark, Ground)]
        for letter in {"O", "A"} & set(at):
            assert any(abs(at[letter] - spot) < NEAR for spot in grounds), (figure.name, letter)


@each(IDS)
def test_a_follower_that_slides_has_its_guide_and_one_that_swings_its_pivot(name: str) -> None:
    cam = given(name).subject
    assert isinstance(cam, Cam)
    for figure in apart(name):
        guides = [mark for mark in figure.marks if isinstance(mark, FixedGuide)]
        letters = {mark.label for mark in figure.marks if isinstance(mark, Point)}
        assert len(guides) == (0 if cam.arm else 2) and ("A" in letters) == bool(cam.arm), figure.name


@each(IDS)
def test_a_roller_is_a_circle_of_its_size_about_its_pin(name: str) -> None:
    cam = given(name).subject
    assert isinstance(cam, Cam)
    for figure in apart(name):
        pins = [
            mark.at for mark in figure.marks if isinstance(mark, Point) and mark.dot is Dot.JOINT and not mark.label
        ]
        rims = [mark for mark in figure.marks if isinstance(mark, Arc) and mark.role is Role.GIVEN]
        assert len(rims) == len(pins) == bool(cam.follower.roller), figure.name
        for rim, pin in zip(rims, pins, strict=True):
            assert abs(rim.centre - pin) < NEAR
            assert abs(rim.radius * figure.scale.value - cam.follower.radius) < NEAR
