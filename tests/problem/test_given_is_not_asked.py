"""Where a file does not say what is to be found, nothing that is given is asked."""

from __future__ import annotations

import re

import pytest

from vecpoly.designs.base import Design
from vecpoly.problem.load import load, loads

_FIND = re.compile(r"^find:.*\n(?:[ -].*\n)*", re.M)


@pytest.mark.parametrize("name", ["8-4", "8-15", "8-18", "dead-centre", "drag-link", "K-crank-rocker-AD", "two-pairs"])
def test_of_a_synthesis_without_find_nothing_is_asked_that_is_given(name: str) -> None:
    """Of 8-4 l_CD, l_AD and K were asked, which are its data."""
    problem = loads(_FIND.sub("", load(name).text))
    assert isinstance(problem.subject, Design)
    given = {symbol for symbol, _ in problem.subject.given()}
    asked = {one.rel.symbol for one in problem.asks}
    assert asked and not asked & given
    assert given & {one.symbol for one in problem.subject.quantities()}
