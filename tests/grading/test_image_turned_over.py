"""An image whose letters run the other way round is one mistake: it is drawn, named, and costs once."""

from __future__ import annotations

import pytest

from tests.drawn_library import drawn, given
from vecpoly import Mistake, Slip
from vecpoly.board.acts import Locate
from vecpoly.board.place import View
from vecpoly.grading.compare.outcome import Basis
from vecpoly.grading.student import check_answers
from vecpoly.mistakes import slips
from vecpoly.solution import Solution, solve

OVER = Slip(Mistake.TURNED_OVER, "e")


def made(name: str, slip: Slip) -> Solution:
    """The solution of one who makes this slip."""
    return solve(given(name), by="exact", repeats=0, precise=False, slip=slip)


def _spot(solution: Solution, letter: str) -> complex:
    """Where this letter stands on the velocity polygon."""
    acts = (act for act in solution.construction.acts if isinstance(act, Locate))
    return next(act.at for act in acts if act.key == letter and act.head.place is View.VELOCITY)


def test_it_can_be_made_with_every_image_that_is_no_straight_line() -> None:
    """3-9's plate is a triangle on both polygons; the points of 3-7a lie on their lines."""
    found = [one for one in slips(given("3-9")) if one.mistake is Mistake.TURNED_OVER]
    assert found == [OVER, Slip(Mistake.TURNED_OVER, "e'")]
    assert not [one for one in slips(given("3-7a")) if one.mistake is Mistake.TURNED_OVER]


def test_the_corner_lies_on_the_other_side_and_what_follows_goes_on_from_there() -> None:
    b, d, e = (_spot(drawn("3-9").solution, letter) for letter in "bde")
    wrong = made("3-9", OVER)
    assert _spot(wrong, "e") == pytest.approx(b + ((e - b) / (d - b)).conjugate() * (d - b))
    assert wrong.answers["v_E"].drawn != pytest.approx(drawn("3-9").solution.answers["v_E"].drawn, rel=1e-3)
    assert wrong.answers["omega_3"].drawn == pytest.approx(drawn("3-9").solution.answers["omega_3"].drawn, rel=1e-9)


@pytest.mark.parametrize(
    ("name", "letter", "follow"), [("3-9", "e", 0), ("A-27", "f4", 2), ("geared-five-bar", "e", 5)]
)
def test_the_answers_of_one_who_makes_it_have_one_cause_and_what_follows_is_right(
    name: str, letter: str, follow: int
) -> None:
    slip = Slip(Mistake.TURNED_OVER, letter)
    given_up = {key: f"{one.drawn:.4g}" for key, one in made(name, slip).answers.items() if key != "p_F"}
    checked = check_answers(given(name), given_up)
    assert list(checked.marked.slips.values()) == [slip]
    assert sum(one.basis is Basis.SLIP for one in checked.answers) == follow
    (told,) = (one.messages[0].words for one in checked.answers if not one.is_right)
    assert "letters run the other way round" in told.en and "字母绕行顺序" in told.zh
