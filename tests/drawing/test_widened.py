"""An angle whose letter finds no place beside its arc is marked where the letter has room between its sides."""

from __future__ import annotations

from collections.abc import Iterator

from tests.drawn_library import DRAFTED, drafted
from tests.drawn_sheets import laid
from tests.each import each
from vecpoly.board.construction import Figure
from vecpoly.board.paper.marks import AngleMark, Mark
from vecpoly.drawing.figure import Bare, Drawing, drawing
from vecpoly.drawing.labels.following import Follower
from vecpoly.drawing.labels.want import Thing
from vecpoly.drawing.scene import Item, Stroke
from vecpoly.drawing.widened import LEAST, MOST, widened

OPENED = ("8-18", "8-15")  # in which leaders of angles crossed other lines


def _figures(name: str) -> Iterator[Figure]:
    if drafted(name) is not None:
        yield from (one.figure for sheet in laid(name) for one in sheet.figures if one.figure is not None)


def _opened(name: str) -> Iterator[tuple[Figure, Drawing]]:
    made = ((figure, drawing(figure)) for figure in _figures(name))
    yield from ((figure, one) for figure, one in made if one.widths)


def _plain(mark: Mark) -> object:
    return (mark.at, mark.start, mark.sweep, mark.label) if isinstance(mark, AngleMark) else mark


def _led(figure: Figure) -> int:
    """Letters on leaders, where no angle is marked otherwise."""
    return sum(label.foot is not None for label in Bare.of(figure, "zh").lettering(None).placed)


@each([*OPENED, *DRAFTED])
def test_an_angle_that_is_marked_otherwise_has_its_letter_beside_it_and_tells_the_same(name: str) -> None:
    found = [*_opened(name)]
    assert found or name not in OPENED
    for figure, one in found:
        other = widened(figure, one.widths)
        assert [_plain(mark) for mark in other.marks] == [_plain(mark) for mark in figure.marks]
        changed = [new for new, old in zip(other.marks, figure.marks, strict=True) if new != old]
        assert changed and all(isinstance(mark, AngleMark) and LEAST <= mark.radius <= MOST for mark in changed)
        assert sum(label.foot is not None for label in one.labels) < _led(figure)


def _arcs(items: tuple[Item, ...]) -> set[tuple[complex, ...]]:
    return {one.points for one in items if isinstance(one, Stroke) and len(one.points) > 8}


def test_in_the_next_position_the_arc_is_as_wide_as_on_paper() -> None:
    figure, one = next(_opened("8-18"))
    assert any(label.want.thing is Thing.ARC for label in one.labels)
    follower = Follower("zh")
    first, second = follower.lettered(figure), follower.lettered(figure)
    assert _arcs(first) == _arcs(second) != _arcs(Bare.of(figure, "zh").items)
