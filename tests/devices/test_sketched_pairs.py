"""The sketch of a chain has every pair that the text names, and each guide on one side in all figures."""

from __future__ import annotations

from tests.drawn_library import drawn, given, ids
from tests.each import Later, each
from vecpoly.board.construction import Figure
from vecpoly.board.paper.bodies import FixedGuide
from vecpoly.board.paper.marks import Point
from vecpoly.devices.structure import Structure
from vecpoly.names import subscripted

CHAINS = Later(lambda: (name for name in ids(mechanisms=False) if isinstance(given(name).subject, Structure)))


def letters(figure: Figure) -> set[str]:
    return {mark.label for mark in figure.marks if isinstance(mark, Point)}


@each(CHAINS)
def test_every_pair_of_a_chain_is_lettered_on_its_sketch(name: str) -> None:
    chain = given(name).subject
    assert isinstance(chain, Structure)
    first = letters(drawn(name).construction.figures[0])
    assert {subscripted(pair.letter) for pair in chain.chain.pairs} <= first


def test_a_guide_stays_on_one_side_of_its_block_when_redundant_links_are_gone() -> None:
    sides = []
    for figure in drawn("2-6").construction.figures[:2]:
        (pin,) = (mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label == "D")
        (guide,) = (
            mark for mark in figure.marks if isinstance(mark, FixedGuide) and abs((mark.a - mark.b).real) < 1e-9
        )
        sides.append(guide.a.real < pin.real)
    assert sides == [True, True]
