"""What lies within a slider block, and where a bar comes out of it."""

from __future__ import annotations

import cmath

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from vecpoly.board.paper.marks import Block
from vecpoly.board.paper.walls import HEIGHT, holds, leaves

ALONG, ASIDE = st.floats(-12.0, 12.0), st.floats(-6.0, 6.0)
OWN = st.builds(complex, ALONG, ASIDE)
SHARES = st.builds(
    complex, st.floats(-0.98, 0.98), st.floats(-0.98, 0.98)
)  # of half the length, and of half the height
BLOCKS = st.builds(
    lambda x, y, turn, length: Block(at=complex(x, y), along=cmath.exp(1j * turn), length=length),
    st.floats(-50.0, 50.0),
    st.floats(-50.0, 50.0),
    st.floats(-3.2, 3.2),
    st.floats(4.0, 20.0),
)


def spot(block: Block, own: complex) -> complex:
    """The place on paper that lies so far along the block and to its left."""
    return block.at + own * block.along


def reach(block: Block, own: complex) -> float:
    """1 on the wall, less within."""
    return max(abs(own.real) / (block.length / 2), abs(own.imag) / (HEIGHT / 2))


@pytest.mark.parametrize("lean", [0.0, 0.4, 0.8, 1.2, 1.57, 2.5, -0.6])
@given(length=st.floats(8.0, 20.0), end=st.sampled_from([-1.0, 1.0]), aside=st.floats(-0.9, 0.9))
def test_a_block_holds_what_lies_just_within_its_walls_and_not_what_lies_just_beyond_however_it_leans(
    lean: float, length: float, end: float, aside: float
) -> None:
    block = Block(at=20 + 30j, along=cmath.exp(1j * lean), length=length)
    for share in (0.95, 1.05):
        at_an_end = complex(share * end * length / 2, aside * HEIGHT / 2)
        beside = complex(aside * length / 2, share * end * HEIGHT / 2)
        assert [holds(block, spot(block, own)) for own in (at_an_end, beside)] == [share < 1.0] * 2


@given(block=BLOCKS, within=SHARES, without=SHARES, out=st.floats(1.02, 4.0), ended=st.booleans())
def test_a_bar_from_within_a_block_to_without_leaves_it_on_a_wall(
    block: Block, within: complex, without: complex, out: float, ended: bool
) -> None:
    start, tip = (
        complex(share.real * block.length / 2, share.imag * HEIGHT / 2)
        for share in (within, complex(out, without.imag) if ended else complex(without.real, -out))
    )
    assert reach(block, start) < 0.99 and reach(block, tip) > 1.01
    wall = leaves(block, spot(block, start), spot(block, tip))
    assert wall is not None
    own = (wall - block.at) / block.along
    assert reach(block, own) == pytest.approx(1.0, abs=1e-6)
    assert ((own - start) / (tip - start)).imag == pytest.approx(0.0, abs=1e-6)
    assert 0.0 < ((own - start) / (tip - start)).real < 1.0


@given(block=BLOCKS, start=OWN, tip=OWN)
def test_no_bar_leaves_a_block_in_which_it_ends(block: Block, start: complex, tip: complex) -> None:
    assume(reach(block, tip) < 0.99)
    assert leaves(block, spot(block, start), spot(block, tip)) is None
