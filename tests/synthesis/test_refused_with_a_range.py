"""Data whose lines do not meet are refused with where one of them had to lie, and there they meet."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest

import vecpoly
from tests.synthesis.inversion import posed
from vecpoly.errors import AssemblyError

FOUR = ["(0, 0) mm at 0 deg", "(13, 19) mm at 0 deg", "(42, 28) mm at 35 deg", "(83, 15) mm at 54 deg"]
THREE = ["(0, 0) mm at 0 deg", "(30, 0) mm at 20 deg", "(70, 0) mm at 50 deg"]
TWO = ["(0, 0) mm at 0 deg", "(0, 40) mm at 60 deg"]


def four(y: str = "-50") -> vecpoly.Problem:
    """A body led through four positions, one of them parallel to another: A on a line, D on y = −50 mm."""
    return posed("positions", poses=FOUR, A=f"on y = {y} mm", D="on y = -50 mm")


def three(x: str = "0") -> vecpoly.Problem:
    """The origin of the body goes along a straight line."""
    return posed("positions", poses=THREE, body={"B": [f"{x} mm", "0 mm"], "C": ["30 mm", "5 mm"]})


def two(x: str = "0") -> vecpoly.Problem:
    """The bisector of the two places of the origin is level."""
    body = {"B": [f"{x} mm", "0 mm"], "C": ["45 mm", "10 mm"]}
    return posed("positions", poses=TWO, body=body, A="on y = -20 mm", D="on y = -20 mm")


def lines(second: str = "270") -> vecpoly.Problem:
    """The coupler's lines in its limits."""
    ends = {"C1": "(0, 0) mm", "C2": "(35, 11) mm"}
    return posed("limit-lines", **ends, line_1="270 deg", line_2=f"{second} deg", alpha_1="40 deg")


@pytest.mark.parametrize("task", [four, three, two, lines])
def test_a_refusal_tells_where_a_datum_had_to_lie_and_there_a_linkage_is_found(
    task: Callable[..., vecpoly.Problem],
) -> None:
    with pytest.raises(AssemblyError, match="with all else as it is") as refused:
        task().solve(by="exact")
    told = refused.value.words.en.partition("with all else as it is")[2]
    assert "其余数据不变时" in refused.value.words.zh
    ends = re.findall(r"(-?[\d.]+) to (-?[\d.]+)", told)
    assert ends or "at most" in told
    for low, high in ends:
        middle = (float(low) + float(high)) / 2 + 0.01 * (float(high) - float(low))
        assert task(f"{middle:.6g}").solve(by="exact").construction.conclusion is None
    for word, way in (("at most", -1), ("at least", 1)):
        for end in re.findall(rf"{word} (-?[\d.]+) mm", told):
            assert task(f"{float(end) + way * 0.5:.6g}").solve(by="exact").construction.conclusion is None


def test_what_alone_does_not_serve_within_a_range_is_left_out_of_it_by_its_own_number() -> None:
    """The x of B was told as at most −0.000002917 mm, or 0.000002917 to 27.28 mm."""
    with pytest.raises(AssemblyError, match=r"at most 27\.28 mm or at least 32\.15 mm, but not 0 mm$"):
        three().solve(by="exact")
