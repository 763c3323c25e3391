"""A mistake that nobody can make changes nothing: it is refused, with those that can be made."""

from __future__ import annotations

import pytest

from tests.drawn_library import IDS, drawn
from tests.each import each
from vecpoly.amend import can_be_made
from vecpoly.board.otherwise.possible import slips_of
from vecpoly.board.otherwise.slip import Mistake, Slip
from vecpoly.errors import UnknownNameError
from vecpoly.foundation.slotted import replace
from vecpoly.problem.load import load
from vecpoly.solution import solve


@each(IDS)
def test_every_mistake_of_the_catalogue_can_be_made_and_none_with_a_letter_that_is_none(name: str) -> None:
    acts = drawn(name).construction.acts
    for slip in slips_of(acts):
        can_be_made(slip, acts)
        with pytest.raises(UnknownNameError):
            can_be_made(replace(slip, instead="zz"), acts)
    with pytest.raises(UnknownNameError, match="there is no zz on the sheet"):
        can_be_made(Slip(Mistake.REVERSED, "zz"), acts)


@pytest.mark.parametrize(
    ("slip", "said"),
    [
        (
            Slip(Mistake.COINCIDENT, "v_B", "c9"),
            "'v_B coincident (c9)'; those that can be made with v_B: v_B reversed;",
        ),
        (Slip(Mistake.TURNED, "v_B", "zz"), "'v_B turned (zz)'"),
        (Slip(Mistake.HALVED, "C"), "'C halved'; those that can be made with C: none"),
    ],
)
def test_a_mistake_that_would_change_nothing_is_refused_with_those_that_can_be_made(slip: Slip, said: str) -> None:
    with pytest.raises(UnknownNameError) as refused:
        solve(load("3-9"), slip=slip, repeats=0, precise=False)
    assert said in refused.value.words.en
    assert not slip.instead or slip.instead in refused.value.words.zh


def test_a_mistake_is_made_on_each_figure_where_its_figure_is_not_named() -> None:
    """R_32 stands on the free body, and in the force polygon."""
    acts = drawn("4-3a").construction.acts
    figured = next(one for one in slips_of(acts) if ":" in one.key)
    can_be_made(replace(figured, key=figured.key.rpartition(":")[2]), acts)
