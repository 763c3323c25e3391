"""A pin of groups drawn apart is open as long as it joins links, and a black dot once all but one are taken off."""

from __future__ import annotations

from collections.abc import Iterator

from tests.drawn_library import LIBRARY, drawn, given
from tests.each import Later, each
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.marks import Dot, Point
from vecpoly.devices.structure import Structure
from vecpoly.devices.structure_pairs import Chain
from vecpoly.drawing.legend.met import taken_off
from vecpoly.methods.devices.structure.count import count
from vecpoly.methods.devices.structure.groups import take_apart
from vecpoly.methods.devices.structure.replacement import replaced
from vecpoly.names import subscripted

Shown = tuple[Figure, tuple[str, ...], frozenset[str]]


def _taken_apart(name: str) -> bool:
    device = given(name).subject
    return isinstance(device, Structure) and any(
        figure.name.startswith("left ") for figure in drawn(name).figures(View.MECHANISM)
    )


def _chain(device: Structure) -> Chain:
    """The chain of lower pairs that is taken apart."""
    drivers = tuple(dict.fromkeys(link for together in device.drive_sets for link in together))
    return replaced(count(device.chain, drivers).reduced, device).chain


def _apart(name: str) -> Iterator[Shown]:
    """Every figure of groups or drivers, the links that it shows, those that were taken off before."""
    device = given(name).subject
    assert isinstance(device, Structure)
    chain = _chain(device)
    figures = {figure.name: figure for figure in drawn(name).figures(View.MECHANISM)}
    for drivers in device.drive_sets:
        sort, gone = "+".join(drivers), frozenset[str]()
        for index, group in enumerate(take_apart(chain, drivers).groups, 1):
            if (shown := figures.get(f"group {sort} {index}")) is not None:
                yield shown, group.links, gone
            gone |= {*group.links}
        if (left := figures.get(f"left {sort}")) is not None:
            yield left, drivers, gone


@each(Later(lambda: [name for name in LIBRARY if _taken_apart(name)]))
def test_a_pin_is_a_dot_just_where_everything_else_that_it_joined_was_taken_off(name: str) -> None:
    device = given(name).subject
    assert isinstance(device, Structure)
    pairs = _chain(device).pairs
    for figure, links, gone in _apart(name):
        dots = {mark.label: mark for mark in figure.marks if isinstance(mark, Point) and mark.dot is not Dot.NONE}
        for pair in (one for one in pairs if one.hinged and {*one.links} & {*links}):
            dot = dots[subscripted(pair.letter)]
            alone = len({*pair.links} - gone) == 1
            assert taken_off(figure, dot) is alone and (dot.dot is Dot.POINT) is alone, (figure.name, pair.letter)
