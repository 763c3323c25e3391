"""What is sure to fail before it is drawn, or before it is weighed, does fail when it is."""

from __future__ import annotations

from collections import Counter

import numpy as np

from tests.variants.block import block, piloted, seed
from vecpoly.variants.conditions import Condition
from vecpoly.variants.draw import tried
from vecpoly.variants.judge import failing, slips_show, verdict
from vecpoly.variants.look import Look

ATTEMPTS = 12


def test_places_with_a_vector_surely_too_short_fail_on_it_when_they_are_drawn() -> None:
    problem, standard = block(), piloted().standard
    graded, seen = standard.graded(problem), Counter[bool]()
    for attempt in range(ATTEMPTS):
        whole = tried(problem, seed("short"), attempt, standard, graded)
        some = tried(problem, seed("short"), attempt, standard, graded, good=True)
        good = [values for values, look in some.drawn if verdict(look, standard) is None]
        for values, look in whole.drawn:
            seen[look is Condition.VECTORS] += 1
            assert (verdict(look, standard) is None) == (values in good)
    assert seen[True] and seen[False]


def test_a_slip_shows_no_more_than_over_the_least_tolerance() -> None:
    problem, standard = block(), piloted().standard
    found = Counter[bool]()
    for attempt in range(ATTEMPTS):
        for _, look in tried(problem, seed("slips"), attempt, standard, standard.graded(problem)).drawn:
            if isinstance(look, Look):
                shifts, most = (abs(one[1:] - one[0]).max(axis=1) for one in (look.places, look.finest))
                assert np.all((shifts <= most * (1 + 1e-9)) | ~np.isfinite(shifts) | ~np.isfinite(most))
                blind = not slips_show(look, standard, look.finest)
                assert not blind or failing(look, standard) is not None
                found[blind] += 1
    assert found[False]
