"""Centres are acts: a centre of somebody's own is gone on with, and a line through the wrong two centres misleads."""

from __future__ import annotations

import pytest

from vecpoly import Mistake, Slip, load, slips, solve
from vecpoly.board.acts import Locate, Parallel
from vecpoly.errors import UnknownNameError
from vecpoly.solution import Solution

CENTRES = ("3-2", "D-1", "3-1a")


def drawn(name: str, **otherwise: object) -> Solution:
    return solve(load(name), by="exact", repeats=0, precise=False, **otherwise)  # type: ignore[arg-type]


def places(solution: Solution) -> dict[str, complex]:
    acts = solution.construction.acts
    return {act.key: act.at for act in acts if isinstance(act, Locate) and act.key.startswith("P")}


@pytest.mark.parametrize("name", CENTRES)
def test_a_centre_put_where_it_is_changes_nothing(name: str) -> None:
    plain = drawn(name)
    sought = list(places(plain))[-1]
    again = drawn(name, points={sought: places(plain)[sought]})
    assert {key: one.drawn for key, one in again.answers.items()} == {
        key: one.drawn for key, one in plain.answers.items()
    }


def test_what_rests_on_a_centre_goes_on_with_somebodys_own() -> None:
    plain, own = drawn("3-2"), drawn("3-2", points={"P13": (-40.0, 0.0)})
    changed = {key for key, one in own.answers.items() if one.drawn != plain.answers[key].drawn}
    assert changed == {"P_13", "omega_3"} == set(plain.construction.dependents("P13")) & set(plain.answers)
    assert own.answers["omega_3"].drawn == pytest.approx(10.0 * 40 / (40 + 60), rel=1e-9)  # ω_1 P_14P_13 / P_34P_13


@pytest.mark.parametrize("name", CENTRES)
def test_every_line_can_be_led_through_a_centre_that_is_not_on_it(name: str) -> None:
    wrong = [slip for slip in slips(load(name)) if slip.mistake is Mistake.OTHER_CENTRE]
    right = places(drawn(name))
    assert wrong
    for slip in wrong:
        ends = [key for key in right if key in slip.key]
        assert slip.instead in right and slip.instead not in ends


def test_a_line_through_the_wrong_centre_puts_the_next_centre_on_it() -> None:
    found = places(drawn("3-2", slip=Slip(Mistake.OTHER_CENTRE, "P14P34", "P12")))
    a, b, c = found["P14"], found["P12"], found["P13"]
    assert abs(((b - a).conjugate() * (c - a)).imag) < 1e-6 * abs(b - a) * abs(c - a)
    assert found["P13"] != pytest.approx(places(drawn("3-2"))["P13"])


def test_a_centre_that_is_not_yet_found_misleads_nobody_and_one_that_there_is_not_is_refused() -> None:
    """At another scale centres may be found in another order: the first ended in a KeyError, in classes too."""
    right, lines = drawn("3-1d"), [one.key for one in drawn("3-1d").construction.acts if isinstance(one, Parallel)]
    first, last = next(key for key in lines if key.startswith("P")), list(places(right))[-1]
    early = drawn("3-1d", slip=Slip(Mistake.OTHER_CENTRE, first, last))
    assert places(early) == places(right)
    with pytest.raises(UnknownNameError, match="no centre 'P99' on the sheet"):
        drawn("3-1d", slip=Slip(Mistake.OTHER_CENTRE, first, "P99"))
