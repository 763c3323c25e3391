"""A construction survives the way to JSON and back."""

from __future__ import annotations

import pytest

from vecpoly.board.record import from_json, to_json
from vecpoly.errors import VecpolyError
from vecpoly.problem.load import load
from vecpoly.solution import solve


@pytest.mark.parametrize("name", ["3-6", "3-9", "3-13"])
def test_a_construction_goes_to_json_and_back(name: str) -> None:
    construction = solve(load(name)).construction
    again = from_json(to_json(construction))
    assert again.figures == construction.figures
    assert again.steps == construction.steps
    assert dict(again.readings) == dict(construction.readings)


@pytest.mark.parametrize("text", ["", "[]", '{"is": "Nothing"}', '{"is": "Words", "zh": "a", "en": "b"}', '{"a": 1}'])
def test_other_json_is_refused(text: str) -> None:
    with pytest.raises(VecpolyError, match="construction"):
        from_json(text)
