"""Where a structural sketch has the number of a link: beside the longest of the link's lines."""

from __future__ import annotations

from tests.drawn_library import drawn, given, ids
from tests.each import Later, each
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import LinkNumber, Plate, Segment
from vecpoly.devices.structure import Structure

IDS = Later(lambda: tuple(name for name in ids(mechanisms=False) if isinstance(given(name).subject, Structure)))


@each(IDS)
def test_the_number_of_a_link_stands_at_no_line_of_it_that_is_shorter_than_another(name: str) -> None:
    for figure in drawn(name).figures(View.MECHANISM):
        for number in figure.marks:
            if isinstance(number, LinkNumber) and number.a != number.b:
                own = [m for m in figure.marks if m.owner == number.owner]
                lines = [(m.a, m.b) for m in own if isinstance(m, Segment)]
                if not lines:
                    plates = [m.points for m in own if isinstance(m, Plate)]
                    lines = [edge for some in plates for edge in zip(some, some[1:] + some[:1], strict=True)]
                longest = max((abs(b - a) for a, b in lines), default=0.0)
                assert abs(number.b - number.a) >= longest - 1e-6, (figure.name, number.number)
