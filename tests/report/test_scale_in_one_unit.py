"""The scale of a sheet has one number: that which is stated stands in the lines of lengths, too."""

from __future__ import annotations

import re

import pytest

from tests.drawn_library import DRAFTED, drafted
from tests.each import each
from vecpoly.algebra.formula import Row, Txt, plain, sym
from vecpoly.algebra.quantity import magnitude
from vecpoly.algebra.rounding import places_of
from vecpoly.algebra.worked import worked
from vecpoly.printed.metres import in_metres

LINE = re.compile(r"[^=]+ = μ_l\u2009[^=]+ = (−?[\d.]+) × [^=]+ = (−?[\d.]+) m ([=≈]) (−?[\d.]+) mm")


def value(text: str) -> float:
    """A number as it is printed."""
    return float(text.replace("−", "-"))


@each(dict.fromkeys((*DRAFTED, "8-12", "8-17", "8-4", "8-1", "cam-rocker", "gear-undercut", "four-positions")))
def test_lengths_are_told_with_the_scale_as_it_is_stated(name: str) -> None:
    solution = drafted(name)
    if solution is None:
        return
    construction = solution.construction
    stated = {one.scale.value for one in construction.figures if one.scale.symbol == "μ_l"}
    for text in (plain(line) for step in construction.steps for line in step.formulas):
        if " = μ_l\u2009" in text and text.endswith(" mm"):
            found = LINE.fullmatch(text)
            assert found is not None, text
            assert any(abs(value(found[1])) == pytest.approx(one, rel=1e-9) for one in stated), text
            half = 0.5001 * 10.0 ** -places_of(found[4]) if found[3] == "≈" else 1e-9 * value(found[4])
            assert abs(1e3 * value(found[2]) - value(found[4])) <= abs(half), text


def test_a_line_that_is_no_length_times_the_scale_stays_as_it_is() -> None:
    mu, read = magnitude("μ_l", 40.0, "mm/mm"), magnitude("CE", 49.2, "mm")
    scales = {sym("μ_l")}
    length = worked(sym("l"), mu * read, "mm")
    assert plain(in_metres(length, length, scales)).endswith(" = 0.04 × 49.2 = 1.968 m = 1968 mm")
    assert in_metres(length, length, set()) is length
    for line in (worked(sym("l"), read * mu, "mm"), worked(sym("v"), mu * read, "mm/s"), Row((Txt("l = 3 mm"),))):
        assert in_metres(line, line, scales) is line
