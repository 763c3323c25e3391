"""A place that is asked for is read beside the moving figures as two coordinates."""

from __future__ import annotations

import re
from types import SimpleNamespace
from typing import Any

import pytest

from vecpoly import load, loads, solve
from vecpoly.player.readings import readings
from vecpoly.player.setting.type import Faces

TEXT = re.sub(r"(?ms)^(printed|find):.*?(?=^\S|\Z)", "", load("3-9").text) + "\nfind: [p_E, v_E, p_D]\n"


def test_the_place_of_a_point_is_told_in_millimetres_as_drawn_and_exact() -> None:
    solution = solve(loads(TEXT), by="exact", repeats=0)
    turn: Any = SimpleNamespace(solution=solution)
    ((*rows,),) = readings([turn], Faces())
    for cells, answer in zip(rows, solution.answers.values(), strict=True):
        if not answer.is_place or answer.exact_vector is None:
            continue
        for cell in (cells[0], cells[1], cells[4]):
            bare = re.sub(r"<[^>]*>", "", cell).replace("−", "-")
            found = [float(number) for number in re.findall(r"-?\d+(?:\.\d+)?", bare)]
            assert found == pytest.approx([1e3 * answer.exact_vector.real, 1e3 * answer.exact_vector.imag], rel=2e-3)
    assert sum(answer.is_place for answer in solution.answers.values()) == 2
